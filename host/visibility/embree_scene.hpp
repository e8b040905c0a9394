#pragma once
/// The scene as Embree sees it: one Embree scene of everything that blocks light, one of the null surfaces. Only host/visibility includes
/// this.
#include <embree3/rtcore.h>

#include <atomic>
#include <memory>
#include <vector>

#include <tbb/task_arena.h>

#include "visibility/boundary_order.hpp"
#include "visibility/outer_walls.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using DevicePointer = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using ScenePointer = std::unique_ptr<RTCSceneTy, ReleaseScene>;

/// What Embree's callbacks need to know of a shape.
struct TracedShape {
    const Shape* shape;
    bool null;      ///< its surface lets everything pass unchanged
    Mat4 to_local;  ///< for analytic shapes
};

struct Visibility::State {
    State(const Scene& scene, int threads);

    const Scene& scene;
    DevicePointer device;
    ScenePointer solid, null;  ///< geometry IDs are shape indices in both
    OuterWalls walls;
    ScenePointer between;      ///< of `solid` what may stand between two points inside all `walls`; none without walls
    bool has_null_boundaries = false, has_solids = false, has_nulls = false;
    std::vector<TracedShape> shapes;
    mutable tbb::task_arena arena;
    mutable std::atomic<std::uint64_t> runaway_walks = 0, invalid_rays = 0;

private:
    void leave_out_walls();
};

/// A ray followed in double. Must begin with Embree's context, through which the callbacks find it.
struct ExactQuery {
    RTCIntersectContext context;
    const Visibility::State* state;
    Ray ray;
    double limit;                    ///< only hits nearer than this count
    Crossings* crossings = nullptr;  ///< collect null boundaries here; otherwise look for the nearest surface
    bool found = false, too_many = false;
    int shape = none;
    unsigned primitive = 0;
    double t = 0, u = 0, v = 0;
    /// Embree's float ray starts this far before the double one, so that rounding its origin loses nothing: Embree's distance is t + shift.
    double shift;

    ExactQuery(const Visibility::State& state, const Ray& ray);
};

}  // namespace tyndall

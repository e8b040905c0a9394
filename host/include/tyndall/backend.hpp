#pragma once
/// The connections alone, for a renderer of its own that has traced its light paths and camera rays: it hands over virtual lights, eye segments, eye points and media, answers
/// shadow segments itself, and gets radiance and variance for every eye. No scene, no film, no ray tracer of ours. host/docs/library.md tells what each number means.
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tyndall/error.hpp"
#include "tyndall/export.h"
#include "tyndall/opencl_handles.hpp"
#include "tyndall/scene_description.hpp"
#include "tyndall/stop.hpp"

namespace tyndall::api {

using Float3 = std::array<float, 3>;

/// A straight piece of a light path inside one medium, up to the next surface or boundary, also where the path itself was scattered before. It shines from everywhere along it.
struct RayLight {
    Float3 origin{};
    float length = 0;
    Float3 direction{0, 0, 1};   ///< of travel, unit
    std::uint32_t medium = 0;    ///< index
    Float3 flux{};               ///< W: the path's power at the origin over the number of paths. What the medium absorbs and scatters along the piece is not in it
    std::uint32_t padding = 0;
};

/// A collision of a light path with a medium.
struct PointLight {
    Float3 position{};
    std::uint32_t medium = 0;
    Float3 direction{0, 0, 1};   ///< of travel before it, unit
    std::uint32_t padding_0 = 0;
    Float3 power{};              ///< W that are scattered here, over the number of paths
    std::uint32_t padding_1 = 0;
};

/// A straight piece of a camera path inside one medium that scatters.
struct EyeSegment {
    Float3 origin{};
    float length = 0;
    Float3 direction{0, 0, 1};   ///< away from the camera, unit
    std::uint32_t medium = 0;
    Float3 throughput{1, 1, 1};  ///< of the camera path up to the origin; what the medium absorbs along the piece is not in it
    std::uint32_t padding = 0;
};

inline constexpr std::uint32_t no_medium = 0xffffffffu;

/// A point on a surface that reflects diffusely.
struct EyePoint {
    Float3 position{};           ///< moved off the surface by the caller, by more than the rounding of its places
    std::uint32_t medium = no_medium;  ///< in front of the surface
    Float3 normal{0, 0, 1};      ///< shading normal towards the camera's side, unit
    std::uint32_t padding_0 = 0;
    Float3 facing{0, 0, 1};      ///< geometric normal towards the camera's side, unit
    std::uint32_t padding_1 = 0;
    Float3 throughput{1, 1, 1};  ///< of the camera path, times reflectance / pi
    std::uint32_t padding_2 = 0;
};

/// A question: does anything stand between? Both ends are pulled in by the rounding of places, 2^-21 of the box's size.
struct ShadowSegment {
    Triple from{}, to{};         ///< from the eye to the light
    std::uint32_t medium = 0;    ///< that the eye is in
    std::uint32_t padding = 0;
};

/// A convex polyhedron that is filled with a medium, in vacuum; containers are disjoint.
struct Container {
    std::uint32_t medium = 0;
    std::vector<std::array<double, 4>> planes{};  ///< up to 64 half-spaces x n[0] + y n[1] + z n[2] <= n[3]
};

/// Called on the thread that called `connect`, thousands of segments at a time. What they throw ends that call and leaves it.
using Occluded = std::function<void(std::span<const ShadowSegment> segments, std::span<std::uint8_t> blocked)>;  ///< writes 1 where something stands between, else 0
using Transmitted = std::function<void(std::span<const ShadowSegment> segments, std::span<Float3> transmittance)>;

struct BackendDescription {
    std::vector<Medium> media{};            ///< lights and eyes name them by index
    std::vector<Container> containers{};    ///< none: between an eye and a light is the light's medium and nothing else
    Triple low{-1, -1, -1}, high{1, 1, 1};  ///< a box that holds every light and every eye; everything is scaled by it
    Occluded occluded{};                    ///< none: nothing stands between
    Transmitted transmittance{};            ///< in place of `occluded` and containers: media of any shape, walked by the caller; 0 where something stands between
    std::string device{};                   ///< as RenderSettings::device, one of them
    std::optional<OpenClHandles> opencl{};  ///< the caller's objects in place of `device`
    int lanes = 0;                        ///< as RenderSettings::lanes
    bool selftest = true;                 ///< as RenderSettings::selftest
    std::uint64_t max_bytes = 0;          ///< of buffers on the device: less is done at a time, ResourceError if nothing can be; 0: 64 MiB of eyes at a time
    const StopFlag* stop = nullptr;       ///< raised: `connect` throws Stopped. Must outlive the backend
    std::function<void(const std::string&)> warn{};  ///< sentences for people, on the thread that called `connect`; without it nothing is printed anywhere
};

struct ConnectOptions {
    std::uint64_t seed = 1;
    int rounds = 2;                       ///< independent estimates of everything, of which results are means; variances take two at least
    std::uint32_t lights_per_eye = 0;     ///< connect each eye to so many lights, chosen without bias by estimates for 64 eyes in a row; 0: to all
};

/// Three floats per eye, in the order of the eyes.
struct Estimates {
    std::vector<float> radiance{};  ///< W/m2/sr, times throughput: what all lights together send along the camera path
    std::vector<float> variance{};  ///< of the mean of the rounds, unbiased, given these lights; 0 with one round
    std::uint64_t shadow_segments = 0;  ///< that were asked
    std::uint64_t not_finite = 0;       ///< samples that were not finite, and count as 0
};

/// Programs and buffers on a device. One thread at a time; several backends may be used by several threads.
class TYNDALL_API Backend {
public:
    /// Copies the description. Throws UsageError, SceneError (media), NoDeviceError, DeviceError.
    explicit Backend(BackendDescription description);
    ~Backend();
    Backend(Backend&&) noexcept;
    Backend& operator=(Backend&&) noexcept;

    /// What the lights send to every eye, estimated by the sampling of the renderer. Throws UsageError for a record that is not finite, not unit, out of the box or of no medium,
    /// with its index; DeviceError, ResourceError, Stopped.
    Estimates connect(std::span<const RayLight> lights, std::span<const EyeSegment> eyes, const ConnectOptions& options = {});
    Estimates connect(std::span<const RayLight> lights, std::span<const EyePoint> eyes, const ConnectOptions& options = {});
    Estimates connect(std::span<const PointLight> lights, std::span<const EyeSegment> eyes, const ConnectOptions& options = {});
    Estimates connect(std::span<const PointLight> lights, std::span<const EyePoint> eyes, const ConnectOptions& options = {});

    struct State;

private:
    std::unique_ptr<State> state_;
};

}  // namespace tyndall::api

#include "visibility/near_search.hpp"

#include <algorithm>
#include <cmath>

#include "visibility/embree_scene.hpp"

namespace tyndall {
namespace {

constexpr double pieces_per_capsule = 16;  ///< in the mean, at most: more boxes fit better and cost more
constexpr double radii_per_piece = 4;      ///< a box much shorter than it is wide buys nothing
constexpr double scene_length = 4;         ///< render space is smaller: what a line in an unbounded medium runs beyond stays in one piece
constexpr double rounding = 0x1p-20;       ///< of a float's position in render space, with room: boxes and distances are wider by it

/// A part of a capsule.
struct CapsulePiece {
    std::uint32_t capsule;
    double start, length;
};

/// As Embree's callbacks find it: the context comes first.
struct NearQuery {
    RTCIntersectContext context;
    const std::vector<Capsule>* capsules;
    const std::vector<CapsulePiece>* pieces;
    Vec3 origin, along;
    std::vector<std::uint32_t>* found;

    void offer(unsigned number)
    {
        const CapsulePiece& piece = (*pieces)[number];
        const Capsule& c = (*capsules)[piece.capsule];
        if (!found->empty() && found->back() == piece.capsule) return;
        if (segment_distance(origin, along, c.origin + piece.start * c.direction, piece.length * c.direction) <= c.radius + rounding) found->push_back(piece.capsule);
    }
};

struct Boxes {
    std::vector<Capsule> capsules;
    std::vector<CapsulePiece> pieces;
};

void bound(const RTCBoundsFunctionArguments* arguments)
{
    const Boxes& boxes = *static_cast<const Boxes*>(arguments->geometryUserPtr);
    const CapsulePiece& piece = boxes.pieces[arguments->primID];
    const Capsule& c = boxes.capsules[piece.capsule];
    const Vec3 from = c.origin + piece.start * c.direction, to = from + piece.length * c.direction, wide(c.radius + rounding);
    const Vec3 low = glm::min(from, to) - wide, high = glm::max(from, to) + wide;
    RTCBounds& b = *arguments->bounds_o;
    b.lower_x = static_cast<float>(low.x), b.lower_y = static_cast<float>(low.y), b.lower_z = static_cast<float>(low.z);
    b.upper_x = static_cast<float>(high.x), b.upper_y = static_cast<float>(high.y), b.upper_z = static_cast<float>(high.z);
}

/// Collects and lets the ray go on.
void collect(const RTCOccludedFunctionNArguments* arguments)
{
    if (arguments->valid[0]) reinterpret_cast<NearQuery*>(arguments->context)->offer(arguments->primID);
}

bool collect_at_point(RTCPointQueryFunctionArguments* arguments)
{
    static_cast<NearQuery*>(arguments->userPtr)->offer(arguments->primID);
    return false;
}

}  // namespace

struct NearSearch::State : Boxes {
    DevicePointer device{rtcNewDevice(nullptr)};
    ScenePointer scene;
};

NearSearch::NearSearch() : state_(std::make_unique<State>()) {}
NearSearch::~NearSearch() = default;
NearSearch::NearSearch(NearSearch&&) noexcept = default;

void NearSearch::set(std::span<const Capsule> capsules)
{
    State& s = *state_;
    s.capsules.assign(capsules.begin(), capsules.end()), s.pieces.clear();
    double total = 0;
    for (const Capsule& c : capsules) total += std::min(c.length, scene_length);
    const double usual = total / (pieces_per_capsule * static_cast<double>(std::max<std::size_t>(capsules.size(), 1)));
    for (std::uint32_t i = 0; i < capsules.size(); ++i) {
        const Capsule& c = capsules[i];
        const double near = std::min(c.length, scene_length), step = std::max(usual, radii_per_piece * c.radius);
        const int count = std::max(static_cast<int>(std::ceil(near / step)), 1);
        for (int k = 0; k < count; ++k) s.pieces.push_back({i, k * near / count, near / count});
        if (c.length > near) s.pieces.push_back({i, near, c.length - near});
    }
    s.scene.reset(rtcNewScene(s.device.get()));
    rtcSetSceneFlags(s.scene.get(), RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(s.device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(s.pieces.size()));
    rtcSetGeometryUserData(geometry, static_cast<Boxes*>(&s));
    rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
    rtcSetGeometryOccludedFunction(geometry, collect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(s.scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(s.scene.get());
}

void NearSearch::find(const Vec3& origin, const Vec3& direction, double length, std::vector<std::uint32_t>& found) const
{
    NearQuery query{.context = {}, .capsules = &state_->capsules, .pieces = &state_->pieces, .origin = origin, .along = length > 0 ? length * direction : Vec3(0), .found = &found};
    const auto f = [](double x) { return static_cast<float>(x); };
    if (!(length > 0)) {
        RTCPointQuery point{.x = f(origin.x), .y = f(origin.y), .z = f(origin.z), .time = 0, .radius = 0};
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(state_->scene.get(), &point, &context, collect_at_point, &query);
        return;
    }
    rtcInitIntersectContext(&query.context);
    RTCRay ray{};
    ray.org_x = f(origin.x), ray.org_y = f(origin.y), ray.org_z = f(origin.z);
    ray.dir_x = f(direction.x), ray.dir_y = f(direction.y), ray.dir_z = f(direction.z);
    ray.tnear = 0, ray.tfar = f(length), ray.mask = 0xffffffffu;
    rtcOccluded1(state_->scene.get(), &query.context, &ray);
}

double segment_distance(const Vec3& origin_a, const Vec3& along_a, const Vec3& origin_b, const Vec3& along_b)
{
    // The nearest points of the lines, moved into the segments one after the other [Ericson 2005, 5.1.9].
    const Vec3 between = origin_a - origin_b;
    const double aa = glm::dot(along_a, along_a), bb = glm::dot(along_b, along_b), ab = glm::dot(along_a, along_b), a = glm::dot(along_a, between), b = glm::dot(along_b, between);
    const auto part = [](double over, double under) { return under > 0 ? std::clamp(over / under, 0.0, 1.0) : 0.0; };
    double s = part(ab * b - a * bb, aa * bb - ab * ab);
    const double t = part(ab * s + b, bb);
    s = part(ab * t - a, aa);
    return glm::length(between + s * along_a - t * along_b);
}

}  // namespace tyndall

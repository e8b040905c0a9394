#include "bench/bare_embree.hpp"

#include <embree3/rtcore.h>
#include <immintrin.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace tyndall::bench {

struct BareEmbree::State {
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = rtcNewScene(device);
    ~State() { rtcReleaseScene(scene), rtcReleaseDevice(device); }
};

namespace {

void add_mesh(RTCDevice device, RTCScene scene, const Mesh& mesh)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices =
        static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
    auto* triangles =
        static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
    for (const Vec3& p : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(p[axis]);
    for (const auto& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) *triangles++ = t[corner];
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

}  // namespace

BareEmbree::BareEmbree(const Scene& scene, bool robust) : state_(std::make_unique<State>())
{
    if (robust) rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
    for (const Shape& shape : scene.shapes) add_mesh(state_->device, state_->scene, shape.mesh);
    rtcCommitScene(state_->scene);
}

BareEmbree::~BareEmbree() = default;

void BareEmbree::occluded(std::span<ShadowPacket> packets) const
{
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040);  // denormals are zero, as Embree wants it
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    alignas(64) int valid[SHADOW_PACKET_SIZE];
    std::fill(std::begin(valid), std::end(valid), -1);
    for (ShadowPacket& packet : packets) rtcOccluded16(valid, state_->scene, &context, reinterpret_cast<RTCRay16*>(&packet));
    _mm_setcsr(before);
}

void BareEmbree::occluded_in_parallel(std::span<ShadowPacket> packets) const
{
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, packets.size(), 64),
                      [&](const auto& range) { occluded(packets.subspan(range.begin(), range.size())); });
}

}  // namespace tyndall::bench

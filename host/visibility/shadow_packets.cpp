/// Shadow segments sixteen at a time, as the device wrote them.
#include <immintrin.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "kernels/shared/records.hpp"
#include "parallel/parallel_for.hpp"
#include "visibility/embree_scene.hpp"

namespace tyndall {
namespace {

constexpr int lanes = SHADOW_PACKET_SIZE;
static_assert(sizeof(ShadowPacket) == sizeof(RTCRay16) && offsetof(ShadowPacket, direction_x) == offsetof(RTCRay16, dir_x) &&
              offsetof(ShadowPacket, tfar) == offsetof(RTCRay16, tfar) && offsetof(ShadowPacket, mask) == offsetof(RTCRay16, mask));

/// Denormals are flushed to zero while this lives: Embree wants it, the thread may be somebody else's.
class FlushDenormals {
public:
    FlushDenormals() : before_(_mm_getcsr())
    {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    unsigned before_;
};

/// -1 in the lanes that ask something and whose numbers are finite; returns how many ask but are not. Loops over whole rows, without branches,
/// because compilers turn those into vectors: this runs once per sixteen rays.
int lanes_to_trace(const ShadowPacket& p, int (&valid)[lanes])
{
    float zero[lanes];  // x - x is 0 for finite x and NaN otherwise
    for (int i = 0; i < lanes; ++i)
        zero[i] = (p.origin_x[i] - p.origin_x[i]) + (p.origin_y[i] - p.origin_y[i]) + (p.origin_z[i] - p.origin_z[i]) +
                  (p.direction_x[i] - p.direction_x[i]) + (p.direction_y[i] - p.direction_y[i]) + (p.direction_z[i] - p.direction_z[i]);
    int traced = 0, idle = 0;
    for (int i = 0; i < lanes; ++i) {
        valid[i] = -static_cast<int>(p.tfar[i] >= p.tnear[i]) & -static_cast<int>(p.tnear[i] >= 0) & -static_cast<int>(zero[i] == 0);
        idle += p.tfar[i] < p.tnear[i];
        traced -= valid[i];
    }
    return lanes - traced - idle;
}

void block_invalid_lanes(ShadowPacket& p, const int (&valid)[lanes])
{
    for (int i = 0; i < lanes; ++i)
        if (!valid[i] && !(p.tfar[i] < p.tnear[i])) p.tfar[i] = -std::numeric_limits<float>::infinity();
}

/// Embree demands 64-byte alignment; a packet elsewhere is copied.
void answer(RTCScene scene, RTCIntersectContext& context, const int* valid, ShadowPacket& packet)
{
    if (reinterpret_cast<std::uintptr_t>(&packet) % alignof(RTCRay16) == 0) {
        rtcOccluded16(valid, scene, &context, reinterpret_cast<RTCRay16*>(&packet));
        return;
    }
    RTCRay16 copy;
    std::memcpy(&copy, &packet, sizeof copy);
    rtcOccluded16(valid, scene, &context, &copy);
    std::memcpy(packet.tfar, copy.tfar, sizeof copy.tfar);
}

void answer_all(const Visibility::State& state, std::span<ShadowPacket> packets)
{
    const FlushDenormals flush;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    alignas(64) int valid[lanes];
    for (ShadowPacket& packet : packets) {
        if (const int invalid = lanes_to_trace(packet, valid)) {
            state.invalid_rays.fetch_add(invalid, std::memory_order_relaxed);
            block_invalid_lanes(packet, valid);
        }
        const bool inside = state.between && state.walls.hold(packet, valid);
        answer(inside ? state.between.get() : state.solid.get(), context, valid, packet);
    }
}

}  // namespace

void Visibility::occluded_here(std::span<ShadowPacket> packets) const { answer_all(*state_, packets); }

void Visibility::occluded(std::span<ShadowPacket> packets) const
{
    constexpr std::size_t grain = 64;  // packets: a few microseconds of tracing, a task's overhead disappears in it
    if (packets.size() <= grain || state_->arena.max_concurrency() == 1) return answer_all(*state_, packets);
    run_in(state_->arena, [&] { parallel_pieces(packets.size(), grain, [&](std::size_t first, std::size_t count) { answer_all(*state_, packets.subspan(first, count)); }); });
}

}  // namespace tyndall

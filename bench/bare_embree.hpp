#pragma once
/// The baseline of bench/shadow: Embree with nothing around it.
#include <memory>
#include <span>

#include "kernels/shared/records.hpp"
#include "scene/scene.hpp"

namespace tyndall::bench {

class BareEmbree {
public:
    /// All meshes of the scene as opaque triangles. robust: Embree's edge-safe mode, which the renderer uses.
    BareEmbree(const Scene& scene, bool robust);
    ~BareEmbree();

    /// rtcOccluded16 on packet after packet; 64-byte alignment is the caller's duty.
    void occluded(std::span<ShadowPacket> packets) const;

    /// The same in parallel on all of TBB's threads.
    void occluded_in_parallel(std::span<ShadowPacket> packets) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tyndall::bench

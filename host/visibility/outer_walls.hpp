#pragma once
/// Triangles that cannot stand between two points of a room because everything is on one side of their planes: floor, ceiling, walls.
#include <span>
#include <vector>

#include "kernels/shared/records.hpp"
#include "scene/scene.hpp"

namespace tyndall {

/// Half spaces n . p < offset, in the numbers that Embree and the packets have. Every wall lies wholly in n . p >= offset of one of them, so no segment with
/// both ends inside of all half spaces meets a wall. Nothing is assumed of the scene: ends that are not inside are asked of the whole scene.
class OuterWalls {
public:
    /// Shapes of more triangles than this are not looked at, nor more planes than `most_planes` kept.
    static constexpr std::size_t most_triangles = 64, most_planes = 12;

    struct HalfSpace {
        float x, y, z, offset;
    };

    OuterWalls() = default;
    /// `solids`: all shapes that block light. Keeps no walls where leaving them out would save next to nothing.
    explicit OuterWalls(std::span<const Shape* const> solids);

    bool empty() const { return half_spaces_.empty(); }
    std::span<const HalfSpace> half_spaces() const { return half_spaces_; }
    /// The triangles of a mesh that are no walls.
    std::vector<glm::uvec3> others(const Mesh& mesh) const;
    /// Do both ends of every segment whose lane is -1 in `valid` lie inside, by more than the rounding of this test? False for numbers that are not finite.
    bool hold(const ShadowPacket& packet, const int (&valid)[SHADOW_PACKET_SIZE]) const;

private:
    bool pay(std::span<const Shape* const> solids) const;
    bool beyond(const HalfSpace& plane, const Mesh& mesh, const glm::uvec3& triangle) const;
    std::vector<HalfSpace> half_spaces_;
};

}  // namespace tyndall

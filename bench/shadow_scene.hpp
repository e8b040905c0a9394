#pragma once
/// Rooms with things in them, for shadow segments.
#include "scene/scene.hpp"

namespace tyndall::bench {

enum class Solids { room_of_tetrahedra, one_ball, room_of_balls };

/// Solids between the lights of a workload of scale .19 and its eyes: four in a room of 12 triangles, bumpy spheres of 2048 triangles each (8204 in all) or tetrahedra (28 in all); or one
/// bumpy sphere of 8192 triangles by itself. Render space. The bumps are products of sines, so nothing is drawn at random.
Scene shadow_scene(Solids solids);

std::size_t triangle_count(const Scene& scene);

/// The workload's scale that fits the room.
inline constexpr float shadow_scale = .19f;

}  // namespace tyndall::bench

#pragma once
/// Where on a shape's own map a hit lies.
#include "scene/scene.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

struct SurfacePlace {
    Vec2 uv{0};
    Vec3 along_u{0};  ///< dp/du up to a factor > 0; 0 where the map has none
};

/// As Mitsuba maps its shapes. Mesh: its texture coordinates, or, without, the barycentric coordinates of its triangles' second and third corner (and no
/// along_u). Sphere: longitude / 2 pi, angle to local +z / pi. Disk: radius, angle / 2 pi. Cylinder: angle / 2 pi, height.
SurfacePlace place_on_surface(const Scene& scene, const Hit& hit);

}  // namespace tyndall

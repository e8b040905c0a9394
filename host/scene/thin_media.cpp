#include "scene/thin_media.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/scene_warnings.hpp"
#include "scene/text.hpp"

namespace tyndall {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

double largest_density(const Scene& scene, const Medium& medium)
{
    if (medium.density == none) return 1;
    const std::vector<float>& values = scene.volumes[static_cast<std::size_t>(medium.density)].values;
    return values.empty() ? 0 : double(*std::max_element(values.begin(), values.end()));
}

bool closed(const Shape& shape) { return shape.type == Shape::Type::sphere || (shape.type == Shape::Type::mesh && shape.mesh.closed); }

/// The medium far away from everything.
int outermost_medium(const Scene& scene)
{
    const Vec3 far_away = glm::normalize(Vec3(.5377, .6121, .5801)) * 4.;  // along no likely edge; render space has radius 1
    return medium_at(scene, Vec3(scene.camera.to_world[3]), scene.camera.medium, far_away);
}

/// No straight line inside the medium is longer.
double longest_line(const Scene& scene, int medium)
{
    Bounds filled;
    for (const Shape& shape : scene.shapes) {
        if (!shape.medium_boundary || (shape.interior != medium && shape.exterior != medium)) continue;
        if (!closed(shape)) return unbounded;
        if (shape.interior != medium) continue;
        const Bounds box = bounds_of(shape);
        filled.grow(box.low), filled.grow(box.high);
    }
    if (outermost_medium(scene) == medium) return unbounded;
    return filled.empty() ? 0 : 2 * filled.radius();
}

}  // namespace

ScatteredAgain scattered_again(const Scene& scene)
{
    ScatteredAgain again;
    double most = 0;
    for (std::size_t m = 0; m < scene.media.size(); ++m) {
        const Medium& medium = scene.media[m];
        const double sigma_s = largest(medium.sigma_s()) * largest_density(scene, medium);
        if (!(sigma_s > 0)) continue;
        const double line = longest_line(scene, static_cast<int>(m)), depth = sigma_s * line;
        again.depth += depth;
        if (depth < most) continue;
        most = depth, again.where = medium.where;
        again.why = line < unbounded ? fmt::format("medium {}: a straight line scatters over at most {:.3g} mean free paths", in_quotes(medium.name), depth)
                                     : fmt::format("medium {} is not inside closed shapes: a straight line in it has no end", in_quotes(medium.name));
    }
    again.share = -std::expm1(-again.depth);
    return again;
}

}  // namespace tyndall

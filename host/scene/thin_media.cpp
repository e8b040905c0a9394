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

/// The boxes of the closed shapes that the medium fills; nothing if other shapes bound it or none does.
std::optional<std::vector<Bounds>> filled_boxes(const Scene& scene, int medium)
{
    std::vector<Bounds> boxes;
    for (const Shape& shape : scene.shapes) {
        if (!shape.medium_boundary || (shape.interior != medium && shape.exterior != medium)) continue;
        if (!closed(shape)) return std::nullopt;
        if (shape.interior == medium) boxes.push_back(bounds_of(shape));
    }
    if (outermost_medium(scene) == medium) return std::nullopt;
    return boxes;
}

/// No straight line inside the medium is longer.
double longest_line(const Scene& scene, int medium)
{
    const auto boxes = filled_boxes(scene, medium);
    if (!boxes) return unbounded;
    Bounds filled;
    for (const Bounds& box : *boxes) filled.grow(box.low), filled.grow(box.high);
    return filled.empty() ? 0 : 2 * filled.radius();
}

}  // namespace

std::optional<std::vector<Bounds>> scattering_regions(const Scene& scene)
{
    std::vector<Bounds> regions;
    for (std::size_t m = 0; m < scene.media.size(); ++m) {
        if (!(largest(scene.media[m].sigma_s()) > 0)) continue;
        const auto boxes = filled_boxes(scene, static_cast<int>(m));
        if (!boxes) return std::nullopt;
        regions.insert(regions.end(), boxes->begin(), boxes->end());
    }
    return regions;
}

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

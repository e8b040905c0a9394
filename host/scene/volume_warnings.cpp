// Grids that are not where their medium is.
#include <fmt/format.h>

#include <algorithm>

#include "scene/containers.hpp"
#include "scene/scene_warnings.hpp"
#include "scene/text.hpp"
#include "scene/transforms.hpp"

namespace tyndall {

namespace {

bool referred_to(const Scene& scene, int medium)
{
    return scene.camera.medium == medium ||
           std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& s) { return s.interior == medium || s.exterior == medium; }) ||
           std::any_of(scene.emitters.begin(), scene.emitters.end(), [&](const Emitter& e) { return e.medium == medium; });
}

/// Of nine places in the grid's box, the middle and one near each corner, how many are in the medium? They lie on no likely edge of a shape, and a thousandth of the
/// box inside of it, so that a shape may be smaller by that much without a word.
int places_in(const Scene& scene, const Volume& volume, int medium)
{
    const Vec3 inset(1e-3, 1.31e-3, .77e-3), middle(.5017, .4989, .5031);
    int found = 0;
    for (int corner = 0; corner < 9; ++corner) {
        const Vec3 end(corner & 1, corner >> 1 & 1, corner >> 2 & 1), local = corner == 8 ? middle : glm::mix(end, 1. - end, inset);
        found += medium_at(scene, Vec3(scene.camera.to_world[3]), scene.camera.medium, transform_point(volume.to_world, local)) == medium;
    }
    return found;
}

bool meets_a_shape_of(const Scene& scene, const Volume& volume, int medium)
{
    return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& s) { return s.interior == medium && boxes_overlap(bounds_of(s), bounds_of(volume), 0); });
}

}  // namespace

void warn_of_grids(SceneBuilder& builder)
{
    const Scene& scene = builder.scene;
    for (std::size_t i = 0; i < scene.media.size(); ++i) {
        const Medium& medium = scene.media[i];
        const int index = static_cast<int>(i);
        if (medium.density == none || !referred_to(scene, index)) continue;
        const Volume& volume = scene.volumes[static_cast<std::size_t>(medium.density)];
        const int found = places_in(scene, volume, index);
        if (found == 9) continue;
        const std::string title = fmt::format("volume {}: ", in_quotes(volume.name));
        if (found == 0 && !meets_a_shape_of(scene, volume, index))
            builder.warn(volume.where, title + fmt::format("no shape that holds the medium {} is where its box is, so there is nothing of it; move either with to_world", in_quotes(medium.name)));
        else
            builder.warn(volume.where, title + fmt::format("its box sticks out of what holds the medium {}; the smoke that is outside is not rendered", in_quotes(medium.name)));
    }
}

}  // namespace tyndall

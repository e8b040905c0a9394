#include "library/backend_media.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "kernels/shared/host_features.hpp"
#include "library/scene_from_description.hpp"
#include "scene/phases.hpp"
#include "scene/volume_values.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

constexpr std::size_t most_planes = 64;  ///< kernels/stages/leg.h

Container container_of(const api::Container& from, const BackendSpace& space, std::size_t media, std::size_t number)
{
    const auto require = [&](bool holds, const std::string& what) {
        if (!holds) throw UsageError(fmt::format("container {}: {}", number, what));
    };
    require(from.medium < media, fmt::format("medium {} of {}", from.medium, media));
    require(from.planes.size() >= 4 && from.planes.size() <= most_planes, fmt::format("{} planes; a convex polyhedron has 4, and at most {} are taken", from.planes.size(), most_planes));
    Container container{.medium = static_cast<int>(from.medium), .shape = none, .planes = {}};
    for (const auto& [x, y, z, offset] : from.planes) {
        const Vec3 n(x, y, z);
        const double length = glm::length(n);
        require(std::isfinite(length) && length > 0 && std::isfinite(offset), "the normal of a plane has no length, or a number is not finite");
        container.planes.push_back({n / length, (offset - glm::dot(n, space.centre)) / (length * space.unit)});
    }
    return container;
}

/// To render space.
void move_media(Scene& scene, const BackendSpace& space)
{
    for (Volume& volume : scene.volumes) {
        for (int axis = 0; axis < 3; ++axis) volume.to_world[axis] /= space.unit;
        volume.to_world[3] = glm::dvec4(space.to_render(Vec3(volume.to_world[3])), 1);
    }
    for (Medium& medium : scene.media) {
        medium.sigma_t *= space.unit;
        const Rgb largest = glm::max(medium.sigma_t, largest_extinction(scene, medium));
        if (!(tyndall::largest(largest) <= std::numeric_limits<float>::max())) throw UsageError(fmt::format("medium \"{}\": sigma_t is too large for a box this large", medium.name));
    }
}

std::uint32_t mask_of(const Scene& scene, const api::BackendDescription& description)
{
    std::uint32_t mask = 0;
    for (const Medium& m : scene.media) {
        if (!scatters_evenly(m.phase)) mask |= feature_bit::anisotropic;
        if (has_lobes(m.phase)) mask |= feature_bit::phase_lobes | feature_bit::anisotropic;
        if (m.sigma_t.r != m.sigma_t.g || m.sigma_t.g != m.sigma_t.b) mask |= feature_bit::coloured;
        if (!m.homogeneous()) mask |= feature_bit::heterogeneous;
    }
    if (scene.media.size() > 1) mask |= feature_bit::many_media;
    if (description.occluded || description.transmittance) mask |= feature_bit::occluders;
    if (!description.containers.empty()) mask |= feature_bit::boundaries;
    if (description.transmittance) mask |= feature_bit::boundaries | feature_bit::nonconvex_media;
    return mask;
}

}  // namespace

BackendMedia::BackendMedia(const api::BackendDescription& description, const BackendSpace& space)
{
    if (description.media.empty()) throw UsageError("there is no medium, so nothing scatters");
    if (description.occluded && description.transmittance) throw UsageError("occluded and transmittance exclude each other: a transmittance of 0 says that something stands between");
    if (description.transmittance && !description.containers.empty()) throw UsageError("containers and transmittance exclude each other: one of them says where media are");
    scene.file = "backend";
    for (std::size_t i = 0; i < description.media.size(); ++i) add_medium(description.media[i], Place("backend", fmt::format("medium {} \"{}\"", i, description.media[i].name)), scene);
    move_media(scene, space);
    for (std::size_t i = 0; i < description.containers.size(); ++i) features.containers.push_back(container_of(description.containers[i], space, scene.media.size(), i));
    features.media_to_media = features.media_to_surface = mask_of(scene, description);
}

std::uint64_t BackendMedia::bytes() const
{
    std::uint64_t bytes = 0;
    for (const Volume& volume : scene.volumes) bytes += volume.values.size() * sizeof(float);
    return bytes;
}

}  // namespace tyndall

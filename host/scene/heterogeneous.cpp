// Media whose extinction or albedo varies in space.
#include <fmt/format.h>

#include "scene/text.hpp"
#include "scene/volume_values.hpp"
#include "scene/volumes.hpp"

namespace tyndall {

namespace {

bool is_one_value(const VolumeStatistics& statistics) { return statistics.least == statistics.largest; }

/// Volumes must be meant for something.
void check_roles(Properties& properties)
{
    const std::vector<std::string> roles{"sigma_t", "albedo"};
    for (const Nested& volume : properties.nested("volume"))
        if (volume.role != roles[0] && volume.role != roles[1])
            refuse(volume.mention->where, fmt::format("{}: the volume needs name=\"sigma_t\" or name=\"albedo\"{}", properties.title(), suggestion(volume.role, roles)));
}

void check_albedo(Properties& properties, const VolumeValue& albedo)
{
    const Rgb largest = albedo.voxels ? statistics_of(*albedo.voxels).largest : albedo.constant;
    for (int c = 0; c < 3; ++c) {
        if (largest[c] <= 1) continue;
        if (albedo.voxels) refuse(albedo.voxels->where, fmt::format("{}: a voxel of {} is {}; albedo must lie between 0 and 1", properties.title(), printable(albedo.voxels->name), largest[c]));
        properties.refuse_parameter("albedo", fmt::format("albedo = {} must lie between 0 and 1", largest[c]));
    }
}

/// An albedo of one value is that value: beyond the box of its voxels it goes on, so the box does not matter.
VolumeValue simplified(VolumeValue albedo)
{
    if (!albedo.voxels) return albedo;
    const VolumeStatistics statistics = statistics_of(*albedo.voxels);
    if (is_one_value(statistics)) return {.constant = statistics.largest};
    return albedo;
}

void set_albedo(SceneBuilder& builder, Properties& properties, Medium& medium, const VolumeValue& albedo)
{
    medium.albedo = albedo.constant;
    if (!albedo.voxels) return;
    if (medium.density == none)
        refuse(albedo.voxels->where, fmt::format("{}: albedo varies but sigma_t does not, so nothing says where the medium ends; give sigma_t as a gridvolume, of one voxel if it "
                                                 "is to be constant in a box",
                                                 properties.title()));
    const auto over = reaching_over(*albedo.voxels, builder.scene.volumes[static_cast<std::size_t>(medium.density)], most_voxels);
    if (!over)
        refuse(albedo.voxels->where, fmt::format("{}: the grid of the albedo covers so little of that of sigma_t that it would take more than {:.0f} voxels of its size; give it a "
                                                 "to_world that covers more",
                                                 properties.title(), most_voxels));
    medium.albedo = statistics_of(*over).largest;
    medium.albedo_volume = add_volume(builder, *over);
}

}  // namespace

void read_heterogeneous(SceneBuilder& builder, Properties& properties, Medium& medium)
{
    const double scale = properties.real("scale", 1, Range::not_negative());
    const VolumeValue sigma_t = read_varying(builder, properties, "sigma_t", Rgb(1));
    VolumeValue albedo = read_varying(builder, properties, "albedo", Rgb(.75));
    check_roles(properties);
    check_albedo(properties, albedo);
    albedo = simplified(std::move(albedo));
    properties.boolean("has_spectral_extinction", true);  // how Mitsuba's integrators sample: nothing that changes the image
    medium.sigma_t = scale * sigma_t.constant;
    const bool empty = sigma_t.voxels && (scale == 0 || statistics_of(*sigma_t.voxels).largest == Rgb(0));
    if (empty) {
        builder.warn(sigma_t.voxels->where, fmt::format("{}: {}; the medium is empty", properties.title(),
                                                        scale == 0 ? "scale is 0" : "every voxel of " + printable(sigma_t.voxels->name) + " is 0"));
        medium.sigma_t = medium.albedo = Rgb(0);
        return;
    }
    if (sigma_t.voxels) {
        medium.sigma_t = Rgb(scale);
        medium.density = add_volume(builder, *sigma_t.voxels);
    }
    set_albedo(builder, properties, medium, albedo);
    if (medium.homogeneous())
        builder.warn(medium.where, properties.title() + ": nothing about it varies, so it fills its shape like a homogeneous one (Mitsuba would fill only the cube from (0, 0, 0) to "
                                                        "(1, 1, 1)); write type=\"homogeneous\"");
}

}  // namespace tyndall

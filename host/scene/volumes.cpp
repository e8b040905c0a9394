#include "scene/volumes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/text.hpp"
#include "scene/transforms.hpp"
#include "scene/volume_values.hpp"

namespace tyndall {

namespace {

/// The voxels of the file that `filename` names, decoded by `read` at the first call for that file and grid.
template <class Read>
const VolumeFile& volume_file(SceneBuilder& builder, Properties& properties, const std::string& grid, Read&& read)
{
    const std::string name = properties.text("filename", "");
    if (name.empty()) properties.refuse_parameter("filename", "needs <string name=\"filename\" value=\"...\"/>");
    const SourceLocation where = properties.where_is("filename");
    const std::pair key(builder.files.find(name, where), grid);
    if (const auto known = builder.volume_files.find(key); known != builder.volume_files.end()) return known->second;
    SceneFiles::Content content = builder.files.read(name, where, largest_volume_file);
    try {
        return builder.volume_files.emplace(key, read(std::move(content.bytes))).first->second;
    } catch (const VolumeFault& fault) {
        refuse(where, fmt::format("{}: {}: {}", properties.title(), printable(name), fault.what()));
    }
}

/// The unit cube onto the box that the file names.
Mat4 box_of(Properties& properties, const VolumeFile& file)
{
    const Vec3 low(file.box[0], file.box[1], file.box[2]), high(file.box[3], file.box[4], file.box[5]);
    for (int axis = 0; axis < 3; ++axis)
        if (!(low[axis] < high[axis]) || !std::isfinite(low[axis]) || !std::isfinite(high[axis]))
            properties.refuse_parameter("use_grid_bbox", fmt::format("the file's box reaches from ({}, {}, {}) to ({}, {}, {}), which is no box; leave use_grid_bbox out and place "
                                                                     "the unit cube with to_world",
                                                                     low.x, low.y, low.z, high.x, high.y, high.z));
    return translation(low) * scaling(high - low);
}

/// A transform out of a file has not been looked at by read_transform.
void check_placement(Properties& properties, const Mat4& to_world)
{
    double edges = 1;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(to_world[column][row]) <= largest_coordinate)) properties.refuse_parameter("filename", fmt::format("the grid's transform leads beyond {:g}", largest_coordinate));
        if (column < 3) edges *= glm::length(Vec3(to_world[column]));
    }
    // 1e-12: as for every <transform>
    if (!(std::abs(glm::determinant(glm::dmat3(to_world))) > 1e-12 * edges)) properties.refuse_parameter("filename", "the grid's transform flattens space; it must have an inverse");
}

Volume volume_of(const VolumeFile& file, Properties& properties)
{
    return {.name = properties.text("filename", ""), .size_x = file.size_x, .size_y = file.size_y, .size_z = file.size_z, .channels = file.channels, .values = file.values,
            .to_world = properties.transform("to_world") * file.placement, .where = properties.where()};
}

Volume read_grid(SceneBuilder& builder, Properties& properties)
{
    const VolumeFile& file = volume_file(builder, properties, "", read_vol);
    Volume volume = volume_of(file, properties);
    if (properties.boolean("use_grid_bbox", false)) volume.to_world = volume.to_world * box_of(properties, file);
    properties.choice("filter_type", "trilinear", {"trilinear"});
    properties.choice("wrap_mode", "clamp", {"clamp"});
    for (const char* without_effect : {"raw", "accel"}) properties.boolean(without_effect, false);  // spectral colours and graphics hardware, of which there are none here
    return volume;
}

Volume read_open_vdb(SceneBuilder& builder, Properties& properties)
{
    const std::string grid = properties.text("grid", "density");
    const VolumeFile& file = volume_file(builder, properties, grid, [&](std::string bytes) { return read_vdb(std::move(bytes), grid); });
    Volume volume = volume_of(file, properties);
    check_placement(properties, volume.to_world);
    return volume;
}

VolumeValue read_volume(SceneBuilder& builder, const XmlElement& element)
{
    Properties properties(element, builder.document);
    VolumeValue value;
    if (properties.type() == "constvolume") {
        value.constant = properties.colour("value", Rgb(1), Range::not_negative());
    } else if (properties.type() == "gridvolume") {
        value.voxels = read_grid(builder, properties);
    } else if (properties.type() == "openvdbvolume") {
        value.voxels = read_open_vdb(builder, properties);
    } else {
        properties.refuse_type({"gridvolume", "openvdbvolume", "constvolume"});
    }
    properties.finish();
    return value;
}

}  // namespace

VolumeValue read_varying(SceneBuilder& builder, Properties& properties, const std::string& name, const Rgb& fallback)
{
    const std::vector<Nested> volumes = properties.nested("volume");
    const auto named = [&](const Nested& volume) { return volume.role == name; };
    const auto found = std::find_if(volumes.begin(), volumes.end(), named);
    if (found == volumes.end()) return {.constant = properties.colour(name, fallback, Range::not_negative())};
    if (properties.has(name)) properties.refuse_parameter(name, fmt::format("{} is given twice, as <{}> and as <volume>", name, properties.written_as(name)));
    if (const auto second = std::find_if(found + 1, volumes.end(), named); second != volumes.end())
        refuse(second->mention->where, fmt::format("{}: a second volume {}", properties.title(), name));
    return read_volume(builder, *found->object);
}

int add_volume(SceneBuilder& builder, Volume volume)
{
    std::vector<Volume>& volumes = builder.scene.volumes;
    double voxels = static_cast<double>(volume.values.size());
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const bool same_element = volumes[i].where.line == volume.where.line && volumes[i].where.column == volume.where.column && volumes[i].where.file == volume.where.file;
        if (same_element && volumes[i].name == volume.name && volumes[i].to_world == volume.to_world && volumes[i].values.size() == volume.values.size()) return static_cast<int>(i);
        voxels += static_cast<double>(volumes[i].values.size());
    }
    if (voxels > most_voxels) refuse(volume.where, fmt::format("the volumes of the scene have {:.0f} voxels up to here; {:.0f} are possible", voxels, most_voxels));
    volumes.push_back(std::move(volume));
    return static_cast<int>(volumes.size()) - 1;
}

}  // namespace tyndall

// The one file that includes OpenVDB: a sparse grid out of a .vdb file, as a dense box of voxels.
#include <fmt/format.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include <iostream>
#include <sstream>

#include "scene/text.hpp"
#include "scene/vdb_header.hpp"
#include "scene/volume_files.hpp"

namespace tyndall {

namespace {

constexpr double most_voxels_of_file = static_cast<double>(largest_volume_file) / sizeof(float);

std::string names_of(const openvdb::GridPtrVec& grids)
{
    std::string names;
    for (const auto& grid : grids) names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", in_quotes(grid->getName()), printable(grid->valueType()));
    return names;
}

openvdb::FloatGrid::Ptr grid_named(const openvdb::GridPtrVec& grids, const std::string& name)
{
    for (const auto& grid : grids) {
        if (!grid || grid->getName() != name) continue;
        if (auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid)) return floats;
        throw VolumeFault(fmt::format("the grid {} holds values of the type {}; only grids of the type float are read", in_quotes(name), in_quotes(grid->valueType())));
    }
    throw VolumeFault(fmt::format("has no grid named {}; {}", in_quotes(name), grids.empty() ? "it is empty" : "it holds " + names_of(grids)));
}

/// The box of the active voxels, after checking that there are some and that a dense copy has a size that a scene may have.
openvdb::CoordBBox checked_box(const openvdb::FloatGrid& grid)
{
    const std::string title = "the grid " + in_quotes(grid.getName());
    if (grid.getGridClass() == openvdb::GRID_LEVEL_SET) throw VolumeFault(title + " is a level set, a distance to a surface; export it as a fog volume");
    if (!grid.transform().isLinear()) throw VolumeFault(title + " lies in a frustum; resample it into a box");
    const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
    if (box.empty()) throw VolumeFault(title + " has no active voxel");
    double voxels = 1;
    for (int axis = 0; axis < 3; ++axis) voxels *= static_cast<double>(box.max()[axis]) - box.min()[axis] + 1;
    if (voxels > most_voxels_of_file)
        throw VolumeFault(fmt::format("{} reaches from ({}, {}, {}) to ({}, {}, {}): {:g} voxels as a box, of which {:g} are possible; crop it or make it coarser", title, box.min().x(),
                                      box.min().y(), box.min().z(), box.max().x(), box.max().y(), box.max().z(), voxels, most_voxels_of_file));
    return box;
}

/// The unit cube onto the box, whose voxels have their centres at whole numbers, and on by the grid's transform.
Mat4 placement_of(const openvdb::FloatGrid& grid, const openvdb::CoordBBox& box)
{
    const openvdb::Vec3d low = box.min().asVec3d() - .5, size = box.dim().asVec3d();
    const auto placed = [&](const openvdb::Vec3d& local) {
        const openvdb::Vec3d p = grid.transform().indexToWorld(low + local * size);
        return Vec3(p.x(), p.y(), p.z());
    };
    const Vec3 origin = placed({0, 0, 0});
    const auto axis = [&](const openvdb::Vec3d& end) { return glm::dvec4(placed(end) - origin, 0); };
    return Mat4(axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1}), glm::dvec4(origin, 1));
}

/// Nothing that is written to standard output arrives there: OpenVDB's warnings do not belong among the data of `--json`.
class QuietOutput {
public:
    QuietOutput() : kept_(std::cout.rdbuf(nullptr)) {}
    ~QuietOutput() { std::cout.rdbuf(kept_); }
    QuietOutput(const QuietOutput&) = delete;
    QuietOutput& operator=(const QuietOutput&) = delete;

private:
    std::streambuf* kept_;
};

openvdb::GridPtrVecPtr grids_of(std::string bytes)
{
    const QuietOutput quiet;
    openvdb::initialize();
    std::istringstream stream(std::move(bytes));
    stream.exceptions(std::ios::failbit | std::ios::badbit);  // OpenVDB does not ask: behind the end of the file it would go on with what it read last
    openvdb::io::Stream archive(stream, false);  // with delayed loading it would write a temporary file
    return archive.getGrids();
}

}  // namespace

VolumeFile read_vdb(std::string bytes, const std::string& name)
{
    check_vdb_header(bytes, openvdb::OPENVDB_FILE_VERSION);
    try {
        const openvdb::GridPtrVecPtr grids = grids_of(std::move(bytes));
        const openvdb::FloatGrid::Ptr grid = grid_named(*grids, name);
        const openvdb::CoordBBox box = checked_box(*grid);
        const openvdb::Coord size = box.dim();
        VolumeFile file{.size_x = size.x(), .size_y = size.y(), .size_z = size.z(), .placement = placement_of(*grid, box)};
        file.values.resize(static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(size.z()));
        openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, file.values.data());
        openvdb::tools::copyToDense(*grid, dense);
        finish_volume(file);
        return file;
    } catch (const VolumeFault&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw VolumeFault("asks for more memory than there is; it is damaged or too large");
    } catch (const std::exception& error) {
        throw VolumeFault("OpenVDB cannot read it: " + printable(error.what()));
    }
}

}  // namespace tyndall

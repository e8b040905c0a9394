/// Meshes, voxels and images.
#include <string>

#include "film/exr.hpp"
#include "memory_file.hpp"
#include "promises.hpp"
#include "scene/mesh_files.hpp"
#include "scene/picture_files.hpp"
#include "scene/vdb_header.hpp"
#include "scene/volume_files.hpp"
#include "tyndall/error.hpp"

namespace tyndall::fuzz {
namespace {

template <class Read>
void read_mesh(Read&& read)
{
    try {
        check_mesh(read().mesh);
    } catch (const MeshFault&) {
    }
}

template <class Read>
void read_volume(Read&& read)
{
    try {
        const VolumeFile file = read();
        require(file.size_x >= 1 && file.size_y >= 1 && file.size_z >= 1, "a grid has a voxel");
        require(file.channels == 1 || file.channels == 3, "a grid has one channel or three");
        require(file.values.size() == std::size_t(file.size_x) * std::size_t(file.size_y) * std::size_t(file.size_z) * std::size_t(file.channels), "a grid has its voxels");
        for (const float value : file.values) require(std::isfinite(value) && value >= 0 && !std::signbit(value), "voxels are finite and not negative");
    } catch (const VolumeFault&) {
    }
}

}  // namespace

void obj(Bytes bytes)
{
    read_mesh([&] { return read_obj(text_of(bytes)); });
}

void ply(Bytes bytes)
{
    read_mesh([&] { return read_ply(text_of(bytes)); });
}

void vol(Bytes bytes)
{
    read_volume([&] { return read_vol(text_of(bytes)); });
}

void vdb_header(Bytes bytes)
{
    if (bytes.empty()) return;
    try {
        check_vdb_header(text_of(bytes.subspan(1)), 224);
    } catch (const VolumeFault&) {
    }
}

void vdb(Bytes bytes)
{
    if (bytes.empty()) return;
    const std::string name = bytes[0] % 2 ? "density" : "";
    read_volume([&] { return read_vdb(std::string(text_of(bytes.subspan(1))), name); });
}

void picture(Bytes bytes)
{
    try {
        const Picture read = read_picture(text_of(bytes));
        require(read.width >= 1 && read.height >= 1, "a picture has a pixel");
        require(read.channels == 1 || read.channels == 3, "a picture has one channel or three");
        require(read.values.size() == std::size_t(read.width) * std::size_t(read.height) * std::size_t(read.channels), "a picture has its pixels");
        for (const float value : read.values) require(std::isfinite(value), "pixels are finite");
    } catch (const PictureFault&) {
    }
}

void exr(Bytes bytes)
{
    const MemoryFile file(bytes);
    try {
        const ExrImage image = read_exr(file.path());
        require(image.width >= 1 && image.height >= 1, "an image has a pixel");
        for (const auto& [name, channel] : image.channels)
            require(channel.values.size() == std::size_t(image.width) * std::size_t(image.height), "a channel has its pixels");
    } catch (const IoError&) {
    }
}

}  // namespace tyndall::fuzz

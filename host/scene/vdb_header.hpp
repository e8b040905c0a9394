#pragma once
/// What an OpenVDB file says before its voxels, against the bytes that are there: OpenVDB itself takes the memory that a text or a value asks for, up to 4 GiB, before it looks whether
/// the file goes on so far.
#include <cstdint>
#include <string_view>

namespace tyndall {

/// Throws VolumeFault unless texts, metadata and the number of grids fit into the file: its own metadata and those of its first grid, which for files with one grid are all that there are.
/// Formats before 222 (OpenVDB 2.0, 2013), which were laid out otherwise, and those after `newest_format`, OpenVDB's own, are refused.
void check_vdb_header(std::string_view bytes, std::uint32_t newest_format);

}  // namespace tyndall

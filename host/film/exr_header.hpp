#pragma once
/// What an OpenEXR file's header claims, against the bytes that are there: OpenEXR itself takes the memory that an attribute asks for before it looks whether the file goes on so far.
#include <filesystem>

namespace tyndall {

/// Does every attribute of the (first) header end inside the file? Nothing is said about what the attributes hold. False, too, for a file that ends within its header.
bool exr_header_fits(const std::filesystem::path& file);

}  // namespace tyndall

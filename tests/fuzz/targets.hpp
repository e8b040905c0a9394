#pragma once
/// What is fuzzed: every reader of bytes that somebody else wrote. Each target takes any bytes at all and returns; what it may throw it catches itself, and what was read
/// must keep the reader's promises. Anything else, an error of a sanitizer included, is a finding.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tyndall::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline std::string_view text_of(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// Ends the program, saying which promise was broken.
void require(bool kept, const char* promise);

void scene(Bytes);       ///< scene XML, with tests/fuzz/files as its folder
void obj(Bytes);
void ply(Bytes);
void vol(Bytes);
void vdb_header(Bytes);  ///< what of a .vdb is read before OpenVDB sees it; the first byte is passed over
void vdb(Bytes);         ///< the first byte chooses the grid's name
void exr(Bytes);
void picture(Bytes);     ///< of a texture or an environment map: PNG or OpenEXR
void checkpoint(Bytes);  ///< a state file; if the first byte is odd, the rest is content, which gets the frame and the checksum that it needs
void shards(Bytes);      ///< two state files in one, to be merged: a little-endian 32-bit length, the first, then the second
void numbers(Bytes);     ///< the first byte chooses an option, the rest is its value

}  // namespace tyndall::fuzz

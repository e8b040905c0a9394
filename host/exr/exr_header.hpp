#pragma once
/// What the header of an OpenEXR file claims, read before OpenEXR reads it: OpenEXR takes the memory that a header asks for before it looks whether the file goes on so far.
#include <cstdint>
#include <stdexcept>

#include <ImfIO.h>

namespace tyndall {

/// What is wrong with an OpenEXR file: "is incomplete". Readers add the file's name.
struct ExrFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Walks over the header of a file of so many bytes as OpenEXR 3.1 does. Throws ExrFault for what is no OpenEXR file, is deep or has several parts or subsampled channels; for a header that ends behind the file; for
/// attributes whose stated size is not what OpenEXR reads of their type, behind which it would take any bytes for names and sizes; for more pixels than a file of so many bytes can hold, and for blocks of pixels
/// far larger than the picture. What OpenEXR then takes is in proportion to the file, or 256 MiB for a buffer. Leaves the stream at its beginning.
void check_exr_header(Imf::IStream& stream, std::uint64_t bytes);

}  // namespace tyndall

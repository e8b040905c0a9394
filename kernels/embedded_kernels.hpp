#pragma once
/// The text of every file below kernels/, carried by the program.
#include <cstddef>
#include <span>

namespace tyndall {

struct EmbeddedKernel {
    const char* path;  ///< from the repository's root: "kernels/math/rod.h"
    const char* text;
    std::size_t size;
};
const std::span<const EmbeddedKernel> embedded_kernels();

}  // namespace tyndall

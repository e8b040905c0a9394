#pragma once
/// The library between the program and the drivers. Includes no OpenCL header.
#include <string>

namespace tyndall {

/// "OpenCL ICD Loader 2.3.1 (OCL Icd free software), OpenCL 3.0": the loader that this process has, by its own words. "" if it says nothing of itself, as loaders without the extension do.
/// Reads the drivers that there are, as the loader does on the first call of any kind. Throws nothing of its own.
std::string opencl_loader();

}  // namespace tyndall

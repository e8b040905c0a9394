#pragma once
/// The one place that configures Khronos' C++ bindings. Only files below host/device include this.
#define CL_HPP_TARGET_OPENCL_VERSION 300
#define CL_HPP_MINIMUM_OPENCL_VERSION 200  // Debian's header fails with 120 when the target is 300
#define CL_HPP_ENABLE_EXCEPTIONS
#include <CL/opencl.hpp>

#include "device/device_list.hpp"

namespace tyndall {

/// The n-th device of list_devices(). Throws NoDeviceError if it is gone.
cl::Device device_at(int index);

/// Of a device that list_devices() has. Throws NoDeviceError for another, and for one that is not usable.
DeviceInfo info_of(const cl::Device& device);

/// "CL_OUT_OF_RESOURCES (-5)".
std::string opencl_error_name(int code);

}  // namespace tyndall

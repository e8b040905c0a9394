#pragma once
/// A device in use: its context, queue and what has been measured on it. Includes no OpenCL header.
#include <cstdint>
#include <memory>
#include <string>

#include "device/device_list.hpp"
#include "tyndall/opencl_handles.hpp"

namespace tyndall {

struct DeviceState;  // device/device_state.hpp

class Device {
public:
    /// Opens the device that `request` names (device_list.hpp). Throws NoDeviceError, DeviceError.
    explicit Device(const std::string& request = "");
    /// Uses the caller's objects. Throws UsageError where they do not belong together or the queue is out of order, NoDeviceError for a device that the loader does not list, DeviceError.
    explicit Device(const OpenClHandles& handles);
    ~Device();
    Device(Device&&) noexcept;

    const DeviceInfo& info() const;
    /// Programs built so far in this process for this device.
    std::uint64_t programs_built() const;
    /// Stages that are made from now on keep their launches below so many seconds, as far as what earlier launches took can tell (launch_budget.hpp).
    void bound_launches(double seconds);
    /// Writes the source of every program into the folder before it is built from now on, named by a hash of its text and options; empty: no longer.
    void dump_kernels(const std::string& folder);
    /// False: the driver has no clock of its own, and times are those of the wall.
    bool time_stamps() const;
    DeviceState& state() { return *state_; }

private:
    std::unique_ptr<DeviceState> state_;
};

}  // namespace tyndall

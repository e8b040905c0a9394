#pragma once
namespace tyndall {

/// OpenCL objects of the caller, as void* so that no OpenCL header is needed. They are retained while they are in use, never changed, and never released more often than that.
struct OpenClHandles {
    void* context = nullptr;  ///< cl_context that holds the device
    void* device = nullptr;   ///< cl_device_id
    void* queue = nullptr;    ///< cl_command_queue of both, in order; null: one is made
};

}  // namespace tyndall

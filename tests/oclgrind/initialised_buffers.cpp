/// Oclgrind 21.10 does not count what clEnqueueFillBuffer writes as written: here it is a clEnqueueWriteBuffer, in front of the loader's.
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

#include <cstring>
#include <vector>

extern "C" cl_int clEnqueueFillBuffer(cl_command_queue queue, cl_mem buffer, const void* pattern, size_t pattern_size, size_t offset, size_t size, cl_uint waits, const cl_event* wait_for,
                                      cl_event* event)
{
    std::vector<unsigned char> bytes(size);
    for (size_t i = 0; i < size; i += pattern_size) std::memcpy(bytes.data() + i, pattern, pattern_size);
    return clEnqueueWriteBuffer(queue, buffer, CL_TRUE, offset, size, bytes.data(), waits, wait_for, event);
}

#include "selftest/bundle.hpp"

namespace tyndall {

constexpr const char* program = R"(/* Replays one launch of a Tyndall selftest: builds ../kernel.cl with ../build_options.txt, runs evaluate_cases on in.f32 and compares with low.f32 and high.f32.
 *   cc -std=c99 replay.c -o replay -lOpenCL -lm
 *   ./replay lanes16/Row01...-rod [DEVICE]      DEVICE: number over all platforms, 0 first
 * Exit code: 0 every output is within its interval, 1 one is not, 2 it could not be run. */
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *folder;

static void stop(const char *what, int code)
{
    fprintf(stderr, "%s: %d\n", what, code);
    exit(2);
}

/* A whole file, with a 0 behind it. */
static void *read_file(const char *name, size_t *size)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    if (!file) stop(path, 0);
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char *bytes = malloc(*size + 1);
    if (!bytes || fread(bytes, 1, *size, file) != *size) stop(path, 1);
    bytes[*size] = 0;
    fclose(file);
    return bytes;
}

static cl_device_id device_number(unsigned wanted)
{
    cl_platform_id platforms[64];
    cl_uint platform_count = 0;
    if (clGetPlatformIDs(64, platforms, &platform_count)) stop("clGetPlatformIDs", 0);
    for (cl_uint p = 0; p < platform_count && p < 64; ++p) {
        cl_device_id devices[64];
        cl_uint count = 0;
        if (clGetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, 64, devices, &count)) continue;
        if (wanted < count) return devices[wanted];
        wanted -= count;
    }
    stop("no such device", (int)wanted);
    return 0;
}

static cl_kernel build(cl_context context, cl_device_id device)
{
    size_t size;
    const char *source = read_file("../kernel.cl", &size), *options = read_file("../build_options.txt", &size);
    cl_int error;
    cl_program program = clCreateProgramWithSource(context, 1, &source, NULL, &error);
    if (error) stop("clCreateProgramWithSource", error);
    if ((error = clBuildProgram(program, 1, &device, options, NULL, NULL))) {
        char log[65536] = "";
        clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, sizeof log - 1, log, NULL);
        fprintf(stderr, "%s\n", log);
        stop("clBuildProgram", error);
    }
    cl_kernel kernel = clCreateKernel(program, "evaluate_cases", &error);
    if (error) stop("clCreateKernel", error);
    return kernel;
}

/* The buffers that all launches share: arguments 4, 5 and 6. */
static void set_tables(cl_context context, cl_kernel kernel)
{
    static const char *const names[3] = {"../../values.f32", "../../lobes.bin", "../../grids.bin"};
    for (cl_uint i = 0; i < 3; ++i) {
        size_t size;
        cl_int error;
        void *bytes = read_file(names[i], &size);
        cl_mem buffer = clCreateBuffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, size, bytes, &error);
        if (error) stop("clCreateBuffer", error);
        clSetKernelArg(kernel, 4 + i, sizeof buffer, &buffer);
    }
}

static int compare(const float *out, unsigned count, unsigned sets, int is_mean, double mean_low, double mean_high)
{
    size_t size;
    int outside = 0;
    if (is_mean) {
        const double *weight = read_file("weight.f64", &size);
        double mean = 0;
        for (unsigned i = 0; i < sets; ++i) mean += weight[i] * out[i];
        outside = !(mean_low <= mean && mean <= mean_high);
        printf("mean %.9g, expected within [%.9g, %.9g]\n", mean, mean_low, mean_high);
    } else {
        const float *low = read_file("low.f32", &size), *high = read_file("high.f32", &size);
        for (unsigned i = 0; i < sets; ++i)
            for (unsigned k = 0; k < 4; ++k) {
                const unsigned at = k * count + i;
                if (low[at] <= out[at] && out[at] <= high[at]) continue;
                printf("set %u, output %u: %.9g, expected within [%.9g, %.9g]\n", i, k, out[at], low[at], high[at]);
                ++outside;
            }
    }
    printf("%d outside\n", outside);
    return outside != 0;
}

int main(int argc, char **argv)
{
    if (argc < 2) stop("usage: replay FOLDER [DEVICE]", 0);
    folder = argv[1];
    size_t size;
    unsigned sampler, lanes, count, sets;
    int is_mean;
    double mean_low, mean_high;
    if (sscanf(read_file("launch.txt", &size), "%u %u %u %u %d %lf %lf", &sampler, &lanes, &count, &sets, &is_mean, &mean_low, &mean_high) != 7) stop("launch.txt", 0);
    cl_device_id device = device_number(argc > 2 ? (unsigned)atoi(argv[2]) : 0);
    cl_int error = 0;
    cl_context context = clCreateContext(NULL, 1, &device, NULL, NULL, &error);
    if (error) stop("clCreateContext", error);
    cl_command_queue queue = clCreateCommandQueue(context, device, 0, &error);
    cl_kernel kernel = build(context, device);
    float *in = read_file("in.f32", &size), *out = calloc(4 * (size_t)count, sizeof(float));
    cl_mem in_buffer = clCreateBuffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, size, in, &error);
    if (error) stop("clCreateBuffer", error);
    cl_mem out_buffer = clCreateBuffer(context, CL_MEM_WRITE_ONLY, 4 * (size_t)count * sizeof(float), NULL, &error);
    if (error) stop("clCreateBuffer", error);
    cl_uint arguments[2] = {sampler, count};
    clSetKernelArg(kernel, 0, sizeof(cl_uint), &arguments[0]);
    clSetKernelArg(kernel, 1, sizeof in_buffer, &in_buffer);
    clSetKernelArg(kernel, 2, sizeof(cl_uint), &arguments[1]);
    clSetKernelArg(kernel, 3, sizeof out_buffer, &out_buffer);
    set_tables(context, kernel);
    size_t local = 8, global = (count / lanes + local - 1) / local * local;
    if ((error = clEnqueueNDRangeKernel(queue, kernel, 1, NULL, &global, &local, 0, NULL, NULL))) stop("clEnqueueNDRangeKernel", error);
    if ((error = clEnqueueReadBuffer(queue, out_buffer, CL_TRUE, 0, 4 * (size_t)count * sizeof(float), out, 0, NULL, NULL))) stop("clEnqueueReadBuffer", error);
    return compare(out, count, sets, is_mean, mean_low, mean_high);
}
)";

const char* replay_program() { return program; }

}  // namespace tyndall

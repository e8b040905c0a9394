#include "selftest/bundle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "device/case_evaluator.hpp"
#include "film/atomic_file.hpp"
#include "kernels/selftest/case_tables.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Raw, as OpenCL sees them; devices are little-endian (host/device/device_list.cpp refuses others), and so is the host that shares their memory.
void write_raw(const fs::path& file, const auto& values)
{
    write_atomically(file, {reinterpret_cast<const char*>(std::data(values)), std::size(values) * sizeof(*std::data(values))});
}

/// One field of the expected outputs, [output][set] as the kernel writes them; sets that only fill the last group expect what the last one does.
std::vector<float> expected_field(const SelftestLaunch<float>& launch, std::size_t count, float GoldenOutput<float>::*field)
{
    std::vector<float> values(case_outputs * count);
    for (std::size_t k = 0; k < case_outputs; ++k)
        for (std::size_t i = 0; i < count; ++i) values[k * count + i] = launch.sets[std::min(i, launch.sets.size() - 1)]->out[k].*field;
    return values;
}

std::vector<float> device_outputs(const SelftestLaunch<float>& launch, std::size_t count)
{
    std::vector<float> values(case_outputs * count);
    for (std::size_t k = 0; k < case_outputs; ++k)
        for (std::size_t i = 0; i < count; ++i) values[k * count + i] = launch.out[std::min(i, launch.out.size() - 1)][k];
    return values;
}

Json buffer(const char* file, const char* type, std::size_t rows, std::size_t count, const char* what)
{
    return {{"file", file}, {"type", type}, {"layout", fmt::format("[{}][{}]", rows, count)}, {"what", what}};
}

Json description(const FailedLaunch& failed, std::size_t count)
{
    Json names = Json::array();
    for (const GoldenSet<float>* set : failed.launch.sets) names.push_back(set->name);
    Json buffers = {buffer("in.f32", "float32 little-endian", case_inputs, count, "the kernel's argument 1"),
                    buffer("out.f32", "float32 little-endian", case_outputs, count, "what the device wrote to argument 3")};
    if (failed.launch.mean) {
        buffers.push_back(buffer("weight.f64", "float64 little-endian", 1, failed.launch.weight.size(), "weights of the nodes; the mean of output 0 is compared"));
    } else {
        buffers.push_back(buffer("value.f32", "float32 little-endian", case_outputs, count, "the right value; NaN: only the interval is known"));
        buffers.push_back(buffer("low.f32", "float32 little-endian", case_outputs, count, "the smallest acceptable value"));
        buffers.push_back(buffer("high.f32", "float32 little-endian", case_outputs, count, "the largest acceptable value"));
    }
    Json json = {{"schema", "tyndall-selftest-launch/1"}, {"case", failed.name},     {"kernel", "evaluate_cases"},
                 {"sampler", failed.launch.sampler},      {"lanes", failed.lanes},   {"count", count},
                 {"sets", failed.launch.in.size()},       {"local_size", 8},         {"buffers", buffers},
                 {"names", names}};
    if (failed.launch.mean) json["mean"] = {{"low", failed.launch.mean->out.low}, {"high", failed.launch.mean->out.high}};
    return json;
}

void make_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw IoError(fmt::format("--bundle: the folder \"{}\" cannot be made: {}; choose another", folder.string(), error.message()));
}

void write_launch(const fs::path& folder, const FailedLaunch& failed)
{
    make_folder(folder);
    const SelftestLaunch<float>& launch = failed.launch;
    const std::vector<float> in = packed_inputs(launch.in, failed.lanes);
    const std::size_t count = in.size() / case_inputs;
    write_raw(folder / "in.f32", in);
    write_raw(folder / "out.f32", device_outputs(launch, count));
    const GoldenOutput<double> mean = launch.mean ? launch.mean->out : GoldenOutput<double>{};
    write_atomically(folder / "launch.txt", fmt::format("{} {} {} {} {} {:.17g} {:.17g}\n", launch.sampler, failed.lanes, count, launch.in.size(), launch.mean ? 1 : 0, mean.low, mean.high));
    write_atomically(folder / "launch.json", description(failed, count).dump(2) + "\n");
    if (launch.mean) return write_raw(folder / "weight.f64", launch.weight);
    write_raw(folder / "value.f32", expected_field(launch, count, &GoldenOutput<float>::value));
    write_raw(folder / "low.f32", expected_field(launch, count, &GoldenOutput<float>::low));
    write_raw(folder / "high.f32", expected_field(launch, count, &GoldenOutput<float>::high));
}

std::string readme(const SelftestResult& result, const std::vector<std::string>& launches)
{
    std::string text = fmt::format(
        "# A kernel that does not give what it must\n\nDevice: {}: {}, driver {}, {}.\n\n"
        "`lanesN/kernel.cl` is one OpenCL C file without includes, built with `lanesN/build_options.txt`; it holds the kernel\n"
        "`evaluate_cases(uint sampler, in, uint count, out, values, lobes, grids)`, one work-item for every N sets of inputs; the last three buffers are `values.f32`,\n"
        "`lobes.bin` and `grids.bin` here, the same for every launch. Each folder below is one launch:\n"
        "`in.f32` and `out.f32` are the buffers as the device read and wrote them, `low.f32` and `high.f32` the interval of every output, `value.f32` the right value\n"
        "computed in 50 digits; `launch.json` says sizes and layouts. All numbers are little-endian.\n\n"
        "To see it again, with any OpenCL 1.2:\n\n    cc -std=c99 replay.c -o replay -lOpenCL\n",
        result.device.platform, result.device.name, result.device.driver, result.device.version);
    for (const std::string& launch : launches) text += "    ./replay " + launch + "\n";
    return text + "\nIt prints what is outside and exits with 1, or with 0 if nothing is. A second argument chooses the device by number over all platforms.\n"
                  "`selftest.json` is the whole report.\n";
}

/// A name that is not taken yet: a row may launch a sampler once for its sets and once for each mean.
std::string launch_name(const FailedLaunch& failed, std::set<std::string>& taken)
{
    const std::string stem = fmt::format("lanes{}/{}-{}{}", failed.lanes, failed.name, sampler_name(failed.launch.sampler), failed.launch.mean ? "-mean" : "");
    std::string name = stem;
    for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}{}", stem, i);
    return name;
}

}  // namespace

void check_bundle_folder(const fs::path& folder)
{
    make_folder(folder);
    std::error_code error;
    if (!fs::is_empty(folder, error) || error) throw IoError(fmt::format("--bundle \"{}\": is not an empty folder; choose another, or empty it", folder.string()));
    check_writable(folder / "README.md");
}

void write_bundle(const fs::path& folder, const SelftestResult& result, const std::string& report)
{
    std::set<std::string> names;
    std::vector<std::string> launches;
    for (const FailedLaunch& failed : result.failed) {
        launches.push_back(launch_name(failed, names));
        write_launch(folder / launches.back(), failed);
    }
    for (const SelftestProgram& program : result.programs) {
        const fs::path own = folder / fmt::format("lanes{}", program.lanes);
        if (!fs::exists(own)) continue;  // nothing failed at this width
        write_atomically(own / "kernel.cl", program.source);
        write_atomically(own / "build_options.txt", program.options);
    }
    write_raw(folder / "values.f32", case_tables::values);
    write_raw(folder / "lobes.bin", case_tables::lobes);
    write_raw(folder / "grids.bin", case_tables::grids);
    write_atomically(folder / "replay.c", replay_program());
    write_atomically(folder / "selftest.json", report);
    write_atomically(folder / "README.md", readme(result, launches));
}

}  // namespace tyndall

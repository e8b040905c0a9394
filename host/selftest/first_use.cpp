#include "selftest/first_use.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>

#include "device/kernel_source.hpp"
#include "film/atomic_file.hpp"
#include "scene/scene_hash.hpp"
#include "selftest/selftest.hpp"
#include "selftest/selftest_output.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

/// Of everything that the check compares: kernels, options, inputs and what they must give. Another commit with the same kernels needs no other check.
std::uint64_t hash_of_check(const FirstUse& use)
{
    SceneHash hash;
    const auto add = [&](const auto& values) { hash.add({reinterpret_cast<const char*>(&values), sizeof values}); };
    hash.add(use.source ? *use.source : flattened_kernel("kernels/selftest/evaluate_cases.cl", {}));
    hash.add(case_options(use.lanes, use.families) + use.device.build_options);
    for (const GoldenSet<float>& set : golden_floats().sets) add(set.sampler), add(set.in), add(set.out);
    for (const GoldenMean<float>& mean : golden_floats().means) add(mean.in), add(mean.out);
    return hash.value();
}

std::string text_of(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Why stamps in this folder mean nothing or cannot be written; empty if all is well. Makes the folder, for its owner alone.
std::string why_unusable(const fs::path& folder)
{
    if (folder.empty()) return "neither XDG_CACHE_HOME nor HOME is set to an absolute path";
    std::error_code error;
    fs::create_directories(folder.parent_path(), error);
    if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return fmt::format("{}: {}", folder.string(), std::strerror(errno));
    struct stat status;
    if (::stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return folder.string() + ": is not a folder";
    if (status.st_uid != ::geteuid() || (status.st_mode & (S_IWGRP | S_IWOTH))) return folder.string() + ": belongs to somebody else, or others may write to it";
    return {};
}

std::string advice(const std::string& why)
{
    return "that this device passed its selftest cannot be remembered, so the selftest runs at every start: " + why + "; set XDG_CACHE_HOME to a folder of your own";
}

/// Writes the stamp; a sentence if that fails.
std::string remember(const fs::path& folder, const SelftestStamp& stamp)
{
    try {
        write_atomically(folder / stamp.name, stamp.text);
        return {};
    } catch (const IoError& error) {
        return advice(error.what());
    }
}

[[noreturn]] void refuse(const FirstUse& use, const SelftestResult& result)
{
    for (const SelftestOutcome& outcome : result.outcomes)
        if (outcome.first)
            throw DeviceError(fmt::format("{}: {}, driver {}: computes wrongly: case {} ({}): {}; run `tyndall selftest --bundle FOLDER` for a report to its makers, "
                                          "try another --device or driver, or go on at your own risk with --no-selftest",
                                          use.device.platform, use.device.name, use.device.driver, outcome.name, place_of(outcome), sentence_of(*outcome.first)));
    throw DeviceError(use.device.platform + ": " + use.device.name + ": failed its selftest");
}

}  // namespace

fs::path cache_folder()
{
    for (const auto& [variable, below] : {std::pair("XDG_CACHE_HOME", "tyndall"), std::pair("HOME", ".cache/tyndall")})
        if (const char* value = std::getenv(variable); value && value[0] == '/') return fs::path(value) / below;
    return {};
}

SelftestStamp stamp_of(const FirstUse& use)
{
    SelftestStamp stamp;
    stamp.text = fmt::format("tyndall-selftest-stamp/1\nversion {}\nplatform {}\ndevice {}\ndriver {}\nopencl {}\nlanes {}\nkernels {:016x}\n", TYNDALL_VERSION, use.device.platform,
                             use.device.name, use.device.driver, use.device.version, use.lanes, hash_of_check(use));
    SceneHash hash;
    hash.add(stamp.text);
    stamp.name = fmt::format("selftest-{:016x}.txt", hash.value());
    return stamp;
}

SelftestReport check_on_first_use(const FirstUse& use)
{
    const fs::path folder = cache_folder();
    const SelftestStamp stamp = stamp_of(use);
    const std::string why = why_unusable(folder);
    if (why.empty() && text_of(folder / stamp.name) == stamp.text) return {.outcome = "passed before", .remembered_in = (folder / stamp.name).string()};
    const SelftestResult result = run_selftest({.device = std::to_string(use.device.index), .lanes = {use.lanes}, .host = false, .families = use.families, .source = use.source});
    if (!result.passed()) refuse(use, result);
    SelftestReport report{.outcome = "passed", .seconds = result.seconds};
    for (const SelftestOutcome& outcome : result.outcomes) report.outputs += outcome.outputs;
    report.warning = why.empty() ? remember(folder, stamp) : advice(why);
    if (report.warning.empty()) report.remembered_in = (folder / stamp.name).string();
    return report;
}

}  // namespace tyndall

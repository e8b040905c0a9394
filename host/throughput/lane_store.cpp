#include "throughput/lane_store.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "film/atomic_file.hpp"
#include "scene/scene_hash.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t largest_file = 1 << 16;

Json identity_of(const DeviceInfo& device)
{
    return {{"platform", device.platform}, {"device", device.name}, {"driver", device.driver}, {"opencl", device.version}};
}

std::string dumped(const Json& json, int indent) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); }

/// The lanes that the file holds for this device; 0 and a reason otherwise.
int lanes_in(const fs::path& file, const DeviceInfo& device, std::string& why)
{
    std::error_code error;
    if (fs::file_size(file, error) > largest_file || error) return why = "it is no small file", 0;
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) return why = "it is no JSON", 0;
    if (json.value("schema", Json()) != lane_schema) return why = fmt::format("its schema is not {}", lane_schema), 0;
    const Json of = json.value("of", Json()), wanted = identity_of(device);
    for (const auto& [key, value] : wanted.items())
        if (!of.is_object() || of.value(key, Json()) != value) return why = "it is another device's or driver's", 0;
    const Json lanes = json.value("lanes", Json());
    for (const int width : {1, 4, 8, 16})
        if (lanes == width) return width;
    return why = "its lanes are not 1, 4, 8 or 16", 0;
}

}  // namespace

fs::path config_folder()
{
    for (const auto& [variable, below] : {std::pair("XDG_CONFIG_HOME", "tyndall"), std::pair("HOME", ".config/tyndall")})
        if (const char* value = std::getenv(variable); value && value[0] == '/') return fs::path(value) / below;
    return {};
}

fs::path lane_file(const DeviceInfo& device)
{
    const fs::path folder = config_folder();
    SceneHash hash;
    hash.add(dumped(identity_of(device), -1));
    return folder.empty() ? folder : folder / fmt::format("lanes-{:016x}.json", hash.value());
}

fs::path prepare_lane_file(const DeviceInfo& device)
{
    const fs::path file = lane_file(device);
    if (file.empty()) throw IoError("the calibration cannot be kept: neither XDG_CONFIG_HOME nor HOME is set to an absolute path");
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) throw IoError(fmt::format("{}: the folder cannot be made: {}; set XDG_CONFIG_HOME to a folder of your own", file.parent_path().string(), error.message()));
    check_writable(file);
    return file;
}

fs::path store_lanes(const DeviceInfo& device, const LaneChoice& choice)
{
    const fs::path file = prepare_lane_file(device);
    Json json{{"schema", lane_schema}, {"of", identity_of(device)}, {"lanes", choice.lanes}, {"by_rule", choice.by_rule}, {"speed", Json::array()}};
    for (const LaneScore& score : choice.scores)
        json["speed"].push_back({{"lanes", score.lanes}, {"median", score.speed.median}, {"low", score.speed.low}, {"high", score.speed.high}});
    write_atomically(file, dumped(json, 2) + "\n");
    return file;
}

StoredLanes stored_lanes(const DeviceInfo& device)
{
    const fs::path file = lane_file(device);
    std::error_code error;
    if (file.empty() || !fs::exists(file, error)) return {};
    std::string why;
    try {
        if (const int lanes = lanes_in(file, device, why)) return {.lanes = lanes, .warning = {}};
    } catch (const std::exception& failure) {
        why = failure.what();
    }
    return {.warning = fmt::format("{}: {}; lanes go by the rule ({}): run `tyndall devices --calibrate` again, or delete the file", file.string(), why, device.default_lanes)};
}

}  // namespace tyndall

#pragma once
/// What the pipeline knows of a kind of virtual light: how a light path becomes records. Everything else about it is in kernels/lights/<name>.h.
#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall {

/// A straight piece of a light path inside one medium.
struct LightPathSegment {
    Vec3 origin, direction;   ///< direction: unit, of travel
    double length;            ///< to the next surface or boundary, or to the sampled collision if `is_short`
    int medium;
    Rgb flux;                 ///< emitted power x throughput up to the origin / number of paths
    int depth;                ///< scattering vertices before the origin
    bool is_short;
    Rgb channel;              ///< if short: probability that each channel chose the distance x its transmittance up to the origin
};

struct LightTechnique {
    std::string_view name;     ///< file name in kernels/lights and host/lights
    std::string_view title;    ///< for people
    std::size_t record_bytes;  ///< size of its record `Light`
    bool unbiased;
    /// Appends the records that a segment leaves.
    void (*deposit)(const LightPathSegment& segment, std::vector<std::byte>& records);
};

/// The technique of that name, from the registry that CMake makes of the files in kernels/lights. Throws UsageError for an unknown one.
const LightTechnique& light_technique(std::string_view name);

/// Appends a record's bytes.
template <typename Record>
void append_record(const Record& record, std::vector<std::byte>& records)
{
    const auto* bytes = reinterpret_cast<const std::byte*>(&record);
    records.insert(records.end(), bytes, bytes + sizeof record);
}

}  // namespace tyndall

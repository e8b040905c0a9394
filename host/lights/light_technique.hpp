#pragma once
/// What the pipeline knows of a kind of virtual light: how a light path becomes records. Everything else about it is in kernels/lights/<name>.h.
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"
#include "tyndall/settings.hpp"

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
    double collision;         ///< distance of the path's own collision, where it goes on in another direction; negative: it leaves the piece
    double radius;            ///< that thick lights have in this pass
    Rgb scattered;            ///< power that it takes on from there: flux x transmittance x sigma_s / density of the collision; 0 without one
};

struct LightTechnique {
    std::string_view method;   ///< as --method calls it
    std::string_view clamped_method;  ///< as it calls the same lights with bounded connections; empty: there are none
    std::string_view name;     ///< file name in kernels/lights and host/lights
    std::string_view title;    ///< for people, in the plural
    std::size_t record_bytes;  ///< size of its record `Light`
    bool is_line;              ///< LIGHT_IS_LINE of its kernels: it shines from everywhere along a segment, and --short means something
    bool is_thick;             ///< its records have a radius, which falls from pass to pass
    bool unbiased;             ///< unless clamped
    std::string_view surface_sampler, surface_sampler_why;  ///< how a surface point's place on it is drawn, and why so
    /// Appends the records that a segment leaves.
    void (*deposit)(const LightPathSegment& segment, std::vector<std::byte>& records);
};

/// All kinds, from the registry that CMake makes of the files in kernels/lights.
std::span<const LightTechnique> light_techniques();

/// The technique that carries what media scatter by that method; null for path tracing. Throws UsageError for a method that no technique has.
const LightTechnique* technique_of(Method method);

/// Does the method bound the connections of its lights?
bool is_clamped(Method method);

/// Do its lights have a radius?
bool is_thick(Method method);

inline bool uses_virtual_lights(Method method) { return technique_of(method) != nullptr; }

/// Every value of --method: the default first, path tracing last.
std::vector<Method> all_methods();

/// Appends a record's bytes.
template <typename Record>
void append_record(const Record& record, std::vector<std::byte>& records)
{
    const auto* bytes = reinterpret_cast<const std::byte*>(&record);
    records.insert(records.end(), bytes, bytes + sizeof record);
}

}  // namespace tyndall

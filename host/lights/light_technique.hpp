#pragma once
/// What the pipeline knows of a kind of virtual light: how a light path becomes records. Everything else about it is in kernels/lights/<name>.h.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"
#include "tyndall/settings.hpp"
#include "visibility/near_search.hpp"

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

/// A light path that arrives at a surface that reflects diffusely.
struct LightPathArrival {
    Vec3 position, direction;  ///< direction: unit, of travel
    Vec3 facing;               ///< geometric normal of the side at which it arrives, unit
    Rgb flux;                  ///< power that it brings / number of paths
    int depth;                 ///< scattering vertices before this one
    double radius;             ///< as a piece's
    Vec3 off_surface{0};       ///< the position, moved off the surface to that side
    Vec3 normal{0};            ///< shading normal of that side, unit
    Rgb reflected{0};          ///< power that goes on from there, per steradian and cosine at the geometric normal: flux x reflectance / pi x (cosine of arrival at the shading over that at the geometric normal)
    int medium = 0;            ///< in front of the surface; the number of media for vacuum
};

/// What a kind of light is to eyes: they are connected to it, or they take from those that come near. The latter are eye segments in media or eye points on surfaces.
enum class Reach { connected, near_segments, near_points };

struct LightTechnique {
    std::string_view method;   ///< as --method calls it
    std::string_view clamped_method;  ///< as it calls the same lights with bounded connections; empty: there are none
    std::string_view name;     ///< file name in kernels/lights and host/lights
    std::string_view title;    ///< for people, in the plural
    std::size_t record_bytes;  ///< size of its record `Light`
    bool is_line;              ///< LIGHT_IS_LINE of its kernels: it shines from everywhere along a segment, and --short means something
    bool is_thick;             ///< its records have a radius, which falls from pass to pass
    bool unbiased;             ///< unless clamped
    std::string_view surface_sampler = {}, surface_sampler_why = {};  ///< how a surface point's place on it is drawn, and why so
    /// Appends the records that a segment leaves.
    void (*deposit)(const LightPathSegment& segment, std::vector<std::byte>& records) = nullptr;

    Reach reach = Reach::connected;
    LayerSet carries = LayerSet().add(Layer::media_to_media).add(Layer::media_to_surface);  ///< layers that they can carry

    // Kinds that eyes take from when they come near: density estimation.
    int blur_dimensions = 1;          ///< of the kernel: its radius to this power falls as eq. 64
    double usual_radius = .05;        ///< in the first pass, of the scene's half diagonal
    std::uint32_t usual_lights = 0;   ///< per pass
    /// Appends the records that an arrival leaves: of kinds that stand on surfaces.
    void (*arrive)(const LightPathArrival& arrival, std::vector<std::byte>& records) = nullptr;
    /// Where a record can be met.
    Capsule (*capsule)(std::span<const std::byte> record) = nullptr;

    /// Connected lights that stand on surfaces, and share their method with a kind that stands in media.
    bool on_surfaces = false;

    bool gathered() const { return reach != Reach::connected; }
};

/// All kinds, from the registry that CMake makes of the files in kernels/lights.
std::span<const LightTechnique> light_techniques();

/// Layers that a technique carries by some method.
struct Gathered {
    const LightTechnique* technique;
    LayerSet layers;
};

/// Which techniques a method is made of: one line for each layer that is not left to straight connections of other kinds and to path tracing.
struct Recipe {
    const LightTechnique* connected = nullptr;    ///< lights that carry media_to_media and media_to_surface
    const LightTechnique* on_surfaces = nullptr;  ///< connected lights that carry surface_to_media and surface_indirect
    bool clamped = false;                       ///< with bounded connections
    std::vector<Gathered> gathered{};           ///< by density estimation
    std::string title{};                        ///< for people, in the plural
};

/// Throws UsageError for a method that there is not. Path tracing is made of nothing.
Recipe recipe_of(Method method);

/// Which lights of the recipe carry the layer; null: none, it is left to camera rays, next-event estimation or path tracing.
const LightTechnique* lights_for(Layer layer, const Recipe& recipe);

/// The methods whose own lights carry the layer, and path tracing.
std::vector<std::string_view> methods_that_carry(Layer layer);

/// The technique whose lights in media the method connects to eyes; null if it has none. Throws UsageError for a method that there is not.
const LightTechnique* technique_of(Method method);

/// Does the method bound the connections of its lights?
bool is_clamped(Method method);

/// Do some of its lights have a radius?
bool is_thick(Method method);

inline bool uses_virtual_lights(Method method) { return technique_of(method) != nullptr; }
/// Does it trace paths from the lights at all?
inline bool uses_light_paths(Method method) { return method != Method::path; }

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

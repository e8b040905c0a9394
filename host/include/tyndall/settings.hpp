#pragma once
/// What a render is asked to do. Plain data; every default is the command line's.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tyndall/layer.hpp"
#include "tyndall/opencl_handles.hpp"
#include "tyndall/stop.hpp"

namespace tyndall {

/// How light is carried: what media scatter by a kind of virtual light, everything else as explain tells; or all of it by path tracing. A value is a name of
/// --method: those below, or that of any light in kernels/lights. Names live as long as the program.
class Method {
public:
    static const Method vrl;   ///< virtual ray lights for media_to_media and media_to_surface, unbiased in every layer
    static const Method path;  ///< the unbiased host path tracer for every layer

    constexpr explicit Method(std::string_view name) : name_(name) {}
    constexpr std::string_view name() const { return name_; }
    friend constexpr bool operator==(const Method&, const Method&) = default;

private:
    std::string_view name_;
};
inline constexpr Method Method::vrl{"vrl"};
inline constexpr Method Method::path{"path"};
constexpr std::string_view name(Method method) { return method.name(); }

enum class LightSegments { all, first };  ///< first: only what leaves the emitter, before any scattering
enum class SegmentLength { long_, short_ };  ///< a VRL ends at the next surface, or at its sampled collision

/// How a virtual ray light and an eye segment are connected [Novak et al. 2012].
enum class Sampler {
    automatic,        ///< the one that wins at equal time for the scene's media (host/docs/performance.md)
    paper_isotropic,  ///< rod-potential marginal, equi-angular conditional
    paper,            ///< rod-potential marginal, conditional in proportion to the product of the phase functions
    paper_6,          ///< the same with six vertices and in proportion to the transmittance as well
    table,            ///< marginal from a table of 8 places x 6 angles; conditional like paper_6's with ten vertices
    table_4x4,        ///< 4 places x 4 angles, six vertices
    table_3x2,        ///< 3 places x 2 angles, four vertices
};
/// The numbers that the samples of pairs are made from.
enum class Sequence {
    automatic,  ///< the one that wins at equal time
    random,     ///< independent of each other
    sobol,      ///< scrambled Sobol points along the samples of a pair and the lights of a pixel [Owen 1995]
};

/// How the transmittance through density grids is found (host/docs/features.md). Both are unbiased.
enum class GridTransmittance {
    march,  ///< tables and a jittered march with an exact correction now and then; single contributions can be negative
    exact,  ///< cell by cell for every pair
};

/// Of what the kernels that evaluate pairs compute with; records, sums and what lights are chosen by stay 32-bit.
enum class Precision { f32, f64 };

/// How compilers may treat the same kernels. fast: terms in another order, reciprocals for divisions, denormal numbers as 0; the selftest does not cover it.
enum class KernelMath { strict, fast };

/// Which virtual lights of a pass an eye is connected to. Both are unbiased.
enum class Selection {
    automatic,  ///< the one that wins at equal time (host/docs/performance.md)
    all,        ///< every light
    tile,       ///< some, chosen by an estimate that a square of pixels shares
};

struct Crop {
    int x = 0, y = 0, width = 0, height = 0;
};

inline constexpr std::uint32_t all_lights = 0xffffffffu;

struct RenderSettings {
    Method method = Method::vrl;
    LayerSet layers = LayerSet::all();
    LayerSet path_layers{};            ///< path-traced whatever the method
    int passes = 0;                    ///< stop after so many; 0: no limit (the command line's default is 16 unless a time is given)
    double seconds = 0;                ///< stop when the next pass would end later; 0: no limit
    double target_error = 0;           ///< stop when the error is at most this with 95 % confidence (film/error_estimate.hpp), after 8 passes at least; 0: never
    std::uint32_t lights = 0;          ///< virtual lights per pass, aimed at; 0: chosen by fixed rule from the image size and `seconds`
    std::uint64_t seed = 1;
    int threads = 0;                   ///< host threads; 0: all cores
    std::optional<int> max_depth{};    ///< instead of the scene's; -1 no limit; D keeps paths with at most D - 1 scattering vertices
    LightSegments light_segments = LightSegments::all;
    SegmentLength segment_length = SegmentLength::long_;
    Sampler sampler = Sampler::automatic;
    Sequence sequence = Sequence::automatic;
    Sequence emission = Sequence::automatic;  ///< of light paths; automatic: sobol
    GridTransmittance transmittance = GridTransmittance::march;
    Precision precision = Precision::f32;
    KernelMath math = KernelMath::strict;
    std::optional<std::uint32_t> features{};  ///< mask of kernels/shared/scene_features.h for all kernels; none: what the scene calls for
    std::string device{};              ///< index, substring of the name, or platform:device; several with commas, or "all"; empty: the default device
    std::optional<OpenClHandles> opencl{};  ///< the caller's context and device, in place of those that `device` names
    int lanes = 0;                     ///< 1, 4, 8, 16; 0: chosen by fixed rule from the device
    bool lanes_calibrated = false;     ///< `lanes` were measured for the device before, not asked for; for the report alone
    std::uint32_t tile_pairs = 0;      ///< pairs per tile; 0: default. Never changes a byte
    double launch_seconds = .1;        ///< a device's launches are kept below, as far as earlier ones can tell. Never changes a byte
    int samples_per_pair = 1;
    Selection selection = Selection::automatic;
    std::uint32_t selected_lights = 0; ///< per pixel and pass; 0: by rule
    int selection_block = 0;           ///< pixels across of the squares that share an estimate, 4, 8 or 16; 0: by rule
    std::uint32_t candidates = 0;      ///< lights chosen for a region of 8 x 8 squares, for the squares to choose among; 0: by rule, all_lights: no such choice
    double selection_defence = -1;     ///< share of the choice that goes by power alone, in [0, 1]; negative: by rule
    int camera_samples = 0;            ///< per pixel and pass, for virtual lights; 0: by rule
    double skip_thin = 0;              ///< leave media_to_media out if at most this share of what media scatter is scattered there again (biased); 0: never
    std::optional<double> clamp{};     ///< of the clamped methods: no connection's 1 / w^2 is more than this over the square of the scene's half diagonal (biased); none: by rule
    std::optional<double> beam_radius{};  ///< of methods with thick lights, in the first pass: a share of the scene's half diagonal (biased); none: by rule
    int block_passes = 8;              ///< passes that are summed by themselves before they join the total (film/film.hpp); part of the result
    std::string dump_kernels{};        ///< folder for the source of every program that is built, as its compiler sees it; empty: none. Never changes a byte
    bool selftest = true;              ///< golden cases before a device renders for the first time; false: at the user's own risk
    const StopFlag* stop = nullptr;    ///< raising it abandons the pass in progress and ends the render; must outlive it
};

}  // namespace tyndall

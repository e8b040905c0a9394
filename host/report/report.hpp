#pragma once
/// What a render did: counts, timings, effects. Plain data, filled by the pipeline, written as JSON (`to_json`) and as a table for people.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tyndall/layer.hpp"

namespace tyndall {

struct StageTime {
    std::string stage;   ///< trace_lights, trace_eyes, trace_paths, sample_pairs, shadow_segments, accumulate_pairs, transfer, film, write
    double seconds = 0;  ///< wall clock
    std::uint64_t count = 0;  ///< of what the stage works on: lights, segments, pairs, ...
};

struct LayerReport {
    std::string layer, technique;  ///< technique: "virtual ray lights", "path tracing", "equi-angular", "next-event estimation", "skipped"
    bool skipped = false;
    std::string why;  ///< the technique; of a skipped layer: what the scene lacks, or that it was turned off
    bool unbiased = true;
    double error = -1;    ///< sqrt(relMSE) relative to the layer itself; negative: unknown or not rendered
    double left_out = 0;  ///< for a layer that the scene has and the settings allow to skip: a bound on its share of the light that media scatter
    std::string bias{};      ///< what makes virtual lights biased, with its number: a clamp, a radius; empty: nothing
    double removed = -1;     ///< share of the layer's light that the clamp took away, over all pixels and channels; negative: no clamp
    double kept_light = 0, removed_light = 0;  ///< if there is a clamp: sums over channels, eyes and passes
    std::string sampler{}, sampler_why{};  ///< of virtual ray lights: how places on light and eye are drawn
};

/// A line of the list of what a scene may call for (host/scene/scene_features.hpp).
struct EffectReport {
    std::string effect;
    bool found = false;  ///< in this scene
    std::string cause;   ///< "file:line:column: sentence" if found
};

/// Something that was not done because the scene does not need it.
struct SavingReport {
    std::string what, because;
    double predicted_seconds = -1;  ///< of processor time that it would have taken; negative: not predicted
};

/// What the first passes said about the rest, to be set beside what happened.
struct Prediction {
    int from_passes = 0;     ///< how many passes it was made from
    int passes = 0;          ///< in all
    double seconds = 0;      ///< for all of them, with what came before the first
    double error = -1;       ///< sqrt(relMSE) at the end; negative: unknown
    double pass_seconds = 0; ///< each
};

/// The pair of a light and an eye that added most to a pixel: nothing is clamped, so this says how much one pair can be worth.
struct WorstPairReport {
    std::string layer;             ///< empty: no pair added anything
    std::uint64_t pass = 0;
    int x = 0, y = 0;              ///< pixel of the window that was rendered
    double radiance = 0;           ///< that it added in that pass, mean of the channels
    double share_of_pixel = 0;     ///< of what the layer has there in that pass
};

struct NumericsLedger {
    std::uint64_t not_finite_pairs = 0, runaway_walks = 0;
    std::uint64_t unsafe_shadow_segments = 0;  ///< rays and shadow segments that were not finite (Visibility::invalid_rays)
    std::uint64_t floored_pairs = 0;           ///< samples under the floor on the distance of light and eye line (kernels/README.md, eq. 7)
    std::vector<std::string> first_cases;  ///< a few, with pixel and light, for the ones above
    WorstPairReport worst_pair;
    std::uint64_t not_finite_pixels = 0;   ///< per pass and layer, from the film; they count as 0
};

/// The golden cases on the device before its first render (host/selftest/first_use.hpp).
struct SelftestReport {
    std::string outcome;        ///< "passed", "passed before", or "skipped" at the user's own risk
    std::uint64_t outputs = 0;  ///< compared now
    double seconds = 0;         ///< beside the other preparations
    std::string remembered_in;  ///< file that says that they passed; empty: none
    std::string warning;        ///< why there is none, and what to do; empty: nothing to say
};

struct Report {
    std::string scene, method, device, driver, build_options;
    std::uint64_t scene_hash = 0, seed = 0;
    int width = 0, height = 0, passes = 0, threads = 0, lanes = 0, max_depth = -1;
    std::uint64_t light_paths = 0, virtual_lights = 0, eye_segments = 0, eye_points = 0, pairs = 0, shadow_segments = 0, launches = 0, programs = 0;
    std::string lanes_from;  ///< "rule", "calibration" (`tyndall devices --calibrate`) or "request"
    double seconds = 0, largest_launch_seconds = 0, pass_seconds = 0, before_seconds = 0;  ///< before: acceleration structures, kernels, pilot
    bool wall_clock = false;  ///< the device has no clock: launches are timed by the one on the wall, and only those that were waited for
    double error = 0;        ///< estimated sqrt(relMSE) of the image (host/film/error_estimate.hpp); negative: unknown (one pass)
    double error_upper = 0;   ///< it is below this with a confidence of 95 %; infinite: too few passes
    double target_error = 0;  ///< that was asked for; 0: none
    std::string stopped_by;  ///< "passes", "time", "target error", "interrupt"
    std::string selection;   ///< which virtual lights eyes were connected to; empty: no virtual lights
    std::string grids;       ///< how transmittance through density grids was found; empty: no pair asked
    std::vector<EffectReport> effects;
    std::vector<SavingReport> savings;
    std::optional<Prediction> prediction;  ///< none: fewer than three passes
    std::optional<SelftestReport> selftest;  ///< none: no device was used
    std::vector<LayerReport> layers;
    std::vector<StageTime> stages;
    std::vector<std::string> warnings;
    NumericsLedger ledger;
    std::string version;               ///< of Tyndall
    std::optional<double> exposure;    ///< of the picture, in stops; none: no picture was written
    std::vector<std::string> outputs;  ///< files written
};

}  // namespace tyndall

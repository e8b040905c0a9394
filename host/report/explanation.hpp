#pragma once
/// What a render would do and why: plain data, filled by host/pipeline/explain.hpp, written as JSON and as text for people.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"

namespace tyndall {

/// A kernel that will be built.
struct KernelReport {
    std::string layer, kernel, features, options;  ///< features: the names of the mask
};

struct MemoryReport {
    std::string what;
    std::uint64_t bytes = 0;
    bool on_device = false;
};

/// A short render that was timed.
struct Calibration {
    int passes = 0;                    ///< that were timed: all but the first, which builds and fills
    double film_share = 1;             ///< of the pixels: a film that would take too long is shrunk, and what grows with the pixels is scaled back
    double before_seconds = 0;         ///< before the first pass: acceleration structures, kernels, pilot
    double first_pass_seconds = 0;
    double pass_seconds = 0;           ///< mean of the timed passes, for the whole film
    double error = -1;                 ///< sqrt(relMSE) of one pass; negative: unknown
    double seconds_to_one_percent = -1;
};

struct Explanation {
    std::string scene, method, device;  ///< device: empty if none is needed or none was found
    int width = 0, height = 0, passes = 0, lanes = 0;
    std::string lanes_from;             ///< "rule", "calibration" (`tyndall devices --calibrate`) or "request"
    double seconds = 0;                 ///< time budget, 0: none
    std::uint32_t lights = 0;           ///< virtual lights per pass, aimed at; 0: no virtual lights
    std::vector<EffectReport> effects;
    std::vector<LayerReport> layers;
    std::vector<KernelReport> kernels;
    std::string selection;              ///< which virtual lights eyes will be connected to; empty: no virtual lights
    std::string grids;                  ///< how transmittance through density grids will be found; empty: no kernel asks
    std::vector<MemoryReport> memory;
    std::vector<SavingReport> savings;  ///< per pass
    std::vector<std::string> warnings;
    std::optional<Calibration> calibration;
    std::string why_no_calibration;     ///< if there is none
};

inline constexpr const char* explanation_schema = "tyndall-explain/1";

/// Pretty-printed JSON with a final line break; unknown numbers are null. Keys are added, never renamed, within one schema.
std::string to_json(const Explanation& explanation);

/// For people: effects with the elements that cause them, layers, kernels, memory, time, warnings.
std::string to_text(const Explanation& explanation);

}  // namespace tyndall

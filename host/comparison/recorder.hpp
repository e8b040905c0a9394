#pragma once
/// One timed run against a reference: its error curve, its images at the wanted times, the spread of its passes.
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/reference.hpp"
#include "metrics/error_curve.hpp"
#include "metrics/image_error.hpp"
#include "pipeline/render.hpp"

namespace tyndall {

/// The finished pass that is nearest to a wanted time, by the ratio of the two.
struct Snapshot {
    double wanted_seconds = 0, seconds = 0;
    int passes = 0;
    std::vector<Rgb> image;
};

struct Run {
    std::uint64_t seed = 0;
    ErrorCurve curve;            ///< at passes whose times differ by 10 % or more, and the first pass at or after every wanted time
    BlockStatistics passes;      ///< of the image of every single pass
    std::vector<Snapshot> snapshots;                 ///< one per wanted time
    std::map<std::string, std::vector<Rgb>> layers;  ///< at the end, if asked for
    ImageError last;             ///< at the end
    Report report;
};

class RunRecorder {
public:
    using Clock = std::function<double()>;  ///< seconds since whenever
    /// `times`: ascending, not empty; the run ends with the first pass at or after the last of them. `clock` measures what recording costs, which is taken off the run's seconds.
    RunRecorder(const Reference& reference, std::vector<double> times, Clock clock);

    /// To be called after every pass; false when the run is over.
    bool after_pass(double seconds, const Film& film);
    /// The finished run.
    Run finish(const RenderOutcome& outcome, std::uint64_t seed, bool keep_layers);

private:
    void keep_snapshots(double seconds, const std::vector<Rgb>& image, int passes);
    bool worth_a_point(double seconds) const;

    const Reference& reference_;
    std::vector<double> times_;
    Clock clock_;
    double recording_ = 0, seconds_ = 0;
    std::vector<Rgb> before_;  ///< the image after the pass before
    Run run_;
};

}  // namespace tyndall

#pragma once
/// What the first passes of a render say about the rest.
#include <optional>

#include "report/report.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

class Forecast {
public:
    /// Passes that it is made from: the first one pays for caches and late compilation, so only the second is taken as the length of all others.
    static constexpr int from_passes = 2;

    /// Call after every pass with the seconds since the start; `error` is asked once, after pass `from_passes`.
    template <class Error>
    void after_pass(const RenderSettings& settings, int passes, double seconds, Error&& error)
    {
        if (passes == 1) first_ = seconds;
        if (passes == from_passes) predict(settings, seconds, error());
    }
    /// Nothing before pass `from_passes`, and nothing where no more passes follow it.
    const std::optional<Prediction>& prediction() const { return prediction_; }

private:
    void predict(const RenderSettings& settings, double seconds, double error);

    double first_ = 0;
    std::optional<Prediction> prediction_;
};

}  // namespace tyndall

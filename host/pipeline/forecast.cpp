#include "pipeline/forecast.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall {

void Forecast::predict(const RenderSettings& settings, double seconds, double error)
{
    const double pass = seconds - first_;
    double passes = settings.passes > 0 ? settings.passes : 1e9;
    if (settings.seconds > 0 && pass > 0) passes = std::min(passes, from_passes + std::floor(std::max(settings.seconds - seconds, 0.0) / pass));
    if (passes <= from_passes) return;
    prediction_ = Prediction{.from_passes = from_passes,
                             .passes = static_cast<int>(passes),
                             .seconds = seconds + pass * (passes - from_passes),
                             .error = error < 0 ? -1 : error * std::sqrt(from_passes / passes),  // variance falls with 1 / passes
                             .pass_seconds = pass};
}

}  // namespace tyndall

#include "film/pass_spread.hpp"

#include <cassert>
#include <cmath>
#include <numeric>

#include "film/error_estimate.hpp"

namespace tyndall {

void PassSpread::add(std::span<const Rgb> pass, std::span<const Rgb> mean, int passes_before)
{
    passes_ = passes_before + 1;
    if (passes_before == 0) return;
    assert(pass.size() == mean.size());
    increments_.resize(static_cast<std::size_t>(passes_before) - 1, 0.0);
    increments_.push_back((passes_ - 1.0) / passes_ * tyndall::relative_mse(pass, mean));
}

std::span<const double> PassSpread::later() const { return std::span(increments_).subspan(increments_.size() / 2); }

double PassSpread::relative_mse() const
{
    if (increments_.empty()) return -1;
    const auto terms = later();
    return std::accumulate(terms.begin(), terms.end(), 0.0) / static_cast<double>(terms.size()) / passes_;
}

double PassSpread::relative_standard_error() const
{
    const auto terms = later();
    const double n = static_cast<double>(terms.size());
    if (n < 3) return -1;
    const double mean = std::accumulate(terms.begin(), terms.end(), 0.0) / n;
    if (!(mean > 0)) return 0;
    double squares = 0;
    for (const double term : terms) squares += (term - mean) * (term - mean);
    return std::sqrt(squares / (n - 1) / n) / mean;
}

}  // namespace tyndall

#include "film/pass_spread.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "film/error_estimate.hpp"

namespace tyndall {

void PassSpread::add(std::span<const Rgb> pass, std::vector<Rgb>&& sum, int before, int block_passes)
{
    constexpr int rough = 4;  // passes that a mean is made of before its weights are good for something
    if (before < std::max(std::min(rough, block_passes / 2), 1)) return;
    assert(pass.size() == sum.size());
    for (Rgb& pixel : sum) pixel /= static_cast<double>(before);
    terms_.push_back(before / (before + 1.0) * tyndall::relative_mse(pass, sum));
}

double PassSpread::relative_standard_error() const
{
    const double n = static_cast<double>(terms_.size());
    if (n < 3) return -1;
    const double mean = std::accumulate(terms_.begin(), terms_.end(), 0.0) / n;
    if (!(mean > 0)) return 0;
    double squares = 0;
    for (const double term : terms_) squares += (term - mean) * (term - mean);
    return std::sqrt(squares / (n - 1) / n) / mean;
}

}  // namespace tyndall

#include "film/layer_deviation.hpp"

#include <algorithm>

#include "film/error_estimate.hpp"

namespace tyndall {
namespace {

int freedom(int passes, int finished) { return finished > 0 ? passes : passes - 1; }

}  // namespace

double LayerDeviation::weighted(const SumAt& block, const SumAt& all, int passes, int finished) const
{
    const double b = passes, n = finished;
    const auto squared = [&](std::size_t i) {
        const Rgb within(squares_[i]), sum = block(i);
        if (finished == 0) return within;
        const Rgb between = sum / b - (all(i) - sum) / n;
        return within + n * b / (n + b) * between * between;
    };
    return mean_of_relative_terms(squares_.size(), squared, [&](std::size_t i) { return all(i) / (n + b); });
}

void LayerDeviation::close_block(const SumAt& block, const SumAt& all, int passes, int finished)
{
    if (freedom(passes, finished) > 0) {
        sums_.push_back(weighted(block, all, passes, finished));
        freedoms_.push_back(freedom(passes, finished));
    }
    std::ranges::fill(squares_, glm::vec3(0));
}

double LayerDeviation::relative_mse(const SumAt& block, const SumAt& all, int passes, int finished) const
{
    if (passes + finished < 2 || squares_.empty()) return -1;
    double sum = 0;
    int freedoms = 0;
    if (passes > 0 && freedom(passes, finished) > 0) sum = weighted(block, all, passes, finished), freedoms = freedom(passes, finished);
    for (std::size_t k = sums_.size(); k-- > 0 && 2 * freedoms < passes + finished - 1;) sum += sums_[k], freedoms += freedoms_[k];
    return freedoms > 0 ? sum / freedoms / (passes + finished) : -1;
}

}  // namespace tyndall

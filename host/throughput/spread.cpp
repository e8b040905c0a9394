#include "throughput/spread.hpp"

#include <algorithm>

namespace tyndall {

Spread spread_of(std::vector<double> values)
{
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return {values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2, values.front(), values.back()};
}

bool measured_above(const Spread& a, const Spread& b) { return a.low > b.high; }

std::vector<std::size_t> unbeaten(std::span<const Spread> spreads)
{
    std::vector<std::size_t> order(spreads.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return spreads[a].median > spreads[b].median; });
    const Spread best = spreads[order.front()];
    std::erase_if(order, [&](std::size_t i) { return measured_above(best, spreads[i]); });
    return order;
}

}  // namespace tyndall

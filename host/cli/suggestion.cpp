#include "cli/suggestion.hpp"

#include <algorithm>

namespace tyndall {
namespace {

/// Optimal string alignment distance.
std::size_t distance(std::string_view a, std::string_view b)
{
    std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) cost[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) cost[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
        }
    return cost[a.size()][b.size()];
}

}  // namespace

std::string nearest_name(std::string_view misspelt, const std::vector<std::string>& known)
{
    misspelt = misspelt.substr(0, 64);  // no known name is longer; the cost is a product of lengths
    std::size_t best = std::max<std::size_t>(2, misspelt.size() / 3) + 1;
    std::string nearest;
    for (const auto& name : known)
        if (const auto d = distance(misspelt, name); d < best) best = d, nearest = name;
    return nearest;
}

std::string suggestion(std::string_view misspelt, const std::vector<std::string>& known)
{
    const auto nearest = nearest_name(misspelt, known);
    return nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?";
}

}  // namespace tyndall

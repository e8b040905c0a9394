#pragma once
/// Phase functions that are sums of lobes, as records of the device and in the textbook's words.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "kernels/shared/records.hpp"

namespace tyndall::plain {

struct Lobes {
    std::string name{};
    std::vector<PhaseLobeRecord> records{};
    std::vector<float> values{};
    std::function<double(double)> phase{};
    double mean = 0;
};

inline double textbook(double g, double mu) { return (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * mu, 1.5)); }
inline double textbook_rayleigh(double mu) { return 3 / (16 * std::numbers::pi) * (1 + mu * mu); }

/// Values at mu = -1, -.5, 0, .5, 1, whose trapezoids add up to 2.
inline constexpr double peaks[] = {.5, .25, .75, 1, 3.5};
inline double textbook_table(double mu)
{
    const double x = 2 * (mu + 1);
    const int i = std::clamp(int(x), 0, 3);
    return ((i + 1 - x) * peaks[i] + (x - i) * peaks[i + 1]) / (4 * std::numbers::pi);
}

inline std::vector<Lobes> all_lobes()
{
    std::vector<float> values;
    for (const double value : peaks) values.push_back(float(value / (4 * std::numbers::pi)));
    const PhaseLobeRecord rayleigh{PHASE_LOBE_RAYLEIGH, 1, 0, 0, 0, 0, 0, 0}, table{PHASE_LOBE_TABLE, 1, .3f, 0, 5, 0, 0, 0};
    PhaseLobeRecord parts[] = {{PHASE_LOBE_HENYEY_GREENSTEIN, .375f, .6f, 0, 0, 0, 0, 0}, {PHASE_LOBE_HENYEY_GREENSTEIN, .25f, -.5f, 0, 0, 0, 0, 0}, rayleigh, table};
    parts[2].weight = .25f, parts[3].weight = .125f;
    return {{"Rayleigh", {rayleigh}, {}, textbook_rayleigh, 0},
            {"table", {table}, values, textbook_table, .3},
            {"blend", {parts[0], parts[1], parts[2], parts[3]}, values,
             [](double mu) { return .375 * textbook(.6f, mu) + .25 * textbook(-.5, mu) + .25 * textbook_rayleigh(mu) + .125 * textbook_table(mu); }, .14}};
}

}  // namespace tyndall::plain

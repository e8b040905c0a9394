#include "scene/phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace tyndall {
namespace {

using Type = PhaseFunction::Type;

/// Appends the phase function, or the parts of a blend, with their weights times `share`.
void append(std::vector<PhaseFunction>& parts, const PhaseFunction& phase, double share)
{
    if (phase.type == Type::blend) {
        for (const PhaseFunction& part : phase.parts) append(parts, part, share);
    } else {
        parts.push_back(phase);
        parts.back().weight = share * phase.weight;
    }
}

}  // namespace

PhaseFunction henyey_greenstein_phase(double g) { return {.type = Type::henyey_greenstein, .g = g}; }

PhaseFunction rayleigh_phase() { return {.type = Type::rayleigh}; }

PhaseFunction table_phase(std::vector<double> values)
{
    PhaseFunction phase{.type = Type::table};
    const double largest = *std::max_element(values.begin(), values.end()), step = 2.0 / double(values.size() - 1);
    for (double& value : values) value /= largest;  // the sum of what is in the file may be beyond the largest number
    double total = 0, moment = 0;
    phase.cumulative.push_back(0);
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const double from = -1 + step * double(i), to = from + step;
        total += .5 * step * (values[i] + values[i + 1]);
        moment += step / 6 * (values[i] * (2 * from + to) + values[i + 1] * (from + 2 * to));
        phase.cumulative.push_back(total);
    }
    for (double& value : values) value /= 2 * std::numbers::pi * total;
    for (double& c : phase.cumulative) c /= total;
    phase.g = moment / total, phase.values = std::move(values);
    return phase;
}

PhaseFunction blend_phase(double weight, const PhaseFunction& first, const PhaseFunction& second)
{
    if (weight == 0) return first;
    if (weight == 1) return second;
    PhaseFunction blend{.type = Type::blend};
    append(blend.parts, first, 1 - weight);
    append(blend.parts, second, weight);
    for (const PhaseFunction& part : blend.parts) blend.g += part.weight * part.g;
    return blend;
}

bool has_lobes(const PhaseFunction& phase) { return phase.type != Type::isotropic && phase.type != Type::henyey_greenstein; }

bool scatters_evenly(const PhaseFunction& phase) { return !has_lobes(phase) && phase.g == 0; }

std::string phase_words(const PhaseFunction& phase)
{
    switch (phase.type) {
        case Type::isotropic: return "isotropic";
        case Type::henyey_greenstein: return fmt::format("Henyey-Greenstein g = {:.6g}", phase.g);
        case Type::rayleigh: return "Rayleigh";
        case Type::table: return fmt::format("table of {} values, mean cosine {:.6g}", phase.values.size(), phase.g);
        case Type::blend: break;
    }
    std::string text;
    for (const PhaseFunction& part : phase.parts) text += fmt::format("{}{:.6g} {}", text.empty() ? "blend of " : " + ", part.weight, phase_words(part));
    return text + fmt::format(", mean cosine {:.6g}", phase.g);
}

}  // namespace tyndall

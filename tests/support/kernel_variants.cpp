#include "kernel_variants.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "kernels/shared/host_features.hpp"
#include "lights/light_technique.hpp"

namespace tyndall::test {
namespace {

enum Choice : std::size_t { light, eye, lanes, sampler, sequence, selection, clamp, transmittance, precision, math, first_feature };
constexpr std::array lane_widths{1, 4, 8, 16};
constexpr std::array<const char*, first_feature> names{"", "eye", "lanes", "sampler", "sequence", "selection", "clamp", "transmittance", "precision", "math"};

std::size_t choice_of(std::uint32_t feature)
{
    std::size_t choice = first_feature;
    for (const SceneFeature& known : scene_feature_list) {
        if (known.bit == feature) return choice;
        ++choice;
    }
    return choice;
}

/// Two values of two choices, in the order of the choices.
using Pair = std::pair<std::pair<std::size_t, int>, std::pair<std::size_t, int>>;

Pair pair_of(std::size_t a, int value_a, std::size_t b, int value_b)
{
    return a < b ? Pair{{a, value_a}, {b, value_b}} : Pair{{b, value_b}, {a, value_a}};
}

/// Every pair of values, whether or not it can occur.
std::set<Pair> all_pairs(const Choices& counts)
{
    std::set<Pair> pairs;
    for (std::size_t b = 0; b < counts.size(); ++b)
        for (std::size_t a = 0; a < b; ++a)
            for (int j = 0; j < counts[b]; ++j)
                for (int i = 0; i < counts[a]; ++i) pairs.insert(pair_of(a, i, b, j));
    return pairs;
}

bool holds(const Choices& row, const Pair& pair) { return row[pair.first.first] == pair.first.second && row[pair.second.first] == pair.second.second; }

/// Fills what is open (-1) by the values that cover most of what is missing.
Choices greedy(Choices row, const std::set<Pair>& missing, const Choices& counts)
{
    for (std::size_t c = 0; c < counts.size(); ++c) {
        if (row[c] >= 0) continue;
        std::ptrdiff_t most = -1;
        int best = 0;
        for (int value = 0; value < counts[c]; ++value) {
            std::ptrdiff_t covered = 0;
            for (std::size_t other = 0; other < counts.size(); ++other) covered += row[other] >= 0 && missing.contains(pair_of(c, value, other, row[other]));
            if (covered > most) most = covered, best = value;
        }
        row[c] = best;
    }
    return row;
}

/// A row with the pair, if it can occur at all: the best one, or one whose light or grids make the pair possible.
Choices row_with(const Pair& wanted, const std::set<Pair>& missing, const Choices& counts)
{
    Choices open(counts.size(), -1);
    open[wanted.first.first] = wanted.first.second, open[wanted.second.first] = wanted.second.second;
    Choices row = allowed(greedy(open, missing, counts));
    for (int value = 0; value < counts[light] && !holds(row, wanted); ++value)
        for (const int grids : {0, 1}) {
            Choices pinned = open;
            if (pinned[light] < 0) pinned[light] = value;
            if (int& heterogeneous = pinned[choice_of(feature_bit::heterogeneous)]; heterogeneous < 0) heterogeneous = grids;
            if (!holds(row, wanted)) row = allowed(greedy(pinned, missing, counts));
        }
    return row;
}

}  // namespace

Choices choice_counts()
{
    Choices counts{static_cast<int>(light_techniques().size()), 2, static_cast<int>(lane_widths.size()), 6, 2, 2, 2, 2, 2, 2};
    counts.resize(first_feature + scene_feature_list.size(), 2);
    return counts;
}

Choices allowed(Choices choices)
{
    const LightTechnique& technique = light_techniques()[static_cast<std::size_t>(choices[light])];
    if (technique.clamped_method.empty()) choices[clamp] = 0;
    if (technique.name != "virtual_ray_light") choices[sampler] = 0;
    if (technique.gathered()) {  // one kind of eye, and no connections
        choices[eye] = technique.reach == Reach::near_points ? 1 : 0, choices[sequence] = choices[selection] = choices[transmittance] = 0;
        for (const std::uint32_t bit : {feature_bit::occluders + 0u, feature_bit::boundaries + 0u, feature_bit::nonconvex_media + 0u}) choices[choice_of(bit)] = 0;
    }
    if (choices[choice_of(feature_bit::nonconvex_media)]) choices[choice_of(feature_bit::occluders)] = 1;
    if (!choices[choice_of(feature_bit::heterogeneous)]) choices[choice_of(feature_bit::coloured_grids)] = choices[transmittance] = 0;
    return choices;
}

PairProgram program_of(const Choices& choices)
{
    const LightTechnique& technique = light_techniques()[static_cast<std::size_t>(choices[light])];
    PairProgram program{.light = std::string(technique.name), .light_bytes = static_cast<std::uint32_t>(technique.record_bytes), .light_is_line = technique.is_line, .gathers = technique.gathered()};
    program.eyes = choices[eye] ? EyeKind::points : EyeKind::segments;
    program.lanes = lane_widths[static_cast<std::size_t>(choices[lanes])];
    program.sampler = choices[sampler], program.sequence = choices[sequence], program.selection = choices[selection] != 0;
    program.clamp = choices[clamp] ? 100.f : 0.f, program.transmittance = choices[transmittance];
    program.precision = choices[precision] ? 64 : 32, program.fast_math = choices[math] != 0;
    for (const SceneFeature& feature : scene_feature_list)
        if (choices[choice_of(feature.bit)]) program.features |= feature.bit;
    return program;
}

std::vector<Choices> covering_choices()
{
    const Choices counts = choice_counts();
    std::set<Pair> missing = all_pairs(counts);
    std::vector<Choices> rows;
    while (!missing.empty()) {
        const Pair wanted = *missing.begin();
        const Choices row = row_with(wanted, missing, counts);
        missing.erase(wanted);  // what is not in the row cannot occur
        const std::size_t before = missing.size();
        for (std::size_t b = 0; b < row.size(); ++b)
            for (std::size_t a = 0; a < b; ++a) missing.erase(pair_of(a, row[a], b, row[b]));
        if (holds(row, wanted) || missing.size() < before) rows.push_back(row);
    }
    return rows;
}

std::string name_of(const Choices& choices)
{
    std::string name(light_techniques()[static_cast<std::size_t>(choices[light])].name);
    for (std::size_t c = eye; c < first_feature; ++c) name += std::string("_") + names[c] + std::to_string(c == lanes ? lane_widths[static_cast<std::size_t>(choices[c])] : choices[c]);
    return name + "_features" + std::to_string(program_of(choices).features);
}

}  // namespace tyndall::test

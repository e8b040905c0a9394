#pragma once
/// The hard cases with what they must give: inputs and, for every output, an interval and the value without rounding where there is one. Made in 50 digits by
/// tests/hard_cases (write_golden_table); host/docs/hard_cases.md says what each row is.
#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace tyndall {

/// low <= output <= high, which no NaN fulfils. Everything finite by default.
template <class Real>
struct GoldenOutput {
    Real value = std::numeric_limits<Real>::quiet_NaN();  ///< NaN: no single value is right
    Real low = std::numeric_limits<Real>::lowest(), high = std::numeric_limits<Real>::max();

    bool holds(Real x) const { return low <= x && x <= high; }
    bool has_value() const { return value == value; }
};

/// One set of inputs of a row for one sampler of kernels/selftest/evaluate.h.
template <class Real>
struct GoldenSet {
    int row;                 ///< index in golden_rows()
    const char* name;
    unsigned sampler;
    std::array<Real, 14> in;
    std::array<GoldenOutput<Real>, 4> out;
};

/// The mean over xi in [0, 1] of output 0, xi being input 11: four Gauss nodes in each of `panels` equal panels.
template <class Real>
struct GoldenMean {
    int row;
    const char* name;
    unsigned sampler, panels;
    std::array<Real, 14> in;
    GoldenOutput<double> out;
};

template <class Real>
struct GoldenTable {
    std::span<const GoldenSet<Real>> sets;
    std::span<const GoldenMean<Real>> means;
};

/// Inputs rounded to float, intervals that float arithmetic keeps.
GoldenTable<float> golden_floats();
/// The same rows in double.
GoldenTable<double> golden_doubles();

/// Names of the rows, in order: what --only selects and reports show. They never change their meaning.
std::span<const std::string_view> golden_rows();

/// Inputs of the nodes of a mean, and their weights, which sum to 1.
template <class Real>
struct MeanNodes {
    std::vector<std::array<Real, 14>> in;
    std::vector<double> weight;
};
template <class Real>
MeanNodes<Real> mean_nodes(std::array<Real, 14> in, unsigned panels)
{
    constexpr std::array node{.86113631159405257522, .33998104358485626480, -.33998104358485626480, -.86113631159405257522};  // Gauss and Legendre, 4 nodes
    constexpr std::array weight{.34785484513745385737, .65214515486254614263, .65214515486254614263, .34785484513745385737};
    MeanNodes<Real> nodes;
    for (unsigned panel = 0; panel < panels; ++panel)
        for (std::size_t k = 0; k < 4; ++k) {
            in[11] = Real((panel + .5 + .5 * node[k]) / panels);
            nodes.in.push_back(in);
            nodes.weight.push_back(weight[k] / (2 * panels));
        }
    return nodes;
}

}  // namespace tyndall

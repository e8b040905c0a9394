#pragma once
/// One row of the golden tables through something that evaluates inputs: the host in two precisions, or a device.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "selftest/golden.hpp"

namespace tyndall {

/// An output outside its interval.
struct SelftestMiss {
    std::string set;            ///< of inputs, or of the mean
    unsigned sampler = 0;       ///< kernels/selftest/evaluate.h
    std::size_t output = 0;
    double got = 0, value = 0, low = 0, high = 0;  ///< value NaN: only the interval is known
    std::vector<double> in;     ///< of a mean: input 11 runs over its nodes
    bool is_mean = false;
};

/// What came of a row.
struct SelftestOutcome {
    std::string name;           ///< golden_rows()
    std::string where;          ///< "host float", "host double" or "device"
    int lanes = 0;              ///< of the device
    std::size_t outputs = 0, misses = 0;
    double worst_ulp = 0, worst_relative = 0;  ///< among outputs whose bound is relative to themselves (at most 32 epsilon of their value)
    double worst_share = 0;     ///< largest share of its bound that an error took up, among all finite outputs with a value; at most 1 unless there are misses
    double seconds = 0;
    std::optional<SelftestMiss> first;
};

/// Sets of inputs for one sampler of a row, or the nodes of one mean, and what an evaluation made of them.
template <class Real>
struct SelftestLaunch {
    unsigned sampler = 0;
    std::vector<std::array<Real, 14>> in;
    std::vector<std::array<Real, 4>> out;
    std::vector<const GoldenSet<Real>*> sets;      ///< as many as `in`; none for a mean
    const GoldenMean<Real>* mean = nullptr;
    std::vector<double> weight;                    ///< of the nodes of the mean
};

template <class Real>
using SelftestEvaluator = std::function<std::vector<std::array<Real, 4>>(unsigned sampler, const std::vector<std::array<Real, 14>>& in)>;

/// The launches of a row, evaluated.
template <class Real>
std::vector<SelftestLaunch<Real>> evaluate_row(int row, const GoldenTable<Real>& table, const SelftestEvaluator<Real>& evaluate);

/// Compares them with the table. Fills everything but `where`, `lanes` and `seconds`.
template <class Real>
SelftestOutcome judge_row(int row, const std::vector<SelftestLaunch<Real>>& launches);

/// "output 0 of \"theta 0.01\" was 1.5 and not within [1.4999, 1.4999]".
std::string sentence_of(const SelftestMiss& miss);

}  // namespace tyndall

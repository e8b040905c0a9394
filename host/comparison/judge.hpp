#pragma once
/// What the runs say, and no more than their error bars carry.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparison/measure.hpp"

namespace tyndall {

/// relMSE of a candidate at one moment, over its runs, less the reference's own share of it.
struct ErrorAt {
    double seconds = 0;
    std::optional<Spread> relative_mse;  ///< nothing: a run had no pass finished by then
    /// The reference's noise is more than half of what was measured in some run: `relative_mse` is then what was measured, an upper bound.
    bool at_most = false;
};

struct Summary {
    std::vector<ErrorAt> curve;     ///< on a grid of times with equal ratios, from where every run has a pass, and the wanted times
    std::vector<ErrorAt> at_times;  ///< the wanted times
    Bias bias;                      ///< of the mean of the image, from every pass of every run
    BlockBias blocks;               ///< the same of blocks of 8 x 8 pixels
    std::optional<Spread> slope;       ///< of log error over log passes; nothing where the reference does not let it be seen
    std::optional<Spread> efficiency;  ///< 1 / (relMSE seconds) at the longest time; nothing where only a bound on relMSE is known
    Spread rmse, relative_mse, trimmed_relative_mse;  ///< at the end of the runs, reference's noise included
    Spread seconds_per_pass;
    int runs_with_outliers = 0;        ///< at the end (ImageError::has_outliers)
    std::size_t worst_pixel = 0;       ///< of the run whose largest terms hold most
    double share_of_largest = 0;       ///< of that run
};

/// Two candidates at one time: `better` had the lower error, by the mean of its logarithm, or by the median where there is only one run or a bound.
struct Verdict {
    std::size_t better = 0, worse = 0;  ///< indices
    double seconds = 0;
    double ratio = 1;            ///< relMSE of worse / better, at least 1: how many times longer the worse one needs for the same error, if errors fall with the root of time
    double low = 0, high = 0;    ///< interval of the ratio that holds with 95 % for all pairs asked about at that time together; high 0: unknown
    bool significant = false;    ///< the interval leaves 1 out
};

struct Judgement {
    std::vector<Summary> summaries;  ///< one per measurement
    std::vector<Verdict> verdicts;   ///< of the pairs asked about, at every wanted time where both have an error
};

/// Every two of so many.
std::vector<std::pair<std::size_t, std::size_t>> all_pairs(std::size_t candidates);

/// `pairs`: indices of measurements that are to be told apart. Every measurement has the same positive number of runs. With one run each nothing is ever significant; nor is what lies at the reference's own noise.
Judgement judge(const std::vector<Measurement>& measurements, const Reference& reference, const std::vector<double>& times, const std::vector<std::pair<std::size_t, std::size_t>>& pairs);

/// What a candidate needs beside another: relMSE over the other's at one time.
struct Price {
    double ratio = 1, low = 0, high = 0;  ///< with the verdict's interval; high 0: unknown
    bool significant = false;
};

/// The verdict on two candidates at a time, seen from `of`; nothing where one of them has no error then, or nobody asked.
std::optional<Price> price(const Judgement& judgement, std::size_t of, std::size_t beside, double seconds);

/// "path has 3.1 (2.2 to 4.4) times the relMSE of vrl at 6 s", or that the bars do not tell them apart.
std::string sentence(const Verdict& verdict, const std::vector<Measurement>& measurements);

/// "no bias found: -0.1 % +- 0.4 %", "biased by +2.0 % +- 0.3 % (z 13)", or that it is unknown.
std::string sentence(const Bias& bias);

}  // namespace tyndall

#pragma once
/// Means of independent measurements with their standard errors, and whether two of them differ by more than noise.
#include <cstddef>
#include <limits>
#include <span>

namespace tyndall {

/// A measured mean: its value, the variance of that value, and how well the variance is known.
struct MeanEstimate {
    double value = 0;
    double variance = 0;                                          ///< of `value`; 0 with infinite degrees: exact
    double degrees = std::numeric_limits<double>::infinity();     ///< of freedom of the variance; 0: unknown, one measurement only
};

/// Mean of independent measurements, one at a time [Welford 1962].
class RunningMean {
public:
    void add(double value);
    std::size_t count() const { return count_; }
    double mean() const { return mean_; }
    MeanEstimate estimate() const;
    /// As if the other's measurements had been added to these [Chan, Golub, LeVeque 1979].
    void merge(const RunningMean& other);

private:
    std::size_t count_ = 0;
    double mean_ = 0, squares_ = 0;  ///< squares: of the distances from the mean
};

/// How far a mean lies from a reference's.
struct Bias {
    double relative = 0;    ///< value / reference - 1
    double half_width = std::numeric_limits<double>::infinity();  ///< of the 95 % confidence interval around `relative`; infinite: unknown
    double z = 0;           ///< normal deviate as improbable as the difference is under noise alone; 0: unknown

    /// Beyond noise: the probability of so large a |z| without bias is .27 %.
    bool significant() const { return z > 3 || z < -3; }
};

/// Welch's comparison of two independent means; the reference's is positive (else everything is 0). Two exact means differ by an infinite z, or not at all.
Bias bias_of(const MeanEstimate& value, const MeanEstimate& reference);

/// The normal deviate with the same tail as Student's t with these degrees of freedom (positive, may be infinite), in [-37, 37]: the tail of 37 is the smallest double.
double normal_deviate(double t, double degrees);

/// Half width of the two-sided confidence interval of an estimate; infinite if its variance is unknown. `confidence` in (0, 1).
double half_width(const MeanEstimate& estimate, double confidence);

/// Degrees of freedom of the sum of two independent variances [Welch 1947].
double welch_degrees(const MeanEstimate& a, const MeanEstimate& b);

/// Middle value, or the mean of the two middle ones; NaN of nothing.
double median(std::span<const double> values);

}  // namespace tyndall

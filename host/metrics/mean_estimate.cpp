#include "metrics/mean_estimate.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

namespace tyndall {

void RunningMean::add(double value)
{
    const double distance = value - mean_;
    mean_ += distance / static_cast<double>(++count_);
    squares_ += distance * (value - mean_);
}

void RunningMean::merge(const RunningMean& other)
{
    if (other.count_ == 0) return;
    const double mine = static_cast<double>(count_), theirs = static_cast<double>(other.count_), all = mine + theirs, distance = other.mean_ - mean_;
    squares_ += other.squares_ + distance * distance * mine * theirs / all;
    mean_ += distance * theirs / all;
    count_ += other.count_;
}

MeanEstimate RunningMean::estimate() const
{
    const double n = static_cast<double>(count_);
    if (count_ < 2) return {mean_, 0, 0};
    return {mean_, squares_ / (n - 1) / n, n - 1};
}

double normal_deviate(double t, double degrees)
{
    constexpr double furthest = 37;
    double z = std::abs(t);
    if (std::isfinite(degrees) && std::isfinite(t)) {
        const double tail = boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), z));
        z = tail > 0 ? boost::math::quantile(boost::math::complement(boost::math::normal(), std::min(tail, .5))) : furthest;
    }
    return std::copysign(std::min(z, furthest), t);
}

double half_width(const MeanEstimate& estimate, double confidence)
{
    if (!(estimate.degrees > 0)) return std::numeric_limits<double>::infinity();
    const double tail = .5 * (1 - confidence);
    const double quantile = std::isfinite(estimate.degrees) ? boost::math::quantile(boost::math::complement(boost::math::students_t(estimate.degrees), tail))
                                                            : boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
    return quantile * std::sqrt(estimate.variance);
}

double welch_degrees(const MeanEstimate& a, const MeanEstimate& b)
{
    const auto share = [](const MeanEstimate& m) { return m.variance > 0 && std::isfinite(m.degrees) ? m.variance * m.variance / m.degrees : 0; };
    const double variance = a.variance + b.variance, shares = share(a) + share(b);
    return shares > 0 ? variance * variance / shares : std::numeric_limits<double>::infinity();
}

Bias bias_of(const MeanEstimate& value, const MeanEstimate& reference)
{
    if (!(reference.value > 0)) return {};
    Bias bias{.relative = value.value / reference.value - 1};
    if (value.degrees == 0 || reference.degrees == 0) return bias;
    const double difference = value.value - reference.value;
    const MeanEstimate both{difference, value.variance + reference.variance, welch_degrees(value, reference)};
    bias.half_width = half_width(both, .95) / reference.value;
    if (difference != 0) bias.z = normal_deviate(difference / std::sqrt(both.variance), both.degrees);
    return bias;
}

double median(std::span<const double> values)
{
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 ? sorted[middle] : .5 * (sorted[middle - 1] + sorted[middle]);
}

}  // namespace tyndall

#pragma once
/// How far passes lie from each other, one number a pass: what the error's own error bar follows from. Memory: 8 bytes a pass.
#include <span>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall {

/// Welford's increments of the relative mean square error. With x_j pass j of n, m_j the mean of the first j and weights w = 1 / (m^2 + e) as in
/// film/error_estimate.hpp,
///
///     d_j = (j - 1) / j   mean over pixels and channels of   w (x_j - m_(j-1))^2
///
/// each d_j (j >= 2) has the weighted variance of one pass as its expectation, so relMSE of the mean is their mean / n; they are uncorrelated, however the noise of
/// a pass is correlated between pixels. Weights come from m_(j-1), so early terms are rough: `relative_mse` takes the later half of them.
class PassSpread {
public:
    /// Pass number passes_before + 1; `mean` is that of the passes before it, of the same size (unused for the first). Passes that were not added were black.
    void add(std::span<const Rgb> pass, std::span<const Rgb> mean, int passes_before);

    /// relMSE of the mean of all passes; negative below two passes.
    double relative_mse() const;

    /// Relative standard error of `relative_mse`, from the spread of its terms; negative if there are fewer than three of them.
    double relative_standard_error() const;

    /// How many terms these are.
    std::size_t terms() const { return later().size(); }

private:
    std::span<const double> later() const;

    int passes_ = 0;
    std::vector<double> increments_;  ///< of passes 2, 3, ...
};

}  // namespace tyndall

#pragma once
/// How far passes lie from each other, one number a pass: what the error's own error bar follows from. Memory: at most 8 bytes a pass.
#include <span>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall {

/// Welford's increments of the relative mean square error within blocks of passes. With x_j pass j of a block, m_j the mean of the block's first j and weights
/// w = 1 / (m^2 + e) as in film/error_estimate.hpp,
///
///     d_j = (j - 1) / j   mean over pixels and channels of   w (x_j - m_(j-1))^2
///
/// each d_j (j >= 2) has the weighted variance of one pass as its expectation; they are uncorrelated, however the noise of a pass is correlated between pixels.
/// Weights come from m_(j-1), so early terms are rough: only those from the fifth pass of a block on are kept, or of its second half if that begins before. A term
/// knows nothing of other blocks, so films that were rendered apart have the same terms as one long render.
class PassSpread {
public:
    /// Pass number `before` of a block of `block_passes`, from 0; `sum` is that of the block's passes before it.
    void add(std::span<const Rgb> pass, std::vector<Rgb>&& sum, int before, int block_passes);

    /// The terms of a block that follows.
    void append(const PassSpread& other) { terms_.insert(terms_.end(), other.terms_.begin(), other.terms_.end()); }

    /// Relative standard error of a relMSE, from the spread of its terms; negative if there are fewer than three of them.
    double relative_standard_error() const;

    std::size_t terms() const { return terms_.size(); }

    template <class Stream, class Self>
    friend void fields(Stream& stream, Self& spread)
        requires std::is_same_v<std::remove_const_t<Self>, PassSpread>
    {
        stream(spread.terms_);
    }

private:
    std::vector<double> terms_;
};

}  // namespace tyndall

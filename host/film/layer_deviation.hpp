#pragma once
/// How far the passes of one layer lie from each other, pixel by pixel: what the layer's error follows from. Memory: 12 bytes per pixel.
#include <cstddef>
#include <functional>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall {

/// Sums of squared deviations from the mean of the block in progress, by Welford's recurrence, and for every block of passes one weighted mean of them, joined with the
/// blocks before it [Chan, Golub, LeVeque 1979]. With N passes of mean m before a block of b passes with mean y and squared deviations Q,
///
///     D = mean over pixels and channels of   w (Q + N b / (N + b) (y - m)^2),   w = 1 / (mean^2 + e) as in film/error_estimate.hpp, mean over N + b passes,
///
/// has b (b - 1 for N = 0) times the weighted variance of one pass as its expectation. Early weights are rough, so relMSE is taken from the last blocks that hold half of
/// what there is. All that a block adds is known from its own sums and those before it, so films that were rendered apart add up to the same numbers.
class LayerDeviation {
public:
    void prepare(std::size_t pixels)
    {
        if (squares_.empty()) squares_.assign(pixels, glm::vec3(0));
    }
    /// Pass number `before` of the block, from 0; `sum`: of the block's passes before it.
    void add(std::size_t pixel, const Rgb& value, const Rgb& sum, int before)
    {
        if (before == 0) return;
        const Rgb d = value - sum / static_cast<double>(before);
        squares_[pixel] += glm::vec3(d * d * (before / (before + 1.0)));
    }
    /// The sums of the layer, at a pixel.
    using SumAt = std::function<Rgb(std::size_t)>;
    /// Ends a block of `passes`, which `block` sums; `all` sums it and the `finished` passes before it. Starts an empty one.
    void close_block(const SumAt& block, const SumAt& all, int passes, int finished);
    /// relMSE of the mean of all passes, the block in progress (possibly of no passes) included; negative below two passes.
    double relative_mse(const SumAt& block, const SumAt& all, int passes, int finished) const;
    /// Puts the block in progress of another film in the place of this one's, which is empty.
    void take_block(LayerDeviation&& other)
    {
        if (!other.squares_.empty()) squares_ = std::move(other.squares_);
    }
    std::size_t memory_bytes() const { return squares_.capacity() * sizeof(glm::vec3); }
    bool empty() const { return squares_.empty(); }
    bool fits(std::size_t pixels) const { return (squares_.empty() || squares_.size() == pixels) && sums_.size() == freedoms_.size(); }

    template <class Stream, class Self>
    friend void fields(Stream& stream, Self& deviation)
        requires std::is_same_v<std::remove_const_t<Self>, LayerDeviation>
    {
        stream(deviation.squares_), stream(deviation.sums_), stream(deviation.freedoms_);
    }

private:
    double weighted(const SumAt& block, const SumAt& all, int passes, int finished) const;

    std::vector<glm::vec3> squares_;
    std::vector<double> sums_;   ///< D of each finished block
    std::vector<int> freedoms_;  ///< and what it is the sum of: b or b - 1
};

}  // namespace tyndall

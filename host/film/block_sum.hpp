#pragma once
/// Sums per pixel, grouped in blocks of passes: finished blocks in one total, the block in progress apart (film/film.hpp says why).
#include <cstddef>
#include <utility>
#include <vector>

namespace tyndall {

template <class T>
class BlockSum {
public:
    bool empty() const { return block_.empty(); }
    /// Takes memory for so many pixels at the first call; all sums are 0 then.
    void prepare(std::size_t pixels)
    {
        if (block_.empty()) block_.assign(pixels, T(0));
    }
    void add(std::size_t pixel, const T& value) { block_[pixel] += value; }
    /// Adds the block in progress to the total and starts an empty one.
    void close_block()
    {
        if (total_.empty()) {
            total_.assign(block_.size(), T(0));
            total_.swap(block_);  // 0 + x is x: the first block is the total
            return;
        }
        for (std::size_t i = 0; i < block_.size(); ++i) total_[i] += block_[i], block_[i] = T(0);
    }
    /// Puts the block in progress of another film in the place of this one's, which is empty.
    void take_block(BlockSum&& other)
    {
        if (other.empty()) return;
        prepare(other.block_.size());
        block_ = std::move(other.block_);
    }
    /// Sum over all passes so far; 0 for a pixel of a sum that was never prepared.
    T value(std::size_t pixel) const
    {
        if (block_.empty()) return T(0);
        return total_.empty() ? block_[pixel] : total_[pixel] + block_[pixel];
    }
    /// Sum over the passes of the block in progress.
    T block_value(std::size_t pixel) const { return block_.empty() ? T(0) : block_[pixel]; }
    std::size_t memory_bytes() const { return (block_.capacity() + total_.capacity()) * sizeof(T); }
    /// Every vector has this many pixels, or none.
    bool fits(std::size_t pixels) const { return (block_.empty() || block_.size() == pixels) && (total_.empty() || (total_.size() == pixels && !block_.empty())); }

    template <class Stream, class Self>
    friend void fields(Stream& stream, Self& sum)
        requires std::is_same_v<std::remove_const_t<Self>, BlockSum>
    {
        stream(sum.block_), stream(sum.total_);
    }

private:
    std::vector<T> block_, total_;
};

}  // namespace tyndall

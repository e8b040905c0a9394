#pragma once
/// Orders eyes so that those of a square of pixels lie together: they share one estimate of every light.
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/shared/records.hpp"

namespace tyndall {

/// What decides where an eye belongs. Eyes of one camera sample follow each other.
struct EyePlace {
    std::uint32_t pixel = 0, medium = 0, depth = 0, sample = 0;
    float length = 0;  ///< of an eye segment
};

/// Squares of `size` x `size` pixels of a film `width` pixels wide; the first corner lies offset pixels left of and above the film's.
struct BlockGrid {
    int width = 1, size = 8, offset_x = 0, offset_y = 0;
    std::uint32_t key = 0;  ///< random; each block mixes its number into it
    int samples = 1;        ///< of the camera per pixel
    int region = 8;         ///< squares across of a region
};

inline constexpr std::uint32_t no_eye = 0xffffffffu;

/// Eyes in groups of 16, groups in blocks. Neighbouring pixels of a full block lie in different groups, so that what a group's eyes share does not show as a square.
struct EyeBlocks {
    std::vector<std::uint32_t> order;     ///< number of the eye in each place; no_eye: padding
    std::vector<EyeBlock> blocks;
    std::vector<std::uint32_t> regions;   ///< number of each region's first block; its eyes are in one medium and at one depth
    std::vector<std::uint32_t> standing;  ///< numbers of eyes whose estimates blocks use (EyeBlock::standing): near the middle of their squares, among segments of three quarters of the longest one's length at least
};

/// Eyes of one block are of the same camera sample, in the same region and square, medium and depth, and are the same piece of their camera paths; the blocks of all camera
/// samples that agree in the rest follow each other and share one standing eye.
EyeBlocks block_eyes(std::span<const EyePlace> eyes, const BlockGrid& grid);

}  // namespace tyndall

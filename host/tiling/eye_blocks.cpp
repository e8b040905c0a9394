#include "tiling/eye_blocks.hpp"

#include <algorithm>
#include <tuple>

#include "device/pair_stage.hpp"

namespace tyndall {
namespace {

struct Placed {
    std::uint32_t region, medium, depth, square, piece, sample;  ///< the block's identity
    std::uint32_t lattice, index;                ///< order within it
    int from_middle;                             ///< squared distance of the pixel, in half pixels
    float length;                                ///< of its segment
};

auto region(const Placed& p) { return std::tie(p.region, p.medium, p.depth); }
auto without_sample(const Placed& p) { return std::tie(p.region, p.medium, p.depth, p.square, p.piece); }
auto identity(const Placed& p) { return std::tie(p.region, p.medium, p.depth, p.square, p.piece, p.sample); }

/// How many earlier eyes of the same camera path are in the same medium at the same depth?
std::uint32_t piece_number(std::span<const EyePlace> eyes, std::size_t i)
{
    std::uint32_t number = 0;
    for (std::size_t j = i; j > 0 && eyes[j - 1].pixel == eyes[i].pixel && eyes[j - 1].sample == eyes[i].sample; --j)
        if (eyes[j - 1].medium == eyes[i].medium && eyes[j - 1].depth == eyes[i].depth) ++number;
    return number;
}

std::vector<Placed> placed_eyes(std::span<const EyePlace> eyes, const BlockGrid& grid)
{
    const int across = (grid.width + grid.size - 1) / grid.size + 1, step = std::max(grid.size / 4, 1);
    std::vector<Placed> placed(eyes.size());
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        const int x = static_cast<int>(eyes[i].pixel) % grid.width + grid.offset_x, y = static_cast<int>(eyes[i].pixel) / grid.width + grid.offset_y;
        const int dx = 2 * (x % grid.size) + 1 - grid.size, dy = 2 * (y % grid.size) + 1 - grid.size;
        const int region_size = grid.size * grid.region;
        placed[i] = {.region = static_cast<std::uint32_t>(y / region_size * across + x / region_size),
                     .medium = eyes[i].medium,
                     .depth = eyes[i].depth,
                     .square = static_cast<std::uint32_t>(y / grid.size * across + x / grid.size),
                     .piece = piece_number(eyes, i),
                     .sample = eyes[i].sample,
                     .lattice = static_cast<std::uint32_t>(y % step * step + x % step),
                     .index = static_cast<std::uint32_t>(i),
                     .from_middle = dx * dx + dy * dy,
                     .length = eyes[i].length};
    }
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
        return std::tuple_cat(identity(a), std::tie(a.lattice, a.index)) < std::tuple_cat(identity(b), std::tie(b.lattice, b.index));
    });
    return placed;
}

std::uint32_t mixed(std::uint32_t key, std::uint32_t number)
{
    std::uint64_t x = (std::uint64_t(key) << 32 | number) * 0x9e3779b97f4a7c15ull;
    return static_cast<std::uint32_t>((x ^ x >> 29) * 0xbf58476d1ce4e5b9ull >> 32);
}

/// Appends the eyes first ... last - 1 as a block, padded.
void add_block(std::span<const Placed> placed, std::size_t first, std::size_t last, const BlockGrid& grid, EyeBlocks& all)
{
    const auto start = static_cast<std::uint32_t>(all.order.size() / eye_alignment);
    for (std::size_t i = first; i < last; ++i) all.order.push_back(placed[i].index);
    while (all.order.size() % eye_alignment != 0) all.order.push_back(no_eye);
    const auto standing = static_cast<std::uint32_t>(all.standing.size() - 1), groups = static_cast<std::uint32_t>(all.order.size() / eye_alignment) - start;
    all.blocks.push_back({start, groups, mixed(grid.key, standing), standing, placed[first].sample, static_cast<std::uint32_t>(grid.samples), 0, 0});
}

/// The eye nearest to the middle of those whose segments are long: at silhouettes a short one knows nothing of lights that the others pass.
std::uint32_t standing_eye(std::span<const Placed> square)
{
    constexpr float representative = .75f;
    const float longest = std::ranges::max(square, {}, &Placed::length).length;
    const Placed* found = nullptr;
    for (const Placed& p : square)
        if (p.length >= representative * longest && (!found || p.from_middle < found->from_middle)) found = &p;
    return found->index;
}

}  // namespace

EyeBlocks block_eyes(std::span<const EyePlace> eyes, const BlockGrid& grid)
{
    const std::vector<Placed> placed = placed_eyes(eyes, grid);
    EyeBlocks all;
    for (std::size_t first = 0, last = 0; first < placed.size(); first = last) {
        if (first == 0 || region(placed[first]) != region(placed[first - 1])) all.regions.push_back(static_cast<std::uint32_t>(all.blocks.size()));
        for (last = first; last < placed.size() && without_sample(placed[last]) == without_sample(placed[first]);) ++last;
        all.standing.push_back(standing_eye(std::span(placed).subspan(first, last - first)));
        for (std::size_t from = first, to = first; from < last; from = to) {
            while (to < last && placed[to].sample == placed[from].sample) ++to;
            add_block(placed, from, to, grid, all);
        }
    }
    return all;
}

}  // namespace tyndall

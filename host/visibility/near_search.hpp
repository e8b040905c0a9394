#pragma once
/// Which of many thick pieces of light paths come near an eye? An acceleration structure of Embree's, of the pieces' boxes.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall {

/// Everything within `radius` of a straight piece; a ball if its length is 0.
struct Capsule {
    Vec3 origin, direction;  ///< direction: unit; meaningless if the length is 0
    double length, radius;
};

/// For estimates of memory. Of each piece: its record, and what Embree 3.13 holds at most while it builds its tree (109 to 151 bytes for 1e6 to 1e3 boxes).
inline constexpr std::size_t near_bytes_per_piece = 24 + 152;
/// Pieces that a long capsule makes in the mean, at most.
inline constexpr std::size_t near_pieces_per_line = 17;

class NearSearch {
public:
    NearSearch();
    ~NearSearch();
    NearSearch(NearSearch&&) noexcept;

    /// Searches these from now on. Long ones are cut into pieces, so that their boxes are small.
    void set(std::span<const Capsule> capsules);

    /// Appends the numbers of all capsules that the segment comes into, in no order, some of them more than once; and of some that it misses by rounding.
    /// A point if the length is 0. May be called from several threads.
    void find(const Vec3& origin, const Vec3& direction, double length, std::vector<std::uint32_t>& found) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Least distance between two segments origin + t direction, 0 <= t <= length.
double segment_distance(const Vec3& origin_a, const Vec3& along_a, const Vec3& origin_b, const Vec3& along_b);

}  // namespace tyndall

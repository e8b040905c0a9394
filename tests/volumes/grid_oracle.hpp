#pragma once
/// Integrals of a grid along a segment in 50 digits, from the exact values of the inputs. Shares no code with kernels/: the value is a sum of hat functions
/// over the voxels, the segment is cut at every plane where it may have a kink, and each piece is integrated by Simpson's rule, exact for cubics.
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "kernels/shared/records.hpp"

namespace tyndall::test {

using Big = boost::multiprecision::cpp_bin_float_50;

class GridOracle {
public:
    GridOracle(const GridRecord& grid, const std::vector<float>& voxels, unsigned channel = 0) : grid_(grid), voxels_(voxels), channel_(channel)
    {
        size_ = {int(grid.size_x), int(grid.size_y), int(grid.size_z)};
        const float matrix[12] = {grid.x_x, grid.x_y, grid.x_z, grid.x_0, grid.y_x, grid.y_y, grid.y_z, grid.y_0, grid.z_x, grid.z_y, grid.z_z, grid.z_0};
        std::copy(std::begin(matrix), std::end(matrix), matrix_.begin());
        for (std::size_t i = 0; i < block(); ++i) largest_ = std::max(largest_, Big(voxels[first() + i]));
    }

    struct Answer {
        Big depth, value, clamped;            ///< of the segment; at its beginning
        Big depth_tolerance, value_tolerance;  ///< for spacing epsilon of the numbers that the inputs are computed with
        bool on_the_edge = false;              ///< so near to a face of the box, but not on it, that rounding decides on which side the beginning lies
    };

    template <class Real>
    Answer along(const std::array<Real, 6>& s, const Big& epsilon) const
    {
        const std::array<Big, 3> a{Big(s[0]), Big(s[1]), Big(s[2])}, b{Big(s[3]), Big(s[4]), Big(s[5])};
        const std::array<Big, 3> start = moved(a), end = moved(b);
        std::array<Big, 3> way;
        Big square = 0;
        for (int k = 0; k < 3; ++k) way[k] = end[k] - start[k], square += (b[k] - a[k]) * (b[k] - a[k]);
        const Big length = sqrt(square);
        Answer answer{integral(start, way) * length, inside(start) ? value(start) : Big(0), value(start), 0, 0};
        // A coordinate carries three roundings of the terms of its sum, as its way does, and two of their combination; a value moves by no more than
        // `largest` per voxel along each of three axes, and its own interpolations round thrice on each of the three axes, by half a spacing.
        const Big shift = 4 * epsilon * std::max(terms(a), terms(b));
        answer.value_tolerance = largest_ * (3 * shift + 5 * epsilon);
        for (std::size_t k = 0; k < 3; ++k)
            for (const Big& out : {Big(abs(start[k])), Big(abs(start[k] - size_[k]))}) answer.on_the_edge |= out > 0 && out <= shift;
        Big clipped = 0;  // how far the ends of the chord through the box may lie from where they should
        for (int k = 0; k < 3; ++k)
            for (const int plane : {0, size_[std::size_t(k)]})
                if (way[k] != 0)
                    if (const Big t = (plane - start[k]) / way[k]; t > -.01 && t < 1.01) clipped += shift / abs(way[k]) + 2 * epsilon * abs(t);
        answer.depth_tolerance = length * (answer.value_tolerance + largest_ * (clipped + 4 * epsilon)) + answer.depth * pieces_ * epsilon / 2;
        return answer;
    }

private:
    std::size_t block() const { return std::size_t(size_[0]) * std::size_t(size_[1]) * std::size_t(size_[2]); }
    std::size_t first() const { return grid_.first + channel_ * block(); }

    std::array<Big, 3> moved(const std::array<Big, 3>& p) const
    {
        std::array<Big, 3> q;
        for (std::size_t k = 0; k < 3; ++k) q[k] = matrix_[4 * k] * p[0] + matrix_[4 * k + 1] * p[1] + matrix_[4 * k + 2] * p[2] + matrix_[4 * k + 3];
        return q;
    }
    Big terms(const std::array<Big, 3>& p) const
    {
        Big most = 0;
        for (std::size_t k = 0; k < 3; ++k)
            most = std::max(most, Big(abs(matrix_[4 * k] * p[0]) + abs(matrix_[4 * k + 1] * p[1]) + abs(matrix_[4 * k + 2] * p[2]) + abs(matrix_[4 * k + 3])));
        return std::max(most, Big(1));
    }
    bool inside(const std::array<Big, 3>& p) const
    {
        for (std::size_t k = 0; k < 3; ++k)
            if (p[k] < 0 || p[k] > size_[k]) return false;
        return true;
    }
    /// Share of voxel i in the value at the coordinate x along an axis: a hat around its centre, flat beyond the outermost centres.
    static Big hat(const Big& x, int i, int size)
    {
        const Big within = std::min(std::max(x, Big(.5)), Big(size - .5)), distance = abs(within - i - Big(.5));
        return distance < 1 ? Big(1 - distance) : Big(0);
    }
    Big value(const std::array<Big, 3>& p) const
    {
        std::array<std::vector<Big>, 3> shares;
        for (std::size_t k = 0; k < 3; ++k)
            for (int i = 0; i < size_[k]; ++i) shares[k].push_back(hat(p[k], i, size_[k]));
        Big sum = 0;
        std::size_t voxel = first();
        for (const Big& z : shares[2])
            for (const Big& y : shares[1])
                for (const Big& x : shares[0]) {
                    if (x != 0 && y != 0 && z != 0) sum += x * y * z * voxels_[voxel];
                    ++voxel;
                }
        return sum;
    }
    Big integral(const std::array<Big, 3>& start, const std::array<Big, 3>& way) const
    {
        std::vector<Big> cuts{Big(0), Big(1)};
        for (std::size_t k = 0; k < 3; ++k)
            for (int half = 0; half <= 2 * size_[k]; ++half)
                if (way[k] != 0)
                    if (const Big t = (Big(half) / 2 - start[k]) / way[k]; t > 0 && t < 1) cuts.push_back(t);
        std::sort(cuts.begin(), cuts.end());
        const auto at = [&](const Big& t) { return std::array<Big, 3>{start[0] + t * way[0], start[1] + t * way[1], start[2] + t * way[2]}; };
        Big sum = 0;
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            const Big middle = (cuts[i - 1] + cuts[i]) / 2;
            if (!inside(at(middle))) continue;
            sum += (cuts[i] - cuts[i - 1]) / 6 * (value(at(cuts[i - 1])) + 4 * value(at(middle)) + value(at(cuts[i])));
        }
        pieces_ = int(cuts.size());
        return sum;
    }

    GridRecord grid_;
    const std::vector<float>& voxels_;
    unsigned channel_;
    std::array<int, 3> size_;
    std::array<float, 12> matrix_;
    Big largest_ = 0;
    mutable int pieces_ = 0;
};

}  // namespace tyndall::test

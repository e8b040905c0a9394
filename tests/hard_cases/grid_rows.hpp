#pragma once
/// Rows 19-21 as a device's selftest holds them: the grids of kernels/selftest/case_tables.hpp against sums of hat functions in 50 digits. tests/volumes has many more grids.
#include "kernels/selftest/case_tables.hpp"
#include "tests/hard_cases/cases.hpp"
#include "tests/volumes/grid_oracle.hpp"

namespace tyndall::test {

/// The segment between two points given in voxel coordinates of a grid of four voxels per unit of length.
template <class Real>
std::array<Real, 14> between_voxels(unsigned number, const std::array<double, 3>& from, const std::array<double, 3>& to)
{
    const GridRecord& g = case_tables::grids[number];
    const std::array<double, 3> shift{g.x_0, g.y_0, g.z_0};
    std::array<Real, 14> in{};
    for (std::size_t k = 0; k < 3; ++k) in[k] = Real((from[k] - shift[k]) / 4), in[3 + k] = Real((to[k] - shift[k]) / 4);
    return in;
}

template <class Real>
HardCase<Real> grid_case(std::string name, unsigned number, const std::array<Real, 14>& in)
{
    static const std::vector<float> voxels(case_tables::values.begin(), case_tables::values.end());
    const unsigned last_channel = number == CASE_COLOURED_GRID ? 2 : 0;
    const GridOracle first(case_tables::grids[number], voxels, 0), last(case_tables::grids[number], voxels, last_channel);
    const std::array<Real, 6> segment{in[0], in[1], in[2], in[3], in[4], in[5]};
    const auto a = first.along(segment, Big(epsilon<Real>)), b = last.along(segment, Big(epsilon<Real>));
    HardCase<Real> c{std::move(name), SAMPLER_GRID + number, in, {}};
    c.expected[2] = Interval::around(a.clamped, a.value_tolerance);
    if (a.on_the_edge) return c;  // rounding decides on which side of a face the segment begins
    c.expected[0] = Interval::around(a.depth, a.depth_tolerance), c.expected[3] = Interval::around(b.depth, b.depth_tolerance);
    c.expected[1] = Interval::around(a.value, a.value_tolerance);
    return c;
}

/// Ends anywhere in a box around the grid, twice as large.
template <class Real>
void add_anywhere(HardRow<Real>& row, const char* name, unsigned number, unsigned seed, int count)
{
    CaseRandom random(seed);
    for (int i = 0; i < count; ++i) {
        std::array<Real, 14> in{};
        for (std::size_t k = 0; k < 6; ++k) in[k] = Real(random.uniform(-1.25, 1.25));
        row.cases.push_back(grid_case<Real>(name, number, in));
    }
}

template <class Real>
HardRow<Real> grid_row19()
{
    HardRow<Real> row;
    for (const double y : {.25, .5, 1.})  // within the empty half and up to its plane: exactly 0
        for (const double end : {.25, .5}) {
            HardCase<Real> c{"in the empty half", SAMPLER_GRID, between_voxels<Real>(0, {-1, y, .5}, {end, y, .5}), {}};
            for (const std::size_t k : {0, 1, 2, 3}) c.expected[k] = {Big(0), Big(0)};
            row.cases.push_back(c);
        }
    for (const double z : {-.5, 0., .5, 1.})
        for (const double end : {.75, 1.5, 2., 3.}) row.cases.push_back(grid_case<Real>("out of the empty half", 0, between_voxels<Real>(0, {-1, .5, z}, {end, .5, z})));
    add_anywhere(row, "through two voxels", 0, 119, 20), add_anywhere(row, "through holes", 1, 120, 60);
    return row;
}

template <class Real>
HardRow<Real> grid_row20()
{
    HardRow<Real> row;
    const std::array<double, 3> size{5, 4, 3};
    const auto add = [&](const char* name, const std::array<double, 3>& from, const std::array<double, 3>& to) {
        row.cases.push_back(grid_case<Real>(name, 1, between_voxels<Real>(1, from, to)));
        row.cases.push_back(grid_case<Real>(name, 1, between_voxels<Real>(1, to, from)));
    };
    for (const std::size_t axis : {0u, 1u, 2u})
        for (const double a : {0., .5, 1., 1.5, -.25})
            for (const double b : {0., .5, 2., 3.}) {
                std::array<double, 3> from{}, to{};
                from[axis] = -1, to[axis] = size[axis] + 1, from[(axis + 1) % 3] = to[(axis + 1) % 3] = a, from[(axis + 2) % 3] = to[(axis + 2) % 3] = b;
                add("parallel to an axis", from, to);
                from[axis] = .5, to[axis] = size[axis] - .5;
                add("from plane to plane", from, to);
            }
    for (const double through : {0., .5, 1.}) {
        add("through edges", {through - 4, through + 4, 1.25}, {through + 4, through - 4, 1.25});
        add("through corners", {through - 4, through - 4, through - 4}, {through + 4, through + 4, through + 4});
    }
    for (const double x : {0., .5, .7, 5.}) add("of no length", {x, x, .5}, {x, x, .5});
    std::array<Real, 14> in = between_voxels<Real>(1, {-1, 2, 1.5}, {6, 2, 1.5});
    in[1] = in[2] = in[4] = in[5] = Real(-0.);
    row.cases.push_back(grid_case<Real>("negative zeros", 1, in));
    return row;
}

template <class Real>
HardRow<Real> grid_row21()
{
    HardRow<Real> row;
    add_anywhere(row, "through holes", 1, 121, 60), add_anywhere(row, "sheared", 2, 122, 60), add_anywhere(row, "three channels", 3, 123, 60);
    return row;
}

}  // namespace tyndall::test

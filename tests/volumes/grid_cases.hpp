#pragma once
/// Grids and segments that have broken traversals: rows 19, 20 and 21 of the hard cases (host/docs/hard_cases.md).
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "tests/volumes/grid_oracle.hpp"

namespace tyndall::test {

using Point = std::array<double, 3>;

/// Voxels and where they are: `corner` + the voxel coordinates times the three columns is a point of render space.
struct TestGrid {
    std::string name;
    GridRecord record{};
    std::vector<float> voxels;
    unsigned channels = 1;
    Point corner{};
    std::array<Point, 3> columns{};

    Point place(const Point& voxel) const
    {
        Point p = corner;
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k) p[k] += voxel[c] * columns[c][k];
        return p;
    }
};

template <class Real>
struct GridRow {
    TestGrid grid;
    std::vector<std::array<Real, 6>> segments;
};

struct GridRandom {
    std::mt19937_64 engine;
    explicit GridRandom(unsigned seed) : engine(seed) {}
    double uniform(double a, double b) { return a + (b - a) * double(engine() >> 11) * 0x1p-53; }
    Point point(double low, double high) { return {uniform(low, high), uniform(low, high), uniform(low, high)}; }
};

inline Point cross(const Point& a, const Point& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// `fill` gives the value of voxel number i (over all channels).
inline TestGrid placed_grid(std::string name, const std::array<unsigned, 3>& size, const Point& corner, const std::array<Point, 3>& columns,
                            const std::function<float(std::size_t)>& fill, unsigned channels = 1)
{
    TestGrid grid{.name = std::move(name), .channels = channels, .corner = corner, .columns = columns};
    const double volume = dot(columns[0], cross(columns[1], columns[2]));
    float* row = &grid.record.x_x;
    for (std::size_t k = 0; k < 3; ++k, row += 4) {
        const Point normal = cross(columns[(k + 1) % 3], columns[(k + 2) % 3]);
        for (std::size_t i = 0; i < 3; ++i) row[i] = float(normal[i] / volume);
        row[3] = float(-dot(normal, corner) / volume);
    }
    grid.record.size_x = size[0], grid.record.size_y = size[1], grid.record.size_z = size[2], grid.record.first = 3;  // something else lies before it
    grid.voxels = {1e30f, 1e30f, 1e30f};
    for (std::size_t i = 0; i < std::size_t(size[0]) * size[1] * size[2] * channels; ++i) grid.voxels.push_back(fill(i));
    return grid;
}

/// Four voxels per unit of length around the origin: every coordinate of a case is exact.
inline TestGrid plain_grid(std::string name, const std::array<unsigned, 3>& size, const std::function<float(std::size_t)>& fill, unsigned channels = 1)
{
    return placed_grid(std::move(name), size, {-.125 * size[0], -.125 * size[1], -.125 * size[2]}, {{{.25, 0, 0}, {0, .25, 0}, {0, 0, .25}}}, fill, channels);
}

inline std::function<float(std::size_t)> noise(unsigned seed, double empty = 0)
{
    return [=](std::size_t i) {
        GridRandom random(seed + unsigned(i) * 7919u);
        return random.uniform(0, 1) < empty ? 0.f : float(random.uniform(.1, 3));
    };
}

template <class Real>
std::array<Real, 6> segment(const TestGrid& grid, const Point& from, const Point& to)
{
    const Point a = grid.place(from), b = grid.place(to);
    return {Real(a[0]), Real(a[1]), Real(a[2]), Real(b[0]), Real(b[1]), Real(b[2])};
}

/// Segments with ends anywhere in a box around the grid, three times as large.
template <class Real>
void add_anywhere(GridRow<Real>& row, unsigned seed, int count)
{
    GridRandom random(seed);
    const GridRecord& r = row.grid.record;
    const auto any = [&] { return Point{random.uniform(-1., 2.) * r.size_x, random.uniform(-1., 2.) * r.size_y, random.uniform(-1., 2.) * r.size_z}; };
    for (int i = 0; i < count; ++i) row.segments.push_back(segment<Real>(row.grid, any(), any()));
}

/// Through special places across the other two axes, forwards and backwards, from outside to outside, between cells, and from planes to planes.
template <class Real>
void add_axis_parallel(GridRow<Real>& row, std::size_t axis)
{
    const std::array<double, 3> size{double(row.grid.record.size_x), double(row.grid.record.size_y), double(row.grid.record.size_z)};
    const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
    const auto places = [&](std::size_t k) { return std::vector<double>{-.25, 0, .25, .5, 1, std::min(1.5, size[k]), size[k] - .5, size[k], size[k] + .25}; };
    for (const double a : places(second))
        for (const double b : places(third))
            for (const auto& [t0, t1] : {std::pair(-1., size[axis] + 1), std::pair(.5, size[axis] - .5), std::pair(0., size[axis]), std::pair(.3, size[axis] - .2)}) {
                Point from{}, to{};
                from[axis] = t0, to[axis] = t1, from[second] = to[second] = a, from[third] = to[third] = b;
                row.segments.push_back(segment<Real>(row.grid, from, to));
                row.segments.push_back(segment<Real>(row.grid, to, from));
            }
}

/// Every coordinate of the first half of the segments moved by one spacing up, of the second half down.
template <class Real>
void add_beside(GridRow<Real>& row)
{
    const std::size_t count = row.segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        std::array<Real, 6> s = row.segments[i];
        for (Real& x : s) x = std::nextafter(x, (i % 2 ? -1 : 1) * std::numeric_limits<Real>::infinity());
        row.segments.push_back(s);
    }
}

template <class Real>
void add_diagonals(GridRow<Real>& row)
{
    const GridRecord& r = row.grid.record;
    const Point ends[] = {{0, 0, 0}, {double(r.size_x), double(r.size_y), double(r.size_z)}};
    for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
        Point from, to;
        for (std::size_t k = 0; k < 3; ++k) from[k] = ends[corner >> k & 1][k], to[k] = ends[!(corner >> k & 1)][k];
        row.segments.push_back(segment<Real>(row.grid, from, to));
    }
    for (const Point d : {Point{1, 1, 1}, Point{1, -1, 1}, Point{1, 1, 0}, Point{0, -1, 1}, Point{-1, 0, 1}, Point{2, 1, 1}})
        for (const double through : {.5, 1., 1.5, 0.}) {  // through edges and corners of cells, of voxels and of the box
            Point from, to;
            for (std::size_t k = 0; k < 3; ++k) from[k] = through - 4 * d[k], to[k] = through + 4 * d[k];
            row.segments.push_back(segment<Real>(row.grid, from, to));
        }
}

template <class Real>
void add_zero_length(GridRow<Real>& row)
{
    for (const Point p : {Point{.7, .8, .9}, Point{.5, .5, .5}, Point{0, 0, 0}, Point{1, .5, 0}, Point{-1, 0, 0}}) row.segments.push_back(segment<Real>(row.grid, p, p));
}

/// Row 19: empty voxels, up to empty grids.
template <class Real>
std::vector<GridRow<Real>> row19()
{
    std::vector<GridRow<Real>> rows;
    const auto pair = [](float a, float b) { return [=](std::size_t i) { return i ? b : a; }; };
    rows.push_back({plain_grid("0 1 along x", {2, 1, 1}, pair(0, 1)), {}});
    rows.push_back({plain_grid("1 0 along y", {1, 2, 1}, pair(1, 0)), {}});
    rows.push_back({plain_grid("0 0 along z", {1, 1, 2}, pair(0, 0)), {}});
    rows.push_back({plain_grid("one full voxel of 27", {3, 3, 3}, [](std::size_t i) { return i == 13 ? 2.f : 0.f; }), {}});
    rows.push_back({plain_grid("half empty", {4, 3, 5}, noise(191, .5)), {}});
    for (GridRow<Real>& row : rows) {
        for (const std::size_t axis : {0u, 1u, 2u}) add_axis_parallel(row, axis);
        add_anywhere(row, 192, 40), add_zero_length(row);
    }
    return rows;
}

/// Row 20: faces, edges, corners, axis-parallel ways, ways of no length, what lies one spacing beside.
template <class Real>
std::vector<GridRow<Real>> row20()
{
    std::vector<GridRow<Real>> rows;
    rows.push_back({plain_grid("cube", {4, 4, 4}, noise(201)), {}});
    rows.push_back({plain_grid("one voxel", {1, 1, 1}, noise(202)), {}});
    rows.push_back({plain_grid("needle", {1, 7, 1}, noise(203, .3)), {}});
    rows.push_back({plain_grid("sheet", {5, 1, 4}, noise(204)), {}});
    TestGrid negative = plain_grid("negative zeros", {3, 4, 3}, noise(205));
    GridRecord& r = negative.record;
    r.x_y = r.x_z = r.y_x = r.y_z = r.z_x = r.z_y = -0.f;
    rows.push_back({std::move(negative), {}});
    rows.push_back({placed_grid("mirrored", {4, 3, 3}, {.5, -.5, .5}, {{{-.25, 0, 0}, {0, .5, 0}, {0, 0, -.25}}}, noise(206)), {}});
    for (GridRow<Real>& row : rows) {
        for (const std::size_t axis : {0u, 1u, 2u}) add_axis_parallel(row, axis);
        add_diagonals(row), add_zero_length(row);
        add_beside(row);
    }
    return rows;
}

/// Row 21: trilinear values, seen from anywhere, in boxes of any form and place.
template <class Real>
std::vector<GridRow<Real>> row21()
{
    std::vector<GridRow<Real>> rows;
    rows.push_back({plain_grid("noise", {6, 5, 4}, noise(211)), {}});
    rows.push_back({plain_grid("three channels", {3, 4, 3}, noise(212), 3), {}});
    rows.push_back({placed_grid("rotated", {5, 4, 6}, {.1, -.2, .3}, {{{.08, .06, 0}, {-.06, .08, 0}, {0, 0, .1}}}, noise(213)), {}});
    rows.push_back({placed_grid("sheared", {4, 6, 3}, {-.3, .1, 0}, {{{.1, .02, -.01}, {.05, .08, .03}, {-.02, .04, .12}}}, noise(214, .3)), {}});
    rows.push_back({placed_grid("needle askew", {1, 9, 1}, {.2, .2, -.4}, {{{.3, .1, 0}, {.01, .05, .06}, {-.1, .2, .3}}}, noise(215)), {}});
    rows.push_back({placed_grid("flat", {8, 8, 1}, {-.5, -.5, 0}, {{{.125, 0, 0}, {0, .125, 0}, {0, 0, 1e-3}}}, noise(216)), {}});
    unsigned seed = 217;
    for (GridRow<Real>& row : rows) add_anywhere(row, seed++, 120);
    return rows;
}

}  // namespace tyndall::test

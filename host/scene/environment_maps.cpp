#include "scene/environment_maps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace tyndall {
namespace {

constexpr double pi = std::numbers::pi;

Rgb texel(const EnvironmentMap& map, std::size_t x, std::size_t y)
{
    const float* value = map.texels.data() + 3 * (y * static_cast<std::size_t>(map.width) + x % static_cast<std::size_t>(map.width));
    return {value[0], value[1], value[2]};
}

/// Of linear sRGB.
double luminance(const Rgb& c) { return .2126 * c.r + .7152 * c.g + .0722 * c.b; }

/// Where a direction lies: the cell between texels x, x + 1 and rows y, y + 1, and the place in it.
struct CellPlace {
    std::size_t x, y;
    double across, down;  ///< in [0, 1]
};

CellPlace place_of(const EnvironmentMap& map, const Vec3& towards)
{
    const double turn = std::atan2(towards.x, -towards.z) / (2 * pi), angle = std::atan2(std::hypot(towards.x, towards.z), towards.y) / pi;
    const double across = turn * map.width - .5, column = std::floor(across), down = angle * (map.height - 1);
    const double row = std::clamp(std::floor(down), 0.0, double(map.height - 2));
    const double wrapped = column - map.width * std::floor(column / map.width);
    return {.x = static_cast<std::size_t>(std::clamp(wrapped, 0.0, double(map.width - 1))), .y = static_cast<std::size_t>(row), .across = across - column, .down = std::clamp(down - row, 0.0, 1.0)};
}

/// Cosine of row y's angle to straight up.
double cosine_of(const EnvironmentMap& map, std::size_t y) { return std::cos(pi * double(y) / double(map.height - 1)); }

/// What a row of cells takes of the sphere, as a difference of cosines: 2 sin a sin b does not cancel near the poles.
double height_of(const EnvironmentMap& map, std::size_t y)
{
    const double step = pi / double(map.height - 1);
    return 2 * std::sin(step * (double(y) + .5)) * std::sin(.5 * step);
}

/// Into a cumulative distribution that ends at 1; an even one where all weights are 0. Returns the sum.
double accumulate(std::span<double> weights)
{
    double sum = 0;
    for (double& weight : weights) weight = sum += weight;
    const double n = static_cast<double>(weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = sum > 0 ? weights[i] / sum : double(i + 1) / n;
    return sum;
}

struct Interval {
    std::size_t index;
    double probability, place;  ///< place: of xi in the interval, in [0, 1)
};

double begin_of(std::span<const double> cumulative, std::size_t i) { return i == 0 ? 0 : cumulative[i - 1]; }

Interval choose(std::span<const double> cumulative, double xi)
{
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end(), xi);
    const std::size_t i = std::min<std::size_t>(static_cast<std::size_t>(found - cumulative.begin()), cumulative.size() - 1);
    const double low = begin_of(cumulative, i), share = cumulative[i] - low;
    return {.index = i, .probability = share, .place = std::clamp((xi - low) / share, 0.0, 0x1.fffffffffffffp-1)};
}

std::span<const double> cells_of(const EnvironmentMap& map, std::size_t row)
{
    return std::span(map.columns).subspan(row * static_cast<std::size_t>(map.width), static_cast<std::size_t>(map.width));
}

/// Probability of a cell over its solid angle.
double density(const EnvironmentMap& map, std::size_t row, double row_probability, double cell_probability)
{
    return row_probability * cell_probability * map.width / (2 * pi * height_of(map, row));
}

}  // namespace

void prepare_environment(EnvironmentMap& map)
{
    const std::size_t width = static_cast<std::size_t>(map.width), rows = static_cast<std::size_t>(map.height) - 1;
    map.rows.assign(rows, 0), map.columns.assign(rows * width, 0), map.mean = Rgb(0);
    for (std::size_t y = 0; y < rows; ++y) {
        const double height = height_of(map, y);
        for (std::size_t x = 0; x < width; ++x) {
            const Rgb mean = .25 * (texel(map, x, y) + texel(map, x + 1, y) + texel(map, x, y + 1) + texel(map, x + 1, y + 1));
            map.columns[y * width + x] = luminance(mean);
            map.mean += mean * (height / (2 * double(width)));
        }
        map.rows[y] = height * accumulate(std::span(map.columns).subspan(y * width, width));
    }
    if (!(accumulate(map.rows) > 0))
        for (std::size_t y = 0; y < rows; ++y) map.rows[y] = .5 * (1 - cosine_of(map, y + 1));
}

Rgb radiance_from(const EnvironmentMap& map, const Vec3& towards)
{
    const CellPlace p = place_of(map, towards);
    const Rgb above = (1 - p.across) * texel(map, p.x, p.y) + p.across * texel(map, p.x + 1, p.y);
    const Rgb below = (1 - p.across) * texel(map, p.x, p.y + 1) + p.across * texel(map, p.x + 1, p.y + 1);
    return (1 - p.down) * above + p.down * below;
}

EnvironmentSample sample_environment(const EnvironmentMap& map, const Vec2& xi)
{
    const Interval row = choose(map.rows, xi.y), cell = choose(cells_of(map, row.index), xi.x);
    const double c = std::clamp(cosine_of(map, row.index) - row.place * height_of(map, row.index), -1.0, 1.0), s = std::sqrt((1 - c) * (1 + c));
    const double azimuth = 2 * pi * (double(cell.index) + .5 + cell.place) / map.width;
    return {.towards = {s * std::sin(azimuth), c, -s * std::cos(azimuth)}, .pdf = density(map, row.index, row.probability, cell.probability)};
}

double pdf_environment(const EnvironmentMap& map, const Vec3& towards)
{
    const CellPlace p = place_of(map, towards);
    const auto cells = cells_of(map, p.y);
    return density(map, p.y, map.rows[p.y] - begin_of(map.rows, p.y), cells[p.x] - begin_of(cells, p.x));
}

}  // namespace tyndall

/// The product of two Henyey-Greenstein lobes, g = .95, over the angle under which an eye segment is seen from a point of a light, and the ten-vertex density that the
/// sampler `paper` draws from: as JSON on standard output, for bench/product_figure.py. The kernels' own mathematics, in double.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "kernels/dialect_host.hpp"

int main()
{
    using namespace tyndall::maths_double;
    constexpr double g = .95, length = 4;
    constexpr int points = 2000;
    // A light that passes before the eye at an angle of 70 degrees: its forward lobe meets the segment near the middle of the arc, the eye's at its far end.
    const real3 p = make_real3(.5, 0, 1.5), a = make_real3(0, 0, 1), b = make_real3(-std::sin(1.2), 0, std::cos(1.2));
    const GuideMedia media = {g, g, 0, 0, 0};
    const WarpShape shape = {10, 1, 0};
    const PhaseFan fan = phase_fan(p, a, length, b, media, shape);
    const PhaseTable table = phase_table(fan, shape);
    double mean = 0, worst = 0;
    for (int i = 0; i < points; ++i) mean += fan_value(fan, shape, fan_direction(fan, (i + .5) / points)) / points;
    std::printf("{\"g\": %g, \"start\": %.6f, \"extent\": %.6f, \"vertices\": [", g, fan.start, fan.extent);
    for (int j = 0; j < shape.vertices; ++j) std::printf("%s[%.6f, %.6g]", j ? ", " : "", table.x[j], table_density(table, shape, table.x[j]));
    std::printf("], \"curve\": [");
    for (int i = 0; i < points; ++i) {
        const double x = (i + .5) / points, f = fan_value(fan, shape, fan_direction(fan, x)) / mean, density = table_density(table, shape, x);
        worst = std::max(worst, f / density);
        if (i % 5 == 0) std::printf("%s[%.5f, %.6g, %.6g]", i ? ", " : "", x, f, density);
    }
    std::printf("], \"largest_ratio\": %.4g}\n", worst);
}

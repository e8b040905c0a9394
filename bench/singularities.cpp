/// What bench/singular_moments.hpp gives for distances from 1e-1 down to 1e-7, as JSON on standard output, for bench/singularities.py.
#include <cstdio>

#include "bench/singular_moments.hpp"

int main()
{
    using namespace tyndall::singular;
    constexpr struct {
        const char* name;
        double (*moment)(double);
    } rows[] = {{"point light - surface", point_to_surface}, {"point light - eye segment", point_to_segment}, {"ray light - surface", ray_to_surface}, {"ray light - eye segment", ray_to_segment}};
    std::printf("{");
    for (const auto& row : rows) {
        std::printf("%s\"%s\": [", &row == rows ? "" : ", ", row.name);
        for (int i = 0; i <= 24; ++i) {
            const double h = std::pow(10., -1 - i / 4.);
            std::printf("%s[%.6e, %.6e]", i ? ", " : "", h, row.moment(h));
        }
        std::printf("]");
    }
    std::printf("}\n");
}

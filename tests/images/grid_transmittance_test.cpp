/// A black plume before a light from everywhere: each pixel shows the transmittance of the grid along its ray, which is integrated here from the bytes of the file.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>

#include "pipeline/render.hpp"
#include "scene/load_scene.hpp"
#include "transport/camera.hpp"

using namespace tyndall;

namespace {

const std::string folder = std::string(TYNDALL_SOURCE_DIR) + "/tests/images/scenes/";

/// The 64^3 values of the plume, [z][y][x], after a header of 48 bytes.
std::vector<float> plume_voxels()
{
    std::ifstream file(folder + "plume64.vol", std::ios::binary);
    std::vector<float> voxels(64 * 64 * 64);
    file.seekg(48);
    file.read(reinterpret_cast<char*>(voxels.data()), std::streamsize(voxels.size() * sizeof(float)));
    EXPECT_TRUE(file);
    return voxels;
}

/// Trilinear between the centres of voxels in the cube [-1, 1]^3, 0 outside of it.
double density(const std::vector<float>& voxels, const Vec3& p)
{
    std::array<int, 3> low;
    std::array<double, 3> f;
    for (int k = 0; k < 3; ++k) {
        if (std::abs(p[k]) > 1) return 0;
        const double at = std::min(std::max(32 * (p[k] + 1) - .5, 0.), 63.);
        low[std::size_t(k)] = std::min(int(at), 62), f[std::size_t(k)] = at - low[std::size_t(k)];
    }
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double share = 1;
        std::size_t index = 0;
        for (int k = 2; k >= 0; --k) {
            const int up = corner >> k & 1;
            share *= up ? f[std::size_t(k)] : 1 - f[std::size_t(k)];
            index = 64 * index + std::size_t(low[std::size_t(k)] + up);
        }
        sum += share * voxels[index];
    }
    return sum;
}

class PlumeTransmittance : public testing::TestWithParam<Method> {};

TEST_P(PlumeTransmittance, IsTheImageOfTheBlackPlume)
{
    const Scene scene = load_scene(folder + "u_plume_transmittance.xml");
    const std::vector<float> voxels = plume_voxels();
    const RenderOutcome outcome = render(scene, {.method = GetParam(), .passes = 1, .seed = 5});
    const std::vector<Rgb> image = outcome.film.beauty();
    double darkest = 1;
    for (int y = 0; y < 64; y += 2)
        for (int x = 0; x < 64; x += 2) {
            const Ray ray = sample_camera(scene.camera, x, y, 5, 0).ray;
            const Vec3 origin = scene.centre + scene.unit * ray.origin;  // in the units of the file
            constexpr int steps = 30000;
            constexpr double from = 2, step = 4.5 / steps;  // the camera is 4.2 away from the middle, the cube's corners sqrt(3)
            double depth = 0;
            for (int i = 0; i < steps; ++i) depth += 7 * step * density(voxels, origin + (from + (i + .5) * step) * ray.direction);
            const double transmittance = std::exp(-depth);
            // The midpoint rule is off by no more than half a step's share of the extinction where the ray enters and leaves: 7 x 7.5e-5 x density each.
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(image[std::size_t(64 * y + x)][c], transmittance, 1e-3) << x << ' ' << y;
            darkest = std::min(darkest, transmittance);
        }
    EXPECT_LT(darkest, .05) << "there is smoke";
}

INSTANTIATE_TEST_SUITE_P(By, PlumeTransmittance, testing::Values(Method::vrl, Method::path), [](const auto& info) { return info.param == Method::vrl ? "vrl" : "path"; });

}  // namespace

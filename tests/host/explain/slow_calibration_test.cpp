/// Seconds that are predicted beside seconds that pass, within the factor of three that a busy machine allows; the factor of two of a quiet one is the bench's to hold (bench/effects/prediction.py).
#include <gtest/gtest.h>

#include "pipeline/explain.hpp"
#include "pipeline/render.hpp"
#include "scene/load_scene.hpp"

namespace tyndall::test {
namespace {

void expect_predicted(const Scene& scene, const RenderSettings& settings, double budget)
{
    const Calibration c = calibrate(scene, settings, budget);
    const Report report = render(scene, settings).report;
    const double measured = (report.seconds - report.before_seconds) / report.passes;
    EXPECT_LT(c.pass_seconds, 3 * measured);
    EXPECT_GT(c.pass_seconds, measured / 3);
}

Scene room(int side)
{
    Scene scene = load_scene(std::filesystem::path(TYNDALL_SOURCE_DIR) / "scenes/forward_fog/scene.xml");
    scene.camera.width = scene.camera.height = scene.camera.crop_width = scene.camera.crop_height = side;
    return scene;
}

TEST(SlowCalibration, PredictsAPassWithinAFactorOfThree) { expect_predicted(room(32), {.passes = 24, .lights = 256}, .5); }
TEST(SlowCalibration, ScalesAShrunkFilmBack) { expect_predicted(room(384), {.passes = 2, .lights = 64}, .2); }

}  // namespace
}  // namespace tyndall::test

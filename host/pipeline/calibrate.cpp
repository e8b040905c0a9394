#include <algorithm>
#include <chrono>
#include <cmath>

#include "pipeline/explain.hpp"
#include "pipeline/light_selection_plan.hpp"
#include "pipeline/render.hpp"

namespace tyndall {
namespace {

constexpr int fewest_passes = 3, most_passes = 64;
constexpr double share_of_a_pass = .25;  ///< of the seconds: the first pass and three more fit

/// What a render of a few passes showed.
struct Measured {
    double before = 0, first = 0, mean = 0, lights = 0;  ///< seconds; lights: of the mean, spent on tracing light paths, which does not grow with the pixels
    double error = -1;                                   ///< of one pass
    int passes = 0;                                      ///< after the first
};

double seconds_of(const Report& report, const std::string& stage)
{
    double seconds = 0;
    for (const StageTime& s : report.stages)
        if (s.stage == stage) seconds += s.seconds;
    return seconds;
}

Measured measure(const Scene& scene, RenderSettings settings, double seconds)
{
    settings.passes = most_passes, settings.seconds = 0;
    std::vector<double> ends;
    const auto go_on = [&](const Progress& progress, const Film&) {
        ends.push_back(progress.seconds);
        const double next = ends.size() > 1 ? ends.back() - ends[ends.size() - 2] : 0;
        return ends.size() < fewest_passes || progress.seconds + next < seconds;
    };
    const Report report = render(scene, settings, go_on).report;
    Measured m{.passes = report.passes - 1};
    m.mean = (ends.back() - ends.front()) / m.passes;
    m.lights = seconds_of(report, "trace_lights") / report.passes;
    m.before = report.before_seconds, m.first = ends.front() - m.before;
    m.error = report.error < 0 ? -1 : report.error * std::sqrt(double(report.passes));  // variance falls with 1 / passes
    return m;
}

/// The scene with a film of about `share` of the pixels.
Scene shrunk(const Scene& scene, double share)
{
    Scene small = scene;
    Camera& camera = small.camera;
    const double factor = std::sqrt(share);
    const auto scaled = [&](int size) { return std::max(static_cast<int>(std::lround(size * factor)), 1); };
    const int right = scaled(camera.crop_x + camera.crop_width), bottom = scaled(camera.crop_y + camera.crop_height);
    camera.width = scaled(camera.width), camera.height = scaled(camera.height);
    camera.crop_x = std::min(scaled(camera.crop_x) - (camera.crop_x == 0), right - 1), camera.crop_y = std::min(scaled(camera.crop_y) - (camera.crop_y == 0), bottom - 1);
    camera.crop_x = std::max(camera.crop_x, 0), camera.crop_y = std::max(camera.crop_y, 0);
    camera.crop_width = right - camera.crop_x, camera.crop_height = bottom - camera.crop_y;
    return small;
}

double pixels(const Scene& scene) { return double(scene.camera.crop_width) * scene.camera.crop_height; }

}  // namespace

Calibration calibrate(const Scene& scene, const RenderSettings& wanted, double seconds)
{
    const RenderSettings settings = with_plan(wanted, plan_selection(wanted, scene.camera));  // of the whole film and the real budget
    const Scene pilot = shrunk(scene, 1.0 / 64);
    const Measured small = measure(pilot, settings, seconds / 4);
    const double growing = (small.mean - small.lights) * pixels(scene) / pixels(pilot);
    const double share = growing > 0 ? std::min(1.0, std::max(share_of_a_pass * seconds / growing, 1.0 / 64)) : 1;
    const Scene film = share < .8 ? shrunk(scene, share) : scene;  // what nearly fits is not shrunk
    const Measured m = measure(film, settings, seconds);
    const double scale = pixels(scene) / pixels(film);
    const auto whole = [&](double pass) { return m.lights + std::max(pass - m.lights, 0.0) * scale; };
    Calibration c{.passes = m.passes, .film_share = 1 / scale, .before_seconds = m.before, .first_pass_seconds = whole(m.first), .pass_seconds = whole(m.mean), .error = m.error};
    constexpr double target = .01;
    if (m.error >= 0) c.seconds_to_one_percent = c.before_seconds + c.pass_seconds * std::max(std::ceil(std::pow(m.error / target, 2)), 1.0);
    return c;
}

}  // namespace tyndall

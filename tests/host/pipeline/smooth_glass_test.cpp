/// Light of a point through smooth glass, which neither paths nor straight connections find: photon beams at three radii, extrapolated to none, against geometrical optics by quadrature. The
/// oracle shares no code with the renderer: Snell, Fresnel and the spreading of a pencil of rays through a plate, as they stand in a textbook.
#include "three_radii.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

constexpr double index_of_glass = 1.5, glass_bottom = -1, glass_top = -.8, half_fog = .5, half_view = 10 * std::numbers::pi / 180;
const Vec3 lamp{.1, -1.5, .2}, eye{.3, .2, 3}, target{0, .1, 0};
const Rgb extinction(.5, 1, 2), albedo(.95, .9, .8), intensity(1, 2, 3);

/// Share of unpolarised light that a boundary to the glass reflects; sine: of the angle in air.
double reflected(double sine)
{
    const double in = std::sqrt(1 - sine * sine), inside = std::sqrt(1 - sine * sine / (index_of_glass * index_of_glass));
    const double s = (in - index_of_glass * inside) / (in + index_of_glass * inside), p = (index_of_glass * in - inside) / (index_of_glass * in + inside);
    return .5 * (s * s + p * p);
}

/// What arrives at a point above the plate, across its direction, per unit of intensity, after 2 `turns` reflections inside of the glass; and the direction.
struct Pencil {
    double irradiance;
    Vec3 direction;
};
Pencil through_plate(const Vec3& at, int turns)
{
    const Vec3 offset = at - lamp;
    const double across = std::hypot(offset.x, offset.z), air = (glass_bottom - lamp.y) + (at.y - glass_top), glass = (2 * turns + 1) * (glass_top - glass_bottom);
    const auto reach = [&](double sine) { return air * sine / std::sqrt(1 - sine * sine) + glass * sine / std::sqrt(index_of_glass * index_of_glass - sine * sine); };
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) (reach(.5 * (low + high)) < across ? low : high) = .5 * (low + high);
    const double sine = .5 * (low + high), cosine = std::sqrt(1 - sine * sine), inside = std::sqrt(1 - sine * sine / (index_of_glass * index_of_glass));
    // sin d(angle) of the lamp's pencil over the ring across d(across) that it lights, foreshortened.
    const double widening = air / (cosine * cosine) + glass * cosine / (index_of_glass * inside * inside * inside), r = reflected(sine);
    const double irradiance = sine / (across * widening * cosine) * (1 - r) * (1 - r) * std::pow(r, 2 * turns);
    return {irradiance, Vec3(sine * offset.x / across, cosine, sine * offset.z / across)};
}

/// Length of the way to `at`, against `direction`, inside of the cube of fog.
double way_in_fog(const Vec3& at, const Vec3& direction)
{
    double way = 1e9;
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0) way = std::min(way, (at[axis] + (direction[axis] > 0 ? half_fog : -half_fog)) / direction[axis]);
    return way;
}

/// Radiance of light scattered once, along the camera's ray.
Rgb radiance_along(const Vec3& direction)
{
    double first = 0, last = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (-half_fog - eye[axis]) / direction[axis], b = (half_fog - eye[axis]) / direction[axis];
        first = std::max(first, std::min(a, b)), last = std::min(last, std::max(a, b));
    }
    Rgb sum(0);
    constexpr int steps = 48;
    for (int i = 0; i < steps && first < last; ++i) {
        const double u = (last - first) * (i + .5) / steps;
        const Vec3 at = eye + (first + u) * direction;
        for (int turns = 0; turns < 4; ++turns) {
            const Pencil pencil = through_plate(at, turns);
            sum += glm::exp(-extinction * (u + way_in_fog(at, pencil.direction))) * (pencil.irradiance * (last - first) / steps);
        }
    }
    return sum * intensity * albedo * extinction / (4 * std::numbers::pi);
}

Rgb mean_over_film(const std::function<Rgb(const Vec3&)>& radiance)
{
    const Vec3 forward = glm::normalize(target - eye), right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0))), up = glm::cross(right, forward);
    Rgb sum(0);
    constexpr int n = 96;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double sx = 2 * (x + .5) / n - 1, sy = 2 * (y + .5) / n - 1;
            sum += radiance(glm::normalize(forward + std::tan(half_view) * (sx * right + sy * up)));
        }
    return sum / double(n * n);
}

TEST(SmoothGlass, BeamsOfAPointThroughAPlateAreWhatOpticsSays)
{
    const std::string glass = R"(<bsdf type="dielectric"><float name="int_ior" value="1.5"/><float name="ext_ior" value="1"/></bsdf>)";
    const Scene scene = scene_of(medium("fog", extinction, albedo) + container(Vec3(-half_fog), Vec3(half_fog), "fog") + box({-6, glass_bottom, -6}, {6, glass_top, 6}, glass) +
                                 point_light(lamp, intensity) + sensor({.origin = eye, .target = target, .fov = 20}));
    const auto three = at_three_radii(scene, {.method = Method("beams"), .layers = only(Layer::single_specular), .passes = 20, .lights = 1500}, .01);
    const Rgb optics = mean_over_film(radiance_along);
    for (const int c : {0, 1, 2}) {
        const Mean beams = extrapolated(three, Layer::single_specular, c);
        std::printf("channel %d: %.5g %.5g %.5g -> %.5g +- %.2g, by optics %.5g\n", c, mean_of(three[0], Layer::single_specular, c).value(), mean_of(three[1], Layer::single_specular, c).value(),
                    mean_of(three[2], Layer::single_specular, c).value(), beams.value(), beams.error(), optics[c]);
        expect_mean(beams, optics[c], "beams through glass");
        EXPECT_LT(beams.error(), .01 * optics[c]) << "the test is too weak: Fresnel's losses are 8 %";
    }
}

}  // namespace

#include "transport/emitter.hpp"

#include "built_scene.hpp"
#include "scene/environment_maps.hpp"
#include "statistics.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

constexpr double half = .4;
const Vec3 receiver_centre(.1, -.9, .2), receiver_normal(0, 1, 0);

/// Colours 1 : 2 : 3, turned, with a dark texel.
void add_sky(BuiltScene& built)
{
    EnvironmentMap map{.name = "sky", .width = 4, .height = 3};
    for (const int brightness : {1, 4, 2, 7, 0, 3, 5, 2, 1, 9, 3, 0})
        for (const int channel : {1, 2, 3}) map.texels.push_back(static_cast<float>(brightness * channel));
    prepare_environment(map);
    built.scene.environment_maps.push_back(map);
    built.emitter({.type = Emitter::Type::envmap, .value = Rgb(1), .map = 0, .map_to_world = Mat3(glm::rotate(Mat4(1), 1.1, glm::normalize(Vec3(1, .4, .2))))});
}

/// A receiving square below; lights of every kind above it, one at a time.
struct Lit {
    BuiltScene built;
    explicit Lit(const std::string& kind)
    {
        const int grey = built.diffuse(Rgb(.5));
        built.square(receiver_centre, receiver_normal, half, grey);
        if (kind == "point") built.point({.3, .2, -.1}, {1, 2, 3});
        if (kind == "spot")
            built.emitter({.type = Emitter::Type::spot,
                           .value = {1, 2, 3},
                           .position = {.3, .2, -.1},
                           .direction = glm::normalize(Vec3(-.3, -1, .2)),
                           .cutoff = .6,
                           .beam = .3});
        if (kind == "sharp spot")
            built.emitter({.type = Emitter::Type::spot,
                           .value = {1, 2, 3},
                           .position = {.3, .2, -.1},
                           .direction = glm::normalize(Vec3(-.3, -1, .2)),
                           .cutoff = .3,
                           .beam = .3});
        if (kind == "square") built.glow(built.square({.2, .3, 0}, glm::normalize(Vec3(.2, -1, .1)), .3, grey), {1, 2, 3});
        if (kind == "box") built.glow(built.box({0, .1, 0}, {.3, .2, .4}, grey), {1, 2, 3});
        if (kind == "sphere") built.glow(built.sphere({.2, .1, 0}, .3, grey), {1, 2, 3});
        const Mat4 turn = glm::rotate(glm::translate(Mat4(1), Vec3(.2, .1, -.1)), 2.1, glm::normalize(Vec3(1, .4, .2)));
        if (kind == "ellipsoid")
            built.glow(built.shape({.type = Shape::Type::sphere, .to_world = turn * glm::scale(Mat4(1), Vec3(.3, .1, .2)), .bsdf = grey}),
                       {1, 2, 3});
        if (kind == "disk")
            built.glow(built.shape({.type = Shape::Type::disk,
                                    .to_world = turn * glm::scale(Mat4(1), Vec3(.3, .1, .2)),
                                    .flip_normals = false,
                                    .bsdf = grey}),
                       {1, 2, 3});
        if (kind == "cylinder")
            built.glow(built.shape({.type = Shape::Type::cylinder, .to_world = turn * glm::scale(Mat4(1), Vec3(.2, .1, .4)), .bsdf = grey}),
                       {1, 2, 3});
        if (kind == "directional")
            built.emitter({.type = Emitter::Type::directional, .value = {1, 2, 3}, .direction = glm::normalize(Vec3(.3, -1, .1))});
        if (kind == "constant") built.constant({1, 2, 3});
        if (kind == "envmap") add_sky(built);
    }
};

Vec3 on_receiver(const Vec2& xi) { return receiver_centre + Vec3((2 * xi.x - 1) * half, 0, (2 * xi.y - 1) * half); }

/// The ray meets the receiver's front.
bool reaches(const EmissionSample& s)
{
    if (!(s.direction.y < 0)) return false;
    const double t = (receiver_centre.y - s.origin.y) / s.direction.y;
    const Vec3 p = s.origin + t * s.direction - receiver_centre;
    return t > 0 && std::abs(p.x) <= half && std::abs(p.z) <= half;
}

class EmitterKind : public testing::TestWithParam<const char*> {};

// Two estimators of the flux through the receiver that share only the scene: from the lights, and from the receiver.
TEST_P(EmitterKind, LightSentEqualsLightReceived)
{
    const Lit lit(GetParam());
    const EmitterSampler emitters(lit.built.scene);
    RandomSequence random = numbers(1);
    Mean sent, received;
    for (int i = 0; i < 300000; ++i) {
        const Vec2 where = random.next2(), way = random.next2();
        const EmissionSample s = sample_emission(emitters, 0, where, way);
        ASSERT_NEAR(glm::length(s.direction), 1, 1e-12);
        sent.add(reaches(s) ? s.weight.y : 0);
        const DirectSample d = sample_direct(emitters, 0, on_receiver(random.next2()), random.next2());
        received.add(d.weight.y * std::max(0.0, glm::dot(d.direction, receiver_normal)) * 4 * half * half);
    }
    ASSERT_GT(received.value(), 0);
    ASSERT_LT(sent.error(), .02 * sent.value()) << "test is too weak";
    expect_same(sent, received);
}

TEST_P(EmitterKind, ColourIsTheEmitters)
{
    const Lit lit(GetParam());
    const EmitterSampler emitters(lit.built.scene);
    RandomSequence random = numbers(2);
    for (int i = 0; i < 100; ++i) {
        const Vec2 where = random.next2(), way = random.next2();
        for (const Rgb& w : {sample_emission(emitters, 0, where, way).weight, sample_direct(emitters, 0, on_receiver(where), way).weight}) {
            EXPECT_NEAR(w.y, 2 * w.x, 1e-12 * w.y);
            EXPECT_NEAR(w.z, 3 * w.x, 1e-12 * w.z);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EmitterKind,
                         testing::Values("point", "spot", "sharp spot", "square", "box", "sphere", "ellipsoid", "disk", "cylinder",
                                         "directional", "constant", "envmap"));

class AreaKind : public testing::TestWithParam<const char*> {};

// The density that multiple importance sampling uses must be the one that sampling has: for a ray in a direction that sample_direct drew,
// pdf_direct says the same.
TEST_P(AreaKind, DensityOfAHitIsTheDensityOfTheSample)
{
    const Lit lit(GetParam());
    const EmitterSampler emitters(lit.built.scene);
    const Visibility visibility(lit.built.scene, 1);
    RandomSequence random = numbers(3);
    int compared = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3 from = on_receiver(random.next2()) + Vec3(0, 1e-3, 0);
        const DirectSample d = sample_direct(emitters, 0, from, random.next2());
        if (d.pdf == 0) continue;
        Hit hit;
        ASSERT_TRUE(visibility.intersect(
            {.origin = from, .direction = d.direction, .t_min = d.distance * (1 - 1e-9), .t_max = d.distance * (1 + 1e-6)}, hit));
        ++compared;
        EXPECT_NEAR(pdf_direct(emitters, from, hit) / d.pdf, 1, 1e-6);
        EXPECT_EQ(emitted_radiance(lit.built.scene, hit, d.direction), Rgb(1, 2, 3));
        EXPECT_EQ(emitted_radiance(lit.built.scene, hit, -d.direction), Rgb(0));
        EXPECT_NEAR(d.weight.x * d.pdf, 1, 1e-9) << "weight x density is the radiance";
    }
    EXPECT_GT(compared, 30);
}

INSTANTIATE_TEST_SUITE_P(Kinds, AreaKind, testing::Values("square", "box", "sphere", "ellipsoid", "disk", "cylinder"));

TEST(Emitter, PowerIsTheMeanEmission)
{
    const auto power = [](const char* kind) {
        const Lit lit(kind);
        const EmitterSampler emitters(lit.built.scene);
        RandomSequence random = numbers(4);
        Mean mean;
        for (int i = 0; i < 100000; ++i) {
            const Vec2 where = random.next2(), way = random.next2();
            mean.add(sample_emission(emitters, 0, where, way).weight.x);
        }
        return mean;
    };
    expect_mean(power("point"), 4 * pi, "point");
    expect_mean(power("square"), pi * .36, "square");
    expect_mean(power("sphere"), pi * 4 * pi * .09, "sphere");
    // falloff 1 to .3, then linear to 0 at .6 rad
    const double cone =
        2 * pi * double(integrate([](long double a) { return std::sin(a) * (a < .3L ? 1 : (.6L - a) / .3L); }, 0, .6L, 1e-12L));
    expect_mean(power("spot"), cone, "spot");
    expect_mean(power("sharp spot"), 2 * pi * (1 - std::cos(.3)), "sharp spot");
}

TEST(Emitter, ChoiceIsProportionalToPowerAndNeverDark)
{
    BuiltScene s;
    s.point({0, 0, 0}, Rgb(0)), s.point({0, 0, 1}, Rgb(1)), s.point({0, 1, 0}, Rgb(3)), s.point({1, 0, 0}, Rgb(0));
    const EmitterSampler emitters(s.scene);
    EXPECT_NEAR(emitters.probability(1), .25, 1e-15);
    EXPECT_NEAR(emitters.probability(2), .75, 1e-15);
    EXPECT_EQ(emitters.probability(0), 0);
    for (const double xi : {0., 0x1p-53, .1, .2499, .2501, .9, 1 - 0x1p-53}) EXPECT_EQ(emitters.choose(xi).emitter, xi < .25 ? 1 : 2) << xi;
    s.scene.emitters.resize(1);
    EXPECT_TRUE(EmitterSampler(s.scene).empty());
    s.scene.emitters.clear();
    EXPECT_TRUE(EmitterSampler(s.scene).empty());
}

TEST(Emitter, SpotFallsOffLinearlyInTheAngle)
{
    const Emitter e{.type = Emitter::Type::spot, .direction = {0, 0, 1}, .cutoff = .5, .beam = .2};
    const auto at = [&](double angle) { return spot_falloff(e, {std::sin(angle), 0, std::cos(angle)}); };
    EXPECT_EQ(at(0), 1);
    EXPECT_EQ(at(.199), 1);
    EXPECT_NEAR(at(.35), .5, 1e-12);
    EXPECT_EQ(at(.501), 0);
    EXPECT_EQ(at(3), 0);
}

TEST(Emitter, TransmittanceToLightFromOutsideCrossesEverything)
{
    BuiltScene s;
    const int fog = s.medium({1, 2, 0}, Rgb(.5));
    s.container(Vec3(-.5), Vec3(.5), {.interior = fog});
    s.constant(Rgb(1));
    s.square({0, 0, -.8}, {0, 0, 1}, .3, s.diffuse(Rgb(0)));
    const Visibility visibility(s.scene, 1);
    const DirectSample up{.direction = {0, 0, 1}, .infinite = true}, down{.direction = {0, 0, -1}, .infinite = true};
    EXPECT_NEAR(transmittance_to(visibility, s.scene, Vec3(0), fog, up).x, std::exp(-.5), 1e-12);
    EXPECT_EQ(transmittance_to(visibility, s.scene, Vec3(0), fog, down), Rgb(0));
    EXPECT_EQ(transmittance_to(visibility, s.scene, {0, 0, .6}, fog, up), Rgb(0, 0, 1))
        << "an unbounded medium lets nothing in where it absorbs";
}

}  // namespace

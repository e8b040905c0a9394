#include "transport/bsdf.hpp"

#include "built_scene.hpp"
#include "statistics.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

/// One square facing +z at the origin, with the given BSDF.
struct Surface {
    BuiltScene built;
    Hit hit{.t = 1, .position = Vec3(0), .geometric_normal = {0, 0, 1}, .shading_normal = {0, 0, 1}, .shape = 0, .primitive = 0};
    explicit Surface(const Bsdf& b) { built.square(Vec3(0), {0, 0, 1}, 1, built.bsdf(b)); }
    const Scene& scene() const { return built.scene; }
};

const Vec3 down = glm::normalize(Vec3(.5, .2, -1)), up = glm::normalize(Vec3(.5, .2, 1));

TEST(Bsdf, DiffuseSamplesFollowTheCosineAndReturnTheReflectance)
{
    Surface s({.reflectance = {.2, .5, .9}});
    s.hit.geometric_normal = s.hit.shading_normal = glm::normalize(Vec3(1, 1, .3));
    const Arrival arrival{.hit = s.hit, .in = -glm::normalize(Vec3(.4, 1, .3))};
    RandomSequence random = numbers(1);
    const auto sample = [&] {
        const BsdfSample b = sample_bsdf(s.scene(), arrival, random.next2());
        EXPECT_NEAR(b.pdf, pdf_bsdf(s.scene(), arrival, b.direction), 1e-12);
        EXPECT_NEAR(glm::length(b.weight - Rgb(.2, .5, .9)), 0, 1e-15);
        EXPECT_NEAR(glm::length(evaluate_bsdf(s.scene(), arrival, b.direction) / b.pdf - b.weight), 0, 1e-12);
        EXPECT_FALSE(b.delta || b.transmitted);
        return b.direction;
    };
    const double p = direction_p(100000, sample, [&](const Vec3& d) { return std::max(0.0, glm::dot(d, s.hit.shading_normal)) / pi; });
    EXPECT_GT(p, false_alarm_rate);
}

TEST(Bsdf, DiffuseHasOneSideUnlessTwoSided)
{
    Surface one({.reflectance = Rgb(.5)}), two({.reflectance = Rgb(.5), .two_sided = true});
    const Arrival behind_one{.hit = one.hit, .in = up}, behind_two{.hit = two.hit, .in = up};
    EXPECT_EQ(sample_bsdf(one.scene(), behind_one, {.3, .4}).weight, Rgb(0));
    EXPECT_EQ(evaluate_bsdf(one.scene(), behind_one, down), Rgb(0));
    EXPECT_EQ(pdf_bsdf(one.scene(), behind_one, down), 0);
    EXPECT_EQ(diffuse_reflectance(one.scene(), one.hit, up), Rgb(0));
    EXPECT_EQ(sample_bsdf(two.scene(), behind_two, {.3, .4}).weight, Rgb(.5));
    EXPECT_LT(sample_bsdf(two.scene(), behind_two, {.3, .4}).direction.z, 0);
    EXPECT_NEAR(evaluate_bsdf(two.scene(), behind_two, down).x, .5 / pi * -down.z, 1e-15);
}

TEST(Bsdf, ASeparateBackBehavesLikeItself)
{
    Surface s({.reflectance = Rgb(.5), .two_sided = true, .back = 1});
    s.built.diffuse(Rgb(.1));
    EXPECT_EQ(sample_bsdf(s.scene(), {.hit = s.hit, .in = down}, {.3, .4}).weight, Rgb(.5));
    EXPECT_EQ(sample_bsdf(s.scene(), {.hit = s.hit, .in = up}, {.3, .4}).weight, Rgb(.1));
}

TEST(Bsdf, DiffuseIsReciprocal)
{
    const Surface s({.reflectance = Rgb(.5)});
    const Vec3 in = glm::normalize(Vec3(-.7, .1, -.2)), out = glm::normalize(Vec3(.3, .9, .5));
    const double forward = evaluate_bsdf(s.scene(), {.hit = s.hit, .in = in}, out).x / out.z;
    const double backward = evaluate_bsdf(s.scene(), {.hit = s.hit, .in = -out}, -in).x / -in.z;
    EXPECT_NEAR(forward, backward, 1e-15);
}

TEST(Bsdf, ImportanceOverAShadingNormalIsTheAdjointOfRadiance)
{
    Surface s({.reflectance = Rgb(.5)});
    s.hit.shading_normal = glm::normalize(Vec3(.3, -.2, 1));
    const Vec3 in = glm::normalize(Vec3(-.7, .1, -.4)), out = glm::normalize(Vec3(.3, .4, .5));
    // flux from in to out, per |in.ng|: radiance carries f |out.ns| from out to in when walked backwards, and f |in.ns| seen from the light
    const double importance = evaluate_bsdf(s.scene(), {.hit = s.hit, .in = in, .mode = TransportMode::importance}, out).x;
    const double radiance = evaluate_bsdf(s.scene(), {.hit = s.hit, .in = -out}, -in).x;
    EXPECT_NEAR(importance * std::abs(in.z), radiance * out.z, 1e-15);
}

TEST(Bsdf, NormalsThatDisagreeLeakNoLight)
{
    Surface s({.reflectance = Rgb(.5)});
    s.hit.shading_normal = glm::normalize(Vec3(1, 0, .2));
    RandomSequence random = numbers(2);
    for (int i = 0; i < 2000; ++i) {
        const BsdfSample b = sample_bsdf(s.scene(), {.hit = s.hit, .in = glm::normalize(Vec3(-1, 0, -.3))}, random.next2());
        if (b.weight != Rgb(0)) {
            ASSERT_GT(b.direction.z, 0);
        }
    }
}

TEST(Fresnel, DielectricKnownValues)
{
    EXPECT_NEAR(fresnel_dielectric(1, 1.5), .04, 1e-15);  // ((n-1)/(n+1))^2
    EXPECT_NEAR(fresnel_dielectric(std::cos(std::atan(1.5)), 1.5), .5 * std::pow((1.5 * 1.5 - 1) / (1.5 * 1.5 + 1), 2),
                1e-15);                                   // Brewster: no parallel part
    EXPECT_EQ(fresnel_dielectric(.3, 1 / 1.5), 1);        // total
    EXPECT_NEAR(fresnel_dielectric(1e-9, 1.5), 1, 1e-7);  // grazing
    EXPECT_EQ(fresnel_dielectric(.4, 1), 0);
}

TEST(Fresnel, DielectricIsTheSameFromBothSides)
{
    for (double c = .05; c < 1; c += .1) {
        const double behind = std::sqrt(1 - (1 - c * c) / 2.25);
        EXPECT_NEAR(fresnel_dielectric(c, 1.5), fresnel_dielectric(behind, 1 / 1.5), 1e-14);
    }
}

TEST(Fresnel, AConductorWithoutAbsorptionIsADielectric)
{
    for (double c = .05; c <= 1; c += .1) EXPECT_NEAR(fresnel_conductor(c, 1.7, 0), fresnel_dielectric(c, 1.7), 1e-13);
    EXPECT_NEAR(fresnel_conductor(1, .2, 3), (.64 + 9) / (1.44 + 9), 1e-14);  // ((n-1)^2 + k^2) / ((n+1)^2 + k^2)
    EXPECT_NEAR(fresnel_conductor(.3, 0, 1), 1, 1e-14);
}

Bsdf glass() { return {.type = Bsdf::Type::dielectric, .reflectance = Rgb(1), .eta = 1.5}; }

TEST(Bsdf, GlassConservesFluxAndRefractsBySnell)
{
    const Surface s(glass());
    for (const Vec3& in : {down, up, glm::normalize(Vec3(1, 0, .2))}) {
        const double eta = in.z < 0 ? 1.5 : 1 / 1.5;
        RandomSequence random = numbers(3);
        Mean reflected, radiance;
        for (int i = 0; i < 40000; ++i) {
            const BsdfSample flux = sample_bsdf(s.scene(), {.hit = s.hit, .in = in, .mode = TransportMode::importance}, random.next2());
            ASSERT_NEAR(flux.weight.x, 1, 1e-12);  // chosen by Fresnel: nothing is lost
            ASSERT_TRUE(flux.delta);
            ASSERT_EQ(flux.transmitted, flux.direction.z * in.z > 0);
            reflected.add(!flux.transmitted);
            const double sine = std::hypot(in.x, in.y), sine_out = std::hypot(flux.direction.x, flux.direction.y);
            ASSERT_NEAR(sine_out, flux.transmitted ? sine / eta : sine, 1e-12);
            const BsdfSample seen = sample_bsdf(s.scene(), {.hit = s.hit, .in = in}, random.next2());
            ASSERT_NEAR(seen.weight.x, seen.transmitted ? 1 / (eta * eta) : 1, 1e-12);
        }
        expect_mean(reflected, fresnel_dielectric(std::abs(in.z), eta));
    }
}

TEST(Bsdf, GlassOfIndexOneIsNotThere)
{
    Bsdf b = glass();
    b.eta = 1;
    const Surface s(b);
    const BsdfSample through = sample_bsdf(s.scene(), {.hit = s.hit, .in = down}, {0, 0});
    EXPECT_NEAR(glm::length(through.direction - down), 0, 1e-15);
    EXPECT_EQ(through.weight, Rgb(1));
}

TEST(Bsdf, ConductorMirrorsByChannel)
{
    const Surface s({.type = Bsdf::Type::conductor, .reflectance = {1, .5, 1}, .conductor_eta = {.2, .2, 1.5}, .conductor_k = {3, 3, 2}});
    const BsdfSample b = sample_bsdf(s.scene(), {.hit = s.hit, .in = down}, {.1, .1});
    EXPECT_NEAR(glm::length(b.direction - Vec3(down.x, down.y, -down.z)), 0, 1e-15);
    EXPECT_NEAR(b.weight.x, fresnel_conductor(-down.z, .2, 3), 1e-15);
    EXPECT_NEAR(b.weight.y, .5 * b.weight.x, 1e-15);
    EXPECT_NEAR(b.weight.z, fresnel_conductor(-down.z, 1.5, 2), 1e-15);
    EXPECT_EQ(sample_bsdf(s.scene(), {.hit = s.hit, .in = up}, {.1, .1}).weight, Rgb(0));
}

TEST(Bsdf, NullLetsEverythingPass)
{
    const Surface s({.type = Bsdf::Type::null});
    const BsdfSample b = sample_bsdf(s.scene(), {.hit = s.hit, .in = down}, {.1, .1});
    EXPECT_EQ(b.direction, down);
    EXPECT_EQ(b.weight, Rgb(1));
    EXPECT_TRUE(b.delta && b.transmitted);
    EXPECT_FALSE(specular(bsdf_of(s.scene(), s.hit)));
}

}  // namespace

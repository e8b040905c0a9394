/// Every surface with a scattering part: values against the printed formulas, densities and samples against quadrature, energy, reciprocity.
#include "rough_surface.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

class RoughBsdf : public testing::TestWithParam<NamedBsdf> {
protected:
    Surface surface{GetParam().bsdf};
    const Bsdf& bsdf() const { return surface.scene().bsdfs[0]; }
    bool through() const { return parts_of(bsdf()).through; }
    /// Directions of travel of arriving light: normal, oblique, grazing; from below too where that matters.
    std::vector<Vec3> arrivals() const
    {
        std::vector<Vec3> list{arriving(1, 0), arriving(.8, .1), arriving(.35, .7), arriving(.05, .4)};
        if (through()) list.insert(list.end(), {arriving(-.9, .2), arriving(-.4, .8)});
        return list;
    }
};

INSTANTIATE_TEST_SUITE_P(Of, RoughBsdf, testing::ValuesIn(rough_bsdfs()), [](const auto& info) { return std::string(info.param.name); });

TEST_P(RoughBsdf, SamplesFollowTheDensity)
{
    std::uint64_t index = 0;
    for (const Vec3& in : arrivals()) {
        RandomSequence random = numbers(200 + index++);
        const Arrival arrival = surface.arriving(in);
        const double kept = over_directions([&](const Vec3& out) { return pdf_bsdf(surface.scene(), arrival, out); });
        const auto draw = [&] {
            for (;;)  // what facets send to other facets, and a plastic's mirror, are not of the density
                if (const BsdfSample s = sample_bsdf(surface.scene(), arrival, random.next2()); s.pdf > 0) return s.direction;
        };
        const double p = draws_p(60000, draw, [&](const Vec3& out) { return pdf_bsdf(surface.scene(), arrival, out) / kept; });
        EXPECT_GT(p, false_alarm_rate) << "from " << -in.z;
        EXPECT_LT(kept, 1 + 1e-4);
    }
}

TEST_P(RoughBsdf, SamplesLostAndDensityAddUpToOne)
{
    for (const Vec3& in : arrivals()) {
        RandomSequence random = numbers(300);
        const Arrival arrival = surface.arriving(in);
        Mean kept;
        for (int i = 0; i < 40000; ++i) kept.add(sample_bsdf(surface.scene(), arrival, random.next2()).pdf > 0);
        const double density = over_directions([&](const Vec3& out) { return pdf_bsdf(surface.scene(), arrival, out); });
        // .01: what the rule's pieces miss of GGX's lobe along the horizon
        EXPECT_NEAR(kept.value(), density, 5 * kept.error() + .01) << "from " << -in.z;
    }
}

TEST_P(RoughBsdf, WeightIsValueOverDensityInBothModes)
{
    for (const TransportMode mode : {TransportMode::radiance, TransportMode::importance})
        for (const Vec3& in : arrivals()) {
            RandomSequence random = numbers(301);
            const Arrival arrival = surface.arriving(in, mode);
            for (int i = 0; i < 300; ++i) {
                const BsdfSample s = sample_bsdf(surface.scene(), arrival, random.next2());
                if (!(s.pdf > 0)) continue;
                const Rgb value = evaluate_bsdf(surface.scene(), arrival, s.direction);
                ASSERT_NEAR(pdf_bsdf(surface.scene(), arrival, s.direction), s.pdf, 1e-9 * s.pdf);
                for (int c = 0; c < 3; ++c) ASSERT_NEAR(value[c], s.weight[c] * s.pdf, 1e-9 * (1 + value[c]));
                ASSERT_EQ(s.transmitted, s.direction.z * in.z > 0);
            }
        }
}

/// Flux that leaves, of flux that arrives: by the values (quadrature) as by the samples' weights (delta parts too), and never more than 1.
TEST_P(RoughBsdf, GivesBackNoMoreThanItGets)
{
    for (const Vec3& in : arrivals()) {
        const Arrival arrival = surface.arriving(in);
        RandomSequence random = numbers(302);
        Mean by_samples, by_scattering;
        for (int i = 0; i < 40000; ++i) {
            const BsdfSample s = sample_bsdf(surface.scene(), arrival, random.next2());
            by_samples.add(s.weight.z), by_scattering.add(s.delta ? 0 : s.weight.z);
        }
        EXPECT_LE(by_samples.value(), 1 + 5 * by_samples.error() + 1e-9) << "from " << -in.z;
        const double integral = over_directions([&](const Vec3& out) { return evaluate_bsdf(surface.scene(), arrival, out).z; });
        EXPECT_NEAR(by_scattering.value(), integral, 5 * by_scattering.error() + 1e-4) << "from " << -in.z;
    }
}

/// f(i, o) n_i^2 = f(o, i) n_o^2 for flux [Veach 1997, eq. 5.14]: radiance back along the way is flux along it over eta^2.
TEST_P(RoughBsdf, IsReciprocalUpToTheIndexSquared)
{
    for (const Vec3& in : arrivals())
        for (const Vec3& out : {spherical(.9, .3), spherical(.3, .05), spherical(-.7, .6), spherical(-.95, .1)}) {
            const double forward = evaluate_bsdf(surface.scene(), surface.arriving(in), out).y / std::abs(out.z);
            const double backward = evaluate_bsdf(surface.scene(), surface.arriving(-out), -in).y / std::abs(in.z);
            const double eta = out.z * in.z > 0 ? (in.z < 0 ? bsdf().eta : 1 / bsdf().eta) : 1;
            EXPECT_NEAR(forward, backward * eta * eta, 1e-9 * (1 + forward));
            const double seen = evaluate_bsdf(surface.scene(), surface.arriving(-out, TransportMode::radiance), -in).y / std::abs(in.z);
            EXPECT_NEAR(forward, seen, 1e-9 * (1 + forward)) << "what flux does one way, radiance does the other";
        }
}

TEST_P(RoughBsdf, IsFiniteAtEveryAngle)
{
    for (const double cosine : {1.0, .3, 1e-9, -1.0, -1e-9, 0.0})
        for (const double x : {0.0, .3, 1 - 0x1p-53})
            for (const double y : {0.0, .7, 1 - 0x1p-53}) {
                const Arrival arrival = surface.arriving(arriving(cosine, .3));
                const BsdfSample s = sample_bsdf(surface.scene(), arrival, {x, y});
                ASSERT_TRUE(std::isfinite(sum(s.weight)) && std::isfinite(s.pdf) && sum(s.weight) >= 0);
                for (const double to : {1.0, 1e-9, 0.0, -1e-9, -1.0}) {
                    const Vec3 out = spherical(to, .9);
                    ASSERT_TRUE(std::isfinite(sum(evaluate_bsdf(surface.scene(), arrival, out)))) << cosine << " to " << to;
                    ASSERT_TRUE(std::isfinite(pdf_bsdf(surface.scene(), arrival, out))) << cosine << " to " << to;
                }
            }
}

const Vec3 ways_in[] = {arriving(.9, .1), arriving(.4, .6), arriving(.1, .3)};
const Vec3 ways_out[] = {spherical(.95, .6), spherical(.5, .1), spherical(.3, .62), spherical(.05, .8)};

TEST(RoughConductor, IsThePrintedFormula)
{
    for (const Roughness::Type type : {Roughness::Type::beckmann, Roughness::Type::ggx}) {
        const Surface s({.type = Bsdf::Type::rough_conductor, .reflectance = Rgb(.9), .conductor_eta = Rgb(.2), .conductor_k = Rgb(3), .roughness = {type, .3, .3}});
        for (const Vec3& in : ways_in)
            for (const Vec3& out : ways_out) {
                const double expected = .9 * double(reflection_oracle(s.scene().bsdfs[0].roughness, {.2L, 3}, -in, out));
                EXPECT_NEAR(evaluate_bsdf(s.scene(), s.arriving(in), out).x, expected, 1e-7 * expected + 1e-15);
            }
    }
}

TEST(RoughDielectric, IsThePrintedFormulaFromBothSides)
{
    for (const Roughness::Type type : {Roughness::Type::beckmann, Roughness::Type::ggx})
        for (const double side : {1., -1.}) {
            const Surface s({.type = Bsdf::Type::rough_dielectric, .reflectance = Rgb(.9), .specular_transmittance = Rgb(.7), .eta = 1.5, .roughness = {type, .3, .3}});
            const double eta = side > 0 ? 1.5 : 1 / 1.5;
            for (const Vec3& in : ways_in)
                for (const Vec3& out : ways_out) {
                    const Roughness& r = s.scene().bsdfs[0].roughness;
                    const double reflected = .9 * double(reflection_oracle(r, (long double)eta, -in, out)), refracted = .7 * double(refraction_oracle(r, eta, -in, -out));
                    EXPECT_NEAR(evaluate_bsdf(s.scene(), s.arriving(side * in), side * out).x, reflected, 1e-7 * reflected + 1e-15);
                    EXPECT_NEAR(evaluate_bsdf(s.scene(), s.arriving(side * in), -side * out).x, refracted, 1e-7 * refracted + 1e-15);
                    EXPECT_NEAR(evaluate_bsdf(s.scene(), s.arriving(side * in, TransportMode::radiance), -side * out).x, refracted / (eta * eta), 1e-7 * refracted + 1e-15);
                }
        }
}

TEST(RoughDielectric, BecomesGlassWhereItIsSmooth)
{
    const Surface rough({.type = Bsdf::Type::rough_dielectric, .reflectance = Rgb(1), .eta = 1.5, .roughness = {Roughness::Type::ggx, 1e-4, 1e-4}});
    RandomSequence random = numbers(303);
    const Vec3 in = arriving(.7, .1);
    Mean reflected, weight;
    for (int i = 0; i < 20000; ++i) {
        const BsdfSample s = sample_bsdf(rough.scene(), rough.arriving(in), random.next2());
        reflected.add(!s.transmitted), weight.add(s.weight.x);
        const double sine = std::hypot(s.direction.x, s.direction.y);
        ASSERT_NEAR(sine, std::hypot(in.x, in.y) / (s.transmitted ? 1.5 : 1), .02);
    }
    expect_mean(reflected, fresnel_dielectric(.7, 1.5));
    EXPECT_NEAR(weight.value(), 1, 1e-6);
}

TEST(ThinDielectric, IsASheetOfTwoFaces)
{
    const Surface s({.type = Bsdf::Type::thin_dielectric, .reflectance = Rgb(1), .specular_transmittance = Rgb(.5), .eta = 1.5});
    for (const Vec3& in : {arriving(.6, .1), arriving(-.6, .1)})
        for (const TransportMode mode : {TransportMode::radiance, TransportMode::importance}) {
            const long double f = fresnel_oracle(.6L, 1.5L), sheet = f + (1 - f) * (1 - f) * f / (1 - f * f);  // the series of reflections inside
            RandomSequence random = numbers(304);
            Mean mirrored, passed;
            for (int i = 0; i < 20000; ++i) {
                const BsdfSample b = sample_bsdf(s.scene(), s.arriving(in, mode), random.next2());
                ASSERT_TRUE(b.delta);
                ASSERT_EQ(b.transmitted, b.direction == in);
                mirrored.add(b.transmitted ? 0 : b.weight.x), passed.add(b.transmitted ? b.weight.x : 0);
            }
            expect_mean(mirrored, double(sheet));
            expect_mean(passed, .5 * double(1 - sheet));
        }
}

TEST(Plastic, IsTheBoundaryOverTheDiffuseBase)
{
    for (const bool nonlinear : {false, true}) {
        const Surface s({.type = Bsdf::Type::plastic, .reflectance = Rgb(.8), .eta = 1.5, .diffuse = Rgb(.6), .nonlinear = nonlinear});
        const auto f = [&](long double mu) { return 2 * mu * fresnel_oracle(mu, 1 / 1.5L); };
        const long double total = std::sqrt(1 - 1 / 2.25L), inside = integrate(f, 0, total, 1e-12L, 30) + integrate(f, total, 1, 1e-12L, 30);
        for (const Vec3& in : ways_in)
            for (const Vec3& out : ways_out) {
                const long double way = (1 - fresnel_oracle(-in.z, 1.5L)) * (1 - fresnel_oracle(out.z, 1.5L)) / 2.25L;
                const double expected = double(way * .6L / (1 - (nonlinear ? .6L : 1) * inside) * out.z / std::numbers::pi_v<long double>);
                EXPECT_NEAR(evaluate_bsdf(s.scene(), s.arriving(in), out).x, expected, 1e-8);
            }
        const BsdfSample mirror = sample_specular(s.scene(), s.arriving(ways_in[1]), {.3, .3});
        EXPECT_TRUE(mirror.delta);
        EXPECT_NEAR(mirror.weight.x, .8 * double(fresnel_oracle(.4L, 1.5L)), 1e-12);
    }
}

TEST(RoughPlastic, IsFacetsOverTheDiffuseBase)
{
    const Surface s({.type = Bsdf::Type::rough_plastic, .reflectance = Rgb(.8), .eta = 1.5, .roughness = {Roughness::Type::ggx, .3, .3}, .diffuse = Rgb(.6)});
    const Surface black({.type = Bsdf::Type::rough_plastic, .reflectance = Rgb(0), .eta = 1.5, .roughness = {Roughness::Type::ggx, .3, .3}, .diffuse = Rgb(.6)});
    const Bsdf& b = s.scene().bsdfs[0];
    const Surface mirror({.type = Bsdf::Type::rough_plastic, .reflectance = Rgb(1), .eta = 1.5, .roughness = {Roughness::Type::ggx, .3, .3}, .diffuse = Rgb(0)});
    const auto passes = [&](double cosine) {
        return 1 - over_directions([&](const Vec3& o) { return evaluate_bsdf(mirror.scene(), mirror.arriving(arriving(cosine, 0)), o).x; });
    };
    for (const Vec3& in : {ways_in[0], ways_in[1]})
        for (const Vec3& out : {ways_out[0], ways_out[2]}) {
            const double facets = .8 * double(reflection_oracle(b.roughness, 1.5L, -in, out)), below = evaluate_bsdf(black.scene(), black.arriving(in), out).x;
            EXPECT_NEAR(evaluate_bsdf(s.scene(), s.arriving(in), out).x, facets + below, 1e-7 * facets + 1e-12);
            // 5e-3: the tables' rule and the line between their nodes
            const double expected = passes(-in.z) * passes(out.z) / 2.25 * .6 / (1 - b.internal_reflectance) * out.z / pi;
            EXPECT_NEAR(below, expected, 5e-3 * expected);
        }
}

TEST(Parts, SayWhatBecomesOfThePath)
{
    for (const NamedBsdf& named : rough_bsdfs()) {
        const SurfaceParts parts = parts_of(named.bsdf);
        EXPECT_TRUE(parts.scattering) << named.name;
        EXPECT_FALSE(parts.lambertian) << named.name;
        EXPECT_EQ(parts.specular, named.bsdf.type == Bsdf::Type::plastic) << named.name;
        EXPECT_EQ(parts.through, named.bsdf.type == Bsdf::Type::rough_dielectric) << named.name;
    }
    EXPECT_TRUE(parts_of({.type = Bsdf::Type::diffuse}).lambertian);
    for (const auto type : {Bsdf::Type::dielectric, Bsdf::Type::thin_dielectric, Bsdf::Type::conductor}) EXPECT_TRUE(parts_of({.type = type}).specular && !parts_of({.type = type}).scattering);
    const Surface one_sided({.type = Bsdf::Type::rough_conductor});
    const SurfaceParts back = parts_at(one_sided.scene(), one_sided.arriving({0, 0, 1}));
    EXPECT_FALSE(back.scattering || back.specular) << "the back is black";
}

}  // namespace

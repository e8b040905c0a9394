#include "scene/microfacet.hpp"

#include "rough_surface.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

const std::vector<Roughness> surfaces{{Roughness::Type::beckmann, .1, .1}, {Roughness::Type::ggx, .1, .1}, {Roughness::Type::beckmann, .6, .6}, {Roughness::Type::ggx, .6, .6},
                                      {Roughness::Type::beckmann, .5, .2}, {Roughness::Type::ggx, .2, .7}, {Roughness::Type::ggx, 1.5, 1.5}, {Roughness::Type::beckmann, 1.5, 1.5}};

TEST(Facets, CoverTheSurfaceOnce)
{
    for (const Roughness& r : surfaces) EXPECT_NEAR(over_directions([&](const Vec3& h) { return facet_density(r, h) * h.z; }), 1, 1e-4) << r.alpha_u;
}

TEST(Facets, DensityIsThatOfTheSlopes)
{
    for (const Roughness& r : surfaces)
        for (const Vec3& h : {spherical(.3, .1), spherical(.9, .7), spherical(.999, .3), Vec3(0, 0, 1)}) {
            const double expected = double(slope_density(r, h.x / h.z, h.y / h.z)) / std::pow(h.z, 4);
            EXPECT_NEAR(facet_density(r, h), expected, 1e-12 * expected);
        }
    for (const Roughness& r : surfaces) EXPECT_EQ(facet_density(r, {0, .6, -.8}), 0);
}

TEST(Facets, ShadowEachOtherAsTheirSlopesSay)
{
    for (const Roughness& r : surfaces) {
        if (r.alpha_u != r.alpha_v) continue;
        for (const double cosine : {1e-3, .05, .3, .7, .95, .9999}) {
            const double expected = double(masking_oracle(r, cosine));
            EXPECT_NEAR(seen_share(r, spherical(cosine, .3)), expected, 2e-8 * expected + 1e-12) << r.alpha_u << " at " << cosine;
            EXPECT_EQ(seen_share(r, spherical(-cosine, .3)), seen_share(r, spherical(cosine, .3)));
        }
    }
}

/// What is seen of all facets from w is what the flat surface would show: the definition of masking, anisotropic ones too [Heitz 2014, eq. 14].
TEST(Facets, SeenOnesFillTheProjectedSurface)
{
    for (const Roughness& r : surfaces)
        for (const Vec3& w : {spherical(.9, .15), spherical(.4, .6)})
            EXPECT_NEAR(over_directions([&](const Vec3& h) { return pdf_seen_facet(r, w, h); }), 1, 2e-4) << r.alpha_u << " " << r.alpha_v;
}

TEST(Facets, DrawsFollowTheirDensity)
{
    std::uint64_t index = 0;
    for (const Roughness& r : surfaces)
        for (const Vec3& w : {Vec3(0, 0, 1), spherical(.8, .15), spherical(.2, .6), spherical(.02, .35)}) {
            RandomSequence random = numbers(100 + index++);
            const double p = draws_p(40000, [&] { return sample_seen_facet(r, w, random.next2()); }, [&](const Vec3& h) { return pdf_seen_facet(r, w, h); });
            EXPECT_GT(p, false_alarm_rate) << r.alpha_u << " " << r.alpha_v << " from " << w.z;
        }
}

TEST(Facets, AreFiniteAtEveryAngle)
{
    for (const Roughness& r : surfaces)
        for (const double cosine : {0.0, 1e-300, 1e-12, .5, 1.0})
            for (const double x : {0.0, 1e-17, .5, 1 - 0x1p-53})
                for (const double y : {0.0, .5, 1 - 0x1p-53}) {
                    const Vec3 w = spherical(cosine, .2), h = sample_seen_facet(r, w, {x, y});
                    ASSERT_NEAR(glm::length(h), 1, 1e-12);
                    ASSERT_GE(h.z, 0);
                    ASSERT_TRUE(std::isfinite(pdf_seen_facet(r, w, h)));
                    ASSERT_TRUE(std::isfinite(seen_over_cosine(r, w)));
                }
}

TEST(Facets, ReflectanceIsItsIntegral)
{
    for (const Roughness& r : {surfaces[3], surfaces[2], Roughness{Roughness::Type::beckmann, .2, .2}})
        for (const double cosine : {.3, .9})
            for (const double eta : {1.5, 1 / 1.5}) {
                const Vec3 from = spherical(cosine, 0);
                const auto reflected = [&](const Vec3& out) {
                    const Vec3 h = glm::normalize(from + out);
                    return out.z > 0 ? double(fresnel_oracle(glm::dot(from, h), eta)) * facet_density(r, h) * seen_share(r, from) * seen_share(r, out) / (4 * cosine) : 0;
                };
                const double expected = over_directions(reflected);
                EXPECT_NEAR(facet_reflectance(r, cosine, eta), expected, 5e-3 * expected + 1e-4) << r.alpha_u << " at " << cosine;
            }
}

TEST(Fresnel, DiffuseReflectanceIsItsIntegral)
{
    for (const double eta : {1.1, 1.49, 2.4, 1 / 1.1, 1 / 1.49, 1 / 2.4}) {
        const long double total = eta < 1 ? std::sqrt(1 - (long double)eta * eta) : 0;  // cosine of total reflection
        const auto f = [&](long double mu) { return 2 * mu * fresnel_oracle(mu, (long double)eta); };
        const double expected = double((total > 0 ? integrate(f, 0, total, 1e-12L, 30) : 0) + integrate(f, total, 1, 1e-12L, 30));
        EXPECT_NEAR(diffuse_fresnel(eta), expected, 1e-9) << eta;
    }
}

}  // namespace

#include "rendered.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

BuiltScene busy_scene(double brightness = 1)
{
    BuiltScene s;
    const int fog = s.medium({1, 2, 4}, {.9, .8, .5}, .4);
    s.container(Vec3(-.5), Vec3(.5), {.interior = fog});
    s.square({0, -.6, 0}, {0, 1, 0}, .9, s.diffuse({.5, .6, .7}));
    s.square({0, 0, .9}, {0, 0, -1}, .9, s.diffuse({.7, .6, .5}));
    const int glass = s.bsdf({.type = Bsdf::Type::dielectric, .reflectance = Rgb(1), .eta = 1.5});
    s.sphere({.2, .64, 0}, .13, glass), s.sphere({.6, -.3, 0}, .2, glass);
    s.glow(s.square({0, .8, 0}, {0, -1, 0}, .3, s.diffuse(Rgb(0))), brightness * Rgb(5, 4, 3));
    s.point({-.7, .5, -.3}, brightness * Rgb(1));
    s.camera({0, .1, -1.3}, {0, 0, 1}, 12, 1.3);
    return s;
}

PassImage one_pass(const Scene& scene, const PathTracingSettings& settings, int threads = 1)
{
    const Visibility visibility(scene, threads);
    PassImage image(scene.camera.crop_width, scene.camera.crop_height, settings.layers);
    trace_paths(scene, visibility, settings, image);
    return image;
}

TEST(PathTracing, TheNumberOfThreadsDoesNotChangeABit)
{
    const BuiltScene s = busy_scene();
    const PathTracingSettings settings{.seed = 9, .pass = 4, .layers = LayerSet::all()};
    EXPECT_EQ(one_pass(s.scene, settings, 1).layers, one_pass(s.scene, settings, 2).layers);
}

TEST(PathTracing, SeedAndPassChangeTheNoise)
{
    const BuiltScene s = busy_scene();
    const auto image = [&](std::uint64_t seed, std::uint64_t pass) {
        return one_pass(s.scene, {.seed = seed, .pass = pass, .layers = LayerSet::all()}).layers;
    };
    EXPECT_NE(image(1, 0), image(2, 0));
    EXPECT_NE(image(1, 0), image(1, 1));
}

TEST(PathTracing, TwiceTheLightIsTwiceTheImage)
{
    const PathTracingSettings settings{.layers = LayerSet::all()};
    const PassImage once = one_pass(busy_scene(1).scene, settings), twice = one_pass(busy_scene(2).scene, settings);
    for (std::size_t l = 0; l < layer_count; ++l)
        for (std::size_t i = 0; i < once.layers[l].size(); ++i) ASSERT_EQ(2.0 * once.layers[l][i], twice.layers[l][i]) << l << ' ' << i;
}

TEST(PathTracing, LightOfExtremeStrengthStaysInProportion)  // hard case 25
{
    const PathTracingSettings settings{.layers = LayerSet::all()};
    const PassImage once = one_pass(busy_scene(1).scene, settings);
    for (const double strength : {0x1p-66, 0x1p66}) {
        const PassImage scaled = one_pass(busy_scene(strength).scene, settings);
        for (std::size_t l = 0; l < layer_count; ++l)
            for (std::size_t i = 0; i < once.layers[l].size(); ++i) ASSERT_EQ(strength * once.layers[l][i], scaled.layers[l][i]);
    }
}

TEST(PathTracing, EveryValueIsFiniteAndNotNegative)
{
    const BuiltScene s = busy_scene();
    for (std::uint64_t pass = 0; pass < 50; ++pass) {
        const PassImage image = one_pass(s.scene, {.pass = pass, .layers = LayerSet::all()});
        for (const auto& layer : image.layers)
            for (const Rgb& value : layer)
                for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(value[c]) && value[c] >= 0);
    }
}

// A layer rendered alone, its paths ended early, has the mean that it has among all.
TEST(PathTracing, EachLayerAloneEqualsTheLayerAmongAll)
{
    const BuiltScene s = busy_scene();
    for (std::size_t l = 0; l < layer_count; ++l) {
        const Layer layer = static_cast<Layer>(l);
        Mean alone, among;
        for (std::uint64_t pass = 0; pass < 400; ++pass) {
            const auto total = [&](const PassImage& image) {
                double sum = 0;
                for (const Rgb& v : image[layer]) sum += v.y;
                return sum;
            };
            alone.add(total(one_pass(s.scene, {.seed = 1, .pass = pass, .layers = only(layer)})));
            among.add(total(one_pass(s.scene, {.seed = 2, .pass = pass, .layers = LayerSet::all()})));
        }
        expect_same(alone, among, std::string(name(layer)).c_str());
        EXPECT_GT(among.value(), 0) << name(layer);
    }
}

TEST(PathTracing, MaxDepthCountsScatteringVertices)
{
    const BuiltScene s = busy_scene();
    const auto lit = [&](int max_depth) {
        LayerSet found;
        for (std::uint64_t pass = 0; pass < 40; ++pass) {
            const PassImage image = one_pass(s.scene, {.pass = pass, .max_depth = max_depth, .layers = LayerSet::all()});
            for (std::size_t l = 0; l < layer_count; ++l)
                for (const Rgb& v : image.layers[l])
                    if (v != Rgb(0)) found.add(static_cast<Layer>(l));
        }
        return found;
    };
    EXPECT_EQ(lit(0), LayerSet());
    EXPECT_EQ(lit(1), LayerSet().add(Layer::emitted));
    EXPECT_EQ(lit(2), LayerSet().add(Layer::surface_direct).add(Layer::single).add(Layer::emitted));
    LayerSet three =
        lit(2).add(Layer::surface_indirect).add(Layer::surface_to_media).add(Layer::media_to_media).add(Layer::media_to_surface);
    EXPECT_EQ(lit(3) & three, three);
    EXPECT_FALSE(lit(3).contains(Layer::surface_indirect_specular));  // needs three vertices
}

TEST(PathTracing, SameImageInAnyUnitOfLength)  // L(kx, sigma/k, k^2 I) = L
{
    const auto render_scaled = [](double k) {
        BuiltScene s;
        const int fog = s.medium(Rgb(2 / k), Rgb(.8), .4);
        s.container(Vec3(-.5 * k), Vec3(.5 * k), {.interior = fog});
        s.square({0, -.6 * k, 0}, {0, 1, 0}, .9 * k, s.diffuse(Rgb(.5)));
        s.point({-.7 * k, .5 * k, -.3 * k}, Rgb(k * k));
        s.camera({0, .1 * k, -1.3 * k}, {0, 0, 1}, 6, .8);
        s.scene.camera.near_clip *= k;
        return render(s.scene, {.passes = 300}).image;
    };
    expect_same(render_scaled(1), render_scaled(.25));
}

TEST(UncarriedLight, IsNamedForLightsWithoutSizeAmongGlass)
{
    const BuiltScene s = busy_scene();
    const auto sentences = uncarried_light(s.scene);
    ASSERT_EQ(sentences.size(), 1u);
    EXPECT_NE(sentences[0].find("point light \"point\""), std::string::npos);
    BuiltScene clear;
    clear.point(Vec3(0), Rgb(1));
    clear.square(Vec3(0), {0, 0, 1}, 1, clear.diffuse(Rgb(.5)));
    EXPECT_TRUE(uncarried_light(clear.scene).empty());
}

}  // namespace

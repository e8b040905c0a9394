/// Virtual ray lights against path tracing, layer by layer, with every kind of phase function.
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

std::string medium_of(const std::string& id, const Rgb& sigma_t, const std::string& phase)
{
    return "<medium type=\"homogeneous\" id=\"" + id + "\">" + rgb("sigma_t", sigma_t) + rgb("albedo", Rgb(.95, .9, .8)) + phase + "</medium>";
}

std::string hg(double g) { return "<phase type=\"hg\">" + float_of("g", g) + "</phase>"; }
std::string blend(double weight, const std::string& parts) { return "<phase type=\"blendphase\">" + float_of("weight", weight) + parts + "</phase>"; }
const std::string rayleigh = R"(<phase type="rayleigh"/>)";
/// Forward peak, backward shoulder, nothing sideways.
const std::string table = R"(<phase type="tabphase"><string name="values" value="2, 1, 0.5, 0, 0, 0, 0.2, 1, 3, 9"/></phase>)";

/// A box of the medium above a floor, lit from above and behind.
std::string scene_with(const std::string& phase, const std::string& more = "")
{
    return medium_of("fog", Rgb(.7, 1.2, 2), phase) + container(Vec3(-.5), Vec3(.5), "fog") + more + horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75))) +
           horizontal({.2, 1.2, -.5}, .3, false, diffuse(Rgb(0)) + glow(Rgb(4, 3, 2))) + sensor({.origin = {.3, .6, 3}});
}

/// `rough`: precision of media_to_media, if it is another.
void expect_twins(const std::string& body, double precision, int vrl_passes = 400, int path_passes = 5000, double rough = 0, std::uint32_t lights = 256)
{
    const Scene scene = scene_of(body);
    const WholeRender vrl = render_whole(scene, {.method = Method::vrl, .passes = vrl_passes, .lights = lights}),
                      path = render_whole(scene, {.method = Method::path, .passes = path_passes, .seed = 2});
    for (const int channel : {0, 1, 2}) {
        expect_layers_agree(vrl, path, {Layer::single, Layer::media_to_surface}, precision, channel);
        expect_layers_agree(vrl, path, {Layer::media_to_media}, rough > 0 ? rough : precision, channel);
    }
}

TEST(PhaseFunctionsAgainstPathTracing, Rayleigh) { expect_twins(scene_with(rayleigh), .02); }
TEST(PhaseFunctionsAgainstPathTracing, Table) { expect_twins(scene_with(table), .02); }
TEST(PhaseFunctionsAgainstPathTracing, Blend) { expect_twins(scene_with(blend(.4, hg(.7) + blend(.5, rayleigh + table))), .02); }
TEST(PhaseFunctionsAgainstPathTracing, BackwardLobe) { expect_twins(scene_with(hg(-.7)), .02); }
TEST(PhaseFunctionsAgainstPathTracing, ForwardLobe) { expect_twins(scene_with(hg(.9)), .045, 1200); }
/// Rare connections along both lobes at once carry much of what scatters twice: a mean of many passes is still rough, and of few lights at the mercy of one of them.
TEST(PhaseFunctionsAgainstPathTracing, NarrowForwardLobe) { expect_twins(scene_with(hg(.95)), .05, 1200, 5000, .12, 4096); }

/// Lanes of one group see different phase functions, and a connection starts in one and ends in the other.
TEST(PhaseFunctionsAgainstPathTracing, BlendBesideHenyeyGreensteinBesideATable)
{
    expect_twins(medium_of("smoke", Rgb(2), blend(.5, hg(.8) + hg(-.4))) + medium_of("haze", Rgb(.8), table) +
                     scene_with(hg(.5), container({-1.2, -.5, -.4}, {-.6, .3, .4}, "smoke") + container({.6, -.5, -.4}, {1.2, .3, .4}, "haze")),
                 .03);
}

/// The comparison can fail: the table run backwards.
TEST(PhaseFunctionsAgainstPathTracing, ATableRunBackwardsIsSeen)
{
    const std::string backwards = R"(<phase type="tabphase"><string name="values" value="9, 3, 1, 0.2, 0, 0, 0, 0.5, 1, 2"/></phase>)";
    const WholeRender vrl = render_whole(scene_of(scene_with(backwards)), {.passes = 500, .lights = 256}),
                      path = render_whole(scene_of(scene_with(table)), {.method = Method::path, .passes = 5000, .seed = 2});
    for (const Layer layer : {Layer::single, Layer::media_to_media, Layer::media_to_surface}) {
        const Mean &a = vrl(layer), &b = path(layer);
        EXPECT_GT(std::abs(a.value() - b.value()), allowed_sigmas * std::sqrt(a.variance_of_mean() + b.variance_of_mean())) << name(layer);
    }
}

}  // namespace

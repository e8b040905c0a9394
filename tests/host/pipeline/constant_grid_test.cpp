/// A medium whose extinction is the same everywhere gives one image, however it is written: homogeneous, as a constvolume, as a .vol file. By virtual ray lights, on the device.
#include <fstream>

#include "tests/support/temporary_folder.hpp"
#include "tests/support/vol_file.hpp"
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

/// `extinction`: what stands for sigma_t in the medium "fog" of the given type. The box is [-.5, .5]^3.
Scene box_of(const std::string& type, const std::string& extinction, const std::filesystem::path& folder = ".")
{
    const std::string fog = "<medium type=\"" + type + "\" id=\"fog\">" + extinction + "<float name=\"albedo\" value=\".9\"/><phase type=\"isotropic\"/></medium>";
    const std::string rest = container(Vec3(-.5), Vec3(.5), "fog") + horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5))) + horizontal({.2, 1.2, -.5}, .3, false, diffuse(Rgb(0)) + glow(Rgb(4))) +
                             sensor({.origin = {.3, .6, 3}});
    return parse_scene("<scene version=\"3.0.0\">" + fog + rest + "</scene>", folder, "scene.xml");
}

const std::string place = R"(<transform name="to_world"><translate x="-0.5" y="-0.5" z="-0.5"/></transform>)";

void expect_as_homogeneous(const Scene& scene)
{
    const RenderSettings settings{.passes = 300, .lights = 256};
    RenderSettings other = settings;
    other.seed = 2;
    const WholeRender grid = render_whole(scene, settings), even = render_whole(box_of("homogeneous", R"(<float name="sigma_t" value="2"/>)"), other);
    expect_layers_agree(grid, even, {Layer::single, Layer::media_to_media, Layer::media_to_surface}, .03);
}

TEST(ConstantGrid, OfAConstvolumeHasTheImageOfAHomogeneousMedium)
{
    expect_as_homogeneous(box_of("heterogeneous", R"(<volume name="sigma_t" type="constvolume"><float name="value" value="2"/></volume>)"));
}

TEST(ConstantGrid, OfAFileHasTheImageOfAHomogeneousMedium)
{
    const TemporaryFolder folder;
    const std::string bytes = vol_bytes({.size = {3, 2, 4}, .values = std::vector<float>(24, 2.f)});
    std::ofstream(folder / "even.vol", std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
    expect_as_homogeneous(box_of("heterogeneous", R"(<volume name="sigma_t" type="gridvolume"><string name="filename" value="even.vol"/>)" + place + "</volume>", folder.path()));
}

}  // namespace

#pragma once
/// Scenes for virtual point lights on surfaces, and their comparison with path tracing. No two surfaces touch: at a common edge the variance of point lights has no bound, and no test of means
/// could judge.
#include "whole_renderer.hpp"

namespace tyndall::test::surface_lights {

inline const std::string view = sensor({.origin = {.3, .6, 3}});
inline const std::string lamp = horizontal({.2, 1.2, .1}, .3, false, diffuse(Rgb(0)) + glow(Rgb(4, 3, 2)));
inline const std::string floor_below = horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75)));
inline const std::string wall = box({-1.2, -.3, -1.2}, {1.2, .9, -1}, diffuse(Rgb(.8, .6, .4)));
inline const std::string fog = medium("fog", Rgb(.5, 1, 2), Rgb(.95, .9, .8), .5), smoke = medium("smoke", Rgb(4, 3, 2), Rgb(.7), -.3);
inline const std::string fog_cube = fog + container(Vec3(-.5), Vec3(.5), "fog"), occluder = box({-.3, .05, -.3}, {.3, .15, .3}, diffuse(Rgb(0)));
inline const std::string puff = R"(<medium type="heterogeneous" id="puff"><volume name="sigma_t" type="gridvolume"><string name="filename" value="plume.vol"/><transform name="to_world"><translate x="-0.5" y="-0.5" z="-0.5"/></transform></volume>
                             <rgb name="albedo" value=".95, .9, .8"/><float name="scale" value="24"/></medium>)";

inline const LayerSet both = LayerSet().add(Layer::surface_to_media).add(Layer::surface_indirect);

inline WholeRender by_points(const Scene& scene, RenderSettings settings)
{
    settings.method = Method("vpl"), settings.layers = both;
    if (settings.lights == 0) settings.lights = 256;
    return render_whole(scene, settings);
}

/// With all lights and with chosen ones; `precision`: of each, relative, one standard error.
inline void expect_agreement(const Scene& scene, double precision, std::initializer_list<Layer> layers = {Layer::surface_to_media, Layer::surface_indirect}, int max_depth = -1)
{
    const WholeRender path = render_whole(scene, {.method = Method::path, .layers = both, .passes = 4000, .seed = 2, .max_depth = max_depth});
    const WholeRender all = by_points(scene, {.passes = 400, .max_depth = max_depth});
    const WholeRender chosen = by_points(scene, {.passes = 200, .lights = 1024, .max_depth = max_depth, .selection = Selection::tile, .selected_lights = 64});
    for (const int channel : {0, 1, 2}) {
        expect_layers_agree(all, path, layers, precision, channel);
        expect_layers_agree(chosen, path, layers, precision, channel);
    }
}

}  // namespace tyndall::test::surface_lights

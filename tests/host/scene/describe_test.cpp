#include "scene/describe.hpp"

#include <gmock/gmock.h>

#include "scene_text.hpp"

namespace tyndall::test {

using testing::HasSubstr;

TEST(Describe, SaysWhatWasReadInTheFilesUnits)
{
    const Scene scene = parse(R"(<scene version="3.0.0"><integrator type="volpath"><integer name="max_depth" value="9"/></integrator>
        <sensor type="perspective"><float name="fov" value="40"/><transform name="to_world"><translate z="4"/></transform></sensor>
        <medium type="homogeneous" id="juice"><rgb name="sigma_t" value="1 2 3"/><phase type="hg"><float name="g" value="0.5"/></phase></medium>
        <medium type="homogeneous" id="lost"/>
        <shape type="cube" id="glass"><ref name="interior" id="juice"/><bsdf type="dielectric"><float name="int_ior" value="1.5"/><float name="ext_ior" value="1"/></bsdf></shape>
        <shape type="sphere"><emitter type="area"><rgb name="radiance" value="7"/></emitter></shape>
        <emitter type="spot"><rgb name="intensity" value="30"/><transform name="to_world"><translate y="2"/></transform></emitter></scene>)");
    const std::string text = describe(scene);
    EXPECT_THAT(text, HasSubstr("camera     at (0, 0, 4), 40 degrees wide, clips 0.01 to 10000, in vacuum"));
    EXPECT_THAT(text, HasSubstr("film       768 x 576 pixels, gaussian filter of 0.5 pixels"));
    EXPECT_THAT(text, HasSubstr("integrator \"volpath\", max_depth 9"));
    // bounds (-1,-1,-1) to (1,2,4): a diagonal of sqrt(4 + 9 + 25)
    EXPECT_THAT(text, HasSubstr("medium     \"juice\": sigma_t 1 2 3, albedo 0.75, Henyey-Greenstein g = 0.5; optical thickness across the "
                                "scene 6.16441 12.3288 18.4932"));
    EXPECT_THAT(text, HasSubstr("shape      \"glass\": 12 triangles, closed, convex, dielectric, \"juice\" inside and vacuum outside"));
    EXPECT_THAT(text, HasSubstr("shape      \"sphere\": sphere, diffuse, glows"));
    EXPECT_THAT(text, HasSubstr("emitter    \"area\": area 7 on shape \"sphere\""));
    EXPECT_THAT(text, HasSubstr("emitter    \"spot\": spot 30 at (0, 2, 0), 20 degrees with full light within 15 towards (0, 0, 1)"));
    EXPECT_THAT(text, HasSubstr("bsdf       \"dielectric\": dielectric reflectance 1, transmittance 1, relative index 1.5"));
    EXPECT_THAT(text, HasSubstr("warning    scene.xml:4:9: medium \"lost\": nothing refers to it"));
}

TEST(Describe, TellsRoughSurfacesApart)
{
    const std::string text = describe(load_body(R"(<bsdf type="roughdielectric" id="frosted"><float name="alpha" value=".3"/><float name="int_ior" value="1.5"/><float name="ext_ior" value="1"/></bsdf>
        <bsdf type="roughconductor" id="brushed"><string name="distribution" value="ggx"/><float name="alpha_u" value=".3"/><float name="alpha_v" value=".1"/></bsdf>
        <bsdf type="plastic" id="toy"><rgb name="diffuse_reflectance" value=".1 .2 .3"/><float name="int_ior" value="1.5"/><float name="ext_ior" value="1"/></bsdf>)" + unit_sphere));
    EXPECT_THAT(text, HasSubstr("\"frosted\": roughdielectric reflectance 1, transmittance 1, relative index 1.5, Beckmann facets of roughness 0.3\n"));
    EXPECT_THAT(text, HasSubstr("\"brushed\": roughconductor reflectance 1, eta 0, k 1, GGX facets of roughness 0.3 along u, 0.1 along v\n"));
    EXPECT_THAT(text, HasSubstr("\"toy\": plastic reflectance 1, below it 0.1 0.2 0.3, relative index 1.5\n"));
}

}  // namespace tyndall::test

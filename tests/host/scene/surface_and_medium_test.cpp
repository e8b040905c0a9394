// Media, phase functions and bsdfs: each parameter, each default, each refusal.
#include "scene_text.hpp"

namespace tyndall::test {

Medium medium_of(const std::string& inside)
{
    const Scene scene = load_body("<medium type=\"homogeneous\" id=\"m\">" + inside + "</medium>" + unit_sphere);
    Medium medium = scene.media.at(0);
    medium.sigma_t /= scene.unit;  // back to the file's units
    return medium;
}
std::string medium_fault(const std::string& inside)
{
    return fault_of_body("<medium type=\"homogeneous\" id=\"juice\">\n" + inside + "</medium>");
}

Bsdf bsdf_of(const std::string& type, const std::string& inside = "")
{
    return load_body("<bsdf type=\"" + type + "\">" + inside + "</bsdf>").bsdfs.at(0);
}
std::string bsdf_fault(const std::string& type, const std::string& inside = "")
{
    return fault_of_body("<bsdf type=\"" + type + "\">\n" + inside + "</bsdf>");
}

TEST(Medium, DefaultsAreMitsubas)
{
    const Medium medium = medium_of("");
    EXPECT_EQ(medium.sigma_t, Rgb(1));
    EXPECT_EQ(medium.albedo, Rgb(.75));
    EXPECT_EQ(medium.phase.type, PhaseFunction::Type::isotropic);
    EXPECT_EQ(medium.phase.g, 0);
    EXPECT_EQ(medium.name, "m");
    EXPECT_EQ(medium_of("<phase type=\"hg\"/>").phase.g, .8);
}

TEST(Medium, ParametersAreRead)
{
    const Medium medium =
        medium_of(R"(<rgb name="sigma_t" value="0.5, 1, 2"/><rgb name="albedo" value="0.25 0.5 1"/><float name="scale" value="4"/>
        <phase type="hg"><float name="g" value="-0.5"/></phase><boolean name="sample_emitters" value="false"/>)");
    EXPECT_EQ(medium.sigma_t, Rgb(2, 4, 8));  // powers of two: exact
    EXPECT_EQ(medium.albedo, Rgb(.25, .5, 1));
    EXPECT_EQ(medium.phase.type, PhaseFunction::Type::henyey_greenstein);
    EXPECT_EQ(medium.phase.g, -.5);
    EXPECT_EQ(medium_of(R"(<float name="sigma_t" value="3"/>)").sigma_t, Rgb(3));
    EXPECT_EQ(medium_of(R"(<integer name="sigma_t" value="3"/>)").sigma_t, Rgb(3));
    EXPECT_EQ(medium_of(R"(<rgb name="sigma_t" value="3"/>)").sigma_t, Rgb(3));
    EXPECT_EQ(medium_of(R"(<spectrum name="sigma_t" value="3"/>)").sigma_t, Rgb(3));
}

TEST(Medium, WrongValuesAreSentences)
{
    EXPECT_EQ(medium_fault("<phase type=\"hg\"><float name=\"g\" value=\"1.2\"/></phase>"),
              "scene.xml:3:18: medium \"juice\": g = 1.2 must lie strictly between -1 and 1");
    EXPECT_EQ(medium_fault("<phase type=\"hg\"><float name=\"g\" value=\"1\"/></phase>"),
              "scene.xml:3:18: medium \"juice\": g = 1 must lie strictly between -1 and 1");
    EXPECT_EQ(medium_fault("<float name=\"sigma_t\" value=\"-1\"/>"), "scene.xml:3:1: medium \"juice\": sigma_t = -1 must not be negative");
    EXPECT_EQ(medium_fault("<rgb name=\"sigma_t\" value=\"1, -0.5, 1\"/>"),
              "scene.xml:3:1: medium \"juice\": sigma_t = -0.5 must not be negative");
    EXPECT_EQ(medium_fault("<float name=\"sigma_t\" value=\"nan\"/>"),
              "scene.xml:3:1: medium \"juice\": sigma_t = \"nan\" is not a finite number");
    EXPECT_EQ(medium_fault("<float name=\"sigma_t\" value=\"inf\"/>"),
              "scene.xml:3:1: medium \"juice\": sigma_t = \"inf\" is not a finite number");
    EXPECT_EQ(medium_fault("<float name=\"sigma_t\" value=\"1e400\"/>"),
              "scene.xml:3:1: medium \"juice\": sigma_t = \"1e400\" is not a finite number");
    EXPECT_EQ(medium_fault("<float name=\"sigma_t\" value=\"0,5\"/>"),
              "scene.xml:3:1: medium \"juice\": sigma_t = \"0,5\" is not a finite number");
    EXPECT_EQ(medium_fault("<rgb name=\"albedo\" value=\"0.5 1.01 0\"/>"),
              "scene.xml:3:1: medium \"juice\": albedo = 1.01 must lie between 0 and 1");
    EXPECT_EQ(medium_fault("<float name=\"scale\" value=\"-2\"/>"), "scene.xml:3:1: medium \"juice\": scale = -2 must not be negative");
    EXPECT_NE(medium_fault("<float name=\"scale\" value=\"1e200\"/><float name=\"sigma_t\" value=\"1e200\"/>")
                  .find("sigma_t x scale is too large"),
              std::string::npos);
}

TEST(Medium, WrongNamesAndTypesAreRefusedWithTheNearest)
{
    EXPECT_EQ(medium_fault("<float name=\"albdo\" value=\"0.5\"/>")
                  .find("scene.xml:3:1: medium \"juice\": unknown parameter \"albdo\" (did you mean \"albedo\"?); it takes: "),
              0u);
    EXPECT_EQ(medium_fault("<string name=\"sigma_t\" value=\"1\"/>"),
              "scene.xml:3:1: medium \"juice\": sigma_t is written as <string>; it must be <rgb>, <float>, <integer> or <spectrum>");
    EXPECT_EQ(medium_fault("<float name=\"sigma_t\" value=\"1\"/><float name=\"sigma_t\" value=\"2\"/>"),
              "scene.xml:3:34: medium \"juice\": sigma_t is given twice, first at scene.xml:3:1");
    EXPECT_EQ(medium_fault("<float name=\"sigma_t\" valeu=\"1\"/>"),
              "scene.xml:3:1: <float> has no attribute \"valeu\" (did you mean \"value\"?); it takes: name, value");
    EXPECT_EQ(medium_fault("<float name=\"sigma_t\"/>"), "scene.xml:3:1: medium \"juice\": sigma_t needs the attribute \"value\"");
    EXPECT_EQ(medium_fault("<float value=\"1\"/>"), "scene.xml:3:1: medium \"juice\": <float> needs the attribute \"name\"");
    EXPECT_EQ(medium_fault("<string name=\"material\" value=\"Skimmilk\"/>"),
              "scene.xml:3:1: medium \"juice\": presets of materials are not supported; give sigma_t and albedo");
    EXPECT_NE(medium_fault("<float name=\"sigma_s\" value=\"1\"/>").find("sigma_s is not supported"), std::string::npos);
    EXPECT_NE(medium_fault("<phase type=\"hg\"/><phase type=\"hg\"/>").find("scene.xml:3:19: medium \"juice\": a second phase"),
              std::string::npos);
    EXPECT_EQ(medium_fault("<volume name=\"sigma_t\" type=\"gridvolume\"/>")
                  .find("scene.xml:3:1: medium \"juice\": sigma_t as <volume type=\"gridvolume\"> is not supported"),
              0u);
    EXPECT_EQ(fault_of_body("<medium type=\"layered\"/>"),
              "scene.xml:2:1: medium type \"layered\" is not supported; supported: homogeneous, heterogeneous");
    EXPECT_EQ(fault_of_body("<medium id=\"a\"/>"), "scene.xml:2:1: <medium> needs the attribute \"type\"");
}

TEST(Colour, FormsThatMeanSomethingElseAreRefused)
{
    EXPECT_NE(medium_fault("<rgb name=\"albedo\" value=\"#ff8000\"/>").find("albedo = \"#ff8000\" is not supported"), std::string::npos);
    EXPECT_NE(medium_fault("<rgb name=\"albedo\" value=\"1 2\"/>").find("must be one or three numbers"), std::string::npos);
    EXPECT_NE(medium_fault("<rgb name=\"albedo\" value=\"\"/>").find("must be one or three numbers"), std::string::npos);
    EXPECT_NE(medium_fault("<spectrum name=\"albedo\" value=\"400:0.1, 700:0.5\"/>").find("spectrum of wavelengths is not supported"),
              std::string::npos);
    EXPECT_NE(medium_fault("<spectrum name=\"albedo\" filename=\"a.spd\"/>").find("spectrum file is not supported"), std::string::npos);
}

TEST(Bsdf, DefaultsAreMitsubas)
{
    EXPECT_EQ(bsdf_of("diffuse").reflectance, Rgb(.5));
    EXPECT_EQ(bsdf_of("null").type, Bsdf::Type::null);
    const Bsdf glass = bsdf_of("dielectric");
    EXPECT_EQ(glass.type, Bsdf::Type::dielectric);
    EXPECT_NEAR(glass.eta, 1.50418, 5e-6);  // Mitsuba 3.9 prints this for bk7 in air
    EXPECT_EQ(glass.reflectance, Rgb(1));
    EXPECT_EQ(glass.specular_transmittance, Rgb(1));
    const Bsdf mirror = bsdf_of("conductor");
    EXPECT_EQ(mirror.type, Bsdf::Type::conductor);
    EXPECT_EQ(mirror.conductor_eta, Rgb(0));
    EXPECT_EQ(mirror.conductor_k, Rgb(1));
    EXPECT_EQ(mirror.reflectance, Rgb(1));
}

TEST(Bsdf, ParametersAreRead)
{
    EXPECT_EQ(bsdf_of("diffuse", R"(<rgb name="reflectance" value="0.1 0.2 0.3"/>)").reflectance, Rgb(.1, .2, .3));
    const Bsdf glass =
        bsdf_of("dielectric",
                R"(<string name="int_ior" value="water"/><float name="ext_ior" value="1"/><rgb name="specular_reflectance" value="0.5"/>
        <rgb name="specular_transmittance" value="1 0.5 0.25"/>)");
    EXPECT_EQ(glass.eta, 1.333);
    EXPECT_EQ(glass.reflectance, Rgb(.5));
    EXPECT_EQ(glass.specular_transmittance, Rgb(1, .5, .25));
    EXPECT_EQ(bsdf_of("dielectric", R"(<float name="int_ior" value="1.5"/><string name="ext_ior" value="vacuum"/>)").eta, 1.5);
    const Bsdf metal = bsdf_of(
        "conductor", R"(<rgb name="eta" value="0.2 0.9 1.1"/><float name="k" value="3"/><float name="specular_reflectance" value="0.9"/>
        <string name="material" value="none"/>)");
    EXPECT_EQ(metal.conductor_eta, Rgb(.2, .9, 1.1));
    EXPECT_EQ(metal.conductor_k, Rgb(3));
    EXPECT_EQ(metal.reflectance, Rgb(.9));
}

TEST(Bsdf, RoughAndThinAndPlasticHaveMitsubasDefaults)
{
    for (const char* type : {"roughdielectric", "roughconductor", "roughplastic"}) {
        const Bsdf b = bsdf_of(type);
        EXPECT_EQ(b.roughness.type, Roughness::Type::beckmann) << type;
        EXPECT_EQ(b.roughness.alpha_u, .1) << type;
        EXPECT_EQ(b.roughness.alpha_v, .1) << type;
        EXPECT_EQ(b.reflectance, Rgb(1)) << type;
    }
    EXPECT_EQ(bsdf_of("thindielectric").type, Bsdf::Type::thin_dielectric);
    EXPECT_EQ(bsdf_of("thindielectric").eta, bsdf_of("dielectric").eta);
    EXPECT_EQ(bsdf_of("roughdielectric").eta, bsdf_of("dielectric").eta);
    for (const char* type : {"plastic", "roughplastic"}) {
        EXPECT_EQ(bsdf_of(type).diffuse, Rgb(.5));
        EXPECT_FALSE(bsdf_of(type).nonlinear);
        EXPECT_NEAR(bsdf_of(type).eta, 1.48959, 5e-6);  // polypropylene in air
    }
    EXPECT_NEAR(bsdf_of("plastic").internal_reflectance, .5905, 1e-3);  // of eta 1.49 [Egan and Hilgeman 1973]
    EXPECT_EQ(bsdf_of("roughplastic").boundary_transmittance.size(), 64u);
}

TEST(Bsdf, RoughnessIsRead)
{
    const Bsdf metal = bsdf_of("roughconductor", R"(<string name="distribution" value="ggx"/><float name="alpha_u" value=".3"/><float name="alpha_v" value=".05"/>
        <boolean name="sample_visible" value="false"/><rgb name="eta" value="1 2 3"/><rgb name="k" value="4 5 6"/>)");
    EXPECT_EQ(metal.type, Bsdf::Type::rough_conductor);
    EXPECT_EQ(metal.roughness.type, Roughness::Type::ggx);
    EXPECT_EQ(metal.roughness.alpha_u, .3);
    EXPECT_EQ(metal.roughness.alpha_v, .05);
    EXPECT_EQ(metal.conductor_k, Rgb(4, 5, 6));
    const Bsdf plastic = bsdf_of("roughplastic", R"(<float name="alpha" value=".2"/><boolean name="nonlinear" value="true"/><rgb name="diffuse_reflectance" value=".1 .2 .3"/>)");
    EXPECT_EQ(plastic.roughness.alpha_v, .2);
    EXPECT_TRUE(plastic.nonlinear);
    EXPECT_EQ(plastic.diffuse, Rgb(.1, .2, .3));
}

TEST(Bsdf, WrongRoughnessIsASentence)
{
    const auto says = [](const char* type, const char* inside, const char* words) {
        EXPECT_NE(bsdf_fault(type, inside).find(words), std::string::npos) << bsdf_fault(type, inside);
        EXPECT_EQ(bsdf_fault(type, inside).find("scene.xml:3:"), 0u) << bsdf_fault(type, inside);
    };
    says("roughconductor", R"(<float name="alpha" value="0"/>)", "alpha = 0 must lie between 0.0001 and 10");
    says("roughconductor", R"(<float name="alpha" value="-.1"/>)", "must lie between");
    says("roughconductor", R"(<float name="alpha" value=".1"/><float name="alpha_u" value=".1"/>)", "alpha excludes alpha_u and alpha_v");
    says("roughconductor", R"(<float name="alpha_u" value=".1"/>)", "come in pairs");
    says("roughdielectric", R"(<string name="distribution" value="phong"/>)", "distribution");
    says("roughdielectric", R"(<float name="int_ior" value="1.5"/><float name="ext_ior" value="1.5"/>)", "makes no boundary");
    says("plastic", R"(<string name="int_ior" value="air"/>)", "makes no boundary");
    says("roughplastic", R"(<float name="alpha_u" value=".1"/>)", "unknown parameter \"alpha_u\" (did you mean \"alpha\"?)");
    says("plastic", R"(<rgb name="diffuse_reflectance" value="1.5 0 0"/>)", "diffuse_reflectance = 1.5 must lie between 0 and 1");
    for (const char* side : {"thindielectric", "roughdielectric"})
        EXPECT_NE(bsdf_fault("twosided", ("<bsdf type=\"" + std::string(side) + "\"/>").c_str()).find("cannot be a side"), std::string::npos);
}

TEST(Bsdf, TwosidedTakesOneOrTwo)
{
    const Scene one =
        load_body("<bsdf type=\"twosided\" id=\"t\"><bsdf type=\"diffuse\"><float name=\"reflectance\" value=\"0.25\"/></bsdf></bsdf>");
    const Bsdf& both = one.bsdfs.back();
    EXPECT_EQ(both.name, "t");
    EXPECT_EQ(both.type, Bsdf::Type::diffuse);
    EXPECT_TRUE(both.two_sided);
    EXPECT_EQ(both.back, none);
    EXPECT_EQ(both.reflectance, Rgb(.25));
    const Scene two = load_body("<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/><bsdf type=\"conductor\"/></bsdf>");
    EXPECT_EQ(two.bsdfs[static_cast<std::size_t>(two.bsdfs.back().back)].type, Bsdf::Type::conductor);
    EXPECT_NE(bsdf_fault("twosided").find("0 bsdfs inside"), std::string::npos);
    EXPECT_NE(bsdf_fault("twosided", "<bsdf type=\"dielectric\"/>")
                  .find("scene.xml:3:1: bsdf \"twosided\": a \"dielectric\" bsdf cannot be a side"),
              std::string::npos);
    EXPECT_NE(bsdf_fault("twosided", "<bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/>").find("3 bsdfs inside"),
              std::string::npos);
}

TEST(Bsdf, WrongValuesAreSentences)
{
    EXPECT_EQ(bsdf_fault("diffuse", R"(<rgb name="reflectance" value="1.5 0 0"/>)"),
              "scene.xml:3:1: bsdf \"diffuse\": reflectance = 1.5 must lie between 0 and 1");
    EXPECT_EQ(bsdf_fault("dielectric", R"(<string name="int_ior" value="watr"/>)")
                  .find("scene.xml:3:1: bsdf \"dielectric\": int_ior = \"watr\" is not a material with a known index of refraction (did "
                        "you mean \"water\"?)"),
              0u);
    EXPECT_EQ(bsdf_fault("dielectric", R"(<float name="int_ior" value="0"/>)"),
              "scene.xml:3:1: bsdf \"dielectric\": int_ior = 0 must be positive");
    EXPECT_NE(bsdf_fault("dielectric", R"(<float name="int_ior" value="1e9"/>)").find("must lie between .01 and 100"), std::string::npos);
    EXPECT_NE(bsdf_fault("conductor", R"(<string name="material" value="Au"/>)").find("material = \"Au\" is not supported"),
              std::string::npos);
    EXPECT_NE(bsdf_fault("conductor", R"(<texture name="eta" type="bitmap"/>)").find("eta as <texture type=\"bitmap\"> is not supported; write it as <rgb>"), std::string::npos);
    EXPECT_EQ(bsdf_fault("null", R"(<float name="opacity" value="1"/>)"),
              "scene.xml:3:1: bsdf \"null\": unknown parameter \"opacity\"; it takes none");
    EXPECT_EQ(bsdf_fault("principled"),
              "scene.xml:2:1: bsdf type \"principled\" is not supported; supported: null, diffuse, twosided, dielectric, thindielectric, roughdielectric, conductor, roughconductor, plastic, "
              "roughplastic");
    EXPECT_EQ(bsdf_fault("difuse").find("scene.xml:2:1: bsdf type \"difuse\" is not supported (did you mean \"diffuse\"?)"), 0u);
}

}  // namespace tyndall::test

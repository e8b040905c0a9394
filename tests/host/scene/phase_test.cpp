// Phase functions: each type, its defaults, what is done to its numbers, and each refusal.
#include <cmath>
#include <numbers>

#include "scene/describe.hpp"
#include "scene/phases.hpp"
#include "scene_text.hpp"

namespace tyndall::test {
namespace {

using Type = PhaseFunction::Type;

std::string medium_with(const std::string& phase) { return "<medium type=\"homogeneous\" id=\"juice\">\n" + phase + "</medium>"; }
PhaseFunction phase_of(const std::string& phase) { return load_body(medium_with(phase) + unit_sphere).media.at(0).phase; }
std::string phase_fault(const std::string& phase) { return fault_of_body(medium_with(phase)); }

std::string table(const std::string& values) { return "<phase type=\"tabphase\"><string name=\"values\" value=\"" + values + "\"/></phase>"; }
std::string blend(const std::string& weight, const std::string& inside)
{
    return "<phase type=\"blendphase\"><float name=\"weight\" value=\"" + weight + "\"/>" + inside + "</phase>";
}
std::string hg(const std::string& g) { return "<phase type=\"hg\"><float name=\"g\" value=\"" + g + "\"/></phase>"; }
const std::string even = "<phase type=\"isotropic\"/>", rayleigh = "<phase type=\"rayleigh\"/>";

TEST(Phase, RayleighHasNoParameters)
{
    EXPECT_EQ(phase_of(rayleigh).type, Type::rayleigh);
    EXPECT_EQ(phase_of(rayleigh).g, 0);
    EXPECT_EQ(phase_fault("<phase type=\"rayleigh\"><float name=\"g\" value=\"0\"/></phase>"),
              "scene.xml:3:24: medium \"juice\": unknown parameter \"g\"; it takes none");
}

// Mitsuba's convention: the table runs over the cosine between the directions of travel, so that its last value is forward scattering.
TEST(Phase, TablesAreNormalisedAndTheirLastValueIsForward)
{
    const PhaseFunction rising = phase_of(table("0, 0.5, 1.0"));
    ASSERT_EQ(rising.values.size(), 3u);
    EXPECT_EQ(rising.values[0], 0);
    EXPECT_NEAR(rising.values[2], .5 / std::numbers::pi, 1e-15);  // density of mu (1 + mu) / 2, over 2 pi
    EXPECT_NEAR(rising.g, 1 / 3., 1e-15);
    EXPECT_EQ(rising.cumulative, (std::vector<double>{0, .25, 1}));
    EXPECT_LT(phase_of(table("3 2 1")).g, 0);
    const PhaseFunction flat = phase_of(table("7 7")), small = phase_of(table("7e-308 7e-308")), large = phase_of(table("1.7e308, 1.7e308,1.7e308"));
    for (const PhaseFunction* phase : {&flat, &small, &large}) {
        EXPECT_NEAR(phase->values.front(), 1 / (4 * std::numbers::pi), 1e-15);
        EXPECT_NEAR(phase->g, 0, 1e-15);
    }
}

TEST(Phase, BlendsAreFlatAndTheirWeightIsTheSeconds)
{
    const PhaseFunction two = phase_of(blend("0.25", hg("0.8") + even));
    ASSERT_EQ(two.parts.size(), 2u);
    EXPECT_EQ(two.type, Type::blend);
    EXPECT_EQ(two.parts[0].weight, .75);
    EXPECT_EQ(two.parts[0].g, .8);
    EXPECT_EQ(two.parts[1].type, Type::isotropic);
    EXPECT_NEAR(two.g, .6, 1e-15);
    const PhaseFunction three = phase_of(blend("0.5", rayleigh + blend("0.25", hg("0.8") + table("0 1"))));
    ASSERT_EQ(three.parts.size(), 3u);
    EXPECT_EQ(three.parts[1].weight, .375);
    EXPECT_EQ(three.parts[2].weight, .125);
    EXPECT_EQ(three.parts[2].type, Type::table);
    EXPECT_NEAR(three.g, .375 * .8 + .125 / 3, 1e-15);
}

TEST(Phase, BlendsOfOnePartAreThatPart)
{
    EXPECT_EQ(phase_of(blend("0", hg("0.8") + rayleigh)).type, Type::henyey_greenstein);
    EXPECT_EQ(phase_of(blend("1", hg("0.8") + rayleigh)).type, Type::rayleigh);
    EXPECT_EQ(phase_of(blend("0.5", blend("0", even + rayleigh) + rayleigh)).parts.size(), 2u);
}

TEST(Phase, PartsMayBeNamedElsewhere)
{
    const Scene scene = load_body("<phase type=\"hg\" id=\"lobe\"><float name=\"g\" value=\"0.5\"/></phase>" +
                                  medium_with(blend("0.5", "<ref id=\"lobe\"/><ref id=\"lobe\"/>")) + unit_sphere);
    EXPECT_EQ(scene.media.at(0).phase.parts.size(), 2u);
    EXPECT_EQ(scene.media.at(0).phase.g, .5);
}

TEST(Phase, WrongNumbersAreSentences)
{
    const std::string at = "scene.xml:3:24: medium \"juice\": ";
    EXPECT_EQ(phase_fault("<phase type=\"tabphase\"/>"), "scene.xml:3:1: medium \"juice\": a tabphase needs the parameter \"values\": two or more numbers");
    EXPECT_EQ(phase_fault(table("")), at + "a table of 0 values; it takes two or more, from cosine -1 to 1");
    EXPECT_EQ(phase_fault(table("1")), at + "a table of 1 values; it takes two or more, from cosine -1 to 1");
    EXPECT_EQ(phase_fault(table("1, -0.5, 1")), at + "value 2 of the table, \"-0.5\", must not be negative");
    EXPECT_EQ(phase_fault(table("1, 2, nan")), at + "value 3 of the table, \"nan\", is not a finite number");
    EXPECT_EQ(phase_fault(table("inf 2")), at + "value 1 of the table, \"inf\", is not a finite number");
    EXPECT_EQ(phase_fault(table("1; 2")), at + "value 1 of the table, \"1;\", is not a finite number");
    EXPECT_EQ(phase_fault(table("0 0.0 0")), at + "all values of the table are 0; at least one must be positive");
    EXPECT_EQ(phase_fault(hg("-1")), "scene.xml:3:18: medium \"juice\": g = -1 must lie strictly between -1 and 1");
    EXPECT_EQ(phase_fault(hg("1")), "scene.xml:3:18: medium \"juice\": g = 1 must lie strictly between -1 and 1");
    EXPECT_EQ(phase_fault(blend("1.5", even + rayleigh)), "scene.xml:3:26: medium \"juice\": weight = 1.5 must lie between 0 and 1");
    EXPECT_EQ(phase_fault(blend("-0.1", even + rayleigh)), "scene.xml:3:26: medium \"juice\": weight = -0.1 must lie between 0 and 1");
    EXPECT_EQ(phase_fault(blend("nan", even + rayleigh)), "scene.xml:3:26: medium \"juice\": weight = \"nan\" is not a finite number");
}

TEST(Phase, WrongPartsOfABlendAreSentences)
{
    EXPECT_EQ(phase_fault("<phase type=\"blendphase\">" + even + rayleigh + "</phase>"),
              "scene.xml:3:1: medium \"juice\": a blendphase needs the parameter \"weight\" between 0 and 1");
    EXPECT_EQ(phase_fault(blend("0.5", even)), "scene.xml:3:1: medium \"juice\": a blendphase of 1 phase functions; it takes two, for weight 0 and for weight 1");
    EXPECT_EQ(phase_fault(blend("0.5", even + even + even)).find("scene.xml:3:1: medium \"juice\": a blendphase of 3 phase functions"), 0u);
    EXPECT_EQ(phase_fault("<phase type=\"blendphase\"><volume name=\"weight\" type=\"gridvolume\"/>" + even + rayleigh + "</phase>"),
              "scene.xml:3:26: medium \"juice\": weight as <volume type=\"gridvolume\"> is not supported; write it as <float> or <integer>");
    EXPECT_EQ(phase_fault("<phase type=\"sggx\"/>"), "scene.xml:3:1: phase type \"sggx\" is not supported; supported: isotropic, hg, rayleigh, tabphase, blendphase");
    EXPECT_NE(phase_fault("<phase type=\"rayliegh\"/>").find("(did you mean \"rayleigh\"?)"), std::string::npos);
}

TEST(Phase, ABlendInsideOfItselfAndTooManyPartsAreRefused)
{
    EXPECT_EQ(fault_of_body("<phase type=\"blendphase\" id=\"a\"><float name=\"weight\" value=\"0.5\"/>" + even + "<ref id=\"a\"/></phase>" + medium_with("<ref id=\"a\"/>")),
              "scene.xml:2:92: medium \"juice\": a blendphase is inside of itself");
    std::string body = "<phase type=\"hg\" id=\"p0\"/>";  // p(i + 1) is twice p(i)
    for (int i = 0; i < 60; ++i)
        body += "<phase type=\"blendphase\" id=\"p" + std::to_string(i + 1) + "\"><float name=\"weight\" value=\"0.5\"/><ref id=\"p" + std::to_string(i) + "\"/><ref id=\"p" +
                std::to_string(i) + "\"/></phase>";
    EXPECT_NE(fault_of_body(body + medium_with("<ref id=\"p60\"/>")).find("a blendphase of 128 parts; the most are 64"), std::string::npos);
    EXPECT_EQ(fault_of_body(body + medium_with("<ref id=\"p6\"/>") + unit_sphere), "");
    std::string chain = "<phase type=\"hg\" id=\"c0\"/>";
    for (int i = 0; i < 2000; ++i)
        chain += "<phase type=\"blendphase\" id=\"c" + std::to_string(i + 1) + "\"><float name=\"weight\" value=\"0.5\"/>" + even + "<ref id=\"c" + std::to_string(i) + "\"/></phase>";
    EXPECT_NE(fault_of_body(chain + medium_with("<ref id=\"c2000\"/>")).find("blendphases nest deeper than 64"), std::string::npos);
}

TEST(Phase, IsDescribedInWords)
{
    EXPECT_EQ(phase_words(phase_of(even)), "isotropic");
    EXPECT_EQ(phase_words(phase_of(hg("0.5"))), "Henyey-Greenstein g = 0.5");
    EXPECT_EQ(phase_words(phase_of(rayleigh)), "Rayleigh");
    EXPECT_EQ(phase_words(phase_of(table("0, 1"))), "table of 2 values, mean cosine 0.333333");
    EXPECT_EQ(phase_words(phase_of(blend("0.25", hg("0.8") + rayleigh))), "blend of 0.75 Henyey-Greenstein g = 0.8 + 0.25 Rayleigh, mean cosine 0.6");
    EXPECT_NE(describe(load_body(medium_with(rayleigh) + unit_sphere)).find("albedo 0.75, Rayleigh; optical"), std::string::npos);
}

}  // namespace
}  // namespace tyndall::test

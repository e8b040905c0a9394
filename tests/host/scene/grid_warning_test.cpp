// What is said about grids: where they are, what is in them.
#include <gmock/gmock.h>

#include "scene/describe.hpp"
#include "scene_text.hpp"
#include "tests/support/vol_file.hpp"

namespace tyndall::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string away = R"(<transform name="to_world"><translate x="1" y="2" z="9"/></transform>)";

std::string grid(const std::string& role, const std::string& steps = R"(<scale value="2"/><translate value="-1"/>)")
{
    return "<volume name=\"" + role + "\" type=\"gridvolume\"><string name=\"filename\" value=\"ball.vol\"/><transform name=\"to_world\">" + steps + "</transform></volume>";
}
std::string holder(const std::string& type, const std::string& steps = "", const std::string& role = "interior")
{
    return "<shape type=\"" + type + "\"><transform name=\"to_world\">" + steps + "</transform><bsdf type=\"null\"/><ref name=\"" + role + "\" id=\"smoke\"/></shape>";
}

/// A scene with a ball of smoke in 16^3 voxels; the grid's tag stands in line 3. The camera and a lamp are far away and in `around`.
Scene smoke_in(const std::string& grids, const std::string& shapes, const std::string& around = "")
{
    const TemporaryFolder folder;
    folder.write("ball.vol", vol_bytes(ball_of_smoke(16)));
    return load_scene(folder.write("scene.xml", "<scene version=\"3.0.0\"><sensor type=\"perspective\"><float name=\"fov\" value=\"45\"/>" + away + around +
                                                    "</sensor>\n<medium type=\"heterogeneous\" id=\"smoke\">\n" + grids +
                                                    "<float name=\"scale\" value=\"3\"/></medium>\n<emitter type=\"point\">" + away + around + "</emitter>" + shapes + "</scene>"));
}
std::vector<std::string> warnings_of(const std::string& grids, const std::string& shapes, const std::string& around = "")
{
    std::vector<std::string> warnings = smoke_in(grids, shapes, around).warnings;
    for (std::string& warning : warnings) warning = warning.substr(warning.find("scene.xml"));
    return warnings;
}

TEST(GridWarning, NoneForAGridInsideItsShape)
{
    EXPECT_THAT(warnings_of(grid("sigma_t"), holder("cube")), IsEmpty());
    EXPECT_THAT(warnings_of(grid("sigma_t"), holder("sphere", R"(<scale value="1.8"/>)")), IsEmpty());
    EXPECT_THAT(warnings_of(grid("sigma_t", R"(<translate value="-.5"/><rotate x="1" y="1" angle="30"/>)"), holder("cube")), IsEmpty());
    EXPECT_THAT(warnings_of(grid("sigma_t"), holder("cube", R"(<scale x=".5"/><translate x="-.5"/>)") + holder("cube", R"(<scale x=".5"/><translate x=".5"/>)")), IsEmpty());
    EXPECT_THAT(warnings_of(grid("sigma_t"), "", R"(<ref id="smoke"/>)"), IsEmpty());  // the medium has no boundary
}

TEST(GridWarning, GridThatSticksOutOfItsShape)
{
    const auto sticks_out = ElementsAre(HasSubstr("scene.xml:3:1: volume \"ball.vol\": its box sticks out of what holds the medium \"smoke\"; the smoke that is outside is not rendered"));
    EXPECT_THAT(warnings_of(grid("sigma_t"), holder("cube", R"(<scale x=".98"/>)")), sticks_out);
    EXPECT_THAT(warnings_of(grid("sigma_t"), holder("sphere")), sticks_out);
    EXPECT_THAT(warnings_of(grid("sigma_t"), holder("cube", R"(<translate y=".1"/>)")), sticks_out);
    EXPECT_THAT(warnings_of(grid("sigma_t"), holder("cube", R"(<scale value=".1"/><translate x=".6"/>)")), sticks_out);  // none of the nine places is in it
    EXPECT_THAT(warnings_of(grid("sigma_t"), holder("cube", R"(<scale value="3"/>)", "interior") + "<shape type=\"cube\"><transform name=\"to_world\"><scale value=\".5\"/><translate value=\"1\"/></transform><bsdf type=\"null\"/><medium name=\"interior\" type=\"homogeneous\"/></shape>"),
                sticks_out);  // another medium fills one corner
}

TEST(GridWarning, GridThatIsElsewhere)
{
    const std::vector<std::string> warnings = warnings_of(grid("sigma_t"), holder("cube", R"(<translate x="4"/>)"));
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("scene.xml:3:1: volume \"ball.vol\": no shape that holds the medium \"smoke\" is where its box is, so there is nothing of it")));
}

TEST(GridWarning, OfAMediumThatNothingRefersToThatIsSaidAlone)
{
    EXPECT_THAT(warnings_of(grid("sigma_t"), ""), ElementsAre(HasSubstr("medium \"smoke\": nothing refers to it")));
}

TEST(DescribeGrid, SaysSizeValuesAndPlace)
{
    const std::string text = describe(smoke_in(grid("sigma_t") + grid("albedo"), holder("cube")));
    EXPECT_THAT(text, HasSubstr("medium     \"smoke\": sigma_t 3 x \"ball.vol\", at most 2.96484; albedo \"ball.vol\", at most 0.988281; isotropic; optical thickness across its box at most 10.2705\n"));
    EXPECT_THAT(text, HasSubstr("volume     \"ball.vol\": 16 x 16 x 16 voxels of one channel, values 0 to 0.988281, mean "));
    EXPECT_THAT(text, HasSubstr(", 0.02 MiB, from (-1, -1, -1) to (1, 1, 1)\n"));
}

}  // namespace
}  // namespace tyndall::test

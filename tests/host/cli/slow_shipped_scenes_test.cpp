/// Every scene that comes along, by every kind of method: no sample that is not a finite number.
#include <set>

#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

TEST_F(Program, ShippedScenesHaveNoNumberThatIsNoneByAnyMethod)
{
    std::set<std::string> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TYNDALL_SOURCE_DIR) / "scenes"))
        if (std::filesystem::exists(entry.path() / "scene.xml")) scenes.insert(entry.path() / "scene.xml");
    EXPECT_GE(scenes.size(), 12u);
    for (const std::string& scene : scenes)
        for (const char* method : {"path", "vrl", "vpl", "vpl-clamped", "vbl", "beams", "photons", "talk"}) {
            const ProcessResult result = run({"render", scene, "--method", method, "--resolution", "24x24", "-p", "2", "--lights", "512", "--strict-nan", "--no-selftest", "--progress", "none", "-o", "small.exr"});
            EXPECT_EQ(result.exit_code, 0) << scene << ", " << method << '\n' << result.err;
        }
}

}  // namespace
}  // namespace tyndall::test

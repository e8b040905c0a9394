/// What libtyndall.so shows to the dynamic linker.
#include <gmock/gmock.h>

#include <sstream>

#include "../../support/child_process.hpp"

using namespace tyndall::test;

namespace {

std::vector<std::string> exported()
{
    const ProcessResult ran = run_process({"/bin/sh", "-c", "nm --dynamic --defined-only --demangle --format=just-symbols '" TYNDALL_LIBRARY "'"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    std::vector<std::string> names;
    std::istringstream lines(ran.out);
    for (std::string line; std::getline(lines, line);) names.push_back(line);
    return names;
}

TEST(LibraryExports, NothingButThePublicInterface)
{
    const auto names = exported();
    ASSERT_GT(names.size(), 20u);
    for (const std::string& name : names) EXPECT_TRUE(name.starts_with("tyndall::api::") || name.starts_with("tyndall_")) << name;
}

TEST(LibraryExports, ThePublicInterface)
{
    const auto names = exported();
    for (const char* name : {"tyndall::api::render(", "tyndall::api::Scene::load(", "tyndall::api::Scene::Scene(", "tyndall::api::Image::write(", "tyndall::api::devices(", "tyndall_render", "tyndall_last_error"})
        EXPECT_THAT(names, testing::Contains(testing::StartsWith(name)));
}

}  // namespace

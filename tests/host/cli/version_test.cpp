#include "cli/version.hpp"

#include <gmock/gmock.h>

namespace tyndall::test {

using testing::HasSubstr;

TEST(Version, NamesTheLoaderOrTheHeadersOfOpenCL)
{
    EXPECT_THAT(version_text("A Loader 1.2.3 (its author), OpenCL 3.0"), HasSubstr("\nA Loader 1.2.3 (its author), OpenCL 3.0\nEmbree 3"));
    EXPECT_THAT(version_text(""), testing::ContainsRegex("\nOpenCL headers [0-9.]+, the loader does not say its version\nEmbree 3"));
}

}  // namespace tyndall::test

#include <gmock/gmock.h>

#include "rules.hpp"

using namespace tyndall::house;
using testing::IsEmpty;

namespace {
const fs::path root = TYNDALL_SOURCE_DIR;
}

TEST(House, IncludesGoOneWay) { EXPECT_THAT(includes_against_the_direction(root), IsEmpty()); }
TEST(House, LibrariesStayInTheirFolder) { EXPECT_THAT(libraries_outside_their_folder(root), IsEmpty()); }
TEST(House, PublicHeadersNeedNoLibrary) { EXPECT_THAT(libraries_in_public_headers(root), IsEmpty()); }
TEST(House, FilesAreShort) { EXPECT_THAT(files_too_long(root), IsEmpty()); }
TEST(House, FunctionsAreShort) { EXPECT_THAT(functions_too_long(root), IsEmpty()); }
TEST(House, KernelsAskIfNotIfdef) { EXPECT_THAT(conditional_compilation_in_kernels(root), IsEmpty()); }
TEST(House, ArithmeticIsNeverApproximatedByOption) { EXPECT_THAT(approximate_arithmetic(root), IsEmpty()); }
TEST(House, TopOfTheRepositoryIsAsPlanned) { EXPECT_THAT(strangers_at_the_top(root), IsEmpty()); }
TEST(House, LinksLeadSomewhere) { EXPECT_THAT(dead_links(root), IsEmpty()); }
TEST(House, PagesAreFound) { EXPECT_THAT(pages_that_nobody_finds(root), IsEmpty()); }
TEST(House, TestsThatDocumentsNameAreThere) { EXPECT_THAT(tests_that_are_not_there(root), IsEmpty()); }
TEST(House, EveryElementOfScenesIsDocumented) { EXPECT_THAT(elements_without_a_page(root), IsEmpty()); }
TEST(House, VersionsAgree) { EXPECT_THAT(versions_that_differ(root), IsEmpty()); }
TEST(House, ScenesAreReproducedByTheirScripts) { EXPECT_THAT(scenes_not_reproduced(root), IsEmpty()); }

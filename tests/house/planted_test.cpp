// Every house rule finds a violation that was planted for it, names its place, and accepts the harmless neighbour beside it.
#include <gmock/gmock.h>

#include "rules.hpp"

using namespace tyndall::house;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using testing::UnorderedElementsAre;

namespace {

std::string lines(int count, const std::string& line)
{
    std::string text;
    for (int i = 0; i < count; ++i) text += line + "\n";
    return text;
}

}  // namespace

TEST(PlantedViolation, ElementWithoutAPageIsFound)
{
    const TemporaryFolder tree;
    tree.write("host/docs/scenes.md", "| `fog` | `density` 1, `type` thick or thin |\n");
    tree.write("host/scene/fog.cpp", "x = properties.real(\"density\", 1);\ny = properties.choice(\"type\", \"thick\", {\"thick\", \"thin\", \"none\"});\nread_colour(builder, properties, \"tint\");\n");
    EXPECT_THAT(elements_without_a_page(tree.path()), ElementsAre(StartsWith("host/scene/fog.cpp:2: reads \"none\""), StartsWith("host/scene/fog.cpp:3: reads \"tint\"")));
}

TEST(PlantedViolation, AnotherVersionIsFound)
{
    const TemporaryFolder tree;
    tree.write("CMakeLists.txt", "project(tyndall VERSION 1.2.3 LANGUAGES CXX)\n");
    tree.write("CITATION.cff", "version: 1.2.3\n");
    tree.write("host/docs/changelog.md", "# Changelog\n\n## [1.2.2] - 2026\n\n## [1.2.3]\n");
    EXPECT_THAT(versions_that_differ(tree.path()), ElementsAre(StartsWith("host/docs/changelog.md: is of version \"1.2.2\"")));
}

TEST(PlantedViolation, IncludeFromFurtherDownIsFound)
{
    const TemporaryFolder tree;
    tree.write("host/scene/scene.hpp", "#include \"pipeline/render.hpp\"\n");
    tree.write("host/pipeline/render.hpp", "#include \"scene/scene.hpp\"\n");
    EXPECT_THAT(includes_against_the_direction(tree.path()), ElementsAre(StartsWith("host/scene/scene.hpp:1: includes host/pipeline")));
}

TEST(PlantedViolation, MiddleRowIncludingItsNeighbourIsFound)
{
    const TemporaryFolder tree;
    tree.write("host/film/film.hpp", "#include \"report/report.hpp\"\n");
    tree.write("host/report/report.hpp", "#include \"kernels/shared/pair.h\"\n#include \"report/other.hpp\"\n");
    tree.write("host/report/other.hpp", "");
    tree.write("kernels/shared/pair.h", "// #include \"film/film.hpp\"\n");
    EXPECT_THAT(includes_against_the_direction(tree.path()), ElementsAre(HasSubstr("never include each other")));
}

TEST(PlantedViolation, KernelIncludingTheHostIsFound)
{
    const TemporaryFolder tree;
    tree.write("kernels/math/rod.h", "#include \"dialect.h\"\n#include \"../../host/scene/scene.hpp\"\n");
    tree.write("kernels/dialect.h", "");
    tree.write("host/scene/scene.hpp", "");
    EXPECT_THAT(includes_against_the_direction(tree.path()), ElementsAre(StartsWith("kernels/math/rod.h:2:")));
}

TEST(PlantedViolation, FolderWithoutARowIsFound)
{
    const TemporaryFolder tree;
    tree.write("host/attic/old.cpp", "");
    EXPECT_THAT(includes_against_the_direction(tree.path()), ElementsAre(StartsWith("host/attic/old.cpp: is in no row")));
}

TEST(PlantedViolation, LibraryAwayFromHomeIsFound)
{
    const TemporaryFolder tree;
    tree.write("host/device/queue.hpp", "#include <CL/opencl.hpp>\n");
    tree.write("host/visibility/scene.cpp", "#include <embree3/rtcore.h>\n");
    tree.write("host/film/exr.cpp", "#include <ImfOutputFile.h>\n#include <png.h>\n");
    tree.write("bench/bare_loop.cpp", "#include <embree3/rtcore.h>\n");
    EXPECT_THAT(libraries_outside_their_folder(tree.path()), IsEmpty());
    tree.write("host/film/film.cpp", "#include <CL/cl.h>\n#include <embree3/rtcore.h>\n");
    tree.write("host/cli/main.cpp", "\n#include <OpenEXR/ImfHeader.h>\n");
    tree.write("kernels/math/rod.h", "#include <glm/glm.hpp>\n");
    EXPECT_THAT(libraries_outside_their_folder(tree.path()),
                UnorderedElementsAre(StartsWith("kernels/math/rod.h:1: GLM"), StartsWith("host/film/film.cpp:1: OpenCL"),
                                     StartsWith("host/film/film.cpp:2: Embree"), StartsWith("host/cli/main.cpp:2: OpenEXR")));
}

TEST(PlantedViolation, LibraryBehindAPublicHeaderIsFound)
{
    const TemporaryFolder tree;
    tree.write("host/include/tyndall/render.hpp", "#include \"scene/vector.hpp\"\n#include <string>\n");
    tree.write("host/scene/vector.hpp", "#include <glm/vec3.hpp>\n");
    EXPECT_THAT(libraries_in_public_headers(tree.path()), ElementsAre(StartsWith("host/scene/vector.hpp:1: a public header reaches GLM")));
}

TEST(PlantedViolation, LongFileIsFound)
{
    const TemporaryFolder tree;
    tree.write("host/film/short.cpp", lines(300, "int a;"));
    tree.write("host/film/long.cpp", lines(301, "int a;"));
    tree.write("host/film/CMakeLists.txt", lines(100, "# a"));
    EXPECT_THAT(files_too_long(tree.path()),
                UnorderedElementsAre(StartsWith("host/film/long.cpp: 301"), StartsWith("host/film/CMakeLists.txt: 100")));
}

TEST(PlantedViolation, LongFunctionIsFound)
{
    const TemporaryFolder tree;
    const std::string head = "namespace a {\nstruct B {\n    int c = 0;\n    int d() const\n    {\n";
    tree.write("host/film/fits.cpp", head + lines(37, "        if (c) { return '{'; }  // }") + "    }\n};\n}\n");
    EXPECT_THAT(functions_too_long(tree.path()), IsEmpty());
    tree.write("host/film/too_long.cpp", head + lines(38, "        if (c) { return '{'; }  // }") + "    }\n};\n}\n");
    EXPECT_THAT(functions_too_long(tree.path()), ElementsAre(StartsWith("host/film/too_long.cpp:4: function of 41 lines")));
}

TEST(PlantedViolation, LongTableIsNoFunction)
{
    const TemporaryFolder tree;
    tree.write("host/film/table.cpp", "const int table[] = {\n" + lines(60, "    1,") + "};\nenum class E {\n" + lines(60, "    a,") + "};\n");
    EXPECT_THAT(functions_too_long(tree.path()), IsEmpty());
}

TEST(PlantedViolation, ConditionalInAKernelIsFound)
{
    const TemporaryFolder tree;
    tree.write("kernels/dialect.h", "#ifdef __OPENCL_C_VERSION__\n#endif\n");
    tree.write("kernels/math/rod.h", "/// A rod.\n#ifndef ROD_H\n#define ROD_H\n#ifndef LANES\n#define LANES 1\n#endif\n#endif\n");
    EXPECT_THAT(conditional_compilation_in_kernels(tree.path()), IsEmpty());
    tree.write("kernels/math/phase.h", "#ifndef PHASE_H\n#define PHASE_H\n#ifdef ANISOTROPIC\n#endif\n#endif\n");
    tree.write("kernels/stages/pairs.cl", "#ifndef LANES\n#define OTHER\n#endif\n");
    EXPECT_THAT(conditional_compilation_in_kernels(tree.path()),
                UnorderedElementsAre(StartsWith("kernels/math/phase.h:3:"), StartsWith("kernels/stages/pairs.cl:1:")));
}

TEST(PlantedViolation, ApproximateArithmeticIsFound)
{
    const TemporaryFolder tree;
    tree.write("kernels/math/rod.h", "real a = exp(b);\nreal c = native_exp(b);\n");
    tree.write("host/device/build.cpp", "const char* options = \"-cl-std=CL1.2 -cl-fast-relaxed-math\";\nconst char* asked_for = \" -cl-mad-enable\";  // --math fast\n");
    tree.write("host/cmake/flags.cmake", "target_compile_options(a PRIVATE -ffp-contract=off)\ntarget_compile_options(a PRIVATE -ffast-math)\n");
    EXPECT_THAT(approximate_arithmetic(tree.path()),
                UnorderedElementsAre(StartsWith("kernels/math/rod.h:2: native_exp"), StartsWith("host/device/build.cpp:1: -cl-fast"),
                                     StartsWith("host/cmake/flags.cmake:2: -ffast-math")));
}

TEST(PlantedViolation, StrangerAtTheTopIsFound)
{
    const TemporaryFolder tree;
    tree.write("README.md", "");
    tree.write(".clang-format", "");
    tree.write("host/a.cpp", "");
    tree.write("notes.txt", "");
    EXPECT_THAT(strangers_at_the_top(tree.path()), ElementsAre(StartsWith("notes.txt")));
}

TEST(PlantedViolation, DeadLinkIsFound)
{
    const TemporaryFolder tree;
    tree.write("README.md", "[host](host/README.md#data) [web](https://example.org/a)\n`host/gone.cpp` `kernels/lights/<light>.h`\n");
    tree.write("host/README.md", "[up](../README.md)\n[film](film/)\n");
    EXPECT_THAT(dead_links(tree.path()),
                UnorderedElementsAre("README.md:2: there is no host/gone.cpp", "host/README.md:2: the link to film/ leads nowhere"));
}

TEST(PlantedViolation, APageThatNobodyFindsIsFound)
{
    const TemporaryFolder tree;
    tree.write("host/docs/README.md", "[one](one.md)\n");
    tree.write("host/docs/one.md", "");
    tree.write("host/docs/two.md", "");
    tree.write("host/docs/decisions/0001-x.md", "");
    EXPECT_THAT(pages_that_nobody_finds(tree.path()), ElementsAre("host/docs/two.md: is not linked from host/docs/README.md"));
}

TEST(PlantedViolation, ATestThatADocumentMadeUpIsFound)
{
    const TemporaryFolder tree;
    tree.write("tests/a_test.cpp", "TEST(Films, AreRight)\nTEST_P(Lanes, Agree)\n");
    tree.write("host/docs/faults.md", "`Films.AreRight`, `Lanes.Agree`\n`scene.xml` `Films.AreWrong`\n");
    EXPECT_THAT(tests_that_are_not_there(tree.path()), ElementsAre("host/docs/faults.md:2: there is no test Films.AreWrong"));
}

TEST(PlantedViolation, GeometryThatItsScriptDoesNotWriteIsFound)
{
    const TemporaryFolder tree;
    const std::string script = "import sys\nopen(sys.argv[1] + '/a.obj', 'w').write('v 0 0 0\\n')\n";
    tree.write("scenes/one/make_geometry.py", script);
    tree.write("scenes/one/scene.xml", "");
    tree.write("scenes/one/README.md", "");
    tree.write("scenes/one/a.obj", "v 0 0 0\n");
    EXPECT_THAT(scenes_not_reproduced(tree.path()), IsEmpty());
    tree.write("scenes/one/a.obj", "v 0 0 1\n");
    tree.write("scenes/one/b.ply", "ply\n");
    tree.write("scenes/two/scene.xml", "");
    EXPECT_THAT(scenes_not_reproduced(tree.path()),
                UnorderedElementsAre(StartsWith("scenes/one/a.obj: is not"), StartsWith("scenes/one/b.ply: is not"), "scenes/two: has no README.md"));
}

/// Errors cross the border of the shared library as what they are, though it exports no symbol of theirs.
#include <gmock/gmock.h>

#include "scenes.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

TEST(LibraryErrors, KeepTheirTypes)
{
    EXPECT_THROW(api::Scene::load("there/is/no/such.xml"), SceneError);
    EXPECT_THROW(api::Scene::parse("<scene version=\"3.0.0\"><oops/></scene>", ".", "text.xml"), SceneError);
    const api::Scene scene(fog_as_data());
    RenderSettings settings = few_passes(1);
    settings.device = "no such device";
    EXPECT_THROW(api::render(scene, settings), NoDeviceError);
    settings = few_passes(1), settings.lanes = 3;
    EXPECT_THROW(api::render(scene, settings), UsageError);
    settings = few_passes(1);
    settings.method = Method::path;
    const api::Image image = api::render(scene, settings);
    EXPECT_THROW(image.write("/nowhere/at/all.exr"), IoError);
    EXPECT_THROW(image.write("picture.jpg"), UsageError);
}

TEST(LibraryErrors, AreAllErrors)
{
    try {
        api::Scene::parse("<scene version=\"3.0.0\">\n  <oops/></scene>", ".", "text.xml");
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("text.xml:2:"));
    }
}

TEST(LibraryErrors, TooMuchMemoryIsRefusedBeforeTheWork)
{
    const api::Scene scene = api::Scene(fog_as_data()).with_film(4096, 4096);
    try {
        api::render(scene, few_passes(1), {.max_bytes = 1 << 20});
        FAIL();
    } catch (const ResourceError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("1048576"));
    }
    EXPECT_NO_THROW(api::render(api::Scene(fog_as_data()), few_passes(1), {.max_bytes = 1 << 30}));
}

}  // namespace

/// The C interface beside the C++ one, and the caller's own OpenCL objects.
#define CL_TARGET_OPENCL_VERSION 300
#include <CL/cl.h>
#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "../../support/temporary_folder.hpp"
#include "scenes.hpp"
#include "settled.hpp"
#include "tyndall/tyndall.h"

using namespace tyndall;
using namespace tyndall::test;

namespace {

struct SceneDestroyer { void operator()(tyndall_scene* scene) const { tyndall_scene_destroy(scene); } };
struct SettingsDestroyer { void operator()(tyndall_settings* settings) const { tyndall_settings_destroy(settings); } };
struct ImageDestroyer { void operator()(tyndall_image* image) const { tyndall_image_destroy(image); } };
using CScene = std::unique_ptr<tyndall_scene, SceneDestroyer>;
using CSettings = std::unique_ptr<tyndall_settings, SettingsDestroyer>;
using CImage = std::unique_ptr<tyndall_image, ImageDestroyer>;

CScene parsed(const std::string& xml)
{
    tyndall_scene* scene = nullptr;
    tyndall_scene_parse(xml.c_str(), ".", "fog.xml", &scene);
    return CScene(scene);
}

CSettings with(const std::vector<std::pair<std::string, std::string>>& values)
{
    tyndall_settings* settings = nullptr;
    tyndall_settings_create(&settings);
    for (const auto& [name, value] : values) EXPECT_EQ(tyndall_settings_set(settings, name.c_str(), value.c_str()), TYNDALL_OK) << tyndall_last_error();
    return CSettings(settings);
}

const std::vector<std::pair<std::string, std::string>> two_passes{{"passes", "2"}, {"lights", "64"}, {"no-selftest", "true"}};

std::vector<float> rendered(const tyndall_scene* scene, const tyndall_settings* settings)
{
    tyndall_image* image = nullptr;
    EXPECT_EQ(tyndall_render(scene, settings, &image), TYNDALL_OK) << tyndall_last_error();
    const CImage owner(image);
    if (!image) return {};
    const float* beauty = tyndall_image_layer(image, "beauty");
    return {beauty, beauty + 3 * 24 * 18};
}

TEST(CInterface, GivesTheImageOfTheCppInterface)
{
    const api::Image image = api::render(api::Scene::parse(fog_as_text(), ".", "fog.xml"), few_passes(2));
    EXPECT_EQ(rendered(parsed(fog_as_text()).get(), with(two_passes).get()), std::vector<float>(image.beauty().begin(), image.beauty().end()));
}

TEST(CInterface, SettingsAreTheProgramsOptions)
{
    const CSettings settings = with({{"time", "1.5h"}, {"layer", "single,media_to_media"}, {"short", "true"}, {"select", "all"}, {"launch-ms", "20"}, {"block-passes", "4"}, {"max-depth", "-1"}});
    for (const auto& [name, value] : std::vector<std::pair<std::string, std::string>>{{"passes", "-1"}, {"passes", ""}, {"passes", "1 2"}, {"layer", "nothing"}, {"short", "maybe"}, {"scene", "x"}, {"", ""}, {"help", "true"}}) {
        EXPECT_EQ(tyndall_settings_set(settings.get(), name.c_str(), value.c_str()), TYNDALL_USAGE_ERROR) << name << "=" << value;
        EXPECT_STRNE(tyndall_last_error(), "");
    }
}

TEST(CInterface, EnvironmentVariablesDoNotOverrideSettings)
{
    ASSERT_EQ(::setenv("TYNDALL_DEVICE", "no such device", 1), 0);
    const CSettings settings = with(two_passes);
    EXPECT_FALSE(rendered(parsed(fog_as_text()).get(), settings.get()).empty());
    ::unsetenv("TYNDALL_DEVICE");
}

TEST(CInterface, ErrorsBelongToTheirThread)
{
    tyndall_scene* scene = nullptr;
    EXPECT_EQ(tyndall_scene_load("no/such/file.xml", &scene), TYNDALL_SCENE_ERROR);
    EXPECT_EQ(scene, nullptr);
    const std::string here = tyndall_last_error();
    EXPECT_THAT(here, testing::HasSubstr("no/such/file.xml"));
    std::thread([] { EXPECT_STREQ(tyndall_last_error(), ""); }).join();
    EXPECT_EQ(tyndall_last_error(), here);
}

TEST(CInterface, NullIsRefusedOrHarmless)
{
    EXPECT_EQ(tyndall_scene_load(nullptr, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_render(nullptr, nullptr, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_add_point(nullptr, nullptr, nullptr, 0), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_image_layer(nullptr, "beauty"), nullptr);
    EXPECT_EQ(tyndall_image_width(nullptr), 0);
    tyndall_image_destroy(nullptr), tyndall_settings_destroy(nullptr), tyndall_description_destroy(nullptr), tyndall_stop_destroy(nullptr), tyndall_stop_raise(nullptr);
}

TEST(CInterface, MemoryIsBounded)
{
    const CScene scene = parsed(fog_as_text());
    const CSettings settings = with(two_passes);
    tyndall_settings_max_bytes(settings.get(), 1000);
    std::string heard;
    tyndall_settings_callbacks(settings.get(), nullptr, [](void* user, int level, const char* text) { if (level == 2) *static_cast<std::string*>(user) += text; }, &heard);
    tyndall_image* image = nullptr;
    EXPECT_EQ(tyndall_render(scene.get(), settings.get(), &image), TYNDALL_DEVICE_ERROR);
    EXPECT_THAT(tyndall_last_error(), testing::HasSubstr("1000"));
    EXPECT_EQ(heard, tyndall_last_error()) << "the log hears the error once";
}

TEST(CInterface, ScenesHaveDefinitionsAndOtherFilms)
{
    const TemporaryFolder folder;
    std::string text = fog_as_text();
    text.insert(text.find('>', text.find("<scene")) + 1, "<default name=\"depth\" value=\"no number\"/><integrator type=\"volpath\"><integer name=\"max_depth\" value=\"$depth\"/></integrator>");
    std::ofstream(folder / "fog.xml") << text;
    const std::string file = (folder / "fog.xml").string();
    const char* names[] = {"depth"};
    const char* values[] = {"7"};
    tyndall_scene* scene = nullptr;
    EXPECT_EQ(tyndall_scene_load(file.c_str(), &scene), TYNDALL_SCENE_ERROR);
    ASSERT_EQ(tyndall_scene_load_with(file.c_str(), names, values, 1, 0, &scene), TYNDALL_OK) << tyndall_last_error();
    const CScene loaded(scene);
    tyndall_scene* other = nullptr;
    ASSERT_EQ(tyndall_scene_with_film(loaded.get(), 7, 5, &other), TYNDALL_OK) << tyndall_last_error();
    const CScene small(other);
    EXPECT_EQ(tyndall_scene_width(small.get()), 7);
    EXPECT_EQ(tyndall_scene_height(small.get()), 5);
    EXPECT_EQ(tyndall_scene_width(loaded.get()), 24);
    EXPECT_EQ(tyndall_scene_with_film(loaded.get(), 0, 5, &other), TYNDALL_USAGE_ERROR);
    for (const auto& [bad_names, bad_values] : {std::pair<const char**, const char**>(nullptr, values), {names, nullptr}}) {
        EXPECT_EQ(tyndall_scene_load_with(file.c_str(), bad_names, bad_values, 1, 0, &scene), TYNDALL_USAGE_ERROR);
        EXPECT_EQ(scene, nullptr);
    }
}

TEST(CInterface, ScenesMayNameFilesOutsideIfTheCallerSaysSo)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "scene");
    std::ofstream(folder / "outside.xml") << "<scene version=\"3.0.0\"/>";
    std::string text = fog_as_text();
    text.insert(text.find('>', text.find("<scene")) + 1, "<include filename=\"../outside.xml\"/>");
    std::ofstream(folder / "scene/fog.xml") << text;
    tyndall_scene* scene = nullptr;
    EXPECT_EQ(tyndall_scene_load_with((folder / "scene/fog.xml").c_str(), nullptr, nullptr, 0, 0, &scene), TYNDALL_SCENE_ERROR);
    EXPECT_EQ(tyndall_scene_load_with((folder / "scene/fog.xml").c_str(), nullptr, nullptr, 0, 1, &scene), TYNDALL_OK) << tyndall_last_error();
    tyndall_scene_destroy(scene);
}

/// A context with a queue, made here.
struct OwnOpenCl {
    cl_platform_id platform = nullptr;
    cl_device_id device = nullptr;
    cl_context context = nullptr;
    cl_command_queue queue = nullptr;

    explicit OwnOpenCl(cl_command_queue_properties properties)
    {
        EXPECT_EQ(clGetPlatformIDs(1, &platform, nullptr), CL_SUCCESS);
        EXPECT_EQ(clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 1, &device, nullptr), CL_SUCCESS);
        context = clCreateContext(nullptr, 1, &device, nullptr, nullptr, nullptr);
        const cl_queue_properties wanted[] = {CL_QUEUE_PROPERTIES, properties, 0};
        queue = clCreateCommandQueueWithProperties(context, device, wanted, nullptr);
    }
    ~OwnOpenCl() { clReleaseCommandQueue(queue), clReleaseContext(context); }
    cl_uint context_references() const
    {
        cl_uint count = 0;
        clGetContextInfo(context, CL_CONTEXT_REFERENCE_COUNT, sizeof count, &count, nullptr);
        return count;
    }
    cl_uint queue_references() const
    {
        cl_uint count = 0;
        clGetCommandQueueInfo(queue, CL_QUEUE_REFERENCE_COUNT, sizeof count, &count, nullptr);
        return count;
    }
};

TEST(CInterface, RendersOnTheCallersContextAndQueue)
{
    const CScene scene = parsed(fog_as_text());
    const std::vector<float> expected = rendered(scene.get(), with(two_passes).get());
    for (const cl_command_queue_properties properties : {cl_command_queue_properties(0), cl_command_queue_properties(CL_QUEUE_PROFILING_ENABLE)}) {
        const OwnOpenCl own(properties);
        const cl_uint contexts = own.context_references(), queues = own.queue_references();
        const CSettings settings = with(two_passes);
        tyndall_settings_opencl(settings.get(), own.context, own.device, own.queue);
        EXPECT_EQ(rendered(scene.get(), settings.get()), expected);
        tyndall_settings_opencl(settings.get(), own.context, own.device, nullptr);
        EXPECT_EQ(rendered(scene.get(), settings.get()), expected);
        EXPECT_EQ(settled([&] { return own.context_references(); }, contexts), contexts);
        EXPECT_EQ(settled([&] { return own.queue_references(); }, queues), queues);
    }
}

TEST(CInterface, ObjectsThatDoNotFitAreRefused)
{
    const CScene scene = parsed(fog_as_text());
    const OwnOpenCl own(CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE), other(0);
    const CSettings settings = with(two_passes);
    for (const auto& [context, queue, word] : {std::tuple(own.context, own.queue, "out of order"), std::tuple(own.context, other.queue, "queue is not one of"), std::tuple(cl_context(nullptr), own.queue, "null")}) {
        tyndall_settings_opencl(settings.get(), context, own.device, queue);
        tyndall_image* image = nullptr;
        EXPECT_EQ(tyndall_render(scene.get(), settings.get(), &image), TYNDALL_USAGE_ERROR) << word;
        EXPECT_THAT(tyndall_last_error(), testing::HasSubstr(word));
    }
}

}  // namespace

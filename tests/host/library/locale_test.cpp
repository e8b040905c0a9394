/// The library in a program whose locale writes decimal commas.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "scenes.hpp"
#include "support/comma_locale.hpp"
#include "tyndall/tyndall.h"

using namespace tyndall;
using namespace tyndall::test;

namespace {

// Scene text, settings as text, options of kernels (a clamp that is no whole number), report and image.
TEST(LibraryLocale, ChangesNoByte)
{
    RenderSettings clamped = few_passes(2);
    clamped.method = Method("vpl-clamped"), clamped.clamp = 12.5;
    const auto rendered = [&](const RenderSettings& settings) {
        const api::Image image = api::render(api::Scene::parse(fog_as_text(), ".", "fog.xml"), settings);
        EXPECT_TRUE(nlohmann::json::accept(image.report()));
        return std::vector<float>(image.beauty().begin(), image.beauty().end());
    };
    const std::vector<float> plain = rendered(clamped);
    const CommaLocale comma;
    EXPECT_EQ(rendered(clamped), plain);
    tyndall_settings* settings = nullptr;
    ASSERT_EQ(tyndall_settings_create(&settings), TYNDALL_OK);
    EXPECT_EQ(tyndall_settings_set(settings, "clamp", "12.5"), TYNDALL_OK) << tyndall_last_error();
    EXPECT_EQ(tyndall_settings_set(settings, "clamp", "12,5"), TYNDALL_USAGE_ERROR);
    tyndall_settings_destroy(settings);
}

}  // namespace

/// Settings as texts, for the C interface: what an option of `tyndall render` sets.
#include "cli/setting_text.hpp"

#include <gmock/gmock.h>

#include "tyndall/error.hpp"

namespace tyndall {
namespace {

TEST(SettingText, FlagsFollowTheirLastValue)
{
    RenderSettings settings;
    const auto set = [&](const char* name, const char* value) { set_setting(settings, name, value); };
    set("no-selftest", "true");
    EXPECT_FALSE(settings.selftest);
    set("no-selftest", "false");
    EXPECT_TRUE(settings.selftest);
    set("short", "true");
    EXPECT_EQ(settings.segment_length, SegmentLength::short_);
    set("short", "false");
    EXPECT_EQ(settings.segment_length, SegmentLength::long_);
    set("long", "false");
    EXPECT_EQ(settings.segment_length, SegmentLength::short_);
    set("long", "true");
    EXPECT_EQ(settings.segment_length, SegmentLength::long_);
}

TEST(SettingText, FlagsAreTrueOrFalse)
{
    for (const char* value : {"", "1", "yes", "TRUE", "true "}) {
        RenderSettings settings;
        EXPECT_THROW(set_setting(settings, "no-selftest", value), UsageError) << value;
        EXPECT_TRUE(settings.selftest) << value;
    }
}

TEST(SettingText, OthersFollowTheirLastValueToo)
{
    RenderSettings settings;
    for (const char* passes : {"8", "64"}) set_setting(settings, "passes", passes);
    EXPECT_EQ(settings.passes, 64);
    set_setting(settings, "layer", "single");
    set_setting(settings, "layer", "emitted");
    EXPECT_EQ(settings.layers, LayerSet().add(Layer::emitted));
}

}  // namespace
}  // namespace tyndall

#include "device/kernel_source.hpp"

#include <gtest/gtest.h>

#include "device/device.hpp"
#include "device/pair_stage.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

TEST(KernelSource, IsFlatAndNamesItsFiles)
{
    const std::string text = flattened_kernel("kernels/stages/gather_lights.cl", {{"LIGHT", "kernels/lights/virtual_ray_light.h"}, {"EYE", "kernels/stages/eye_segments.h"}});
    EXPECT_EQ(text.find("\n#include"), std::string::npos);
    for (const char* file : {"kernels/dialect.h", "kernels/math/rod.h", "kernels/lights/virtual_ray_light.h", "kernels/stages/eye_segments.h"})
        EXPECT_NE(text.find("#line 1 \"" + std::string(file) + "\""), std::string::npos) << file;
}

TEST(KernelSource, AMissingFileIsNamed)
{
    EXPECT_THROW(flattened_kernel("kernels/stages/none.cl", {}), BuildError);
}

TEST(KernelSource, ABrokenBuildShowsDeviceOptionsAndLog)
{
    Device device;
    try {
        PairStage stage(device, {.lanes = 3}, {});  // there is no float3 with vload3 of our kind
        FAIL();
    } catch (const BuildError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(device.info().name), std::string::npos);
        EXPECT_NE(message.find("-DLANES=3"), std::string::npos);
        EXPECT_NE(message.find("kernels/dialect.h"), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace tyndall

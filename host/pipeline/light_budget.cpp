#include "pipeline/light_budget.hpp"

#include <algorithm>
#include <cmath>

#include "device/pair_stage.hpp"

namespace tyndall {

std::uint32_t default_lights(const Camera& camera, double seconds)
{
    constexpr double pairs_per_second = 3e7;  // a CPU of two cores with some shadow segments; faster devices get shorter passes, which costs little
    constexpr double share = .025;            // of the budget: at least 40 passes, so that the error bar means something
    constexpr double fewest = 16, most = 4096;
    if (seconds <= 0) return light_block / 2;  // its pairs cost about as much as the rest of a pass on a CPU
    const double pixels = double(camera.crop_width) * camera.crop_height;
    const double lights = std::clamp(seconds * share * pairs_per_second / pixels, fewest, most);
    return static_cast<std::uint32_t>(lights < light_block ? lights : std::floor(lights / light_block) * light_block);
}

}  // namespace tyndall

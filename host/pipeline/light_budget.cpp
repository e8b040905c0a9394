#include "pipeline/light_budget.hpp"

#include <algorithm>
#include <cmath>

#include "device/pair_stage.hpp"

namespace tyndall {

std::uint32_t default_lights(const Camera& camera, double seconds)
{
    constexpr double pairs_per_second = 4e7;  // a CPU of two cores with some shadow segments; faster devices get shorter passes, which costs little
    constexpr double share = .025;            // of the budget: at least 40 passes, so that the error bar means something
    if (seconds <= 0) return 2 * light_block;
    const double pixels = double(camera.crop_width) * camera.crop_height;
    const double blocks = std::floor(seconds * share * pairs_per_second / pixels / light_block);
    return static_cast<std::uint32_t>(std::clamp(blocks, 1.0, 16.0)) * light_block;
}

}  // namespace tyndall

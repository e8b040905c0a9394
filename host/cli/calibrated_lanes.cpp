#include "cli/calibrated_lanes.hpp"

#include "cli/say.hpp"
#include "report/readable.hpp"
#include "throughput/lane_store.hpp"
#include "tyndall/error.hpp"

namespace tyndall {

std::string take_calibrated_lanes(RenderSettings& settings)
{
    if (settings.lanes != 0 || settings.method == Method::path) return {};
    try {
        const StoredLanes stored = stored_lanes(choose_devices(settings.device).front());
        settings.lanes = stored.lanes, settings.lanes_calibrated = stored.lanes != 0;
        return stored.warning;
    } catch (const NoDeviceError&) {
        return {};
    }
}

int kept_lanes(const DeviceInfo& device)
{
    const StoredLanes stored = stored_lanes(device);
    if (!stored.warning.empty()) say(stderr, "warning: {}\n", terminal_safe(stored.warning));
    return stored.lanes ? stored.lanes : device.default_lanes;
}

}  // namespace tyndall

/// The C interface: the connections alone.
#include <algorithm>
#include <cstddef>

#include "library/c_description.hpp"
#include "tyndall/backend.hpp"

using namespace tyndall;

struct tyndall_backend {
    api::Backend backend;
    tyndall_log_callback log = nullptr;
    void* user = nullptr;  ///< of the log
};

namespace {

// The records of both interfaces are one: their fields lie at the same places.
static_assert(sizeof(tyndall_ray_light) == sizeof(api::RayLight) && offsetof(tyndall_ray_light, medium) == offsetof(api::RayLight, medium) &&
              offsetof(tyndall_ray_light, flux) == offsetof(api::RayLight, flux));
static_assert(sizeof(tyndall_point_light) == sizeof(api::PointLight) && offsetof(tyndall_point_light, direction) == offsetof(api::PointLight, direction) &&
              offsetof(tyndall_point_light, power) == offsetof(api::PointLight, power));
static_assert(sizeof(tyndall_eye_segment) == sizeof(api::EyeSegment) && offsetof(tyndall_eye_segment, direction) == offsetof(api::EyeSegment, direction) &&
              offsetof(tyndall_eye_segment, throughput) == offsetof(api::EyeSegment, throughput));
static_assert(sizeof(tyndall_eye_point) == sizeof(api::EyePoint) && offsetof(tyndall_eye_point, normal) == offsetof(api::EyePoint, normal) &&
              offsetof(tyndall_eye_point, facing) == offsetof(api::EyePoint, facing) && offsetof(tyndall_eye_point, throughput) == offsetof(api::EyePoint, throughput));
static_assert(sizeof(tyndall_shadow_segment) == sizeof(api::ShadowSegment) && offsetof(tyndall_shadow_segment, medium) == offsetof(api::ShadowSegment, medium));

api::Occluded asking(tyndall_occluded occluded, void* user)
{
    if (!occluded) return {};
    return [=](std::span<const api::ShadowSegment> segments, std::span<std::uint8_t> blocked) {
        if (occluded(user, reinterpret_cast<const tyndall_shadow_segment*>(segments.data()), segments.size(), blocked.data()) != 0) throw UsageError("the caller's occluded ended the call");
    };
}

api::Transmitted asking(tyndall_transmittance passed, void* user)
{
    needed(passed, "passed");
    return [=](std::span<const api::ShadowSegment> segments, std::span<api::Float3> out) {
        if (passed(user, reinterpret_cast<const tyndall_shadow_segment*>(segments.data()), segments.size(), out.data()->data()) != 0) throw UsageError("the caller's transmittance ended the call");
    };
}

/// What both ways to make a backend take from their arguments.
api::BackendDescription described(const tyndall_description* media, const tyndall_settings* settings, const double* low, const double* high)
{
    const tyndall_description& from = needed(media, "the description");
    api::BackendDescription description{.media = from.data.media, .containers = from.containers, .low = triple(low, "low"), .high = triple(high, "high")};
    if (!settings) return description;
    const RenderSettings& s = settings->settings;
    description.device = s.device, description.opencl = s.opencl, description.lanes = s.lanes, description.selftest = s.selftest, description.stop = s.stop;
    description.max_bytes = settings->max_bytes;
    if (const auto log = settings->log) description.warn = [log, user = settings->user](const std::string& text) { log(user, 1, text.c_str()); };
    return description;
}

template <typename Record, typename CRecord>
std::span<const Record> records(const CRecord* from, std::size_t count, const char* what)
{
    if (count > 0) needed(from, what);
    return {reinterpret_cast<const Record*>(from), count};
}

template <typename Light, typename Eye, typename CLight, typename CEye>
tyndall_status connect(tyndall_backend* backend, const CLight* lights, std::size_t light_count, const CEye* eyes, std::size_t eye_count, const tyndall_connect* how, float* radiance, float* variance)
{
    const auto connected = [&] {
        api::ConnectOptions options;
        if (how) options = {.seed = how->seed, .rounds = how->rounds, .lights_per_eye = how->lights_per_eye};
        if (eye_count > 0) needed(radiance, "the place for the radiance");
        const api::Estimates estimates = needed(backend, "the backend").backend.connect(records<Light>(lights, light_count, "lights"), records<Eye>(eyes, eye_count, "eyes"), options);
        std::copy(estimates.radiance.begin(), estimates.radiance.end(), radiance);
        if (variance) std::copy(estimates.variance.begin(), estimates.variance.end(), variance);
    };
    const tyndall_status status = guarded(connected);
    if (status != TYNDALL_OK && backend && backend->log) backend->log(backend->user, 2, tyndall_last_error());
    return status;
}

/// The backend with the log of its settings.
tyndall_backend* logging(api::Backend backend, const tyndall_settings* settings)
{
    return settings ? new tyndall_backend{std::move(backend), settings->log, settings->user} : new tyndall_backend{std::move(backend)};
}

}  // namespace

extern "C" {

tyndall_status tyndall_backend_create(const tyndall_description* media, const tyndall_settings* settings, const double* low, const double* high, tyndall_occluded occluded, void* user,
                                      tyndall_backend** backend)
{
    return made(backend, [&] {
        api::BackendDescription description = described(media, settings, low, high);
        description.occluded = asking(occluded, user);
        return logging(api::Backend(std::move(description)), settings);
    });
}

tyndall_status tyndall_backend_create_passing(const tyndall_description* media, const tyndall_settings* settings, const double* low, const double* high, tyndall_transmittance passed, void* user,
                                              tyndall_backend** backend)
{
    return made(backend, [&] {
        api::BackendDescription description = described(media, settings, low, high);
        description.transmittance = asking(passed, user);
        return logging(api::Backend(std::move(description)), settings);
    });
}

tyndall_status tyndall_add_container(tyndall_description* description, int medium, const double* planes, size_t plane_count)
{
    return guarded([&] {
        tyndall_description& to = needed(description, "the description");
        added(to.data.media, medium, "medium"), needed(planes, "planes");
        api::Container container{.medium = static_cast<std::uint32_t>(medium)};
        for (std::size_t i = 0; i < plane_count; ++i) container.planes.push_back({planes[4 * i], planes[4 * i + 1], planes[4 * i + 2], planes[4 * i + 3]});
        to.containers.push_back(std::move(container));
    });
}

void tyndall_backend_destroy(tyndall_backend* backend) { delete backend; }

tyndall_status tyndall_rays_to_segments(tyndall_backend* backend, const tyndall_ray_light* lights, size_t light_count, const tyndall_eye_segment* eyes, size_t eye_count,
                                        const tyndall_connect* how, float* radiance, float* variance)
{
    return connect<api::RayLight, api::EyeSegment>(backend, lights, light_count, eyes, eye_count, how, radiance, variance);
}

tyndall_status tyndall_rays_to_points(tyndall_backend* backend, const tyndall_ray_light* lights, size_t light_count, const tyndall_eye_point* eyes, size_t eye_count,
                                      const tyndall_connect* how, float* radiance, float* variance)
{
    return connect<api::RayLight, api::EyePoint>(backend, lights, light_count, eyes, eye_count, how, radiance, variance);
}

tyndall_status tyndall_points_to_segments(tyndall_backend* backend, const tyndall_point_light* lights, size_t light_count, const tyndall_eye_segment* eyes, size_t eye_count,
                                          const tyndall_connect* how, float* radiance, float* variance)
{
    return connect<api::PointLight, api::EyeSegment>(backend, lights, light_count, eyes, eye_count, how, radiance, variance);
}

tyndall_status tyndall_points_to_points(tyndall_backend* backend, const tyndall_point_light* lights, size_t light_count, const tyndall_eye_point* eyes, size_t eye_count,
                                        const tyndall_connect* how, float* radiance, float* variance)
{
    return connect<api::PointLight, api::EyePoint>(backend, lights, light_count, eyes, eye_count, how, radiance, variance);
}

}  // extern "C"

/// The C interface: settings, rendering, images, devices.
#include <string>

#include "cli/setting_text.hpp"
#include "library/c_guard.hpp"
#include "library/c_handles.hpp"

using namespace tyndall;

namespace {

api::RenderOptions options_of(const tyndall_settings& s, const tyndall_scene& scene)
{
    api::RenderOptions options{.max_bytes = s.max_bytes};
    if (s.progress)
        options.progress = [&](const api::Progress& p, const api::Preview& film) {
            const tyndall_progress progress{.size = sizeof progress, .passes_done = p.passes_done, .passes_wanted = p.passes_wanted, .seconds = p.seconds, .seconds_left = p.seconds_left,
                                            .error = p.error, .width = scene.scene.width(), .height = scene.scene.height(), .film = &film};
            return s.progress(s.user, &progress) == 0;
        };
    if (s.log) options.log = [&](api::LogLevel level, const std::string& text) { s.log(s.user, static_cast<int>(level), text.c_str()); };
    return options;
}

}  // namespace

extern "C" {

tyndall_status tyndall_settings_create(tyndall_settings** settings)
{
    return made(settings, [] { return new tyndall_settings; });
}

void tyndall_settings_destroy(tyndall_settings* settings) { delete settings; }

tyndall_status tyndall_settings_set(tyndall_settings* settings, const char* name, const char* value)
{
    return guarded([&] { set_setting(needed(settings, "the settings").settings, &needed(name, "the name"), &needed(value, "the value")); });
}

void tyndall_settings_max_bytes(tyndall_settings* settings, uint64_t bytes)
{
    if (settings) settings->max_bytes = bytes;
}

void tyndall_settings_opencl(tyndall_settings* settings, void* context, void* device, void* queue)
{
    if (settings) settings->settings.opencl = OpenClHandles{.context = context, .device = device, .queue = queue};
}

void tyndall_settings_callbacks(tyndall_settings* settings, tyndall_progress_callback progress, tyndall_log_callback log, void* user)
{
    if (settings) settings->progress = progress, settings->log = log, settings->user = user;
}

tyndall_status tyndall_preview(const tyndall_progress* progress, float* rgb, size_t floats)
{
    return guarded([&] { static_cast<const api::Preview*>(needed(progress, "the progress").film)->beauty({&needed(rgb, "the place for the picture"), floats}); });
}

tyndall_status tyndall_stop_create(tyndall_stop** stop)
{
    return made(stop, [] { return new tyndall_stop; });
}

void tyndall_stop_raise(tyndall_stop* stop)
{
    if (stop) stop->flag.raise();
}

void tyndall_stop_destroy(tyndall_stop* stop) { delete stop; }

void tyndall_settings_stop(tyndall_settings* settings, const tyndall_stop* stop)
{
    if (settings) settings->settings.stop = stop ? &stop->flag : nullptr;
}

tyndall_status tyndall_render(const tyndall_scene* scene, const tyndall_settings* settings, tyndall_image** image)
{
    return made(image, [&] {
        const tyndall_settings usual;
        const tyndall_settings& s = settings ? *settings : usual;
        return new tyndall_image{api::render(needed(scene, "the scene").scene, s.settings, options_of(s, *scene))};
    });
}

void tyndall_image_destroy(tyndall_image* image) { delete image; }
int tyndall_image_width(const tyndall_image* image) { return image ? image->image.width() : 0; }
int tyndall_image_height(const tyndall_image* image) { return image ? image->image.height() : 0; }
int tyndall_image_passes(const tyndall_image* image) { return image ? image->image.passes() : 0; }
double tyndall_image_error(const tyndall_image* image) { return image ? image->image.error() : -1; }
const char* tyndall_image_stopped_by(const tyndall_image* image) { return image ? image->image.stopped_by().c_str() : ""; }
const char* tyndall_image_report(const tyndall_image* image) { return image ? image->image.report().c_str() : ""; }

const float* tyndall_image_layer(const tyndall_image* image, const char* name)
{
    if (!image || !name) return nullptr;
    const std::string_view wanted(name);
    if (wanted == "beauty") return image->image.beauty().data();
    if (wanted == "variance") return image->image.variance().data();
    for (std::size_t l = 0; l < layer_count; ++l)
        if (layer_names[l] == wanted) {
            const auto layer = image->image.layer(static_cast<Layer>(l));
            return layer.empty() ? nullptr : layer.data();
        }
    return nullptr;
}

tyndall_status tyndall_image_write(const tyndall_image* image, const char* exr)
{
    return guarded([&] { needed(image, "the image").image.write(&needed(exr, "the file's name")); });
}

int tyndall_device_count(void)
{
    int count = 0;
    guarded([&] { count = static_cast<int>(api::devices().size()); });
    return count;
}

const char* tyndall_device_name(int index)
{
    thread_local std::string text;
    bool found = false;
    guarded([&] {
        for (const auto& d : api::devices())
            if (d.index == index) text = d.platform + ": " + d.name + (d.usable ? "" : " (" + d.why_not + ")"), found = true;
    });
    return found ? text.c_str() : nullptr;
}

}  // extern "C"

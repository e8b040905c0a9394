#include <fmt/format.h>

#include <iterator>

#include "report/explanation.hpp"
#include "report/readable.hpp"

namespace tyndall {
namespace {

using Text = std::string;

template <class... Arguments>
void add(Text& text, fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
    fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
    text += '\n';
}

std::string bytes_words(std::uint64_t bytes)
{
    const double mib = static_cast<double>(bytes) / (1024. * 1024.);
    return mib < 1024 ? fmt::format("{:.1f} MiB", mib) : fmt::format("{:.1f} GiB", mib / 1024);
}

void add_head(Text& text, const Explanation& e)
{
    add(text, "{}: {} x {} pixels, method {}", terminal_safe(e.scene), e.width, e.height, e.method);
    if (e.lights) add(text, "about {} virtual lights a pass, on {}", e.lights, e.device.empty() ? "no device" : terminal_safe(e.device) + ", " + readable_lanes(e.lanes, e.lanes_from));
}

void add_effects(Text& text, const Explanation& e)
{
    add(text, "effects found");
    std::string absent;
    for (const EffectReport& effect : e.effects) {
        if (effect.found) add(text, "  {:<22} {}", effect.effect, terminal_safe(effect.cause));
        else absent += " " + effect.effect;
    }
    add(text, "effects that the scene does not have\n {}", absent.empty() ? " none" : absent);
}

void add_layers(Text& text, const Explanation& e)
{
    add(text, "layers");
    for (const LayerReport& layer : e.layers) {
        add(text, "  {:<26} {}{}", layer.layer, layer.skipped ? "skipped: " : layer.technique + (layer.why.empty() ? "" : ": "), terminal_safe(layer.why));
        if (!layer.bias.empty()) add(text, "  {:<26}   biased: {}", "", layer.bias);
        if (!layer.sampler.empty()) add(text, "  {:<26}   sampler {}: {}", "", layer.sampler, terminal_safe(layer.sampler_why));
    }
}

void add_kernels(Text& text, const Explanation& e)
{
    add(text, "kernels to be built{}", e.kernels.empty() ? ": none" : "");
    for (const KernelReport& kernel : e.kernels)
        add(text, "  {:<18} {:<18} {}  ({})", kernel.layer, kernel.kernel, kernel.features, kernel.options);
    if (!e.selection.empty()) add(text, "virtual lights per pass: {}", e.selection);
    if (!e.grids.empty()) add(text, "transmittance through density grids: {}", e.grids);
}

void add_memory(Text& text, const Explanation& e)
{
    add(text, "memory, estimated");
    for (const MemoryReport& memory : e.memory) add(text, "  {:<44} {:>10} on the {}", memory.what, bytes_words(memory.bytes), memory.on_device ? "device" : "host");
}

void add_savings(Text& text, const Explanation& e)
{
    if (e.savings.empty()) return;
    add(text, "not done, because the scene does not need it");
    for (const SavingReport& saving : e.savings)
        add(text, "  {}: {}{}", saving.what, saving.because,
            saving.predicted_seconds < 0 ? "" : fmt::format(", predicted {} of processor time a pass", readable_seconds(saving.predicted_seconds)));
}

void add_time(Text& text, const Explanation& e)
{
    if (!e.calibration) return add(text, "time: not measured: {}", terminal_safe(e.why_no_calibration));
    const Calibration& c = *e.calibration;
    add(text, "time, predicted from {} passes after the first{}", c.passes,
        c.film_share < 1 ? fmt::format(" on {:.3g} % of the pixels", 100 * c.film_share) : "");
    add(text, "  before the first pass      {}", readable_seconds(c.before_seconds));
    add(text, "  each pass                  {}, with an error of {}", readable_seconds(c.pass_seconds), readable_percent(c.error));
    if (e.passes) add(text, "  {:>6} passes              {}", e.passes, readable_seconds(c.before_seconds + c.first_pass_seconds + c.pass_seconds * (e.passes - 1)));
    add(text, "  to an error of 1 %         {}", readable_seconds(c.seconds_to_one_percent));
}

}  // namespace

std::string to_text(const Explanation& e)
{
    Text text;
    add_head(text, e);
    add_effects(text, e);
    add_layers(text, e);
    add_kernels(text, e);
    add_memory(text, e);
    add_savings(text, e);
    add_time(text, e);
    for (const auto& warning : e.warnings) add(text, "warning: {}", terminal_safe(warning));
    return text;
}

}  // namespace tyndall

#include "cli/render_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lights/light_technique.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

bool plain(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || std::string_view("-_./=:,%+").find(c) != std::string_view::npos; }

/// What differs from the defaults of `render`, of settings that concern virtual lights alone.
std::string virtual_light_options(const RenderSettings& s)
{
    std::string line;
    if (s.sampler != Sampler::automatic) line += fmt::format(" --sampler {}", name_in(sampler_names, s.sampler));
    if (s.sequence != Sequence::automatic) line += fmt::format(" --sequence {}", name_in(sequence_names, s.sequence));
    if (s.emission != Sequence::automatic) line += fmt::format(" --emission {}", name_in(sequence_names, s.emission));
    if (s.transmittance != GridTransmittance::march) line += fmt::format(" --transmittance {}", name_in(transmittance_names, s.transmittance));
    if (s.precision != Precision::f32) line += fmt::format(" --precision {}", name_in(precision_names, s.precision));
    if (s.math != KernelMath::strict) line += fmt::format(" --math {}", name_in(math_names, s.math));
    if (s.segment_length == SegmentLength::short_) line += " --short";
    if (s.clamp) line += fmt::format(" --clamp {:g}", *s.clamp);
    if (s.beam_radius) line += fmt::format(" --beam-radius {:g}", *s.beam_radius);
    if (s.lights) line += fmt::format(" --lights {}", s.lights);
    if (s.selection != Selection::automatic) line += fmt::format(" --select {}", name_in(selection_names, s.selection));
    if (s.selected_lights) line += fmt::format(" --selected {}", s.selected_lights);
    if (s.candidates) line += s.candidates == all_lights ? " --candidates all" : fmt::format(" --candidates {}", s.candidates);
    if (s.samples_per_pair != 1) line += fmt::format(" --samples {}", s.samples_per_pair);
    if (s.lanes) line += fmt::format(" --lanes {}", s.lanes);
    if (!s.device.empty()) line += " --device " + shell_quoted(s.device);
    return line;
}

}  // namespace

std::string shell_quoted(const std::string& text)
{
    if (!text.empty() && std::ranges::all_of(text, plain)) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string render_line(const CompareCommand& command, const RenderSettings& settings)
{
    std::string line = fmt::format("tyndall render {} --method {}", shell_quoted(command.inputs.front().string()), name(settings.method));
    if (uses_light_paths(settings.method)) line += virtual_light_options(settings);
    for (const std::string& layer : command.layers) line += " --layer " + shell_quoted(layer);
    if (settings.max_depth) line += fmt::format(" --max-depth {}", *settings.max_depth);
    if (command.resolution) line += fmt::format(" --resolution {}x{}", command.resolution->first, command.resolution->second);
    if (command.crop) line += fmt::format(" --crop {},{},{},{}", command.crop->x, command.crop->y, command.crop->width, command.crop->height);
    if (settings.threads) line += fmt::format(" --threads {}", settings.threads);
    for (const auto& [name, value] : command.load.definitions) line += " -D " + shell_quoted(name + "=" + value);
    if (command.load.allow_outside) line += " --allow-outside";
    return line;
}

}  // namespace tyndall

#include "pipeline/check_settings.hpp"

#include <cmath>
#include <string>

#include "lights/light_technique.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

void require(bool holds, const std::string& sentence)
{
    if (!holds) throw UsageError(sentence);
}

/// "a or b": the methods of which it is true.
std::string methods_that(bool (*holds)(Method))
{
    std::string names;
    for (const Method method : all_methods())
        if (holds(method)) names += (names.empty() ? "" : " or ") + std::string(method.name());
    return names;
}

/// What only some methods have.
void require_of_method(const RenderSettings& s)
{
    const std::string method(s.method.name());
    require(!s.clamp || (std::isfinite(*s.clamp) && *s.clamp > 0), "the clamp must be a finite number above 0");
    require(!s.clamp || is_clamped(s.method), "--clamp bounds the connections of a clamped method, and \"" + method + "\" is none; use --method " + methods_that(is_clamped));
    require(!s.beam_radius || (std::isfinite(*s.beam_radius) && *s.beam_radius > 0 && *s.beam_radius <= 1), "the beam radius must be above 0 and at most 1: a share of the scene's half diagonal");
    require(!s.beam_radius || is_thick(s.method), "--beam-radius is for lights that are thick, and those of \"" + method + "\" are not; use --method " + methods_that(is_thick));
}

}  // namespace

void check_settings(const RenderSettings& s)
{
    constexpr std::uint32_t most_lights = 1u << 24;
    require(s.passes > 0 || s.seconds > 0 || s.target_error > 0, "nothing says when to stop: give passes, a time or a target error");
    require(std::isfinite(s.target_error) && s.target_error >= 0, "the target error must be a finite number, not negative");
    require(s.passes >= 0, "passes = " + std::to_string(s.passes) + " must not be negative");
    require(std::isfinite(s.seconds) && s.seconds >= 0, "time must be a finite number of seconds, not negative");
    require(s.lights <= most_lights, "lights = " + std::to_string(s.lights) + " per pass is more than " + std::to_string(most_lights) + "; use more passes instead");
    require(s.lanes == 0 || s.lanes == 1 || s.lanes == 4 || s.lanes == 8 || s.lanes == 16, "lanes = " + std::to_string(s.lanes) + " must be 1, 4, 8 or 16 (0: by rule)");
    require(s.threads >= 0 && s.threads <= 1024, "threads = " + std::to_string(s.threads) + " must lie between 0 (all) and 1024");
    require(s.max_depth.value_or(-1) >= -1, "max depth = " + std::to_string(s.max_depth.value_or(-1)) + " must be -1 (no limit) or at least 0");
    require(s.tile_pairs <= 1u << 28, "tile = " + std::to_string(s.tile_pairs) + " pairs is more than " + std::to_string(1u << 28));
    require(s.launch_seconds >= .001 && s.launch_seconds <= 1000, "a launch must be allowed between 1 ms and 1000 s");
    require(s.samples_per_pair >= 1 && s.samples_per_pair <= 256, "samples per pair = " + std::to_string(s.samples_per_pair) + " must lie between 1 and 256");
    require(s.selected_lights <= 1u << 16, "selected lights = " + std::to_string(s.selected_lights) + " per pixel is more than " + std::to_string(1u << 16));
    require(s.candidates <= 1u << 20 || s.candidates == all_lights, "candidates = " + std::to_string(s.candidates) + " is more than " + std::to_string(1u << 20));
    require(s.selection_block == 0 || s.selection_block == 4 || s.selection_block == 8 || s.selection_block == 16,
            "selection block = " + std::to_string(s.selection_block) + " pixels must be 4, 8 or 16 (0: by rule)");
    require(s.selection_defence <= 1, "the share of lights that are chosen by power must be at most 1");
    require(s.camera_samples >= 0 && s.camera_samples <= 64, "camera samples = " + std::to_string(s.camera_samples) + " per pass must lie between 1 and 64 (0: by rule)");
    require(s.skip_thin >= 0 && s.skip_thin < 1, "the share of light that may be left out must be at least 0 and less than 1");
    require_of_method(s);
    require(s.block_passes >= 1 && s.block_passes <= 1 << 16, "block of passes = " + std::to_string(s.block_passes) + " must lie between 1 and 65536");
    require(!s.layers.empty(), "no layer is left to render");
}

}  // namespace tyndall

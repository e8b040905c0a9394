#pragma once
/// How many virtual lights a pass has, and which of them it connects each eye to.
#include <cstdint>
#include <string>

#include "scene/scene.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

struct SelectionPlan {
    std::uint32_t lights = 0;  ///< per pass, aimed at
    bool chosen = false;       ///< false: every eye connects to every light
    std::uint32_t slots = 0;   ///< lights per pixel and pass, over all its camera samples; all of them unless `chosen`
    int block = 8;             ///< pixels across of the squares that share an estimate
    double defence = .1;       ///< share that goes by power alone
    std::uint32_t candidates = 0;  ///< lights that are chosen for a region of 8 x 8 squares, for the squares to choose among; 0: all
    std::uint32_t offered = 1u << 16;  ///< of more lights than that a region looks at one of several equal parts
    int camera_samples = 1;    ///< per pixel and pass, for virtual lights
    std::string why;

    /// Do squares choose among candidates?
    bool by_region() const { return chosen && candidates > 0 && lights / 2 > candidates; }
    std::uint32_t slots_per_sample() const { return slots / static_cast<std::uint32_t>(camera_samples); }
};

/// The settings' wishes, and where they leave something open a fixed rule of image size and time budget, never of a clock, so that the bytes do not depend on
/// the machine (host/docs/performance.md has the measurements): 2048 lights of which each pixel is connected to 64, chosen by an estimate per 8 x 8 pixels; all
/// lights if fewer than 512 are asked for. How many there are where all are connected follows the time budget (default_lights); a choice has its 2048 in the shortest render, because one pass of it
/// leaves a quarter of the error that the same time leaves in many passes of few lights.
SelectionPlan plan_selection(const RenderSettings& settings, const Camera& camera);

/// The settings with the plan written into them: for a render of another film size or time that is to have the same lights and choice.
RenderSettings with_plan(RenderSettings settings, const SelectionPlan& plan);

/// One line for people.
std::string to_text(const SelectionPlan& plan);

}  // namespace tyndall

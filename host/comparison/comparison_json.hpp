#pragma once
/// A comparison as data: for programs, and for the page.
#include <string>
#include <vector>

#include "comparison/every_dial.hpp"
#include "comparison/judge.hpp"

namespace tyndall {

/// What surrounds the measurements.
struct ComparisonAbout {
    std::string version, scene_file, layer;  ///< layer: "image", or the names of the layers that were compared
    std::uint64_t scene_hash = 0;
    std::vector<std::string> warnings;
    std::string command;                     ///< that makes the comparison again
    std::vector<std::string> render_commands;  ///< that render what each candidate was, one per candidate, without budget and seed
};

/// Keeps its arguments by reference.
struct Comparison {
    const ComparisonAbout& about;
    const Reference& reference;
    const MeasuringPlan& plan;
    const std::vector<Measurement>& measurements;
    const Judgement& judgement;
    const std::vector<DialSweep>& sweeps;    ///< one dial at a time; empty: a comparison of all with all
};

/// "schema": "tyndall-comparison/1". Numbers that are unknown or not finite are null; seeds and the hash are text.
std::string to_json(const Comparison& comparison);

/// The same on one line, with the images (comparison/page_image.hpp) of the reference and of the first run of each candidate: at every wanted time, and its layers at the end. Layers are
/// left out where they would make the page larger than `most_page_bytes`; a warning says so.
std::string to_page_data(const Comparison& comparison);

inline constexpr double most_page_bytes = 48e6;

/// Lines for people: errors at the wanted times, bias, what can be told apart.
std::string to_table(const Comparison& comparison);

}  // namespace tyndall

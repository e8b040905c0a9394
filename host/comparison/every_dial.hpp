#pragma once
/// One setting at a time: what each is worth in accuracy for the same time.
#include "comparison/candidate.hpp"

namespace tyndall {

/// What settings are that were left to a rule.
struct UsualValues {
    std::uint32_t lights = 2048;          ///< per pass
    std::uint32_t selected = 64;          ///< per pixel and pass; as many as lights: no choice
    int lanes = 16;
    Sampler sampler = Sampler::paper_isotropic;
    bool anisotropic = false, grids = false;  ///< in the scene's media
    bool fp64 = false;                    ///< the device has 64-bit numbers
};

/// A dial with its other values: candidates that differ from `usual` in it alone.
struct DialSweep {
    std::string name, usual_value;
    std::size_t usual = 0;                ///< index of a candidate
    std::vector<std::size_t> others;
};

struct EveryDial {
    std::vector<Candidate> candidates;    ///< `base` first
    std::vector<DialSweep> sweeps;
};

/// All dials of `base`, whose method has virtual lights: the methods beside it, what its lights and kernels can be told, and the bounds and radii of biased methods. Values
/// that mean the same in this scene, or that the device cannot do, are left out. Throws UsageError for a method without virtual lights.
EveryDial every_dial(const RenderSettings& base, const UsualValues& usual);

/// Name of a value: its candidate's, without the name of the usual one that it was set on.
std::string value_name(std::string_view usual, std::string_view candidate);

/// The pairs that a table of dials tells apart: each value and the usual one.
std::vector<std::pair<std::size_t, std::size_t>> pairs_of(const std::vector<DialSweep>& sweeps);

}  // namespace tyndall

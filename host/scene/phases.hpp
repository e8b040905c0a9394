#pragma once
/// Phase functions of every type, ready to be evaluated and sampled, and words for them.
#include <string>

#include "scene/scene.hpp"

namespace tyndall {

PhaseFunction henyey_greenstein_phase(double g);

PhaseFunction rayleigh_phase();

/// Two or more finite values >= 0, not all of them 0, at equally spaced mu from -1 to 1, in any unit.
PhaseFunction table_phase(std::vector<double> values);

/// (1 - weight) x first + weight x second, weight in [0, 1]. Blends inside are taken apart; parts without weight are left out.
PhaseFunction blend_phase(double weight, const PhaseFunction& first, const PhaseFunction& second);

/// Isotropic, or so close to it that no kernel needs to know.
bool scatters_evenly(const PhaseFunction& phase);

/// Neither isotropic nor Henyey and Greenstein's: a sum of lobes.
bool has_lobes(const PhaseFunction& phase);

/// "Rayleigh", "table of 19 values, mean cosine .3".
std::string phase_words(const PhaseFunction& phase);

}  // namespace tyndall

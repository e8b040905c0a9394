#pragma once
/// The covering set of kernel variants: what every test means that says "every variant" and cannot afford the full product of some 10^5 programs.
#include <vector>

#include "device/pair_stage.hpp"

namespace tyndall::test {

/// One number per choice that a program offers; what it stands for is `program_of`'s affair.
using Choices = std::vector<int>;

/// How many values each choice has: light, kind of eye, lanes, sampler, sequence, selection, clamp, transmittance, precision, math, then one for every feature.
Choices choice_counts();

/// The nearest choices that exist: connections that the host walks have occluders, coloured grids are grids, clamps belong to lights that have a clamped method, ways of sampling to virtual ray lights.
Choices allowed(Choices choices);

PairProgram program_of(const Choices& choices);

/// A set of allowed choices in which every pair of values of two choices occurs that can occur: some sixty, always the same.
std::vector<Choices> covering_choices();

/// A name for tests: letters, digits and underscores.
std::string name_of(const Choices& choices);

}  // namespace tyndall::test

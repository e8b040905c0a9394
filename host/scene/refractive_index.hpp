#pragma once
/// Indices of refraction that a scene can name instead of a number.
#include <optional>
#include <string>
#include <vector>

namespace tyndall {

/// At about 589 nm; nothing for an unknown name.
std::optional<double> refractive_index(const std::string& name);

std::vector<std::string> named_refractive_indices();

}  // namespace tyndall

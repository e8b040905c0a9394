#pragma once
/// Refuses settings that make no sense before any work is done.
#include "tyndall/settings.hpp"

namespace tyndall {

/// Throws UsageError with what is wrong and what is allowed.
void check_settings(const RenderSettings& settings);

}  // namespace tyndall

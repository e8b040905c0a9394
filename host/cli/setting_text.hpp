#pragma once
#include <string>

#include "tyndall/settings.hpp"

namespace tyndall {

/// Sets what the option `--name` of `tyndall render` sets, from the same text; the value of a flag is "true" or "false". Throws UsageError for an unknown name, with the
/// nearest one, and for a value that makes no sense. Environment variables are not looked at.
void set_setting(RenderSettings& settings, const std::string& name, const std::string& value);

}  // namespace tyndall

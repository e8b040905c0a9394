#pragma once
/// Reads the subset of Mitsuba 3's scene format that host/docs/scenes.md lists.
#include <filesystem>
#include <map>
#include <string>

#include "scene/scene.hpp"

namespace tyndall {

struct LoadOptions {
    std::map<std::string, std::string> definitions;  ///< -D name=value
    bool allow_outside = false;                      ///< let the scene name files outside its own folder
};

/// Throws SceneError, with file:line:column, for anything that is missing, misspelt, out of range or not supported.
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

/// The same from text; `folder` is where the files that it names are looked for, `name` stands for the file in messages.
Scene parse_scene(const std::string& xml, const std::filesystem::path& folder, const std::string& name, const LoadOptions& options = {});

}  // namespace tyndall

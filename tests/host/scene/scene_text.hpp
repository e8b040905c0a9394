#pragma once
/// Scenes written in the test, and what the loader says to them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scene/load_scene.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {

inline const std::string plain_sensor = R"(<sensor type="perspective"><float name="fov" value="45"/></sensor>)";

/// The scene around `body`, with a sensor. Line 1 is the scene's tag and the sensor; `body` starts line 2.
inline std::string around(const std::string& body) { return "<scene version=\"3.0.0\">" + plain_sensor + "\n" + body + "\n</scene>"; }

inline Scene parse(const std::string& xml, const LoadOptions& options = {}) { return parse_scene(xml, ".", "scene.xml", options); }
inline Scene load_body(const std::string& body, const LoadOptions& options = {}) { return parse(around(body), options); }

/// The message of the SceneError, "" if there is none.
inline std::string fault(const std::string& xml, const LoadOptions& options = {})
{
    try {
        parse(xml, options);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}
inline std::string fault_of_body(const std::string& body, const LoadOptions& options = {}) { return fault(around(body), options); }

/// A sphere of radius 1 at the origin fixes the scale: with a camera inside it the half diagonal is sqrt(3), so one unit is 2.
inline const std::string unit_sphere = R"(<shape type="sphere"/>)";

/// A folder that is gone after the test.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "tyndall_scene_XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = std::filesystem::canonical(name);
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const
    {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

inline std::string fault_of_file(const std::filesystem::path& file, const LoadOptions& options = {})
{
    try {
        load_scene(file, options);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

/// Every component within `tolerance`.
inline void expect_near(const Vec3& a, const Vec3& b, double tolerance, const std::string& what = "")
{
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << what << " axis " << axis;
}

}  // namespace tyndall::test

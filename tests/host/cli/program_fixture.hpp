#pragma once
/// The built program in a fresh folder with a small scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/child_process.hpp"
#include "support/temporary_folder.hpp"

namespace tyndall::test {

/// A fog cube around a camera and a point light; 16 x 12 pixels.
inline constexpr const char* fog_scene = R"(<scene version="3.0.0">
  <default name="density" value="1"/>
  <integrator type="volpath"><integer name="max_depth" value="4"/></integrator>
  <medium type="homogeneous" id="fog">
    <float name="sigma_t" value="$density"/>
    <float name="albedo" value="0.8"/>
  </medium>
  <sensor type="perspective">
    <float name="fov" value="45"/>
    <transform name="to_world"><lookat origin="0, 0, -3" target="0, 0, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm">
      <integer name="width" value="16"/><integer name="height" value="12"/>
      <rfilter type="box"/>
    </film>
    <ref id="fog"/>
  </sensor>
  <emitter type="point">
    <point name="position" x="0" y="1" z="0"/>
    <rgb name="intensity" value="3, 2, 1"/>
    <ref id="fog"/>
  </emitter>
  <shape type="cube">
    <transform name="to_world"><scale value="4"/></transform>
    <bsdf type="null"/>
    <ref name="interior" id="fog"/>
  </shape>
</scene>
)";

class Program : public testing::Test {
protected:
    Program() { write_file("scene.xml", fog_scene); }

    void write_file(const std::string& name, const std::string& text) { std::ofstream(folder / name, std::ios::binary) << text; }

    static std::vector<std::string> command(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.begin(), TYNDALL_PROGRAM);
        return arguments;
    }

    ProcessSetup here() const { return {.folder = folder.path()}; }

    ProcessResult run(std::vector<std::string> arguments) { return run_process(command(std::move(arguments)), here()); }

    ProcessResult run(std::vector<std::string> arguments, ProcessSetup setup)
    {
        setup.folder = folder.path();
        return run_process(command(std::move(arguments)), setup);
    }

    /// Names of the files in the folder, sorted.
    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path())) names.push_back(entry.path().filename());
        std::ranges::sort(names);
        return names;
    }

    TemporaryFolder folder;
};

}  // namespace tyndall::test

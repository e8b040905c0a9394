#pragma once
/// Small scenes, written in the test. The first line is the scene's tag and the sensor, which stands at z = 4 and looks at the origin; every part is a line.
#include <string>
#include <vector>

#include "scene/load_scene.hpp"

namespace tyndall::test {

inline std::string sensor(const std::string& inside = "")
{
    return R"(<sensor type="perspective"><float name="fov" value="45"/><transform name="to_world"><lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/></transform>)"
           R"(<film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="16"/></film>)" + inside + "</sensor>";
}

inline Scene scene_of(const std::vector<std::string>& parts, const std::string& inside_sensor = "")
{
    std::string xml = "<scene version=\"3.0.0\">" + sensor(inside_sensor);
    for (const std::string& part : parts) xml += "\n" + part;
    return parse_scene(xml + "</scene>", ".", "scene.xml", {});
}

inline std::string medium(const std::string& id, const std::string& sigma_t = ".5", const std::string& albedo = ".8", const std::string& phase = "")
{
    return "<medium type=\"homogeneous\" id=\"" + id + "\"><rgb name=\"sigma_t\" value=\"" + sigma_t + "\"/><rgb name=\"albedo\" value=\"" + albedo + "\"/>" + phase + "</medium>";
}
inline const std::string forward = R"(<phase type="hg"><float name="g" value=".6"/></phase>)";
inline const std::string in_fog = R"(<ref id="fog"/>)";

inline std::string shape(const std::string& type, const std::string& id, const std::string& place, const std::string& rest)
{
    return "<shape type=\"" + type + "\" id=\"" + id + "\"><transform name=\"to_world\">" + place + "</transform>" + rest + "</shape>";
}
/// A boundary that light crosses straight on, with a medium inside.
inline std::string container(const std::string& type, const std::string& id, const std::string& place, const std::string& inside = "fog")
{
    return shape(type, id, place, "<bsdf type=\"null\"/><ref name=\"interior\" id=\"" + inside + "\"/>");
}
inline const std::string small = R"(<scale value=".2"/>)", here = R"(<scale value="1"/>)", below = R"(<scale value="5"/><rotate x="1" angle="-90"/><translate y="-2"/>)";
inline const std::string white = R"(<bsdf type="diffuse"/>)", black = R"(<bsdf type="diffuse"><rgb name="reflectance" value="0"/></bsdf>)";
inline const std::string glass = R"(<bsdf type="dielectric"/>)", mirror = R"(<bsdf type="conductor"><string name="material" value="none"/></bsdf>)";
inline std::string lamp(const std::string& inside = "") { return R"(<emitter type="point" id="lamp"><point name="position" y="3"/>)" + inside + "</emitter>"; }

}  // namespace tyndall::test

#include "scene/transforms.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/properties.hpp"
#include "scene/text.hpp"

namespace tyndall {

namespace {

double real_attribute(const XmlElement& element, std::string_view name, std::string_view text)
{
    const auto value = parse_real(text);
    if (!value) refuse(element.where, fmt::format("<{}> {} = {} is not a finite number", element.tag, name, in_quotes(text)));
    return *value;
}

std::vector<double> list_attribute(const XmlElement& element, std::string_view name)
{
    std::vector<double> numbers;
    const std::string text = element.value_of(name);
    for (const std::string_view piece : split_list(text)) numbers.push_back(real_attribute(element, name, piece));
    return numbers;
}

Vec3 vector_attribute(const XmlElement& element, std::string_view name)
{
    const auto numbers = list_attribute(element, name);
    if (numbers.size() != 3)
        refuse(element.where, fmt::format("<{}> {} = {} must be three numbers", element.tag, name, in_quotes(element.value_of(name))));
    return {numbers[0], numbers[1], numbers[2]};
}

Mat4 read_rotate(const XmlElement& element)
{
    require_known_attributes(element, {"x", "y", "z", "value", "angle"});
    const std::string* angle = element.find("angle");
    if (!angle) refuse(element.where, "<rotate> needs the attribute \"angle\", in degrees");
    const Vec3 axis = read_vector(element, 0);
    if (axis == Vec3(0)) refuse(element.where, "<rotate> about an axis of length zero; give x, y or z");
    return rotation(axis, real_attribute(element, "angle", *angle));
}

Mat4 read_look_at(const XmlElement& element)
{
    require_known_attributes(element, {"origin", "target", "up"});
    for (const char* name : {"origin", "target"})
        if (!element.find(name)) refuse(element.where, fmt::format("<lookat> needs the attribute \"{}\"", name));
    const Vec3 up = element.find("up") ? vector_attribute(element, "up") : Vec3(0);
    return look_at(vector_attribute(element, "origin"), vector_attribute(element, "target"), up, element.where);
}

Mat4 read_matrix(const XmlElement& element)
{
    require_known_attributes(element, {"value"});
    const auto numbers = list_attribute(element, "value");
    if (numbers.size() != 16 && numbers.size() != 9)
        refuse(element.where, fmt::format("<matrix> has {} numbers; it takes 16, or 9, row by row", numbers.size()));
    const int size = numbers.size() == 16 ? 4 : 3;
    Mat4 matrix(1);
    auto number = numbers.begin();
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) matrix[column][row] = *number++;
    if (matrix[0][3] != 0 || matrix[1][3] != 0 || matrix[2][3] != 0 || matrix[3][3] != 1)
        refuse(element.where, "<matrix> must end in the row 0 0 0 1");
    return matrix;
}

Mat4 read_step(const XmlElement& element)
{
    if (!element.children.empty()) refuse(element.children[0].where, fmt::format("<{}> has nothing inside", printable(element.tag)));
    if (element.tag == "rotate") return read_rotate(element);
    if (element.tag == "lookat") return read_look_at(element);
    if (element.tag == "matrix") return read_matrix(element);
    if (element.tag == "translate" || element.tag == "scale") {
        require_known_attributes(element, {"x", "y", "z", "value"});
        return element.tag == "scale" ? scaling(read_vector(element, 1)) : translation(read_vector(element, 0));
    }
    const std::vector<std::string> known{"translate", "rotate", "scale", "lookat", "matrix"};
    refuse(element.where, fmt::format("<{}> is no step of a <transform>{}; steps are: {}", printable(element.tag),
                                      suggestion(element.tag, known), join(known)));
}

/// A direction across `d`, chosen as Mitsuba does, so that a lookat without up is the same image [Duff et al., "Building an Orthonormal
/// Basis, Revisited", JCGT 2017].
Vec3 some_perpendicular(const Vec3& d)
{
    const double sign = std::copysign(1.0, d.z), a = -1 / (sign + d.z);
    return {1 + sign * a * d.x * d.x, sign * a * d.x * d.y, -sign * d.x};
}

}  // namespace

Vec3 read_vector(const XmlElement& element, double fallback)
{
    if (element.find("value")) {
        if (element.find("x") || element.find("y") || element.find("z"))
            refuse(element.where, fmt::format("<{}> has both \"value\" and x, y, z; give one", printable(element.tag)));
        const auto numbers = list_attribute(element, "value");
        if (numbers.size() == 1) return Vec3(numbers[0]);
        return vector_attribute(element, "value");
    }
    Vec3 result(fallback);
    for (int axis = 0; axis < 3; ++axis) {
        const std::string name(1, "xyz"[axis]);
        if (const std::string* text = element.find(name)) result[axis] = real_attribute(element, name, *text);
    }
    return result;
}

Mat4 look_at(const Vec3& origin, const Vec3& target, const Vec3& given_up, const SourceLocation& where)
{
    const Vec3 towards = target - origin;
    if (towards == Vec3(0)) refuse(where, "<lookat> has the same origin and target");
    const Vec3 forward = glm::normalize(towards);
    const Vec3 up = given_up == Vec3(0) ? some_perpendicular(forward) : glm::normalize(given_up);
    const Vec3 across = glm::cross(up, forward);
    // 1e-9: below it the direction is the rounding error of its inputs.
    if (!(glm::length(across) > 1e-9)) refuse(where, "<lookat> looks along its up vector; choose another up");
    const Vec3 left = glm::normalize(across);
    return Mat4(glm::dvec4(left, 0), glm::dvec4(glm::cross(forward, left), 0), glm::dvec4(forward, 0), glm::dvec4(origin, 1));
}

Mat4 rotation(const Vec3& axis, double degrees)
{
    // Quarter turns are exact: sin and cos of multiples of 90 degrees are, and boxes stay boxes.
    const double turn = std::remainder(degrees, 360.0), radians = turn * (std::numbers::pi / 180);
    const bool quarter = std::remainder(turn, 90.0) == 0;
    const double s = quarter ? std::round(std::sin(radians)) : std::sin(radians),
                 c = quarter ? std::round(std::cos(radians)) : std::cos(radians);
    const Vec3 u = glm::normalize(axis);
    const glm::dmat3 outer = glm::outerProduct(u, u), cross(0, u.z, -u.y, -u.z, 0, u.x, u.y, -u.x, 0);
    return Mat4(c * glm::dmat3(1) + (1 - c) * outer + s * cross);
}

Mat4 translation(const Vec3& by)
{
    Mat4 matrix(1);
    matrix[3] = glm::dvec4(by, 1);
    return matrix;
}

Mat4 scaling(const Vec3& by) { return Mat4(glm::dmat3(by.x, 0, 0, 0, by.y, 0, 0, 0, by.z)); }

Mat4 read_transform(const XmlElement& element)
{
    require_known_attributes(element, {"name"});
    Mat4 result(1);
    for (const XmlElement& step : element.children) result = read_step(step) * result;
    double product = 1;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(result[column][row]) <= largest_coordinate))
                refuse(element.where, fmt::format("<transform> leads beyond {:g}", largest_coordinate));
        if (column < 3) product *= glm::length(Vec3(result[column]));
    }
    // 1e-12: the volume of the unit cube's image against its edges; below it the image is flat within rounding.
    if (!(std::abs(glm::determinant(glm::dmat3(result))) > 1e-12 * product))
        refuse(element.where, "<transform> flattens space (a scale of 0?); it must have an inverse");
    return result;
}

}  // namespace tyndall

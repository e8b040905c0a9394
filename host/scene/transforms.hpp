#pragma once
/// <transform>: translate, rotate, scale, lookat and matrix, the first listed applied first.
#include "scene/xml_element.hpp"

namespace tyndall {

/// The product of a <transform>'s steps. Throws SceneError for anything else inside and for a transform that has no inverse.
Mat4 read_transform(const XmlElement& element);

/// x, y, z attributes (missing ones are `fallback`), or value="1 2 3", or value="2" for all three.
Vec3 read_vector(const XmlElement& element, double fallback);

/// Camera-to-world of Mitsuba's lookat: local +z towards the target, +x to the left of the image, +y up.
/// `up` zero picks a direction that suits. The three must not lie on a line.
Mat4 look_at(const Vec3& origin, const Vec3& target, const Vec3& up, const SourceLocation& where);

/// Rotation by `degrees` about an axis of any length but zero, counter-clockwise when the axis points at the viewer.
Mat4 rotation(const Vec3& axis, double degrees);

Mat4 translation(const Vec3& by);
Mat4 scaling(const Vec3& by);

/// Coordinates beyond this are refused: their squares must stay finite.
inline constexpr double largest_coordinate = 1e100;

/// The point moved.
inline Vec3 transform_point(const Mat4& m, const Vec3& p) { return Vec3(m * glm::dvec4(p, 1)); }
/// The direction turned (and stretched).
inline Vec3 transform_direction(const Mat4& m, const Vec3& d) { return glm::dmat3(m) * d; }

}  // namespace tyndall

#pragma once
/// Boundaries of media that are simple enough for a kernel: disjoint convex polyhedra. And what can stand between two points.
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall {

/// The half-space dot(normal, x) <= offset; normal has unit length and points outwards.
struct HalfSpace {
    Vec3 normal;
    double offset;
};

/// A convex polyhedron filled with a medium, vacuum outside.
struct Container {
    int medium, shape;
    std::vector<HalfSpace> planes;
};

struct ContainerSearch {
    std::vector<Container> containers;  ///< of every shape that bounds a medium; empty if `obstacle` is not
    std::string obstacle;               ///< why they are not disjoint convex polyhedra in vacuum; empty if they are
    SourceLocation where;               ///< of the obstacle
    bool convex() const { return obstacle.empty(); }
};

/// The boundaries of media as disjoint convex polyhedra in vacuum, consistent with the media of camera and emitters, or the first reason why they are not.
ContainerSearch find_containers(const Scene& scene);

/// A boundary without a surface: light goes straight on.
bool is_null(const Scene& scene, const Shape& shape);

/// True if the boxes share more than `slack` in every axis.
bool boxes_overlap(const Bounds& a, const Bounds& b, double slack);

/// A surface that cannot stand between two points on the scene's shapes or inside its containers: flat, with all shapes on one side of it.
/// (Not so in a medium without bounds: there, points exist beyond every wall's edge.)
bool flat_and_outermost(const Scene& scene, const Shape& shape);

}  // namespace tyndall

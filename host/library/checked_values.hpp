#pragma once
/// Numbers from callers: checked, with a message that names the element.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "scene/transforms.hpp"
#include "tyndall/error.hpp"
#include "tyndall/scene_description.hpp"

namespace tyndall {

/// An element of a description, for messages. Every function throws SceneError "scene: element: what is wrong".
class Place {
public:
    Place(std::string scene, std::string element) : scene_(std::move(scene)), element_(std::move(element)) {}
    std::string name() const { return scene_ + ": " + element_; }

    void require(bool holds, const std::string& sentence) const
    {
        if (!holds) throw SceneError(name() + ": " + sentence);
    }

    /// In [low, high]; `open`: strictly between.
    double number(const char* what, double value, double low, double high, bool open = false) const
    {
        const bool inside = open ? value > low && value < high : value >= low && value <= high;
        require(inside, fmt::format("{} = {} must lie {} {} and {}", what, value, open ? "strictly between" : "between", low, high));
        return value;
    }

    /// Channels in [0, most].
    Rgb colour(const char* what, const api::Triple& c, double most) const { return {number(what, c[0], 0, most), number(what, c[1], 0, most), number(what, c[2], 0, most)}; }

    Vec3 point(const char* what, const api::Triple& p) const
    {
        for (const double x : p) number(what, x, -largest_coordinate, largest_coordinate);
        return {p[0], p[1], p[2]};
    }

    Vec3 direction(const char* what, const api::Triple& d) const
    {
        const Vec3 v = point(what, d);
        require(glm::length(v) > 0, fmt::format("{} has length zero", what));
        return glm::normalize(v);
    }

    /// first ... count - 1.
    int index(const char* what, int value, std::size_t count, int first) const
    {
        require(value >= first && value < static_cast<int>(count), fmt::format("{} = {} is not the index of one; there are {}", what, value, count));
        return value;
    }

private:
    std::string scene_, element_;
};

}  // namespace tyndall

#include "library/backend_records.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene/transforms.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

float f(double x) { return static_cast<float>(x); }
Vec3 vec(const api::Float3& v) { return {v[0], v[1], v[2]}; }

/// Checks one record after the other.
class Check {
public:
    Check(const char* kind, const BackendSpace& space, std::size_t media) : kind_(kind), space_(space), media_(media) {}
    void next() { ++index_; }

    void require(bool holds, const std::string& what) const
    {
        if (!holds) throw UsageError(fmt::format("{} {}: {}", kind_, index_, what));
    }

    /// In the box, or outside of it by no more than rounding; in render space.
    Vec3 place(const api::Float3& from) const
    {
        const Vec3 p = vec(from), slack(1e-5 * space_.unit);  // floats of places as large as the box
        require(glm::all(glm::greaterThanEqual(p, space_.low - slack)) && glm::all(glm::lessThanEqual(p, space_.high + slack)),
                fmt::format("({}, {}, {}) is not in the box from ({}, {}, {}) to ({}, {}, {})", p.x, p.y, p.z, space_.low.x, space_.low.y, space_.low.z, space_.high.x, space_.high.y, space_.high.z));
        return space_.to_render(p);
    }

    Vec3 unit(const api::Float3& from) const
    {
        const Vec3 d = vec(from);
        require(std::abs(glm::dot(d, d) - 1) <= 1e-3, fmt::format("the direction ({}, {}, {}) is not a unit vector", d.x, d.y, d.z));  // what single precision leaves of one
        return glm::normalize(d);
    }

    double length(float from, const api::Float3& origin, const api::Float3& direction) const
    {
        require(std::isfinite(from) && from >= 0, fmt::format("the length {} is not a finite number >= 0", from));
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const double end = double(origin[a]) + double(from) * direction[a], slack = 1e-4 * space_.unit;
            require(end >= space_.low[axis] - slack && end <= space_.high[axis] + slack, fmt::format("its end, at length {}, is not in the box", from));
        }
        return from / space_.unit;
    }

    Rgb colour(const api::Float3& from) const
    {
        const Rgb c = vec(from);
        require(std::isfinite(c.r + c.g + c.b) && c.r >= 0 && c.g >= 0 && c.b >= 0, fmt::format("({}, {}, {}) are not three finite numbers >= 0", c.r, c.g, c.b));
        return c;
    }

    int medium(std::uint32_t index) const
    {
        require(index < media_, fmt::format("medium {} of {}", index, media_));
        return static_cast<int>(index);
    }

private:
    const char* kind_;
    const BackendSpace& space_;
    std::size_t media_, index_ = 0;
};

void deposit(Method method, const LightPathSegment& segment, std::vector<std::byte>& records)
{
    const LightTechnique& technique = *technique_of(method);
    const std::size_t before = records.size();
    technique.deposit(segment, records);
    records.resize(before + technique.record_bytes);  // a light without power leaves nothing by itself: numbers stay those of the caller
}

}  // namespace

BackendSpace::BackendSpace(const api::Triple& from, const api::Triple& to) : low(from[0], from[1], from[2]), high(to[0], to[1], to[2])
{
    for (int axis = 0; axis < 3; ++axis)
        if (!(low[axis] <= high[axis] && low[axis] >= -largest_coordinate && high[axis] <= largest_coordinate))
            throw UsageError("the box that holds everything: low must not lie above high, and both must be finite");
    const double radius = .5 * glm::length(high - low);
    if (!(radius >= 1 / largest_coordinate)) throw UsageError("the box that holds everything has no extent");
    int exponent = 0;
    const double mantissa = std::frexp(radius, &exponent);
    centre = .5 * (low + high), unit = std::ldexp(1.0, mantissa == .5 ? exponent - 1 : exponent);
}

api::Triple BackendSpace::from_render(const Vec3& p) const
{
    const Vec3 q = centre + unit * p;
    return {q.x, q.y, q.z};
}

std::vector<std::byte> light_records(std::span<const api::RayLight> lights, const BackendSpace& space, std::size_t media)
{
    std::vector<std::byte> records;
    Check check("ray light", space, media);
    for (const api::RayLight& l : lights) {
        deposit(Method::vrl, {.origin = check.place(l.origin), .direction = check.unit(l.direction), .length = check.length(l.length, l.origin, l.direction), .medium = check.medium(l.medium),
                              .flux = check.colour(l.flux) / space.unit / space.unit, .depth = 0, .is_short = false, .channel = Rgb(0), .collision = -1, .radius = 0, .scattered = Rgb(0)},
                records);
        check.next();
    }
    return records;
}

std::vector<std::byte> light_records(std::span<const api::PointLight> lights, const BackendSpace& space, std::size_t media)
{
    std::vector<std::byte> records;
    Check check("point light", space, media);
    for (const api::PointLight& l : lights) {
        deposit(Method("vpl"), {.origin = check.place(l.position), .direction = check.unit(l.direction), .length = 0, .medium = check.medium(l.medium), .flux = Rgb(0), .depth = 0, .is_short = false,
                                .channel = Rgb(0), .collision = 0, .radius = 0, .scattered = check.colour(l.power) / space.unit / space.unit},
                records);
        check.next();
    }
    return records;
}

std::vector<EyeSegment> eye_records(std::span<const api::EyeSegment> eyes, const BackendSpace& space, std::size_t media)
{
    std::vector<EyeSegment> records;
    records.reserve(eyes.size());
    Check check("eye segment", space, media);
    for (const api::EyeSegment& e : eyes) {
        const Vec3 o = check.place(e.origin), d = check.unit(e.direction);
        const Rgb t = check.colour(e.throughput);
        records.push_back({f(o.x), f(o.y), f(o.z), f(check.length(e.length, e.origin, e.direction)), f(d.x), f(d.y), f(d.z), static_cast<uint>(check.medium(e.medium)), f(t.r), f(t.g), f(t.b), 0,
                           static_cast<uint>(records.size()), 0, 0, 0});
        check.next();
    }
    return records;
}

std::vector<EyePoint> eye_records(std::span<const api::EyePoint> eyes, const BackendSpace& space, std::size_t media)
{
    std::vector<EyePoint> records;
    records.reserve(eyes.size());
    Check check("eye point", space, media);
    for (const api::EyePoint& e : eyes) {
        const Vec3 p = check.place(e.position), n = check.unit(e.normal), g = check.unit(e.facing);
        const Rgb t = check.colour(e.throughput);
        const uint medium = e.medium == api::no_medium ? NO_MEDIUM : static_cast<uint>(check.medium(e.medium));
        records.push_back({f(p.x), f(p.y), f(p.z), medium, f(n.x), f(n.y), f(n.z), 0, f(t.r), f(t.g), f(t.b), static_cast<uint>(records.size()), f(g.x), f(g.y), f(g.z), 0});
        check.next();
    }
    return records;
}

}  // namespace tyndall

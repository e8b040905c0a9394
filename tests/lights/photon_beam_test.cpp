/// The light contract for photon beams: what an eye segment takes from a beam, added up over all places where the beam could be, is what quadrature says that shares no code with kernels/, at wide
/// and narrow angles; float agrees with double; hard cases are finite and bounded; and the blur's bias falls as section 19 of kernels/README.md predicts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "lights/progressive_radius.hpp"
#include "tests/lights/host_maths.hpp"

namespace tyndall {
namespace maths_float {
#include "kernels/lights/photon_beam.h"
}
#undef PHOTON_BEAM_H
namespace maths_double {
#include "kernels/lights/photon_beam.h"
}
namespace {

using glm::dvec3;
using plain::Pair;

template <typename Beam>
Beam beam_of(const Pair& p, double radius)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    return {{f(p.p.x), f(p.p.y), f(p.p.z), f(p.light_length), f(p.b.x), f(p.b.y), f(p.b.z), 0, f(p.flux.x), f(p.flux.y), f(p.flux.z), 0, f(p.share.x), f(p.share.y), f(p.share.z), p.is_short ? 1u : 0u},
            f(radius), 0, 0, 0};
}

MediumRecord medium_of(const Pair& p)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(p.sigma_t.x), f(p.sigma_t.y), f(p.sigma_t.z), f(p.g), f(p.sigma_s.x), f(p.sigma_s.y), f(p.sigma_s.z), 0, 0, NO_GRID, NO_GRID, 0};
}

/// What the segment takes from the beam, by the kernels' functions.
dvec3 taken(const Pair& p, double radius, double xi)
{
    using namespace maths_double;
    const EyeSegmentLanes eye{{p.o.x, p.o.y, p.o.z}, {p.a.x, p.a.y, p.a.z}, {1, 1, 1}, p.eye_length};
    const PhotonBeam beam = beam_of<PhotonBeam>(p, radius);
    // The record is in float; the meeting of this test is in double, so that places may lie as closely as it likes.
    const MediumRecord medium = medium_of(p);
    const MediumLanes lanes{{p.sigma_t.x, p.sigma_t.y, p.sigma_t.z}, {p.sigma_s.x, p.sigma_s.y, p.sigma_s.z}, p.g, {1, 0, 0, {phase_range(medium)}}};
    const Meeting at = meet_beam({p.p.x - p.o.x, p.p.y - p.o.y, p.p.z - p.o.z}, eye.direction, eye.length, {p.b.x, p.b.y, p.b.z}, p.light_length, radius, fading_beside(eye, lanes, beam, medium), xi);
    const real3 r = gather_on_segment(eye, lanes, beam, medium, {nullptr, nullptr}, at, even_matter(at.u), even_matter(at.v));
    return {r.x, r.y, r.z};
}
dvec3 taken_in_float(const Pair& p, double radius, double xi)
{
    using namespace maths_float;
    const auto v = [](const dvec3& x) { return real3{float(x.x), float(x.y), float(x.z)}; };
    const EyeSegmentLanes eye{v(p.o), v(p.a), {1, 1, 1}, float(p.eye_length)};
    const PhotonBeam beam = beam_of<PhotonBeam>(p, radius);
    const MediumRecord medium = medium_of(p);
    const MediumLanes lanes{v(p.sigma_t), v(p.sigma_s), float(p.g), {1, 0, 0, {phase_range(medium)}}};
    const Meeting at = meet_segment(eye, lanes, beam, medium, float(xi));
    const real3 r = gather_on_segment(eye, lanes, beam, medium, {nullptr, nullptr}, at, even_matter(at.u), even_matter(at.v));
    return {r.x, r.y, r.z};
}

double textbook_phase(double g, double mu) { return (1 - g * g) / (4 * M_PI * std::pow(1 + g * g - 2 * g * mu, 1.5)); }

/// What all parallel copies of the beam together send along the eye segment, without any blur: copies lie at every offset across the beam, one per unit of area. Each point of the segment that lies
/// between the planes of the beams' ends is lit by one of them.
dvec3 of_all_offsets(const Pair& p)
{
    const int n = 200000;
    dvec3 sum(0);
    const double phase = textbook_phase(p.g, glm::dot(p.b, -p.a));
    for (int i = 0; i < n; ++i) {
        const double u = (i + .5) / n * p.eye_length, v = glm::dot(p.o + u * p.a - p.p, p.b);
        if (v < 0 || v > p.light_length) continue;
        dvec3 along = glm::exp(-p.sigma_t * v);
        if (p.is_short) along /= glm::dot(p.share, along);
        sum += p.flux * p.sigma_s * phase * along * glm::exp(-p.sigma_t * u);
    }
    return sum * p.eye_length / double(n);
}

/// The same by the kernels: the sum over a grid of offsets across the beam that covers all that meet the segment.
dvec3 sum_of_offsets(const Pair& p, double radius, int n)
{
    const dvec3 any = std::abs(p.b.x) < .6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), e = glm::normalize(glm::cross(p.b, any)), f = glm::cross(p.b, e);
    const dvec3 ends[] = {p.o - p.p, p.o + p.eye_length * p.a - p.p};
    const double low_e = std::min(glm::dot(ends[0], e), glm::dot(ends[1], e)) - radius, high_e = std::max(glm::dot(ends[0], e), glm::dot(ends[1], e)) + radius;
    const double low_f = std::min(glm::dot(ends[0], f), glm::dot(ends[1], f)) - radius, high_f = std::max(glm::dot(ends[0], f), glm::dot(ends[1], f)) + radius;
    dvec3 sum(0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            Pair moved = p;
            moved.p += (low_e + (i + .5) / n * (high_e - low_e)) * e + (low_f + (j + .5) / n * (high_f - low_f)) * f;
            sum += taken(moved, radius, std::fmod((i * 1. + j * .6180339887498949), 1.));
        }
    return sum * (high_e - low_e) * (high_f - low_f) / double(n) / double(n);
}

/// The beam turned to an angle with the eye segment, about the beam's middle, which is put at the segment's.
Pair at_angle(std::mt19937& engine, double g, bool is_short, double angle, bool against)
{
    Pair p = plain::random_pair(engine, g, is_short);
    const dvec3 any = std::abs(p.a.x) < .6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), side = glm::normalize(glm::cross(p.a, any));
    p.b = glm::normalize((against ? -1. : 1.) * std::cos(angle) * p.a + std::sin(angle) * side);
    p.p = p.o + .4 * p.eye_length * p.a - .45 * p.light_length * p.b;
    return p;
}

TEST(PhotonBeam, AddsUpToTheLightOfAllItsOffsetsAtEveryAngle)
{
    std::mt19937 engine(21);
    for (const double angle : {1.5, .8, .3, .1, .02, 1e-4, 0.})
        for (const bool against : {false, true})
            for (const double radius : {.3, .05}) {
                const Pair p = at_angle(engine, against ? .5 : -.3, radius > .1, angle, against);
                const dvec3 right = of_all_offsets(p), ours = sum_of_offsets(p, radius, 700);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(ours[c] / right[c], 1, 6e-3) << "angle " << angle << " radius " << radius << " against " << against << " channel " << c;  // the ends of the pair cut cells of the grid
            }
}

TEST(PhotonBeam, APlantedErrorOfTheToleranceIsSeen)
{
    std::mt19937 engine(21);
    Pair p = at_angle(engine, .5, false, .8, false);
    const double right = of_all_offsets(p).x;
    p.g = .52;
    EXPECT_GT(std::abs(sum_of_offsets(p, .3, 700).x / right - 1), 6e-3);
}

TEST(PhotonBeam, GivesNothingBeyondItsRadiusNorBeyondItsEnds)
{
    Pair p{.o = {}, .a = {1, 0, 0}, .p = {.5, -.5, 0}, .b = {0, 1, 0}, .eye_length = 1, .light_length = 1, .g = 0, .sigma_t = dvec3(0), .sigma_s = dvec3(1), .flux = dvec3(1)};
    const double on_axis = .75 / .1 / (4 * M_PI);
    EXPECT_NEAR(taken(p, .1, .5).x, on_axis, 1e-6 * on_axis);
    p.p.z = .05;
    EXPECT_NEAR(taken(p, .1, .5).x, on_axis * .75, 1e-6 * on_axis);
    p.p.z = .1001;
    EXPECT_EQ(taken(p, .1, .5).x, 0);
    p.p.z = 0;
    for (const double x : {-.01, 1.01}) {  // the eye segment ends inside the radius, but not on it
        p.p.x = x;
        EXPECT_EQ(taken(p, .1, .5).x, 0) << x;
    }
    p.p.x = .5;
    for (const double y : {.01, -1.01}) {  // and so does the beam
        p.p.y = y;
        EXPECT_EQ(taken(p, .1, .5).x, 0) << y;
    }
    p.p.y = 0;
    EXPECT_GT(taken(p, .1, .5).x, 0) << "it begins on the eye segment";
}

TEST(PhotonBeam, FloatAgreesWithDouble)
{
    std::mt19937 engine(23);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> errors;
    for (int i = 0; i < 200000; ++i) {
        Pair p = at_angle(engine, i % 2 ? .55 : 0, i % 3 == 0, std::pow(10, -4 * uniform(engine)), i % 5 == 0);
        const double radius = static_cast<float>(std::pow(10, -1 - 2 * uniform(engine)));
        p.p += radius * (dvec3(uniform(engine), uniform(engine), uniform(engine)) - .5);
        p = plain::as_float(p);
        const double xi = std::floor(uniform(engine) * 0x1p24) * 0x1p-24;
        const dvec3 f = taken_in_float(p, radius, xi), d = taken(p, radius, xi);
        ASSERT_TRUE(std::isfinite(f.x + f.y + f.z)) << "pair " << i;
        if (d.x > 0 || f.x > 0) errors.push_back(glm::length(f - d) / std::max(glm::length(d), glm::length(f)));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_GT(errors.size(), 50000u);
    EXPECT_LT(errors[errors.size() / 2], 2e-6);
    // Near the edge of the kernel the distance's rounding, some epsilon of the scene, is divided by the radius; the share of pairs that notice falls with it.
    EXPECT_LT(errors[errors.size() * 99 / 100], 1e-2);
}

TEST(PhotonBeam, HardCasesAreFiniteAndBounded)
{
    Pair p{.o = {.1, .2, .3}, .a = {1, 0, 0}, .p = {}, .b = {}, .eye_length = 1, .light_length = 1, .g = .9, .sigma_t = dvec3(1, 2, 3), .sigma_s = dvec3(1), .flux = dvec3(1)};
    const double peak = textbook_phase(.9, 1);
    for (const double radius : {.1, 1e-3, 1e-6})
        for (const double length : {0., 1e-7, .5, 1e4, 1e30})
            for (const double eye_length : {1e-7, 1., 1e30})
                for (const double angle : {0., 1e-12, 1e-7, 1e-4, radius, .4, .6, M_PI / 2, M_PI - 1e-7, M_PI})
                    for (const double offset : {0., 1e-9, .5 * radius}) {
                        p.b = {std::cos(angle), std::sin(angle), 0}, p.light_length = length, p.eye_length = eye_length;
                        p.p = p.o + dvec3(.3, 0, offset);
                        for (const double xi : {0., .5, 1 - 0x1p-24}) {
                            const dvec3 f = taken_in_float(p, radius, xi), d = taken(p, radius, xi);
                            const double shorter = std::min(eye_length, length), bound = peak * std::max(.75 / radius * std::max(shorter / radius, 2.), 1.16 * shorter * 2 / (M_PI * radius * radius));
                            for (const dvec3& x : {f, d}) {
                                ASSERT_TRUE(std::isfinite(x.x + x.y + x.z)) << radius << " " << length << " " << eye_length << " " << angle << " " << offset;
                                ASSERT_GE(std::min({x.x, x.y, x.z}), 0);
                                ASSERT_LE(x.x, 1.001 * bound) << radius << " " << length << " " << eye_length << " " << angle << " " << offset;
                            }
                        }
                    }
}

/// Bias of a sheet of parallel beams whose density across the eye is e^(-x^2 / 2): in closed form the blur's second moment, r^2 / 5, times half the second derivative.
TEST(PhotonBeam, BiasFallsWithTheSquareOfTheRadius)
{
    Pair p{.o = {-.5, 0, 0}, .a = {1, 0, 0}, .p = {}, .b = {0, 1, 0}, .eye_length = 1, .light_length = 2, .g = 0, .sigma_t = dvec3(0), .sigma_s = dvec3(4 * M_PI), .flux = dvec3(1)};
    std::vector<double> biases;
    for (const double radius : {.4, .2, .1}) {
        const int n = 4000;
        double sum = 0;
        for (int i = 0; i < n; ++i) {
            p.p = {0, -1, radius * (2 * (i + .5) / n - 1)};
            sum += std::exp(-.5 * p.p.z * p.p.z) * taken(p, radius, .5).x * 2 * radius / n;
        }
        biases.push_back(sum - 1);  // at the middle the density is 1
        EXPECT_NEAR(biases.back() / (-.1 * radius * radius), 1, .02 + .2 * radius * radius) << radius;
    }
    EXPECT_NEAR(std::log2(biases[0] / biases[2]) / 2, 2, .03);
}

}  // namespace
}  // namespace tyndall

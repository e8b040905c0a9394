#include "transport/phase_function.hpp"

#include "transport/frame.hpp"
#include "transport/warp.hpp"

namespace tyndall {
namespace {

/// Inverse of the distribution of mu. With s = 2 xi - 1 the textbook's (1 + g^2 - ((1 - g^2) / (1 + g s))^2) / 2g has a factor g in its
/// numerator; divided out, nothing cancels at g = 0.
double henyey_greenstein_cosine(double g, double xi)
{
    const double s = 2 * xi - 1, k = 1 + g * s, h = 1 + g * g;
    return (s * h + .5 * g * (3 + s * s * h - g * g)) / (k * k);
}

}  // namespace

double evaluate_phase(const PhaseFunction& phase, const Vec3& in, const Vec3& out)
{
    if (phase.type == PhaseFunction::Type::isotropic) return pdf_uniform_sphere;
    const double g = std::abs(phase.g);
    const Vec3 apart = phase.g < 0 ? in + out : in - out;
    const double base = (1 - g) * (1 - g) + g * glm::dot(apart, apart);
    return pdf_uniform_sphere * (1 - g) * (1 + g) / (base * std::sqrt(base));
}

PhaseSample sample_phase(const PhaseFunction& phase, const Vec3& in, const Vec2& xi)
{
    if (phase.type == PhaseFunction::Type::isotropic) return {.direction = sample_uniform_sphere(xi), .pdf = pdf_uniform_sphere};
    const Vec3 direction = Frame(in).to_world(spherical(henyey_greenstein_cosine(phase.g, xi.x), xi.y));
    return {.direction = direction, .pdf = evaluate_phase(phase, in, direction)};
}

}  // namespace tyndall

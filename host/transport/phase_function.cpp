#include "transport/phase_function.hpp"

#include <algorithm>
#include <cmath>

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

/// Real root of mu^3 + 3 mu = 8 xi - 4: with mu = 2 sinh t the left side is 2 sinh 3t, so that nothing cancels, unlike in Cardano's formula.
double rayleigh_cosine(double xi) { return 2 * std::sinh(std::asinh(4 * xi - 2) / 3); }

/// Position of mu in the table, in steps from -1.
struct TablePlace {
    std::size_t step;
    double offset;  ///< in [0, 1]
};
TablePlace place_in_table(const PhaseFunction& table, double mu)
{
    const std::size_t steps = table.values.size() - 1;
    const double position = std::clamp(.5 * (mu + 1), 0.0, 1.0) * double(steps);
    const std::size_t step = std::min(static_cast<std::size_t>(position), steps - 1);
    return {step, position - double(step)};
}

/// The step by its probability; within it the density is linear, f0 to f1, and the root of its quadratic distribution is
/// xi (f0 + f1) / (f0 + sqrt((1 - xi) f0^2 + xi f1^2)), a sum of positive numbers.
double table_cosine(const PhaseFunction& table, double xi)
{
    const auto& c = table.cumulative;
    const std::size_t above = static_cast<std::size_t>(std::upper_bound(c.begin(), c.end(), xi) - c.begin());  // the first that is larger: its step is not empty
    const std::size_t step = std::min(above, c.size() - 1) - 1;
    const double within = rescale(xi, c[step], c[step + 1]), f0 = table.values[step], f1 = table.values[step + 1];
    const double root = std::sqrt((1 - within) * f0 * f0 + within * f1 * f1);
    const double offset = f0 + root > 0 ? within * (f0 + f1) / (f0 + root) : 0;
    return -1 + 2 * (double(step) + offset) / double(c.size() - 1);
}

double cosine_of(const PhaseFunction& phase, double xi)
{
    switch (phase.type) {
        case PhaseFunction::Type::henyey_greenstein: return henyey_greenstein_cosine(phase.g, xi);
        case PhaseFunction::Type::rayleigh: return rayleigh_cosine(xi);
        case PhaseFunction::Type::table: return table_cosine(phase, xi);
        case PhaseFunction::Type::isotropic: return 1 - 2 * xi;
        case PhaseFunction::Type::blend: break;
    }
    for (const PhaseFunction& part : phase.parts) {
        if (xi < part.weight || &part == &phase.parts.back()) return cosine_of(part, rescale(xi, 0, part.weight));
        xi -= part.weight;
    }
    return 1;  // a blend has parts
}

double evaluate_henyey_greenstein(double mean_cosine, const Vec3& in, const Vec3& out)
{
    const double g = std::abs(mean_cosine);
    const Vec3 apart = mean_cosine < 0 ? in + out : in - out;
    const double base = (1 - g) * (1 - g) + g * glm::dot(apart, apart);
    return pdf_uniform_sphere * (1 - g) * (1 + g) / (base * std::sqrt(base));
}

double evaluate_table(const PhaseFunction& table, double mu)
{
    const TablePlace place = place_in_table(table, mu);
    return (1 - place.offset) * table.values[place.step] + place.offset * table.values[place.step + 1];
}

double evaluate_blend(const PhaseFunction& blend, const Vec3& in, const Vec3& out)
{
    double sum = 0;
    for (const PhaseFunction& part : blend.parts) sum += part.weight * evaluate_phase(part, in, out);
    return sum;
}

}  // namespace

double evaluate_phase(const PhaseFunction& phase, const Vec3& in, const Vec3& out)
{
    switch (phase.type) {
        case PhaseFunction::Type::isotropic: return pdf_uniform_sphere;
        case PhaseFunction::Type::henyey_greenstein: return evaluate_henyey_greenstein(phase.g, in, out);
        case PhaseFunction::Type::table: return evaluate_table(phase, glm::dot(in, out));
        case PhaseFunction::Type::blend: return evaluate_blend(phase, in, out);
        case PhaseFunction::Type::rayleigh: break;
    }
    const double mu = glm::dot(in, out);
    return .75 * pdf_uniform_sphere * (1 + mu * mu);
}

PhaseSample sample_phase(const PhaseFunction& phase, const Vec3& in, const Vec2& xi)
{
    if (phase.type == PhaseFunction::Type::isotropic) return {.direction = sample_uniform_sphere(xi), .pdf = pdf_uniform_sphere};
    const Vec3 direction = Frame(in).to_world(spherical(cosine_of(phase, xi.x), xi.y));
    return {.direction = direction, .pdf = evaluate_phase(phase, in, direction)};
}

}  // namespace tyndall

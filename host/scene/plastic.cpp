#include "scene/plastic.hpp"

#include <algorithm>

#include "scene/fresnel.hpp"
#include "scene/microfacet.hpp"

namespace tyndall {
namespace {

constexpr std::size_t table_size = 64;  ///< Mitsuba's, so that images agree
constexpr double lowest_cosine = 1e-6;  ///< of the table's first value: edge-on a facet's reflectance is a limit

double cosine_at(std::size_t i) { return std::max(lowest_cosine, double(i) / double(table_size - 1)); }

}  // namespace

void prepare_plastic(Bsdf& bsdf)
{
    bsdf.internal_reflectance = diffuse_fresnel(1 / bsdf.eta);
    bsdf.boundary_transmittance.clear();
    if (bsdf.type != Bsdf::Type::rough_plastic) return;
    double inside = 0;
    for (std::size_t i = 0; i < table_size; ++i) {
        bsdf.boundary_transmittance.push_back(1 - facet_reflectance(bsdf.roughness, cosine_at(i), bsdf.eta));
        inside += 2 * cosine_at(i) * facet_reflectance(bsdf.roughness, cosine_at(i), 1 / bsdf.eta) / double(table_size);
    }
    bsdf.internal_reflectance = inside;
}

double plastic_transmittance(const Bsdf& bsdf, double cosine)
{
    if (bsdf.type != Bsdf::Type::rough_plastic) return 1 - fresnel_dielectric(cosine, bsdf.eta);
    const double position = std::clamp(cosine, 0.0, 1.0) * double(table_size - 1);
    const std::size_t step = std::min(static_cast<std::size_t>(position), table_size - 2);
    const double offset = position - double(step);
    return (1 - offset) * bsdf.boundary_transmittance[step] + offset * bsdf.boundary_transmittance[step + 1];
}

}  // namespace tyndall

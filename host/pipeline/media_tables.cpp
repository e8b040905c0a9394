#include "pipeline/media_tables.hpp"

#include "scene/phases.hpp"
#include "volumes/grid_record.hpp"

namespace tyndall {
namespace {

float f(double x) { return static_cast<float>(x); }

/// Appends one lobe, with the values of a table.
void add_lobe(const PhaseFunction& phase, double weight, MediaTables& tables)
{
    PhaseLobeRecord lobe{.kind = PHASE_LOBE_HENYEY_GREENSTEIN, .weight = f(weight), .g = f(phase.g)};  // g = 0: isotropic, exactly
    if (phase.type == PhaseFunction::Type::rayleigh) lobe.kind = PHASE_LOBE_RAYLEIGH;
    if (phase.type == PhaseFunction::Type::table) {
        lobe.kind = PHASE_LOBE_TABLE, lobe.first_value = static_cast<uint>(tables.phase_values.size()), lobe.value_count = static_cast<uint>(phase.values.size());
        for (const double value : phase.values) tables.phase_values.push_back(f(value));
    }
    tables.lobes.push_back(lobe);
}

/// Appends the lobes of a phase function that has any, and says where they are.
void add_lobes(const PhaseFunction& phase, MediumRecord& medium, MediaTables& tables)
{
    if (!has_lobes(phase)) return;
    medium.first_lobe = static_cast<uint>(tables.lobes.size());
    if (phase.type == PhaseFunction::Type::blend)
        for (const PhaseFunction& part : phase.parts) add_lobe(part, part.weight, tables);
    else
        add_lobe(phase, 1, tables);
    medium.lobe_count = static_cast<uint>(tables.lobes.size()) - medium.first_lobe;
}

uint grid_index(int volume) { return volume == none ? NO_GRID : static_cast<uint>(volume); }

uint grid_colours(const Scene& scene, const Medium& medium)
{
    const auto coloured = [&](int volume) { return volume != none && scene.volumes[static_cast<std::size_t>(volume)].channels == 3; };
    return (coloured(medium.density) ? DENSITY_GRID_COLOURED : 0u) + (coloured(medium.albedo_volume) ? ALBEDO_GRID_COLOURED : 0u);
}

}  // namespace

MediaTables media_tables(const Scene& scene, const SceneFeatures& features)
{
    MediaTables tables;
    for (const Medium& m : scene.media) {
        const Rgb t = m.sigma_t, s = m.albedo_volume == none ? m.sigma_s() : t;
        tables.media.push_back({f(t.r), f(t.g), f(t.b), f(m.phase.g), f(s.r), f(s.g), f(s.b), 0, 0, grid_index(m.density), grid_index(m.albedo_volume), grid_colours(scene, m)});
        add_lobes(m.phase, tables.media.back(), tables);
    }
    tables.media.push_back({.density_grid = NO_GRID, .albedo_grid = NO_GRID});  // vacuum: what lights on surfaces may have in front of them
    for (const Container& container : features.containers) {
        tables.containers.push_back({static_cast<uint>(container.medium), static_cast<uint>(tables.planes.size()), static_cast<uint>(container.planes.size()), 0});
        for (const HalfSpace& p : container.planes) tables.planes.push_back({f(p.normal.x), f(p.normal.y), f(p.normal.z), f(p.offset)});
    }
    for (const Volume& volume : scene.volumes) {
        tables.grids.push_back(grid_record(volume, tables.voxels.size()));
        tables.voxels.insert(tables.voxels.end(), volume.values.begin(), volume.values.end());
    }
    return tables;
}

}  // namespace tyndall

#include "pipeline/media_tables.hpp"

#include "volumes/grid_record.hpp"

namespace tyndall {
namespace {

uint grid_index(int volume) { return volume == none ? NO_GRID : static_cast<uint>(volume); }

uint grid_colours(const Scene& scene, const Medium& medium)
{
    const auto coloured = [&](int volume) { return volume != none && scene.volumes[static_cast<std::size_t>(volume)].channels == 3; };
    return (coloured(medium.density) ? DENSITY_GRID_COLOURED : 0u) + (coloured(medium.albedo_volume) ? ALBEDO_GRID_COLOURED : 0u);
}

}  // namespace

MediaTables media_tables(const Scene& scene, const SceneFeatures& features)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    MediaTables tables;
    for (const Medium& m : scene.media) {
        const Rgb t = m.sigma_t, s = m.albedo_volume == none ? m.sigma_s() : t;
        tables.media.push_back({f(t.r), f(t.g), f(t.b), m.phase.type == PhaseFunction::Type::isotropic ? 0.0f : f(m.phase.g), f(s.r), f(s.g), f(s.b), 0, 0, grid_index(m.density), grid_index(m.albedo_volume), grid_colours(scene, m)});
    }
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

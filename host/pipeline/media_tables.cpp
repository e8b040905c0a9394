#include "pipeline/media_tables.hpp"

namespace tyndall {

MediaTables media_tables(const Scene& scene, const SceneFeatures& features)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    MediaTables tables;
    for (const Medium& m : scene.media) {
        const Rgb t = m.sigma_t, s = m.sigma_s();
        tables.media.push_back({f(t.r), f(t.g), f(t.b), m.phase.type == PhaseFunction::Type::isotropic ? 0.0f : f(m.phase.g), f(s.r), f(s.g), f(s.b), 0, 0, NO_GRID, NO_GRID, 0});
    }
    for (const Container& container : features.containers) {
        tables.containers.push_back({static_cast<uint>(container.medium), static_cast<uint>(tables.planes.size()), static_cast<uint>(container.planes.size()), 0});
        for (const HalfSpace& p : container.planes) tables.planes.push_back({f(p.normal.x), f(p.normal.y), f(p.normal.z), f(p.offset)});
    }
    return tables;
}

}  // namespace tyndall

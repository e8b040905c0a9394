#include "scene/scene_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "kernels/shared/host_features.hpp"
#include "scene/phases.hpp"
#include "scene/scene_effects.hpp"
#include "scene/text.hpp"

namespace tyndall {
namespace {

constexpr Layer connected_layers[] = {Layer::media_to_media, Layer::media_to_surface};

/// Notes why the kernels of a layer, or of both, need a feature. Only the first cause of each is kept.
class FeatureNotes {
public:
    void need(Layer layer, std::uint32_t bit, const Cause& cause)
    {
        const bool known = std::any_of(causes_.begin(), causes_.end(), [&](const FeatureCause& c) { return c.bit == bit && c.layer == layer; });
        if (!known) causes_.push_back({bit, layer, cause.sentence, cause.where});
    }
    void need(std::uint32_t bit, const Cause& cause)
    {
        for (const Layer layer : connected_layers) need(layer, bit, cause);
    }
    std::uint32_t mask(Layer layer) const
    {
        std::uint32_t mask = 0;
        for (const FeatureCause& c : causes_)
            if (c.layer == layer) mask |= c.bit;
        return mask;
    }
    std::vector<FeatureCause> causes() && { return std::move(causes_); }

private:
    std::vector<FeatureCause> causes_;
};

std::string title(const Medium& medium) { return "medium " + in_quotes(medium.name); }
std::string title(const Shape& shape) { return "shape " + in_quotes(shape.name); }

void note_volumes(const Scene& scene, const Medium& m, FeatureNotes& notes)
{
    for (const auto& [what, index] : {std::pair{"sigma_t", m.density}, std::pair{"albedo", m.albedo_volume}}) {
        if (index == none) continue;
        const Volume& volume = scene.volumes[static_cast<std::size_t>(index)];
        const Cause cause{fmt::format("{}: {} from the grid {}", title(m), what, in_quotes(volume.name)), volume.where};
        notes.need(feature_bit::heterogeneous, cause);
        if (index != m.density || volume.channels == 1) continue;
        notes.need(feature_bit::coloured_grids, cause);
        notes.need(feature_bit::coloured, cause);
    }
}

void note_media(const Scene& scene, FeatureNotes& notes)
{
    for (const Medium& m : scene.media) {
        const Cause scatters{fmt::format("{}: {}", title(m), phase_words(m.phase)), m.where};
        if (!scatters_evenly(m.phase)) notes.need(feature_bit::anisotropic, scatters);
        if (has_lobes(m.phase)) notes.need(feature_bit::phase_lobes, scatters);
        note_volumes(scene, m, notes);
        if (m.sigma_t.r != m.sigma_t.g || m.sigma_t.r != m.sigma_t.b)
            notes.need(feature_bit::coloured, {title(m) + ": sigma_t differs between channels", m.where});
    }
    if (scene.media.size() > 1)
        notes.need(feature_bit::many_media, {fmt::format("{} besides {}", title(scene.media[1]), title(scene.media[0])), scene.media[1].where});
}

void note_settings(bool short_lights, int max_depth, FeatureNotes& notes)
{
    if (short_lights) notes.need(feature_bit::short_lights, {"setting: short light segments", {}});
    if (max_depth >= 0) notes.need(feature_bit::depth_limit, {fmt::format("setting: max_depth = {}", max_depth), {}});
}

/// The first null shape that tells two media apart.
const Shape* first_null_boundary(const Scene& scene)
{
    const auto found = std::find_if(scene.shapes.begin(), scene.shapes.end(),
                                    [&](const Shape& s) { return s.medium_boundary && is_null(scene, s) && s.interior != s.exterior; });
    return found == scene.shapes.end() ? nullptr : &*found;
}

void note_boundaries(const Shape& boundary, const ContainerSearch& search, FeatureNotes& notes)
{
    const Cause crossing{title(boundary) + " bounds a medium", boundary.where};
    notes.need(Layer::media_to_surface, feature_bit::boundaries, crossing);
    if (!search.convex() || search.containers.size() > 1) notes.need(Layer::media_to_media, feature_bit::boundaries, crossing);
    if (search.convex()) return;
    notes.need(feature_bit::nonconvex_media, {search.obstacle, search.where});
    notes.need(feature_bit::occluders, {search.obstacle + ", and the host's walk answers both questions", search.where});
}

/// May the shape block a connection between two points of the containers (of all space without containers)?
bool occludes_within(const Scene& scene, const Shape& shape, const std::vector<Container>& containers)
{
    if (containers.empty()) return true;
    if (flat_and_outermost(scene, shape)) return false;
    if (containers.size() > 1) return true;
    return boxes_overlap(bounds_of(shape), bounds_of(scene.shapes[static_cast<std::size_t>(containers.front().shape)]), 1e-7);  // touching does not block
}

void note_occluders(const Scene& scene, const std::vector<Container>& containers, FeatureNotes& notes)
{
    for (const Shape& shape : scene.shapes) {
        if (is_null(scene, shape)) continue;
        const Cause cause{title(shape) + " may stand in between", shape.where};
        if (occludes_within(scene, shape, containers)) notes.need(Layer::media_to_media, feature_bit::occluders, cause);
        if (containers.empty() || !flat_and_outermost(scene, shape)) notes.need(Layer::media_to_surface, feature_bit::occluders, cause);
    }
}

/// Kernels for connections to lights on surfaces: the media's features, and where such lights stand: outside of media, behind anything, across any boundary.
void find_surface_masks(const Scene& scene, SceneFeatures& f)
{
    const bool bounded = std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const Shape& s) { return s.medium_boundary && s.interior != s.exterior; });
    std::uint32_t mask = f.mask() & ~(feature_bit::short_lights | feature_bit::occluders | feature_bit::boundaries | feature_bit::nonconvex_media);
    mask |= feature_bit::occluders | (f.mask() & feature_bit::nonconvex_media);
    if (first_null_boundary(scene)) mask |= feature_bit::boundaries;
    else if (bounded) mask |= feature_bit::many_media;  // walls and glass end the medium: a light may have vacuum in front of it
    f.surface_to_media = mask, f.surface_indirect = mask & ~(feature_bit::anisotropic | feature_bit::phase_lobes);
}

/// The lines of the list for this scene.
std::vector<Effect> effects_of(const Scene& scene, const std::vector<FeatureCause>& causes)
{
    std::vector<Effect> effects;
    for (const EffectRow& row : effect_list()) {
        if (row.bit == 0) continue;
        const auto cause = std::find_if(causes.begin(), causes.end(), [&](const FeatureCause& c) { return c.bit == row.bit; });
        effects.push_back(cause == causes.end() ? Effect{row} : Effect{row, true, cause->cause, cause->where});
    }
    for (const SceneFact& fact : scene_facts()) {
        const auto cause = fact.cause_of(scene);
        effects.push_back(cause ? Effect{fact.row, true, cause->sentence, cause->where} : Effect{fact.row});
    }
    return effects;
}

/// What is saved where a kernel feature is not needed.
std::string_view saving_of(std::uint32_t bit)
{
    switch (bit) {
        case feature_bit::anisotropic: return "phase functions: 1/(4 pi) is a constant";
        case feature_bit::coloured: return "two of three transmittances";
        case feature_bit::occluders: return "shadow segments: one kernel samples and adds";
        case feature_bit::many_media: return "the look-up of a medium for every eye";
        case feature_bit::boundaries: return "clipping connections at the boundaries of media";
        case feature_bit::nonconvex_media: return "walking connections through boundaries on the host";
        case feature_bit::short_lights: return "the survival probability of short lights";
        case feature_bit::depth_limit: return "counting vertices";
        case feature_bit::phase_lobes: return "sums of lobes and tables in phase functions";
        case feature_bit::heterogeneous: return "looking up voxels: extinction and albedo are constants of a medium";
        case feature_bit::coloured_grids: return "two of three look-ups of extinction";
    }
    return {};
}

}  // namespace

std::vector<EffectRow> effect_list()
{
    std::vector<EffectRow> rows;
    for (const SceneFeature& feature : scene_feature_list) rows.push_back({feature.name, feature.bit, feature.meaning, saving_of(feature.bit)});
    for (const SceneFact& fact : scene_facts()) rows.push_back(fact.row);
    return rows;
}

SceneFeatures features_of(const Scene& scene, bool short_lights, int max_depth)
{
    FeatureNotes notes;
    note_media(scene, notes);
    note_settings(short_lights, max_depth, notes);
    SceneFeatures f;
    if (const Shape* boundary = first_null_boundary(scene)) {
        ContainerSearch search = find_containers(scene);
        note_boundaries(*boundary, search, notes);
        f.containers = std::move(search.containers);
    }
    note_occluders(scene, f.containers, notes);
    f.media_to_media = notes.mask(Layer::media_to_media), f.media_to_surface = notes.mask(Layer::media_to_surface);
    find_surface_masks(scene, f);
    f.causes = std::move(notes).causes();
    f.effects = effects_of(scene, f.causes);
    const auto found = [&](std::string_view name) { return std::any_of(f.effects.begin(), f.effects.end(), [&](const Effect& e) { return e.row.name == name && e.found; }); };
    f.scattering_media = found("SCATTERING_MEDIA"), f.absorbing_media = found("MEDIA");
    f.surfaces_in_reach = found("SURFACES_IN_REACH");
    f.glossy_surfaces = found("GLOSSY_SURFACES"), f.receiving_surfaces = found("RECEIVING_SURFACES"), f.specular_surfaces = found("SPECULAR_SURFACES");
    return f;
}

std::string feature_names(std::uint32_t mask)
{
    std::string names;
    for (const SceneFeature& feature : scene_feature_list)
        if (mask & feature.bit) names += (names.empty() ? "" : " ") + std::string(feature.name);
    return names.empty() ? "none" : names;
}

}  // namespace tyndall

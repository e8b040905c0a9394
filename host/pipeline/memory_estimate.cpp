#include "pipeline/memory_estimate.hpp"

#include <algorithm>

#include "device/pair_stage.hpp"
#include "film/film.hpp"
#include "kernels/shared/host_features.hpp"
#include "lights/light_technique.hpp"
#include "pipeline/light_selection_plan.hpp"
#include "tiling/connect_pairs.hpp"
#include "visibility/near_search.hpp"

namespace tyndall {
namespace {

constexpr std::uint64_t features_bytes = sizeof(Rgb) + sizeof(Vec3) + sizeof(double);  ///< albedo, normal, depth

/// Sums per pixel: layers, squares of the beauty, features; twice, once a block of passes has been closed. The deviations of the layers once.
std::uint64_t film_bytes(std::uint64_t pixels, const RenderSettings& settings, std::size_t layers)
{
    const bool one_block = settings.passes > 0 && settings.passes <= settings.block_passes;
    return pixels * ((one_block ? 1u : 2u) * ((layers + 1) * sizeof(Rgb) + features_bytes) + layers * sizeof(glm::vec3));
}

/// Tables of what lies along lights and eye segments.
void add_tables(const std::string& layer, std::uint64_t segments, std::uint32_t features, std::uint32_t lights, std::vector<MemoryReport>& memory)
{
    if (!(features & feature_bit::heterogeneous)) return;
    const std::uint64_t channels = features & feature_bit::coloured_grids ? 3 : 1;
    memory.push_back({layer + ": tables of density grids", (segments + lights) * 65 * channels * sizeof(float), true});
}

/// Estimates of the lights for squares of pixels, and what was chosen by them.
void add_choice(const std::string& layer, std::uint64_t eyes, const SelectionPlan& plan, std::vector<MemoryReport>& memory)
{
    constexpr std::uint64_t estimate = sizeof(float) + sizeof(std::uint32_t);
    const std::uint64_t lights = std::max(plan.by_region() ? plan.candidates : plan.lights, 1u);
    const std::uint64_t squares = std::min<std::uint64_t>(eyes / static_cast<std::uint64_t>(plan.block * plan.block * plan.camera_samples) + 1, estimates_at_a_time / lights + 1);
    const std::uint64_t of_regions = plan.by_region() ? 2 * eye_alignment * estimate * std::min(plan.lights, plan.offered) : 0;
    memory.push_back({layer + ": chosen lights and their estimates",
                      std::max(squares * lights * estimate, of_regions) + eyes / eye_alignment * plan.slots_per_sample() * sizeof(LightChoice), true});
}

/// What the connections of one layer take on the device.
void add_device(const RenderSettings& settings, const LayerPlan& plan, Layer which, std::uint64_t pixels, std::uint32_t features, std::vector<MemoryReport>& memory)
{
    const SelectionPlan& selection = plan.selection;
    const LightTechnique& technique = lights_of(plan, which);
    const std::string layer(name(which));
    const std::uint32_t lights = selection.lights;
    const std::uint64_t eyes = std::min<std::uint64_t>(pixels * static_cast<std::uint64_t>(selection.camera_samples), eyes_at_a_time(features));
    const bool occluders = features & feature_bit::occluders;
    if (selection.chosen) add_choice(layer, eyes, selection, memory);
    add_tables(layer, eyes_of(which) == EyeKind::segments ? eyes : 0, features, technique.is_line ? lights : 0, memory);
    constexpr std::uint64_t sums = 6 * sizeof(float), packet = sizeof(ShadowPacket) / SHADOW_PACKET_SIZE, contribution = 3 * sizeof(float);
    memory.push_back({layer + ": eyes and their sums", eyes * (sizeof(EyeSegment) + sums), true});
    memory.push_back({layer + ": virtual lights", (lights + (selection.by_region() ? selection.candidates : 0)) * technique.record_bytes, true});
    if (!occluders) return;
    const std::uint32_t samples = static_cast<std::uint32_t>(settings.samples_per_pair), wanted = std::max((settings.tile_pairs ? settings.tile_pairs : shadowed_pairs) / samples, 1u);
    const std::uint32_t slots = std::min(selection.slots_per_sample(), light_block);
    const std::uint64_t pairs = std::min<std::uint64_t>(eyes, shadowed_tile_eyes(wanted, slots)) * slots * samples;
    memory.push_back({layer + ": two tiles of shadow segments", 2 * pairs * (packet + contribution), true});
}

/// What density estimation with one kind of light takes: its lights and the boxes of the search on the host, and lists of what is near.
void add_gather(const GatherPlan& gather, const RenderSettings& settings, std::uint64_t eyes, std::uint32_t features, std::vector<MemoryReport>& memory)
{
    const LightTechnique& technique = *gather.technique;
    const std::string title(technique.title);
    const std::uint64_t pieces = technique.is_line ? near_pieces_per_line : 1;
    memory.push_back({title + ": lights of a pass and the search among them", gather.lights * (technique.record_bytes + sizeof(Capsule) + pieces * near_bytes_per_piece)});
    memory.push_back({title + ": lights", gather.lights * std::uint64_t(technique.record_bytes), true});
    const std::uint64_t groups = eyes / eye_alignment + 1, most = settings.tile_pairs ? settings.tile_pairs : near_numbers_at_a_time;
    const std::uint64_t listed = std::min(groups * gather.lights, most), eyes_at_once = std::min(eyes, std::max<std::uint64_t>(most / std::max(gather.lights, 1u), 1) * eye_alignment);
    memory.push_back({title + ": lists of what is near, at most", listed * sizeof(std::uint32_t), true});
    memory.push_back({title + ": eyes and their sums", eyes_at_once * (sizeof(EyeSegment) + 6 * sizeof(float)), true});
    add_tables(title, technique.reach == Reach::near_segments ? eyes_at_once : 0, features, technique.is_line ? gather.lights : 0, memory);
}

std::uint64_t grid_bytes(const Scene& scene)
{
    std::uint64_t bytes = 0;
    for (const Volume& volume : scene.volumes) bytes += volume.values.size() * sizeof(float);
    return bytes;
}

}  // namespace

std::size_t eyes_at_a_time(std::uint32_t features) { return features & feature_bit::heterogeneous ? 1u << 16 : 1u << 19; }

std::vector<MemoryReport> estimate_memory(const Scene& scene, const RenderSettings& settings, const LayerPlan& plan, const BuildMasks& masks)
{
    const std::uint64_t pixels = static_cast<std::uint64_t>(scene.camera.crop_width) * static_cast<std::uint64_t>(scene.camera.crop_height);
    std::vector<MemoryReport> memory{{"film", film_bytes(pixels, settings, plan.rendered().size())},
                                     {"image of a pass", pixels * (plan.rendered().size() * sizeof(Rgb) + features_bytes)}};
    const std::uint64_t grids = grid_bytes(scene);
    if (grids > 0) memory.push_back({"grids of voxels", grids});
    if (!plan.on_device()) return memory;
    const std::uint64_t segments = plan.connects_segments() || plan.gathers_at(Reach::near_segments) ? 1 : 0, points = plan.connects_points() || plan.gathers_at(Reach::near_points) ? 1 : 0;
    const std::uint64_t eyes = pixels * static_cast<std::uint64_t>(plan.selection.camera_samples);
    memory.push_back({"eye segments and eye points", eyes * (segments + points) * sizeof(EyeSegment)});
    const std::vector<Layer> connected = connected_layers(plan);
    for (const Layer layer : connected) add_device(settings, plan, layer, pixels, masks.of(layer), memory);
    for (const GatherPlan& gather : plan.gathers) add_gather(gather, settings, eyes, gather_program(gather, settings, masks, 1).features, memory);
    if (grids > 0) memory.push_back({"grids of voxels, once for each layer of connections and each kind of gathered light", (connected.size() + plan.gathers.size()) * grids, true});
    return memory;
}

}  // namespace tyndall

/// api::Backend: stages of the device without scene, film or ray tracer.
#include "tyndall/backend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "kernels/shared/host_features.hpp"
#include "library/backend_media.hpp"
#include "library/backend_records.hpp"
#include "library/backend_shadows.hpp"
#include "pipeline/build_masks.hpp"
#include "pipeline/choose_sampler.hpp"
#include "pipeline/media_tables.hpp"
#include "pipeline/memory_estimate.hpp"
#include "selftest/first_use.hpp"
#include "transport/random_sequence.hpp"

namespace tyndall::api {

struct Backend::State {
    BackendDescription wanted;
    BackendSpace space;
    BackendMedia media;
    Device device;
    int lanes;
    std::map<std::tuple<std::string, EyeKind, bool>, PairStage> stages;  ///< by light, eye, and whether lights are chosen
    std::size_t most_eyes;                                             ///< at a time

    explicit State(BackendDescription&& description)
        : wanted(std::move(description)),
          space(wanted.low, wanted.high),
          media(wanted, space),
          device(wanted.opencl ? Device(*wanted.opencl) : Device(wanted.device)),
          lanes(wanted.lanes ? wanted.lanes : device.info().default_lanes),
          most_eyes(eyes_at_a_time(media.features.mask()))
    {
        if (wanted.lanes != 0 && wanted.lanes != 1 && wanted.lanes != 4 && wanted.lanes != 8 && wanted.lanes != 16)
            throw UsageError(fmt::format("lanes = {} must be 1, 4, 8 or 16 (0: by rule)", wanted.lanes));
    }

    PairStage& stage(Method method, EyeKind kind, bool chosen)
    {
        const LightTechnique& technique = *technique_of(method);
        const auto key = std::tuple(std::string(technique.name), kind, chosen);
        if (const auto known = stages.find(key); known != stages.end()) return known->second;
        const ChosenSampler sampler = choose_sampler(media.scene, media.features, Sampler::automatic);
        const LayerPlan plan{.technique = &technique, .media_to_media = kind == EyeKind::segments, .media_to_surface = kind == EyeKind::points,
                             .selection = {.chosen = chosen}, .sampler = sampler.sampler};
        const RenderSettings settings;
        const BuildMasks masks{media.features.media_to_media, media.features.media_to_surface};
        if (wanted.selftest) {
            const SelftestReport checked = check_on_first_use({.device = device.info(), .lanes = lanes, .families = case_families(plan, settings, masks)});
            if (wanted.warn && !checked.warning.empty()) wanted.warn(checked.warning);
        }
        return stages.try_emplace(key, device, pair_program(plan, settings, kind == EyeKind::segments ? Layer::media_to_media : Layer::media_to_surface, masks, lanes), media_tables(media.scene, media.features)).first->second;
    }

    ConnectSettings settings() const
    {
        return {.features = media.features.mask(), .samples = 1, .lanes = lanes, .stop = wanted.stop};
    }
};

namespace {

/// Eyes in a row that share an estimate, and the estimates that a batch may hold.
constexpr std::size_t block_eyes_in_a_row = 64;

/// Bytes on the device that do not depend on how many eyes are taken at a time, and those of each eye.
struct DeviceBytes {
    std::uint64_t fixed, per_eye;
};

DeviceBytes bytes_of(const BackendMedia& media, std::size_t lights, std::size_t light_bytes, std::uint32_t chosen)
{
    constexpr std::uint64_t tables = 66 * sizeof(float), sums = 6 * sizeof(float), worst = 2 * sizeof(float), estimate = 2 * sizeof(float);
    const bool grids = media.features.mask() & feature_bit::heterogeneous, shadows = media.features.mask() & feature_bit::occluders;
    DeviceBytes bytes{.fixed = lights * (light_bytes + sizeof(float) + (grids ? tables : 0)) + media.bytes(), .per_eye = sizeof(::tyndall::EyeSegment) + sums + worst + (grids ? tables : 0)};
    if (shadows) bytes.fixed += 2 * std::uint64_t(shadowed_pairs) * (sizeof(ShadowPacket) / SHADOW_PACKET_SIZE + 3 * sizeof(float));
    if (chosen) bytes.per_eye += chosen * sizeof(LightChoice) / eye_alignment + lights * estimate / block_eyes_in_a_row;
    return bytes;
}

/// As many as fit, a multiple of 64.
std::size_t eyes_that_fit(const Backend::State& state, const DeviceBytes& bytes, std::size_t lights, std::uint32_t chosen)
{
    std::uint64_t most = state.most_eyes;
    if (chosen) most = std::min<std::uint64_t>(most, estimates_at_a_time / std::max<std::size_t>(lights, 1) * block_eyes_in_a_row);
    if (const std::uint64_t room = state.wanted.max_bytes) {
        const std::uint64_t least = bytes.fixed + block_eyes_in_a_row * bytes.per_eye;
        if (room < least)
            throw ResourceError(fmt::format("max_bytes = {} is less than the {} that {} lights and {} eyes take on the device; hand over fewer lights at a time", room, least, lights, block_eyes_in_a_row));
        most = std::min<std::uint64_t>(most, (room - bytes.fixed) / bytes.per_eye);
    }
    return std::max<std::size_t>(most / block_eyes_in_a_row, 1) * block_eyes_in_a_row;
}

template <typename Eye>
struct Batch {
    std::vector<Eye> eyes, standing;
    std::vector<EyeBlock> blocks;
    std::vector<int> media;

    /// Eyes first ... first + count - 1 with the keys of a round, padded; blocks of 64 in a row, for which the middle one stands.
    Batch(const std::vector<Eye>& all, std::size_t first, std::size_t count, std::uint64_t round_key)
    {
        const auto key_of = [&](std::uint64_t i) { return static_cast<uint>(mix_bits(round_key ^ mix_bits(i)) >> 32); };
        eyes.assign(all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(first + count));
        for (std::size_t i = 0; i < count; ++i) eyes[i].key = key_of(first + i);
        pad(eyes);
        for (std::size_t at = 0; at < eyes.size(); at += block_eyes_in_a_row) {
            const std::size_t in_block = std::min(block_eyes_in_a_row, eyes.size() - at);
            blocks.push_back({static_cast<uint>(at / eye_alignment), static_cast<uint>(in_block / eye_alignment), key_of(~(first + at)), static_cast<uint>(standing.size()), 0, 1, 0, 0});
            standing.push_back(eyes[std::min(at + in_block / 2, count - 1)]);
        }
        pad(standing);
        for (const Eye& eye : eyes) media.push_back(eye.medium == NO_MEDIUM ? vacuum : static_cast<int>(eye.medium));
    }

    static void pad(std::vector<Eye>& records)
    {
        while (records.size() % eye_alignment != 0) {
            records.push_back(records.back());
            records.back().throughput_r = records.back().throughput_g = records.back().throughput_b = 0;
        }
    }
};

/// Sums of the rounds and of their squares.
struct Moments {
    std::vector<double> sum, square;

    void write(int rounds, Estimates& to) const
    {
        const double n = rounds;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            to.radiance[i] = static_cast<float>(sum[i] / n);
            if (rounds > 1) to.variance[i] = static_cast<float>(std::max(square[i] - sum[i] * sum[i] / n, 0.) / (n * (n - 1)));
        }
    }
};

/// One call of `connect`.
template <typename Eye>
class Connecting {
public:
    Connecting(Backend::State& state, PairStage& stage, std::span<const std::byte> lights, std::uint32_t light_count, const std::vector<Eye>& eyes, const ConnectOptions& options)
        : state_(state), stage_(stage), lights_{.records = lights, .count = light_count}, eyes_(eyes), options_(options)
    {
    }

    Estimates run(std::size_t batch)
    {
        Estimates all{.radiance = std::vector<float>(3 * eyes_.size()), .variance = std::vector<float>(3 * eyes_.size())};
        if (eyes_.empty() || lights_.count == 0) return all;
        Moments moments{std::vector<double>(3 * eyes_.size()), std::vector<double>(3 * eyes_.size())};
        const std::uint64_t not_finite_before = stage_.ledger().not_finite;
        for (int round = 0; round < options_.rounds; ++round)
            for (std::size_t first = 0; first < eyes_.size();) {
                const std::size_t count = std::min(batch, eyes_.size() - first);
                if (!add(first, count, mix_bits(mix_bits(options_.seed) + static_cast<std::uint64_t>(round)), moments)) {
                    batch = std::max(batch / 2 / block_eyes_in_a_row, std::size_t(1)) * block_eyes_in_a_row;
                    continue;
                }
                first += count;
            }
        moments.write(options_.rounds, all);
        all.shadow_segments = counts_.shadow_segments, all.not_finite = stage_.ledger().not_finite - not_finite_before;
        return all;
    }

private:
    /// False: the device lacks room for so many at a time.
    bool add(std::size_t first, std::size_t count, std::uint64_t key, Moments& moments)
    try {
        const Batch<Eye> batch(eyes_, first, count, key);
        const ConnectSettings settings = state_.settings();
        const EyeBatch eyes{std::as_bytes(std::span(batch.eyes)), static_cast<std::uint32_t>(batch.eyes.size()), batch.media};
        const LightSelection selection{.standing = std::as_bytes(std::span(batch.standing)), .standing_count = static_cast<std::uint32_t>(batch.standing.size()), .blocks = batch.blocks,
                                       .slots = options_.lights_per_eye};
        const std::vector<double> sums = connect_pairs(stage_, answer_by(state_.wanted, state_.space, eyes.media, settings), eyes, lights_, settings, counts_, options_.lights_per_eye ? &selection : nullptr);
        for (std::size_t i = 0; i < 3 * count; ++i) moments.sum[3 * first + i] += sums[i], moments.square[3 * first + i] += sums[i] * sums[i];
        return true;
    } catch (const ResourceError&) {
        stage_.recover();
        if (count <= block_eyes_in_a_row) throw;
        return false;
    } catch (...) {
        stage_.recover();
        throw;
    }

    Backend::State& state_;
    PairStage& stage_;
    LightBatch lights_;
    const std::vector<Eye>& eyes_;
    ConnectOptions options_;
    ConnectCounts counts_;
};

template <typename Light, typename Eye>
Estimates connect_all(Backend::State& state, Method method, EyeKind kind, std::span<const Light> lights, std::span<const Eye> eyes, ConnectOptions options)
{
    if (options.rounds < 1) throw UsageError(fmt::format("rounds = {} must be at least 1", options.rounds));
    if (lights.size() > 1u << 24) throw UsageError(fmt::format("{} lights are more than {}; hand them over in parts and add the results", lights.size(), 1u << 24));
    if (options.lights_per_eye >= lights.size()) options.lights_per_eye = 0;
    const std::vector<std::byte> records = light_records(lights, state.space, state.media.scene.media.size());
    const auto eye_list = eye_records(eyes, state.space, state.media.scene.media.size());
    const DeviceBytes bytes = bytes_of(state.media, lights.size(), technique_of(method)->record_bytes, options.lights_per_eye);
    const std::size_t batch = eyes_that_fit(state, bytes, lights.size(), options.lights_per_eye);
    PairStage& stage = state.stage(method, kind, options.lights_per_eye > 0);
    return Connecting(state, stage, records, static_cast<std::uint32_t>(lights.size()), eye_list, options).run(batch);
}

}  // namespace

Backend::Backend(BackendDescription description) : state_(std::make_unique<State>(std::move(description))) {}
Backend::~Backend() = default;
Backend::Backend(Backend&&) noexcept = default;
Backend& Backend::operator=(Backend&&) noexcept = default;

Estimates Backend::connect(std::span<const RayLight> lights, std::span<const EyeSegment> eyes, const ConnectOptions& options)
{
    return connect_all(*state_, Method::vrl, EyeKind::segments, lights, eyes, options);
}
Estimates Backend::connect(std::span<const RayLight> lights, std::span<const EyePoint> eyes, const ConnectOptions& options)
{
    return connect_all(*state_, Method::vrl, EyeKind::points, lights, eyes, options);
}
Estimates Backend::connect(std::span<const PointLight> lights, std::span<const EyeSegment> eyes, const ConnectOptions& options)
{
    return connect_all(*state_, Method("vpl"), EyeKind::segments, lights, eyes, options);
}
Estimates Backend::connect(std::span<const PointLight> lights, std::span<const EyePoint> eyes, const ConnectOptions& options)
{
    return connect_all(*state_, Method("vpl"), EyeKind::points, lights, eyes, options);
}

}  // namespace tyndall::api

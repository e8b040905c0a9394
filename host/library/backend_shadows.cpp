#include "library/backend_shadows.hpp"

#include <cmath>
#include <limits>

#include "tyndall/error.hpp"

namespace tyndall {
namespace {

/// A lane of a packet.
struct Asked {
    std::size_t packet, lane;
};

struct Questions {
    std::vector<api::ShadowSegment> segments;
    std::vector<Asked> asked;
};

Questions questions_of(const SampledTile& sampled, const PairTile& tile, const BackendSpace& space, const std::vector<int>& media, const ConnectSettings& settings)
{
    Questions all;
    const std::size_t pairs = std::size_t(tile.lights) * settings.samples, first_eye = std::size_t(tile.first_group) * static_cast<std::size_t>(settings.lanes);
    for (std::size_t p = 0; p < sampled.packets.size(); ++p) {
        const ShadowPacket& s = sampled.packets[p];
        for (std::size_t i = 0; i < SHADOW_PACKET_SIZE; ++i) {
            if (!(s.tfar[i] >= s.tnear[i])) continue;
            const Vec3 from(s.origin_x[i], s.origin_y[i], s.origin_z[i]), d(s.direction_x[i], s.direction_y[i], s.direction_z[i]);
            const int medium = media[first_eye + p / pairs * SHADOW_PACKET_SIZE + i];
            all.segments.push_back({space.from_render(from + double(s.tnear[i]) * d), space.from_render(from + double(s.tfar[i]) * d), static_cast<std::uint32_t>(medium)});
            all.asked.push_back({p, i});
        }
    }
    return all;
}

}  // namespace

ShadowAnswer answer_by(const api::BackendDescription& caller, const BackendSpace& space, const std::vector<int>& media, const ConnectSettings& settings)
{
    return [&](const SampledTile& sampled, const PairTile& tile) -> std::uint64_t {
        const Questions q = questions_of(sampled, tile, space, media, settings);
        if (q.asked.empty()) return 0;
        if (caller.transmittance) {
            std::vector<api::Float3> passed(q.asked.size());
            caller.transmittance(q.segments, passed);
            for (std::size_t i = 0; i < passed.size(); ++i) {
                const Rgb factor(passed[i][0], passed[i][1], passed[i][2]);
                if (!(std::isfinite(factor.r + factor.g + factor.b) && factor.r >= 0 && factor.g >= 0 && factor.b >= 0))
                    throw UsageError("the caller's transmittance of a segment is negative or not finite");
                scale_contribution(sampled, tile, settings, q.asked[i].packet, q.asked[i].lane, factor);
            }
        } else {
            std::vector<std::uint8_t> blocked(q.asked.size());
            caller.occluded(q.segments, blocked);
            for (std::size_t i = 0; i < blocked.size(); ++i)
                if (blocked[i]) sampled.packets[q.asked[i].packet].tfar[q.asked[i].lane] = -std::numeric_limits<float>::infinity();
        }
        return q.asked.size();
    };
}

}  // namespace tyndall

#pragma once
/// Eyes and lights for device tests, and the same sums on the host in float and double.
#include <cstdint>
#include <vector>

#include "device/pair_stage.hpp"

namespace tyndall::testing {

struct RandomPairs {
    std::vector<EyeSegment> segments;   ///< a multiple of 16
    std::vector<EyePoint> points;       ///< likewise
    std::vector<std::byte> lights;      ///< virtual ray lights
    std::uint32_t light_count = 0;
    MediaTables tables;
};

struct PairWishes {
    std::uint32_t eyes = 64, lights = 300;
    double g = 0;
    bool coloured = false, short_lights = false;
    bool lobes = false;      ///< a blend of two Henyey-Greenstein lobes, Rayleigh's and a table
    bool two_media = false;  ///< every other eye and light is in a second medium, without lobes
    std::uint32_t seed = 5;
};

/// Camera outside a cube of side 2 that is full of lights; one medium; the cube's six planes as its container if `container`.
RandomPairs random_pairs(const PairWishes& wishes, bool container = false);

/// Sum over lights, r g b per eye, by the same mathematics on the host in double (from the float records and the same random numbers).
std::vector<double> host_sums(const RandomPairs& pairs, EyeKind kind, int sampler = SAMPLER_PAPER_ISOTROPIC, int sequence = SEQUENCE_RANDOM);

/// Turns and moves some lights so that pairs are nearly parallel, on one line, touch, start at the eye, or have no length.
void degenerate(RandomPairs& pairs);

/// All tiles of a stage without occluders.
std::vector<double> gathered(PairStage& stage, const RandomPairs& pairs, EyeKind kind, std::uint32_t tile_groups, std::uint32_t tile_lights, std::uint32_t vertex_limit = 0xffffffffu);
/// The same with occluders, every shadow segment answered "visible".
std::vector<double> sampled_and_accumulated(PairStage& stage, const RandomPairs& pairs, EyeKind kind, std::uint32_t tile_groups);

/// Lays one light across the first eye segment: both run along axes and meet in a point.
void lay_light_across(RandomPairs& pairs, std::uint32_t light);

/// Sets one light's red flux to a value.
void set_flux(RandomPairs& pairs, std::uint32_t light, float red);

}  // namespace tyndall::testing

#pragma once
/// What the device does with pairs of a light and an eye: everything but visibility. Includes no OpenCL header.
///
/// Eyes are groups of `lanes` neighbours; lights come in blocks of `light_block`. Whatever the tiles, every eye adds its lights in the same blocks and order.
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "device/device.hpp"
#include "kernels/shared/records.hpp"

namespace tyndall {

inline constexpr std::uint32_t light_block = 256;
inline constexpr std::uint32_t eye_alignment = 16;  ///< the number of eyes is a multiple of this: pad with eyes of no throughput

enum class EyeKind { segments, points };

struct PairProgram {
    std::string light = "virtual_ray_light";  ///< file in kernels/lights
    std::uint32_t light_bytes = 64;           ///< of its record
    bool light_is_line = true;                ///< its LIGHT_IS_LINE: in density grids it has tables of what lies along it
    EyeKind eyes = EyeKind::segments;
    std::uint32_t features = 0;               ///< mask of kernels/shared/scene_features.h
    int lanes = 16;
    int sampler = 0, sequence = 0;            ///< kernels/shared/samplers.h
    std::uint32_t samples = 1;                ///< per pair; contributions are their sum
    bool selection = false;                   ///< eyes connect to the lights that were chosen for them
    int transmittance = 0;                    ///< kernels/shared/transmittance_modes.h; means something with HETEROGENEOUS only
    float clamp = 0;                          ///< kernels/shared/clamp.h: bound of 1 / w^2; 0: none
    int precision = 32;                       ///< bits of the numbers that pairs are evaluated with, 32 or 64
    bool fast_math = false;                   ///< the compiler may reorder and approximate
    bool gathers = false;                     ///< eyes take from lights that come near (gather_near) instead of being connected to them

    /// Per eye: of what arrives and, with a clamp, of what it took away.
    std::uint32_t sums_of_eye() const { return clamp > 0 ? 2 : 1; }
};

/// Tables that do not change during a render.
struct MediaTables {
    std::vector<MediumRecord> media;
    std::vector<ContainerRecord> containers;
    std::vector<PlaneRecord> planes;
    std::vector<PhaseLobeRecord> lobes{};
    std::vector<float> phase_values{};
    std::vector<GridRecord> grids{};
    std::vector<float> voxels{};
};

/// A rectangle of pairs. With shadow segments its lights lie in one block; first_group x lanes is a multiple of the packet size.
struct PairTile {
    std::uint32_t first_group = 0, groups = 0, first_light = 0, lights = 0;
};

/// A sampled tile as the host sees it: one packet per 16 eyes and pair, in rows of 16 eyes; contributions [group][pair][r g b][lane], with a clamp [r g b of what is kept, r g b of what it removed].
struct SampledTile {
    std::span<ShadowPacket> packets;
    std::span<float> contributions;
};

/// What the host does with a sampled tile: sets tfar of blocked lanes to -infinity, or multiplies contributions.
using TileWork = std::function<void(const SampledTile&)>;

struct PairLedger {
    std::uint32_t not_finite = 0, first_eye = 0, first_counter = 0;
    std::uint32_t floored = 0;  ///< samples of pairs so close to crossing that the floor on their distance was active (kernels/README.md, eq. 7)

    /// As the device counts: how many are not finite, where the first is, how many are floored.
    void add(const std::array<std::uint32_t, 4>& counted)
    {
        if (not_finite == 0) first_eye = counted[1], first_counter = counted[2];
        not_finite += counted[0], floored += counted[3];
    }
};

/// The pair that added most to its eye, as the sum of its channels; the same for every tile size.
struct WorstPair {
    std::uint32_t eye = 0, slot = 0;  ///< slot: the light's number, or its place among the eye's chosen lights
    double value = 0;
};

struct PairTimings {
    double gather = 0, sample = 0, accumulate = 0, tabulate = 0, select = 0, largest_launch = 0;  ///< seconds on the device
    std::uint64_t launches = 0;
};

/// "-cl-std=CL1.2 -DLANES=16 ...": the build options of a program; part of the report.
std::string build_options(const PairProgram& program);

/// One kernel that a program needs.
struct KernelBuild {
    std::string name;            ///< of the kernel
    std::string options;
    std::uint32_t features = 0;

    /// Its file in kernels/stages; kernels of one file and the same options are one program.
    std::string file() const { return name == "weigh_lights" || name == "pool_shares" ? "select_lights" : name; }
    /// It asks neither eyes, lights nor features: one program serves all.
    bool serves_all() const { return name == "accumulate_pairs" || file() == "select_lights"; }
};

/// How lights are chosen for blocks of eyes.
struct LightSelection {
    std::span<const std::byte> standing;   ///< raw records of the eyes whose estimates the blocks share
    std::uint32_t standing_count = 0;      ///< a multiple of eye_alignment
    std::span<const EyeBlock> blocks;      ///< together they hold every group of 16 eyes once
    std::uint32_t slots = 64;              ///< lights per eye; a block's part makes one of `parts` out of slots x parts
    float defence = .1f;                   ///< share of the choice that goes by power alone, in [0, 1]
};

/// gather_lights if nothing can occlude; otherwise sample_pairs, and accumulate_pairs, which is the same program for every eye, light and feature. Density
/// grids: also the tables along lights and eye segments.
std::vector<KernelBuild> kernel_builds(const PairProgram& program);

/// What the device's compiler reads for one of them.
std::string kernel_text(const PairProgram& program, const KernelBuild& wanted);

class PairStage {
public:
    /// Compiles (or takes from the driver's cache) the program's kernels: gather only if nothing can occlude, sample and accumulate otherwise.
    PairStage(Device& device, const PairProgram& program, const MediaTables& tables);
    ~PairStage();
    PairStage(PairStage&&) noexcept;

    /// Starts a set of eyes and lights: raw records, sums at zero, tables along them where there are density grids. vertex_limit: at most so many scattering vertices on a path (ignored without DEPTH_LIMIT).
    /// weights: what each light counts for, if the lights were chosen among others (empty: 1).
    void begin(std::span<const std::byte> eyes, std::uint32_t eye_count, std::span<const std::byte> lights, std::uint32_t vertex_limit, std::span<const float> weights = {});
    std::uint32_t groups() const;

    /// Chooses lights for all eyes, after `begin` and before the first tile; from here on the tiles' lights are slots. Without lights it does nothing.
    void select(const LightSelection& selection);
    /// Lights that `candidates` chooses among.
    void offer(std::span<const std::byte> lights, std::uint32_t vertex_limit);
    /// `slots` of the offered lights first ... first + count - 1, chosen for a region of which selection.standing are 16 eyes of the same depth: a light's expected
    /// sum of weights is 1. By number; a light may come several times in a row. Waits.
    std::vector<LightChoice> candidates(const LightSelection& selection, std::uint32_t first, std::uint32_t count, std::uint32_t key);
    /// What was chosen, slots per group of 16 eyes (tests, reports). Waits.
    std::vector<LightChoice> chosen() const;

    /// Without occluders: adds a tile (first_light a multiple of light_block), in as many launches as the device's bound on their time asks for. Returns before it is
    /// done, but waits for the first launch of all, which tells how long pairs take.
    void gather(const PairTile& tile);

    /// Of a program that gathers: adds to all eyes what they take from lights that are near. near: numbers of lights, for 16 eyes after the other; those of group i begin at starts[i] and end at
    /// starts[i + 1]. In as many launches as the device's bound on their time asks for.
    void gather_near(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> near);

    /// With occluders: so many of `pairs` may be sampled in one tile, by the time that earlier ones took.
    std::uint32_t most_sampled(std::uint32_t pairs) const;
    /// In two slots 0 and 1: sample writes contributions and shadow segments; the host answers them between `sampled` and `accumulate`.
    void sample(int slot, const PairTile& tile);
    SampledTile sampled(int slot);
    void accumulate(int slot);

    /// Whether the device's threads run functions of the host between kernels: then `chain` does all three steps.
    bool runs_native_kernels() const;
    /// Samples a tile, has `work` done by one of the device's threads, adds what is left; tiles are added in the order of the calls while two of them are at work. Waits only while several are on their way.
    /// What a tile's `work` throws is thrown by a later call or by end_chain; the sums then mean nothing.
    void chain(const PairTile& tile, TileWork work);
    /// Until all chained tiles are added.
    void end_chain();
    /// The same when something has been thrown: nothing of the caller's is used any more.
    void drop_chain() noexcept;

    /// Until everything that was started is done.
    void wait();
    /// Waits; r, g, b per eye, sums over lights and samples; with a clamp each is followed by r, g, b of what it removed.
    std::vector<double> sums();
    /// Of the set whose sums were taken last.
    WorstPair worst() const;
    /// Of everything whose sums were taken.
    PairLedger ledger() const;
    /// After a ResourceError: gives back the memory that depends on how much is done at a time and forgets the set that was begun. `begin` starts again.
    void recover();
    PairTimings timings() const;
    /// The build options of its program.
    std::string options() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tyndall

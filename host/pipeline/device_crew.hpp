#pragma once
/// The devices of a render, each with a stage of its own: they take pieces of the eyes as they become free.
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "device/pair_stage.hpp"
#include "tiling/connect_pairs.hpp"

namespace tyndall {

/// Some of the units that a job is made of, first ... last - 1.
struct Piece {
    std::size_t first, last;
};

/// Sums of eyes that do not depend on each other, cut at will.
struct SharedJob {
    std::size_t units = 0;                              ///< groups of 16 eyes, or blocks of them
    std::function<std::size_t(Piece)> eyes;             ///< how many a piece has
    std::function<bool(Piece)> fits = [](Piece) { return true; };  ///< may it be one piece, however much room there is?
    std::function<std::vector<double>(PairStage&, const ConnectSettings&, Piece, ConnectCounts&)> sums;  ///< called from several threads, never twice at a time for one stage
    std::function<void(Piece, const std::vector<double>&)> add;                                           ///< called in the order of the pieces
};

class DeviceCrew {
public:
    DeviceCrew(std::vector<PairStage> stages, const ConnectSettings& settings);

    /// Does all of the job. Bytes do not depend on who does what, nor on how it is cut. A device that runs short of memory or resources does half as much at a time from
    /// then on; one that fails takes no further part, and the others do its piece. Throws DeviceError when nobody is left.
    void share(const SharedJob& job, ConnectCounts& counts);

    /// The stage of the first device that has not failed.
    PairStage& first();
    std::vector<const PairStage*> stages() const;
    /// What devices ran short of, and which have failed.
    std::vector<std::string> warnings() const;

private:
    struct Worker {
        PairStage stage;
        ConnectSettings settings;
        std::size_t most_eyes;  ///< at a time
        int shortages = 0;
        std::string shortage{}, failure{};
        bool failed() const { return !failure.empty(); }
    };
    struct Shared;

    std::vector<Piece> cut(const SharedJob& job) const;
    std::vector<double> sums_of(Worker& worker, const SharedJob& job, Piece piece, ConnectCounts& counts);
    bool take_less(Worker& worker, std::size_t eyes, const std::string& why);
    void work(Worker& worker, const SharedJob& job, Shared& shared);
    std::size_t able() const;

    std::vector<Worker> workers_;
};

}  // namespace tyndall

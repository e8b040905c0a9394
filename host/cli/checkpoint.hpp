#pragma once
/// The file from which a render goes on after an interruption.
#include <chrono>
#include <filesystem>
#include <optional>

#include "pipeline/render.hpp"

namespace tyndall {

/// The checkpoint of an output: beside it, under its name with ".checkpoint" behind.
std::filesystem::path checkpoint_of(const std::filesystem::path& output);

class Checkpoint {
public:
    /// `interval`: seconds between two checkpoints, 0: none at all; nothing: 30 s, in runs of more than a minute.
    Checkpoint(std::filesystem::path file, std::optional<double> interval) : file_(std::move(file)), interval_(interval) {}

    const std::filesystem::path& file() const { return file_; }
    bool enabled() const { return !interval_ || *interval_ > 0; }
    /// What an earlier run left, if anything. Throws SceneError for a file that cannot be gone on from.
    std::optional<RenderState> read();
    /// Saves if it is time: never more often than a twentieth of the time goes into it. A failure is a warning, once: the render goes on.
    void after_pass(const Progress& progress, const RenderState& state);
    /// Saves now, unless checkpoints are turned off. Throws IoError.
    void save(const RenderState& state);
    /// Removes the file if this run has written it or has gone on from it.
    void remove();

private:
    using Clock = std::chrono::steady_clock;
    bool due(const Progress& progress) const;

    std::filesystem::path file_;
    std::optional<double> interval_;
    Clock::time_point last_ = Clock::now();
    double cost_ = 0;  ///< seconds that the last one took
    bool ours_ = false, warned_ = false;
};

}  // namespace tyndall

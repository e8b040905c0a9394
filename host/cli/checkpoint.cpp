#include "cli/checkpoint.hpp"

#include <algorithm>

#include "cli/say.hpp"
#include "report/readable.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

constexpr double usual_interval = 30, worth_it = 60;  ///< seconds
constexpr double least_share = 20;                    ///< of the time goes to other things, for one part that goes into checkpoints

double seconds_since(std::chrono::steady_clock::time_point start) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }

}  // namespace

std::filesystem::path checkpoint_of(const std::filesystem::path& output) { return std::filesystem::path(output) += ".checkpoint"; }

std::optional<RenderState> Checkpoint::read()
{
    if (!std::filesystem::exists(file_)) return std::nullopt;
    RenderState state = read_state(file_);
    ours_ = true;
    return state;
}

bool Checkpoint::due(const Progress& progress) const
{
    if (!enabled() || seconds_since(last_) < std::max(interval_.value_or(usual_interval), least_share * cost_)) return false;
    return interval_ || progress.seconds + progress.seconds_left > worth_it;
}

void Checkpoint::after_pass(const Progress& progress, const RenderState& state)
{
    if (!due(progress)) return;
    try {
        save(state);
    } catch (const IoError& error) {
        last_ = Clock::now();
        if (!warned_) say(stderr, "warning: no checkpoint could be written, the render goes on without: {}\n", terminal_safe(error.what()));
        warned_ = true;
    }
}

void Checkpoint::save(const RenderState& state)
{
    if (!enabled()) return;
    const auto start = Clock::now();
    write_state(file_, state);
    ours_ = true, cost_ = seconds_since(start), last_ = Clock::now();
}

void Checkpoint::remove()
{
    std::error_code ignored;
    if (ours_) std::filesystem::remove(file_, ignored);
}

}  // namespace tyndall

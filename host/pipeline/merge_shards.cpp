#include "pipeline/merge_shards.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/report_bytes.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

struct Part {
    std::filesystem::path file;
    RenderState state;  ///< without its films
};

/// Settings that a machine brings with it.
bool of_device(const StateSetting& setting) { return setting.name == "device" || setting.name == "driver" || setting.name.starts_with("kernels of "); }

std::string passes_text(const PassRange& range) { return fmt::format("passes {} to {}", range.first + 1, range.end); }

std::vector<Part> index_of(const std::vector<std::filesystem::path>& files, bool mixed_devices)
{
    std::vector<Part> parts;
    for (const auto& file : files) {
        Part part{file, read_state(file)};
        if (part.state.shard.whole()) throw SceneError(fmt::format("{}: is the checkpoint of a whole render, not a shard; --resume goes on with it", file.string()));
        if (!part.state.finished)
            throw SceneError(fmt::format("{}: is not finished: {} of {} passes are done; go on with --resume", file.string(), part.state.passes(), part.state.range.end - part.state.range.first));
        part.state.films.clear();
        if (mixed_devices) std::erase_if(part.state.settings, of_device);
        parts.push_back(std::move(part));
    }
    return parts;
}

void check_same_render(const std::vector<Part>& parts)
{
    const Part& first = parts.front();
    for (const Part& part : parts) {
        std::vector<std::string> wrong = differences(part.state.settings, first.state.settings, first.file.string());
        if (part.state.run_passes != first.state.run_passes)
            wrong.push_back(fmt::format("passes is {} here and {} in {}", part.state.run_passes, first.state.run_passes, first.file.string()));
        if (!wrong.empty()) throw SceneError(fmt::format("{}: is a shard of another render: {}", part.file.string(), fmt::join(wrong, "; ")));
    }
}

/// `parts` in the order of their passes.
void check_complete(const std::vector<Part>& parts)
{
    std::vector<std::string> missing;
    PassRange done;
    const Part* last = nullptr;
    const auto miss = [&](int from, int to) {
        if (from < to) missing.push_back(passes_text({from, to}));
    };
    for (const Part& part : parts) {
        const PassRange range = part.state.range;
        if (range.first == range.end) continue;
        if (range.first < done.end)
            throw SceneError(fmt::format("{}: holds {}, which {} holds too; name every shard once", part.file.string(), passes_text({range.first, std::min(range.end, done.end)}), last->file.string()));
        miss(done.end, range.first);
        done.end = range.end, last = &part;
    }
    miss(done.end, parts.front().state.run_passes);
    if (missing.empty()) return;
    const RenderState& any = parts.front().state;
    throw SceneError(fmt::format("{} of {} are in none of the {} files ({} shards make up the render)", fmt::join(missing, ", "), any.run_passes, parts.size(), any.shard.of));
}

void add_savings(Report& sum, const Report& next)
{
    for (std::size_t i = 0; i < std::min(sum.savings.size(), next.savings.size()); ++i)
        if (sum.savings[i].predicted_seconds >= 0) sum.savings[i].predicted_seconds += next.savings[i].predicted_seconds;
}

}  // namespace

RenderState merge_shards(const std::vector<std::filesystem::path>& files, bool mixed_devices)
{
    std::vector<Part> parts = index_of(files, mixed_devices);
    std::ranges::stable_sort(parts, {}, [](const Part& part) { return std::pair(part.state.range.first, part.state.range.end); });
    check_same_render(parts);
    check_complete(parts);
    RenderState whole;
    for (const Part& part : parts) {
        RenderState next = read_state(part.file);
        if (next.films.empty()) continue;
        Report report = std::move(next.report);
        if (whole.films.empty()) {
            const Film& film = next.films[0];
            whole = RenderState{.settings = next.settings, .run_passes = next.run_passes, .finished = true, .window = next.window, .asked = next.asked};
            whole.films.push_back(Film(film.width(), film.height(), film.layers(), {.block_passes = film.block_passes()}));
        } else {
            add_counts(report, whole.report), add_savings(report, whole.report);
        }
        whole.report = std::move(report);
        if (!next.films[0].same_kind(whole.films[0])) throw SceneError(fmt::format("{}: is damaged: its film is not that of its settings", part.file.string()));
        for (Film& film : next.films) whole.films[0].append(std::move(film));
    }
    whole.report.prediction.reset();
    whole.report.pass_seconds = whole.report.seconds / whole.films[0].passes();
    return whole;
}

}  // namespace tyndall

#include "cli/progress_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/say.hpp"
#include "report/readable.hpp"

namespace tyndall {
namespace {

constexpr double plain_interval_seconds = 30;
constexpr std::size_t bar_cells = 20;

nlohmann::json number(double value, bool known = true)
{
    return known && std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

}  // namespace

double share_done(const Progress& progress)
{
    const double time = progress.seconds + progress.seconds_left;
    const double of_time = time > 0 && std::isfinite(time) ? progress.seconds / time : 0;
    const double of_passes = progress.passes_wanted > 0 ? static_cast<double>(progress.passes_done) / progress.passes_wanted : 0;
    return std::clamp(std::max(of_time, of_passes), 0., 1.);
}

std::string progress_text(const Progress& progress)
{
    std::string text = fmt::format("pass {}", progress.passes_done);
    if (progress.passes_wanted > 0) text += fmt::format("/{}", progress.passes_wanted);
    if (progress.pairs_per_second > 0) text += fmt::format(", {} pairs/s", readable_count(progress.pairs_per_second));
    if (progress.shadow_segments_per_second > 0)
        text += fmt::format(", {} shadow segments/s", readable_count(progress.shadow_segments_per_second));
    text += fmt::format(", error {}", readable_percent(progress.error));
    if (progress.seconds_to_error > 0)
        text += fmt::format(", {} in {}", readable_percent(progress.error_aimed_at), readable_seconds(progress.seconds_to_error));
    return text + fmt::format(", {} left", readable_seconds(progress.seconds_left));
}

void ProgressView::end_line()
{
    if (line_open_) std::fputc('\n', stream_), std::fflush(stream_);
    line_open_ = false;
}

ProgressView::~ProgressView()
{
    end_line();
}

void ProgressView::show(const Progress& progress)
{
    switch (style_) {
        case ProgressStyle::none:
            return;
        case ProgressStyle::bar:
            return show_bar(progress);
        case ProgressStyle::plain:
            return show_plain(progress);
        case ProgressStyle::json:
            return show_json(progress);
    }
}

void ProgressView::show_bar(const Progress& progress)
{
    const auto full = static_cast<std::size_t>(share_done(progress) * bar_cells);
    std::string line = fmt::format("[{:.<{}}] {}", std::string(full, '#'), bar_cells, progress_text(progress));
    line.resize(std::min(line.size(), static_cast<std::size_t>(std::max(columns_ - 1, 1))));  // a full line would wrap and scroll
    say(stream_, "\r\033[K{}", line);
    std::fflush(stream_);
    line_open_ = true;
}

void ProgressView::show_plain(const Progress& progress)
{
    const int tenths = static_cast<int>(10 * share_done(progress));
    if (tenths <= tenths_shown_ && progress.seconds - seconds_shown_ < plain_interval_seconds) return;
    tenths_shown_ = tenths, seconds_shown_ = progress.seconds;
    say(stream_, "{:3.0f} %  {}\n", 100 * share_done(progress), progress_text(progress));
    std::fflush(stream_);
}

void ProgressView::show_json(const Progress& progress)
{
    const nlohmann::ordered_json json{{"event", "progress"},
                                      {"passes_done", progress.passes_done},
                                      {"passes_wanted", progress.passes_wanted},
                                      {"seconds", number(progress.seconds)},
                                      {"seconds_left", number(progress.seconds_left, progress.seconds_left >= 0)},
                                      {"error", number(progress.error, progress.error >= 0)},
                                      {"error_aimed_at", number(progress.error_aimed_at)},
                                      {"seconds_to_error", number(progress.seconds_to_error, progress.seconds_to_error >= 0)},
                                      {"pairs_per_second", number(progress.pairs_per_second)},
                                      {"shadow_segments_per_second", number(progress.shadow_segments_per_second)}};
    say(stream_, "{}\n", json.dump());
    std::fflush(stream_);
}

}  // namespace tyndall

#include "cli/write_image.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/say.hpp"
#include "film/exr.hpp"
#include "pipeline/render.hpp"
#include "report/readable.hpp"
#include "report/report_output.hpp"

namespace tyndall {

Report write_image(const OutputPaths& paths, const RenderState& state, const ImageWishes& wishes)
{
    const Film& film = state.films.at(0);
    Report report = state.report;
    describe_film(report, film);
    report.ledger.not_finite_pixels = film.not_finite().count;
    for (const auto& pixel : film.not_finite().first_cases)
        report.ledger.first_cases.push_back(
            fmt::format("pass {}, layer {}, pixel ({}, {}) was not finite", pixel.pass, name(pixel.layer), pixel.x, pixel.y));
    compress_exr_in_threads(report.threads);  // most of the time that writing takes, and after a signal a second is all there is
    write_outputs(paths, film, state.window, wishes, state.asked, report);
    return report;
}

void print_summary(Report report, const std::vector<std::string>& printed_warnings)
{
    std::erase_if(report.warnings, [&](const auto& warning) { return std::ranges::find(printed_warnings, warning) != printed_warnings.end(); });
    say(stderr, "{}", to_table(report));
}

void print_outputs(const std::string& stopped_by, const std::vector<std::string>& outputs, ProgressStyle style)
{
    if (style == ProgressStyle::json) {
        const nlohmann::ordered_json event{{"event", "finished"}, {"stopped_by", stopped_by}, {"outputs", outputs}};
        say("{}\n", event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    } else {
        const bool is_shown = ::isatty(STDOUT_FILENO);
        for (const auto& output : outputs) say("{}\n", is_shown ? terminal_safe(output) : output);
    }
}

}  // namespace tyndall

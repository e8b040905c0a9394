#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/comparison_json.hpp"
#include "report/readable.hpp"

namespace tyndall {
namespace {

/// "2.31 % (2.20 to 2.45)"; "<" where only a bound is known.
std::string error_text(const ErrorAt& at)
{
    if (!at.relative_mse) return "no pass yet";
    const auto percent = [](double relative_mse) { return 100 * std::sqrt(std::max(relative_mse, 0.)); };
    return fmt::format("{}{:.3g} % ({:.3g} to {:.3g})", at.at_most ? "< " : "", percent(at.relative_mse->median), percent(at.relative_mse->low), percent(at.relative_mse->high));
}

/// "1.9 (1.6 to 2.3)" times the relMSE of the usual value, or what keeps it from being told.
std::string price_text(const Comparison& c, const DialSweep& sweep, std::size_t other)
{
    const auto p = price(c.judgement, other, sweep.usual, c.plan.times.back());
    if (!p) return "no pass yet";
    if (!(p->high > 0)) return fmt::format("{:.3g}, without an error bar", p->ratio);
    return fmt::format("{:.3g} ({:.3g} to {:.3g}){}", p->ratio, p->low, p->high, p->significant ? "" : ", not told apart");
}

/// A row per value of a dial.
std::string dial_table(const Comparison& c)
{
    std::string text = fmt::format("relMSE at {:g} s over that of the usual value: so many times longer for the same error, with intervals that hold together with 95 %\n", c.plan.times.back());
    for (const DialSweep& sweep : c.sweeps) {
        text += fmt::format("{:<26} {} is usual\n", sweep.name, sweep.usual_value);
        for (const std::size_t other : sweep.others) {
            const std::string& name = c.measurements[other].candidate.name;
            text += fmt::format("  {:<28} {:<44} {}\n", name, price_text(c, sweep, other), c.judgement.summaries[other].bias.significant() ? sentence(c.judgement.summaries[other].bias) : "");
        }
    }
    return text;
}

}  // namespace

std::string to_table(const Comparison& c)
{
    std::size_t width = 9;
    for (const Measurement& m : c.measurements) width = std::max(width, m.candidate.name.size());
    std::string text = fmt::format("reference: {}\nerror (root of relMSE), median of {} runs (lowest to highest)\n{:<{}}", terminal_safe(c.reference.origin),
                                   c.measurements.empty() ? 0 : c.measurements.front().runs.size(), "", width);
    for (const double time : c.plan.times) text += fmt::format("  {:<24}", fmt::format("{:g} s", time));
    for (std::size_t i = 0; i < c.measurements.size(); ++i) {
        text += fmt::format("\n{:<{}}", c.measurements[i].candidate.name, width);
        for (const ErrorAt& at : c.judgement.summaries[i].at_times) text += fmt::format("  {:<24}", error_text(at));
    }
    text += "\n";
    for (std::size_t i = 0; i < c.measurements.size(); ++i) {
        const Summary& s = c.judgement.summaries[i];
        text += fmt::format("{:<{}}  {}\n", c.measurements[i].candidate.name, width, sentence(s.bias));
        if (s.runs_with_outliers)
            text += fmt::format("{:<{}}  outliers: in {} of {} runs a thousandth of the values holds up to {:.0f} % of the squared error\n", "", width, s.runs_with_outliers,
                                c.measurements[i].runs.size(), 100 * s.share_of_largest);
    }
    if (!c.sweeps.empty()) return text + dial_table(c);
    for (const Verdict& verdict : c.judgement.verdicts)
        if (verdict.seconds == c.plan.times.back()) text += sentence(verdict, c.measurements) + "\n";
    return text;
}

}  // namespace tyndall

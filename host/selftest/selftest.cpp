#include "selftest/selftest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "tyndall/error.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "selftest/evaluate.hpp"
// clang-format on

namespace tyndall {

static_assert(CASE_FAMILIES == every_case_family);

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string lower(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
    return result;
}

bool among(int row, std::uint32_t families)
{
    const auto belongs = [&](const auto& entry) { return entry.row == row && (family_of(entry.sampler) & families); };
    return std::ranges::any_of(golden_floats().sets, belongs) || std::ranges::any_of(golden_floats().means, belongs);
}

std::vector<int> selected_rows(const std::vector<std::string>& only, std::uint32_t families)
{
    const auto rows = golden_rows();
    std::vector<int> selected;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (among(static_cast<int>(i), families) && (only.empty() || std::ranges::any_of(only, [&](const std::string& part) { return lower(rows[i]).find(lower(part)) != std::string::npos; })))
            selected.push_back(static_cast<int>(i));
    if (selected.empty()) throw UsageError(fmt::format("--only \"{}\": no case is named so; `tyndall selftest` lists them all", fmt::join(only, ", ")));
    return selected;
}

template <class Real>
std::vector<std::array<Real, 4>> on_host(unsigned sampler, const std::vector<std::array<Real, 14>>& in)
{
    std::vector<std::array<Real, 4>> out;
    for (const auto& i : in) out.push_back(evaluate_on_host<Real>(sampler, i));
    return out;
}

/// One row, timed.
template <class Real>
std::pair<SelftestOutcome, std::vector<SelftestLaunch<Real>>> run_row(int row, const GoldenTable<Real>& table, const SelftestEvaluator<Real>& evaluate)
{
    const Clock::time_point start = Clock::now();
    auto launches = evaluate_row(row, table, evaluate);
    SelftestOutcome outcome = judge_row(row, launches);
    outcome.seconds = seconds_since(start);
    return {std::move(outcome), std::move(launches)};
}

template <class Real>
void run_on_host(SelftestResult& result, const std::vector<int>& rows, const GoldenTable<Real>& table, const char* where)
{
    for (const int row : rows) {
        result.outcomes.push_back(run_row<Real>(row, table, on_host<Real>).first);
        result.outcomes.back().where = where;
    }
}

void run_on_device(SelftestResult& result, const std::vector<int>& rows, CaseEvaluator evaluator)
{
    const int lanes = evaluator.lanes();
    const auto evaluate = [&](unsigned sampler, const std::vector<std::array<float, 14>>& in) { return evaluator.evaluate(sampler, in); };
    evaluate(0, {golden_floats().sets.front().in});  // some drivers finish compiling at the first launch: no row's time
    result.programs.push_back({lanes, evaluator.source(), evaluator.options()});
    for (const int row : rows) {
        auto [outcome, launches] = run_row<float>(row, golden_floats(), evaluate);
        outcome.where = "device", outcome.lanes = lanes;
        for (SelftestLaunch<float>& launch : launches)
            if (judge_row<float>(row, {launch}).misses) result.failed.push_back({outcome.name, lanes, std::move(launch)});
        result.outcomes.push_back(std::move(outcome));
    }
}

}  // namespace

bool SelftestResult::passed() const
{
    return std::ranges::all_of(outcomes, [](const SelftestOutcome& outcome) { return outcome.misses == 0; });
}

SelftestResult run_selftest(const SelftestRequest& request)
{
    const Clock::time_point start = Clock::now();
    const std::vector<int> rows = selected_rows(request.only, request.families);
    Device device(request.device);
    SelftestResult result{.device = device.info()};
    if (request.host) {
        run_on_host(result, rows, golden_floats(), "host float");
        run_on_host(result, rows, golden_doubles(), "host double");
    }
    const std::vector<int> lanes = request.lanes.empty() ? std::vector{device.info().default_lanes} : request.lanes;
    for (const int width : lanes) run_on_device(result, rows, CaseEvaluator(device, width, request.source, request.families));
    result.seconds = seconds_since(start);
    return result;
}

std::uint32_t family_of(unsigned sampler)
{
    if (sampler < SAMPLER_WARP_10) return CASES_PLAIN;
    if (sampler < SAMPLER_MARGINAL_8X6) return CASES_PRODUCTS;
    if (sampler < SAMPLER_PHASE_OF) return CASES_MARGINALS;
    return sampler < SAMPLER_GRID ? CASES_LOBES : CASES_GRIDS;
}

std::string sampler_name(unsigned sampler)
{
    constexpr std::array names{"rod", "angle", "pair", "phase", "scatter", "distance", "surface", "linear", "balance", "ratio", "rod_pdf", "warp_10", "warp_10t", "warp_6t", "warp_4t",
                               "marginal_8x6", "marginal_4x4", "marginal_3x2", "rayleigh", "table", "both_ways", "blend", "spike", "warp_rayleigh", "warp_table",
                               "warp_both_ways", "warp_blend", "warp_spike", "grid_pair", "grid_holes", "grid_sheared", "grid_coloured"};
    static_assert(names.size() == SAMPLER_COUNT);
    return sampler < names.size() ? names[sampler] : std::to_string(sampler);
}

}  // namespace tyndall

// Writes index.html and comparison.json of a comparison whose truth is known, into the folder that is named: no clock, so the page is always the same.
#include <cstdio>

#include "../comparison/synthetic_renderer.hpp"
#include "comparison/comparison_json.hpp"
#include "film/atomic_file.hpp"
#include "report/comparison_page.hpp"

namespace tyndall::test {
namespace {

/// The first makes the reference. Then a plain method, one that is biased by 3 %, one whose first pass takes long, and one with a stray value.
const std::vector<SyntheticMethod> methods{{.noise = .2}, {}, {.bias = .03}, {.noise = .2, .pass_seconds = 3}, {.outlier = 300}};

void write(const std::filesystem::path& folder)
{
    const std::vector<double> times{2, 10};
    const RenderFunction render = synthetic_renderer(methods);
    const MadeReference made = make_reference(render, {}, 400, [] { return false; });
    const MeasuringPlan plan{.times = times, .repeats = 3};
    const std::vector<Candidate> candidates{candidate("plain", 1), candidate("biased", 2), candidate("slow start", 3), candidate("stray value", 4)};
    const MeasuringHooks hooks{[] { return false; }, [](const std::string&) {}, [] { return 0.; }};
    const auto measurements = measure(candidates, made.reference, plan, render, hooks);
    const Judgement judgement = judge(measurements, made.reference, times, all_pairs(measurements.size()));
    const ComparisonAbout about{.version = "test", .scene_file = "a/scene.xml", .layer = "image", .warnings = {"</script><b>a warning that looks like markup</b>"}, .command = "tyndall compare a/scene.xml",
                                .render_commands = std::vector<std::string>(candidates.size(), "tyndall render a/scene.xml")};
    const std::vector<DialSweep> sweeps{{"noise", "plain", 0, {1, 2}}, {"luck", "plain", 0, {3}}};
    const Comparison comparison{about, made.reference, plan, measurements, judgement, {}};
    write_atomically(folder / "comparison.json", to_json(comparison));
    write_atomically(folder / "index.html", comparison_page(to_page_data(comparison)));
    const Judgement of_dials = judge(measurements, made.reference, times, pairs_of(sweeps));
    write_atomically(folder / "dials.html", comparison_page(to_page_data({about, made.reference, plan, measurements, of_dials, sweeps})));
}

}  // namespace
}  // namespace tyndall::test

int main(int argc, char** argv)
{
    if (argc != 2) return std::fputs("usage: write_page FOLDER\n", stderr), 2;
    tyndall::test::write(argv[1]);
}

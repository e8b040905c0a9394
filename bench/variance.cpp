/// Variance over squared mean of one pair's estimate, per sampler, on a grid of extinction x asymmetry, as JSON on standard output.
///     variance [PAIRS [SAMPLES]]
/// The kernels' own mathematics on the host, in double; nothing occludes, media are homogeneous and grey. bench/variance.py makes tables of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/variance_pairs.hpp"

namespace tyndall::bench {
namespace {

using namespace maths_double;

struct Cell {
    double sigma, g;
};

/// The estimate of one sample: its value over the density of its place.
using Estimate = std::function<double(const VariancePair&, const Cell&, Random2)>;
struct Sampler {
    std::string name;
    Estimate estimate;
};

/// Product of phase functions times transmittance at the places v and u.
double carried(const VariancePair& p, const Cell& c, double v, double u)
{
    const real3 d = along3(along3(p.q, v, p.b), -u, p.a);
    const double w = length3(d);
    const real3 to_eye = make_real3(-d.x / w, -d.y / w, -d.z / w);
    return phase_henyey_greenstein(p.b, to_eye, c.g) * phase_henyey_greenstein(to_eye, make_real3(-p.a.x, -p.a.y, -p.a.z), c.g) * std::exp(-c.sigma * (v + u + w));
}

GuideMedia media(const Cell& c) { return {c.g, c.g, c.sigma, c.sigma, c.sigma}; }

/// What a marginal leaves to a conditional of so many vertices; 0: the even angle.
double with_conditional(const VariancePair& p, const Cell& c, const RodSample& rod, int vertices, bool absorbs, double xi)
{
    const real3 at = along3(p.q, rod.v, p.b);
    PhaseWarp warp = {xi, 1};
    if (vertices > 0 && (absorbs || c.g != 0)) warp = sample_phase_product(at, p.a, p.eye_length, p.b, media(c), {vertices, c.g != 0, absorbs}, xi);
    const AngleSample angle = sample_equiangular(at, p.a, p.eye_length, warp.x);
    return pair_weight(rod, angle) / warp.density * carried(p, c, rod.v, angle.u);
}

Sampler paper(std::string name, int vertices, bool absorbs)
{
    return {std::move(name), [=](const VariancePair& p, const Cell& c, Random2 xi) {
                return with_conditional(p, c, sample_rod(p.q, p.a, p.b, p.light_length, xi.first), vertices, absorbs, xi.second);
            }};
}

Sampler table(std::string name, int nodes, int angles, int vertices)
{
    return {std::move(name), [=](const VariancePair& p, const Cell& c, Random2 xi) {
                const RodSample rod = sample_rod_table(p.q, p.a, p.b, p.light_length, p.eye_length, media(c), {nodes, angles, c.g != 0}, xi.first);
                return with_conditional(p, c, rod, vertices, true, xi.second);
            }};
}

/// A virtual point light per sample: the place on the light in proportion to the transmittance along it, the place on the eye segment equi-angular.
double point_light(const VariancePair& p, const Cell& c, Random2 xi)
{
    const double v = sample_distance(c.sigma, p.light_length, xi.first);
    const AngleSample angle = sample_equiangular(along3(p.q, v, p.b), p.a, p.eye_length, xi.second);
    return angle.angle_over_distance / pdf_distance(c.sigma, p.light_length, v) * carried(p, c, v, angle.u);
}

const std::vector<Sampler>& samplers()
{
    static const std::vector<Sampler> all{{"vpl", point_light},           paper("paper-isotropic", 0, false), paper("paper", 10, false),
                                          paper("paper-6", 6, true),      table("table", 8, 6, 10),           table("table-4x4", 4, 4, 6),
                                          table("table-3x2", 3, 2, 4)};
    return all;
}

struct Moments {
    double sum = 0, squares = 0;
    int count = 0;
    void add(double x) { sum += x, squares += x * x, ++count; }
    double mean() const { return sum / count; }
    /// Around its own mean, over the square of a better one.
    double relative_variance(double true_mean) const { return std::max(squares - sum * sum / count, 0.) / ((count - 1) * true_mean * true_mean); }
};

/// Means of `together` samples at a time.
Moments moments(const Sampler& sampler, const VariancePair& pair, const Cell& cell, std::uint32_t key, int samples, int together, bool sobol)
{
    Moments m;
    for (int run = 0; run < samples / together; ++run) {
        double mean = 0;
        for (int i = 0; i < together; ++i) {
            const Random2 xi = sobol ? scrambled_sobol2(mix_scalar(key) + std::uint32_t(run), std::uint32_t(i)) : random2(mix_scalar(key), std::uint32_t(run * together + i));
            mean += sampler.estimate(pair, cell, xi) / together;
        }
        m.add(mean);
    }
    return m;
}

/// Mean over the pairs of variance over squared mean, its standard error over the pairs, and the largest deviation of a pair's mean from the table's in its standard errors.
struct Row {
    double mean = 0, error = 0, bias = 0;
};
Row measured(const Sampler& sampler, const std::vector<VariancePair>& pairs, const std::vector<Moments>& truth, const Cell& cell, int samples, int together, bool sobol)
{
    Moments over_pairs;
    Row row;
    double difference = 0, variance = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double mean = truth[i].mean();
        const Moments m = moments(sampler, pairs[i], cell, std::uint32_t(i) * 977u + 1u, samples, together, sobol);
        over_pairs.add(m.relative_variance(mean));
        difference += m.mean() / mean - 1;
        variance += m.relative_variance(mean) / m.count + truth[i].relative_variance(mean) / truth[i].count;
    }
    row.mean = over_pairs.mean();
    row.error = std::sqrt(std::max(over_pairs.squares / over_pairs.count - row.mean * row.mean, 0.) / over_pairs.count);
    row.bias = difference / std::sqrt(variance);
    return row;
}

/// Samples of one pair at a time, and from which numbers.
struct Drawing {
    const char* sequence;
    int together;
};

void print_column(const Cell& cell, const std::vector<VariancePair>& pairs, int samples, std::span<const Sampler> compared, std::span<const Drawing> drawings, bool last)
{
    std::vector<Moments> truth;
    for (std::size_t i = 0; i < pairs.size(); ++i) truth.push_back(moments(samplers()[4], pairs[i], cell, std::uint32_t(i) * 977u + 500000u, 4 * samples, 16, true));
    std::printf("  {\"sigma_t\": %g, \"g\": %g, \"samplers\": {", cell.sigma, cell.g);
    const char* comma = "";
    for (const auto& [sequence, together] : drawings)
        for (const Sampler& sampler : compared) {
            if (together == 4 && sampler.name == "vpl") continue;
            const Row row = measured(sampler, pairs, truth, cell, samples, together, std::string(sequence) == "sobol");
            const std::string name = together == 1 ? sampler.name : sampler.name + ", 4 " + sequence;
            std::printf("%s\n    \"%s\": {\"variance\": %.4g, \"standard_error\": %.2g, \"bias_in_standard_errors\": %.2f}", comma, name.c_str(), row.mean, row.error, row.bias);
            comma = ",";
        }
    std::printf("\n  }}%s\n", last ? "" : ",");
    std::fflush(stdout);
}

/// `name`: of the list in the output.
void print_columns(const char* name, std::span<const double> asymmetries, const std::vector<VariancePair>& pairs, int samples, std::span<const Sampler> compared,
                   std::span<const Drawing> drawings)
{
    std::printf("\"%s\": [\n", name);
    for (const double g : asymmetries)
        for (const double sigma : {.1, 1., 4.}) print_column({sigma, g}, pairs, samples, compared, drawings, g == asymmetries.back() && sigma == 4);
    std::printf("]");
}

}  // namespace
}  // namespace tyndall::bench

int main(int argc, char** argv)
{
    using namespace tyndall::bench;
    const int count = argc > 1 ? std::atoi(argv[1]) : 1000, samples = argc > 2 ? std::atoi(argv[2]) : 2000;
    if (count < 1 || samples < 4) return std::fprintf(stderr, "usage: variance [PAIRS [SAMPLES]]: at least 1 and 4\n"), 2;
    const auto pairs = variance_pairs(2012, count);
    std::printf("{\"pairs\": %d, \"samples\": %d, \"seed\": 2012, ", count, samples);
    constexpr std::array all{Drawing{"random", 1}, Drawing{"random", 4}, Drawing{"sobol", 4}};
    constexpr std::array one{Drawing{"random", 1}};
    print_columns("columns", std::array{0., .55, .9}, pairs, samples, samplers(), all);
    std::printf(", ");
    // Where the product of phase functions begins to win: the samplers that `auto` chooses from, at more asymmetries.
    print_columns("crossing", std::array{.2, .3, .45, .55, .6, .7, .8, .9, .95}, pairs, samples, std::span(samplers()).subspan(1, 3), one);
    std::puts("}");
}

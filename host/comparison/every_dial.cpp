#include "comparison/every_dial.hpp"

#include <fmt/format.h>

#include "lights/light_technique.hpp"
#include "pipeline/layer_plan.hpp"
#include "tyndall/error.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

constexpr std::string_view set_on = " · ";

struct Builder {
    EveryDial all;

    /// A sweep around candidate `usual`; without any value there is none.
    void add(const std::string& name, std::size_t usual, const std::string& usual_value, const std::vector<DialValue>& values)
    {
        if (values.empty()) return;
        DialSweep sweep{name, usual_value, usual, {}};
        for (const DialValue& value : values) {
            Candidate candidate{all.candidates[usual].name + std::string(set_on) + value.name, all.candidates[usual].settings};
            value.set(candidate.settings);
            sweep.others.push_back(all.candidates.size());
            all.candidates.push_back(std::move(candidate));
        }
        all.sweeps.push_back(std::move(sweep));
    }

    template <class Value, std::size_t count>
    void add_named(const std::string& name, const std::array<Named<Value>, count>& table, std::initializer_list<Value> values, Value usual, Value RenderSettings::*member)
    {
        std::vector<DialValue> others;
        for (const Value value : values)
            if (value != usual) others.push_back({std::string(name_in(table, value)), [=](RenderSettings& s) { s.*member = value; }});
        add(name, 0, std::string(name_in(table, usual)), others);
    }
};

std::vector<DialValue> numbers_of_lights(std::uint32_t usual)
{
    std::vector<DialValue> values;
    for (const std::uint32_t lights : {usual / 4, 4 * usual}) values.push_back({fmt::format("{} lights", lights), [=](RenderSettings& s) { s.lights = lights; }});
    return values;
}

/// How many of the lights each pixel is connected to. The number of lights stays what it was by rule.
std::vector<DialValue> choices(const UsualValues& usual)
{
    std::vector<DialValue> values;
    const std::uint32_t lights = usual.lights;
    for (const std::uint32_t chosen : {usual.selected / 4, 4 * usual.selected}) {
        if (chosen == 0 || chosen >= lights) continue;
        values.push_back({fmt::format("{} chosen", chosen), [=](RenderSettings& s) { s.selection = Selection::tile, s.selected_lights = chosen, s.lights = lights; }});
    }
    if (usual.selected < lights) values.push_back({"all connected", [=](RenderSettings& s) { s.selection = Selection::all, s.lights = lights; }});
    return values;
}

std::vector<DialValue> lane_widths(int usual)
{
    std::vector<DialValue> values;
    for (const int lanes : {1, 4, 8, 16})
        if (lanes != usual) values.push_back({fmt::format("{} lanes", lanes), [=](RenderSettings& s) { s.lanes = lanes, s.lanes_calibrated = false; }});
    return values;
}

std::vector<DialValue> samples_per_pair()
{
    std::vector<DialValue> values;
    for (const int samples : {2, 4}) values.push_back({fmt::format("{} samples", samples), [=](RenderSettings& s) { s.samples_per_pair = samples; }});
    return values;
}

void add_lights_and_kernels(Builder& b, const UsualValues& usual)
{
    using enum Sampler;
    if (usual.anisotropic) b.add_named("sampler", sampler_names, {paper_isotropic, paper, paper_6, table}, usual.sampler, &RenderSettings::sampler);
    else b.add_named("sampler", sampler_names, {paper_isotropic, table}, usual.sampler, &RenderSettings::sampler);
    b.add("virtual lights per pass", 0, fmt::to_string(usual.lights), numbers_of_lights(usual.lights));
    b.add("of which each pixel meets", 0, usual.selected < usual.lights ? fmt::to_string(usual.selected) : "all", choices(usual));
    b.add("samples per pair", 0, "1", samples_per_pair());
    b.add_named("numbers of light paths", sequence_names, {Sequence::random}, Sequence::sobol, &RenderSettings::emission);
    b.add_named("numbers of samples", sequence_names, {Sequence::sobol}, Sequence::random, &RenderSettings::sequence);
    if (technique_of(b.all.candidates[0].settings.method)->is_line)
        b.add_named("length of lights", segment_length_names, {SegmentLength::short_}, SegmentLength::long_, &RenderSettings::segment_length);
    if (usual.grids) b.add_named("transmittance", transmittance_names, {GridTransmittance::exact}, GridTransmittance::march, &RenderSettings::transmittance);
    b.add("lane width", 0, fmt::to_string(usual.lanes), lane_widths(usual.lanes));
    if (usual.fp64) b.add_named("precision", precision_names, {Precision::f64}, Precision::f32, &RenderSettings::precision);
    b.add_named("kernel arithmetic", math_names, {KernelMath::fast}, KernelMath::strict, &RenderSettings::math);
}

/// In the first pass, of the lights of a method that have one.
double usual_radius(Method method)
{
    const Recipe recipe = recipe_of(method);
    return recipe.gathered.empty() ? recipe.connected->usual_radius : recipe.gathered.front().technique->usual_radius;
}

/// Clamps and radii, around the biased methods of the first sweep.
void add_bounds(Builder& b)
{
    const std::size_t methods = b.all.candidates.size();
    for (std::size_t i = 0; i < methods; ++i) {
        const Method method = b.all.candidates[i].settings.method;
        if (is_clamped(method)) {
            std::vector<DialValue> values;
            for (const double clamp : {10., 1000.}) values.push_back({fmt::format("clamp {:g}", clamp), [=](RenderSettings& s) { s.clamp = clamp; }});
            b.add(fmt::format("clamp of {}", method.name()), i, fmt::format("{:g}", usual_clamp), values);
        }
        if (is_thick(method)) {
            const double usual = usual_radius(method);
            std::vector<DialValue> values;
            for (const double radius : {.4 * usual, 2 * usual}) values.push_back({fmt::format("radius {:g}", radius), [=](RenderSettings& s) { s.beam_radius = radius; }});
            b.add(fmt::format("radius of {}", method.name()), i, fmt::format("{:g}", usual), values);
        }
    }
}

}  // namespace

EveryDial every_dial(const RenderSettings& base, const UsualValues& usual)
{
    if (!uses_virtual_lights(base.method)) throw UsageError(fmt::format("--dials turns those of a method with virtual lights, and \"{}\" has none", base.method.name()));
    Builder b;
    b.all.candidates.push_back({std::string(base.method.name()), base});
    DialSweep methods{"method", std::string(base.method.name()), 0, {}};
    for (const Method method : all_methods()) {
        if (method == base.method) continue;
        methods.others.push_back(b.all.candidates.size());
        b.all.candidates.push_back({std::string(method.name()), base});
        b.all.candidates.back().settings.method = method;
    }
    b.all.sweeps.push_back(std::move(methods));
    add_bounds(b);
    add_lights_and_kernels(b, usual);
    return std::move(b.all);
}

std::string value_name(std::string_view usual, std::string_view candidate)
{
    const std::string start = std::string(usual) + std::string(set_on);
    if (candidate.starts_with(start)) candidate.remove_prefix(start.size());
    return std::string(candidate);
}

std::vector<std::pair<std::size_t, std::size_t>> pairs_of(const std::vector<DialSweep>& sweeps)
{
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const DialSweep& sweep : sweeps)
        for (const std::size_t other : sweep.others) pairs.emplace_back(sweep.usual, other);
    return pairs;
}

}  // namespace tyndall

#pragma once
/// The names of settings on the command line, in reports and on pages. A new enumerator gets its line here, and every command knows it.
#include <array>
#include <string_view>

#include "tyndall/settings.hpp"

namespace tyndall {

template <class Value>
struct Named {
    std::string_view name;
    Value value;
};

inline constexpr std::array sampler_names{Named<Sampler>{"auto", Sampler::automatic},
                                          Named<Sampler>{"paper-isotropic", Sampler::paper_isotropic},
                                          Named<Sampler>{"paper", Sampler::paper},
                                          Named<Sampler>{"paper-6", Sampler::paper_6},
                                          Named<Sampler>{"table", Sampler::table},
                                          Named<Sampler>{"table-4x4", Sampler::table_4x4},
                                          Named<Sampler>{"table-3x2", Sampler::table_3x2}};
inline constexpr std::array sequence_names{Named<Sequence>{"auto", Sequence::automatic}, Named<Sequence>{"random", Sequence::random}, Named<Sequence>{"sobol", Sequence::sobol}};
inline constexpr std::array transmittance_names{Named<GridTransmittance>{"march", GridTransmittance::march}, Named<GridTransmittance>{"exact", GridTransmittance::exact}};
inline constexpr std::array selection_names{Named<Selection>{"auto", Selection::automatic}, Named<Selection>{"all", Selection::all}, Named<Selection>{"tile", Selection::tile}};
inline constexpr std::array segment_length_names{Named<SegmentLength>{"long", SegmentLength::long_}, Named<SegmentLength>{"short", SegmentLength::short_}};
inline constexpr std::array precision_names{Named<Precision>{"f32", Precision::f32}, Named<Precision>{"f64", Precision::f64}};
inline constexpr std::array math_names{Named<KernelMath>{"strict", KernelMath::strict}, Named<KernelMath>{"fast", KernelMath::fast}};

/// The name that stands beside `value`; every enumerator has one.
template <class Value, std::size_t count>
constexpr std::string_view name_in(const std::array<Named<Value>, count>& names, Value value)
{
    for (const auto& named : names)
        if (named.value == value) return named.name;
    return {};
}

/// Where the lane width comes from: "rule", "calibration" or "request".
constexpr std::string_view lanes_from(const RenderSettings& settings) { return settings.lanes == 0 ? "rule" : settings.lanes_calibrated ? "calibration" : "request"; }

}  // namespace tyndall

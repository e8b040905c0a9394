#pragma once
/// kernels/selftest/evaluate_cases.cl on a device at one lane width: every sampler of the kernels' mathematics behind one call. Includes no OpenCL header.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "device/device.hpp"

namespace tyndall {

inline constexpr std::size_t case_inputs = 14, case_outputs = 4;
inline constexpr std::uint32_t every_case_family = 31;  ///< CASE_FAMILIES of kernels/selftest/evaluate.h

class CaseEvaluator {
public:
    /// Compiles the families of cases that are asked for. `source`: a kernel text in place of the program's own, for tests that plant an error. Throws BuildError, DeviceError.
    CaseEvaluator(Device& device, int lanes, std::optional<std::string> source = {}, std::uint32_t families = every_case_family);
    ~CaseEvaluator();
    CaseEvaluator(CaseEvaluator&&) noexcept;

    /// One launch: outputs of each set of inputs. Throws DeviceError.
    std::vector<std::array<float, case_outputs>> evaluate(std::uint32_t sampler, std::span<const std::array<float, case_inputs>> in);

    int lanes() const;
    /// What the device's compiler was given: one flat text without includes, and its options.
    const std::string& source() const;
    const std::string& options() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Options that evaluate_cases.cl is built with.
std::string case_options(int lanes, std::uint32_t families = every_case_family);

/// The sets as the kernel's input buffer: field f of set i at f * count + i, count rounded up to whole groups of lanes by repeating the last set.
std::vector<float> packed_inputs(std::span<const std::array<float, case_inputs>> in, int lanes);

}  // namespace tyndall

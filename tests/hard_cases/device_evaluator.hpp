#pragma once
/// evaluate.h on an OpenCL device at one lane width.
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tyndall::test {

class DeviceEvaluator {
public:
    /// The first device of the first platform; throws std::runtime_error with the build log if the kernel does not build.
    explicit DeviceEvaluator(unsigned lanes);
    ~DeviceEvaluator();
    std::vector<std::array<float, 4>> evaluate(unsigned sampler, std::span<const std::array<float, 14>> in) const;
    std::string device_name() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tyndall::test

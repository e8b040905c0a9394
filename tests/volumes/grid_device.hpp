#pragma once
/// evaluate_grid.h on an OpenCL device at one lane width.
#include <memory>

#include "tests/volumes/grid_cases.hpp"

namespace tyndall::test {

class GridDevice {
public:
    /// The first device of the first platform; throws std::runtime_error with the build log if the kernel does not build.
    explicit GridDevice(unsigned lanes);
    ~GridDevice();
    std::vector<std::array<float, 4>> evaluate(const TestGrid& grid, const std::vector<std::array<float, 6>>& segments) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tyndall::test

/// planted_errors KIND: makes the error of that kind, which the sanitizer must find; without one, a loop whose passes share nothing, which it must let pass.
#include <chrono>
#include <cstdio>
#include <limits>
#include <memory>
#include <numeric>
#include <string_view>
#include <thread>
#include <vector>

#include "parallel/parallel_for.hpp"

namespace {

using tyndall::parallel_for;

/// What the passes write before the loop ends is read after it.
int separate_sums(std::size_t count)
{
    std::vector<int> squares(count, 1);
    parallel_for(std::size_t(0), count, [&](std::size_t i) { squares[i] += static_cast<int>(i * i); });
    return std::accumulate(squares.begin(), squares.end(), 0);
}

/// Every pass takes so long that several threads run some.
int shared_sum(std::size_t count)
{
    int sum = 0;
    parallel_for(std::size_t(0), count / 10, [&](std::size_t i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        sum += static_cast<int>(i);
    });
    return sum;
}

int past_the_end(std::size_t count) { return std::make_unique<int[]>(count)[count]; }

int given_back(std::size_t count)
{
    auto numbers = std::make_unique<int[]>(count);
    const int* first = numbers.get();
    numbers.reset();
    return *first;
}

/// Many, because the last may still be seen in a register.
int leaked(std::size_t count)
{
    int sum = 0;
    for (int i = 0; i < 100; ++i) sum += *new int[count]();
    return sum;
}

}  // namespace

int main(int count, char** values)
{
    const std::string_view kind = count > 1 ? values[1] : "none";
    const auto many = static_cast<std::size_t>(count) * 500;
    int result = 0;
    if (kind == "race") result = shared_sum(many);
    else if (kind == "outside") result = past_the_end(many);
    else if (kind == "given_back") result = given_back(many);
    else if (kind == "leak") result = leaked(many);
    else if (kind == "overflow") result = std::numeric_limits<int>::max() + count;
    else if (kind == "conversion") result = static_cast<int>(static_cast<double>(many) * 1e10);
    else result = separate_sums(many);
    std::printf("%d\n", result);
}

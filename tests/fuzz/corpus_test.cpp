/// What fuzzing has found so far, with any compiler: every input of the corpus is read or refused, and nobody writes to standard output.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "targets.hpp"

namespace tyndall::fuzz {
namespace {

struct Target {
    const char* name;
    void (*run)(Bytes);
};
void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, EveryInputIsReadOrRefused)
{
    int inputs = 0;
    testing::internal::CaptureStdout();
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TYNDALL_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name)) {
        SCOPED_TRACE(entry.path().string());
        std::ifstream stream(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        EXPECT_NO_THROW(GetParam().run({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
        ++inputs;
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_GT(inputs, 3);
}

INSTANTIATE_TEST_SUITE_P(Of, Corpus,
                         testing::Values(Target{"scene", scene}, Target{"obj", obj}, Target{"ply", ply}, Target{"vol", vol}, Target{"vdb", vdb}, Target{"exr", exr}, Target{"picture", picture},
                                         Target{"checkpoint", checkpoint}, Target{"shards", shards}, Target{"numbers", numbers}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace tyndall::fuzz

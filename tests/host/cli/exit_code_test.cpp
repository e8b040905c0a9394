#include "cli/exit_code.hpp"

#include <gtest/gtest.h>

#include <new>
#include <string>

#include "tyndall/error.hpp"

namespace tyndall {
namespace {

struct Ended {
    int code;
    std::string message;
};

template <class Exception>
Ended ended_by(const Exception& exception)
{
    testing::internal::CaptureStderr();
    int code = -1;
    try {
        throw exception;
    } catch (...) {
        code = report_failure();
    }
    return {code, testing::internal::GetCapturedStderr()};
}

TEST(ExitCode, EveryErrorHasItsOwn)
{
    EXPECT_EQ(ended_by(Error("x")).code, 1);
    EXPECT_EQ(ended_by(UsageError("x")).code, 2);
    EXPECT_EQ(ended_by(SceneError("x")).code, 3);
    EXPECT_EQ(ended_by(NoDeviceError("x")).code, 4);
    EXPECT_EQ(ended_by(DeviceError("x")).code, 5);
    EXPECT_EQ(ended_by(BuildError("x")).code, 5);
    EXPECT_EQ(ended_by(IoError("x")).code, 6);
    EXPECT_EQ(ended_by(TemporaryError("x")).code, 75);
    EXPECT_EQ(ended_by(std::bad_alloc()).code, 1);
    EXPECT_EQ(ended_by(42).code, 1);
}

TEST(ExitCode, MessagesAreSentencesOnOurBehalf)
{
    EXPECT_EQ(ended_by(SceneError("scene.xml:1:2: bad")).message, "tyndall: scene.xml:1:2: bad\n");
    EXPECT_NE(ended_by(std::runtime_error("odd")).message.find("please report it"), std::string::npos);
    EXPECT_NE(ended_by(std::bad_alloc()).message.find("not enough memory"), std::string::npos);
}

TEST(ExitCode, MessagesKeepLinesButNoEscapeCodes)
{
    EXPECT_EQ(ended_by(BuildError("log:\n  a\x1b[31m")).message, "tyndall: log:\n  a\\x1b[31m\n");
}

}  // namespace
}  // namespace tyndall

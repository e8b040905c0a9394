#pragma once
/// The same with the program: exit code, message and files.
#include "../cli/program_fixture.hpp"

namespace tyndall::test {

class ProgramSweep : public Program {
protected:
    ProcessResult render(const std::string& faults)
    {
        ProcessSetup setup = here();
        setup.environment = {{"LD_PRELOAD", TYNDALL_FAULTY_OPENCL_LIBRARY}, {"TYNDALL_FAULTY_OPENCL", faults}, {"ASAN_OPTIONS", "verify_asan_link_order=0"}};
        return run({"render", "scene.xml", "-o", "image.exr", "--passes", "1", "--resolution", "8x8", "--lights", "64", "--no-selftest", "--no-timestamps", "--progress", "none"}, setup);
    }

    /// Every `step`-th call from `first` fails, with codes in turn, once or for ever.
    void sweep(long first, long step)
    {
        ASSERT_EQ(render("").exit_code, 0);
        const std::string expected = file_bytes(folder / "image.exr");
        const std::vector<std::string> outputs = files();
        long failed = 0, runs = 0;
        for (long n = first;; n += step, ++runs) {
            write_file("image.exr", "old");
            const std::string faults = "say=1 queries=1 fail_at=" + std::to_string(n) + " error=" + std::to_string(std::array{-5, -36, -4, -14, -6}[static_cast<std::size_t>(runs % 5)]) +
                                       (runs % 3 == 1 ? " late=1" : "") + (runs % 2 == 1 ? " failures=1000000" : "");
            const ProcessResult r = render(faults);
            ASSERT_EQ(r.signal, 0) << faults << '\n' << r.err;  // 9: it hung, and was killed
            if (r.err.find("faulty OpenCL:") == std::string::npos) break;  // fewer calls than that
            ASSERT_THAT(r.exit_code, testing::AnyOf(0, 4, 5)) << faults << ", signal " << r.signal << '\n' << r.err;
            EXPECT_EQ(file_bytes(folder / "image.exr"), r.exit_code == 0 ? expected : "old") << faults << '\n' << r.err;
            EXPECT_EQ(files(), outputs) << faults;
            if (r.exit_code == 0) continue;
            ++failed;
            EXPECT_THAT(r.err, testing::HasSubstr("tyndall: ")) << faults;
        }
        EXPECT_GT(runs, 80 / step);
        EXPECT_GT(failed, 20 / step);
    }
};

}  // namespace tyndall::test

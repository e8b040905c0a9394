#include "cli/exit_code.hpp"

#include <cstdio>
#include <new>
#include <string>

#include "report/readable.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

/// Messages may have several lines (a kernel's build log) and may quote files: escape what is not text, line by line.
std::string terminal_safe_lines(const std::string& text)
{
    std::string clean;
    std::size_t start = 0;
    for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
        clean += terminal_safe(text.substr(start, end - start)) + "\n";
    return clean + terminal_safe(text.substr(start));
}

int ends(ExitCode code, const std::string& message)
{
    std::fprintf(stderr, "tyndall: %s\n", terminal_safe_lines(message).c_str());
    return static_cast<int>(code);
}

int code_of_current_exception()
{
    try {
        throw;
    } catch (const UsageError& error) {
        return ends(ExitCode::usage, error.what());
    } catch (const SceneError& error) {
        return ends(ExitCode::input, error.what());
    } catch (const NoDeviceError& error) {
        return ends(ExitCode::no_device, error.what());
    } catch (const DeviceError& error) {
        return ends(ExitCode::device_failed, error.what());
    } catch (const TemporaryError& error) {
        return ends(ExitCode::temporary, error.what());
    } catch (const IoError& error) {
        return ends(ExitCode::output, error.what());
    } catch (const std::bad_alloc&) {
        return ends(ExitCode::internal,
                    "not enough memory; lower --resolution or --lights, keep fewer layers with --layer, or close other programs");
    } catch (const std::exception& error) {
        return ends(ExitCode::internal,
                    std::string("internal error: ") + error.what() + "; please report it with the command line and the scene");
    } catch (...) {
        return ends(ExitCode::internal, "internal error of an unknown kind; please report it with the command line and the scene");
    }
}

}  // namespace

int report_failure() noexcept
{
    try {
        return code_of_current_exception();
    } catch (...) {
        std::fputs("tyndall: out of memory\n", stderr);
        return static_cast<int>(ExitCode::internal);
    }
}

}  // namespace tyndall

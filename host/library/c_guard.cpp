#include "library/c_guard.hpp"

#include <new>

#include "library/c_handles.hpp"

namespace tyndall {
namespace {

thread_local std::string last_error;

tyndall_status status_of(const std::exception& error)
{
    const auto is = [&]<typename Type>(const Type*) { return dynamic_cast<const Type*>(&error) != nullptr; };
    if (is(static_cast<UsageError*>(nullptr))) return TYNDALL_USAGE_ERROR;
    if (is(static_cast<SceneError*>(nullptr))) return TYNDALL_SCENE_ERROR;
    if (is(static_cast<NoDeviceError*>(nullptr))) return TYNDALL_NO_DEVICE;
    if (is(static_cast<DeviceError*>(nullptr))) return TYNDALL_DEVICE_ERROR;
    if (is(static_cast<TemporaryError*>(nullptr))) return TYNDALL_TEMPORARY_ERROR;
    if (is(static_cast<IoError*>(nullptr))) return TYNDALL_IO_ERROR;
    return TYNDALL_INTERNAL_ERROR;
}

void keep(const char* text) noexcept
{
    try {
        last_error = text;
    } catch (...) {
        last_error.clear();  // no memory for a sentence
    }
}

}  // namespace

tyndall_status note_failure() noexcept
{
    try {
        throw;
    } catch (const std::bad_alloc&) {
        keep("out of memory");
    } catch (const std::exception& error) {
        keep(error.what());
        return status_of(error);
    } catch (...) {
        keep("an unknown error");
    }
    return TYNDALL_INTERNAL_ERROR;
}

}  // namespace tyndall

extern "C" {

const char* tyndall_last_error(void) { return tyndall::last_error.c_str(); }
int tyndall_abi_version(void) { return TYNDALL_ABI_VERSION; }

const char* tyndall_version(void)
{
    static const std::string text = tyndall::api::version();
    return text.c_str();
}

}  // extern "C"

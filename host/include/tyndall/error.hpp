#pragma once
/// What can go wrong, by who can mend it. Every message says what happened, where, and what to do.
#include <stdexcept>
#include <string>

namespace tyndall {

/// Base of all errors that Tyndall throws on purpose. Programming mistakes are asserts instead.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};
/// The request makes no sense: a setting out of range, options that exclude each other. Exit code 2.
struct UsageError : Error {
    using Error::Error;
};
/// A scene or another input file is invalid or not supported; the message starts with `file:line:column:`. Exit code 3.
struct SceneError : Error {
    using Error::Error;
};
/// No usable OpenCL device. Exit code 4.
struct NoDeviceError : Error {
    using Error::Error;
};
/// An OpenCL device failed while it was used. Exit code 5.
struct DeviceError : Error {
    using Error::Error;
};
/// It lacks memory or other resources for what was asked at once: less at a time may do. Exit code 5.
struct ResourceError : DeviceError {
    using DeviceError::DeviceError;
};
/// A kernel did not compile; the message holds device, options and log. Exit code 5.
struct BuildError : DeviceError {
    using DeviceError::DeviceError;
};
/// A result could not be written (or an image not be read). Exit code 6.
struct IoError : Error {
    using Error::Error;
};
/// The same, for a reason that may be gone at another try: a file server that does not answer. Exit code 75.
struct TemporaryError : IoError {
    using IoError::IoError;
};

}  // namespace tyndall

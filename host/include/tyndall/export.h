#ifndef TYNDALL_EXPORT_H
#define TYNDALL_EXPORT_H
/// TYNDALL_API marks what the shared library exports; everything else in it is hidden.
#if defined(__GNUC__)
#define TYNDALL_API __attribute__((visibility("default")))
#else
#define TYNDALL_API
#endif
#endif

#pragma once
/// A locale that writes decimal commas, made on the spot from Debian's package `locales`: a minimal machine has none.
#include <clocale>
#include <filesystem>
#include <locale>
#include <string>

#include "child_process.hpp"
#include "environment_variable.hpp"
#include "temporary_folder.hpp"

namespace tyndall::test {

/// A folder for LOCPATH that holds de_DE.UTF-8.
class CommaLocaleFiles {
public:
    CommaLocaleFiles()
    {
        const ProcessResult made = run_process({"/usr/bin/localedef", "-i", "de_DE", "-f", "UTF-8", (files_ / name()).string()}, {});
        if (made.exit_code != 0) throw std::runtime_error("localedef made no locale; is Debian's package locales installed? " + made.err);
    }
    static const char* name() { return "de_DE.UTF-8"; }
    std::string folder() const { return files_.path().string(); }

private:
    TemporaryFolder files_;
};

/// Once for all tests of a program.
inline const CommaLocaleFiles& comma_locale_files()
{
    static const CommaLocaleFiles files;
    return files;
}

/// That locale for C and C++ as long as it lives, as in a program that calls setlocale(LC_ALL, "") and renders by the library.
class CommaLocale {
public:
    CommaLocale() : path_("LOCPATH", comma_locale_files().folder().c_str()), before_c_(std::setlocale(LC_ALL, nullptr)), before_(std::locale::global(std::locale(CommaLocaleFiles::name())))
    {
        if (std::string(std::localeconv()->decimal_point) != ",") throw std::runtime_error("the locale has no decimal comma");
    }
    ~CommaLocale()
    {
        std::locale::global(before_);
        std::setlocale(LC_ALL, before_c_.c_str());
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

private:
    EnvironmentVariable path_;
    std::string before_c_;
    std::locale before_;
};

}  // namespace tyndall::test

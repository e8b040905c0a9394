/// Started with this in LD_PRELOAD, a program runs in the locale of its environment, which must have a decimal comma: as if it had called setlocale itself.
#include <clocale>
#include <cstdlib>
#include <cstring>
#include <locale>

namespace {

[[gnu::constructor]] void enter()
{
    std::locale::global(std::locale(""));
    if (std::strcmp(std::localeconv()->decimal_point, ",") != 0) std::abort();
}

}  // namespace

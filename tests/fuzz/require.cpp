#include <cstdio>
#include <cstdlib>

#include "targets.hpp"

namespace tyndall::fuzz {

void require(bool kept, const char* promise)
{
    if (kept) return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
}

}  // namespace tyndall::fuzz

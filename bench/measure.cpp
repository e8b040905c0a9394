#include "bench/measure.hpp"

#include <sched.h>
#include <stdlib.h>

#include <string>

namespace tyndall::bench {

void use_workers(int threads) { setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(threads).c_str(), 0); }

void stay_on_cores(int cores)
{
    cpu_set_t allowed, chosen;
    CPU_ZERO(&chosen);
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&chosen) < cores; ++cpu)
        if (CPU_ISSET(cpu, &allowed)) CPU_SET(cpu, &chosen);
    sched_setaffinity(0, sizeof chosen, &chosen);
}

}  // namespace tyndall::bench

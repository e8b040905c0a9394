#include "bench/roofline/steps.hpp"

#include <dlfcn.h>
#include <signal.h>
#include <stddef.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tyndall::bench {
namespace {

/// What the child tells: where the kernel's code begins, where its file is mapped, and its name.
struct Told {
    std::uint64_t entries[2];
    std::uint64_t base;
    char file[1024];
};

/// Finds the kernel's code among what is loaded. PoCL has two entries to a kernel; it takes one of them.
void tell(const std::string& kernel, Told& told)
{
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const std::size_t begin = line.find('/');
        if (begin == std::string::npos || !line.ends_with("/" + kernel + ".so")) continue;
        const std::string path = line.substr(begin);
        void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_NOLOAD);
        Dl_info info{};
        for (int i = 0; library && i < 2; ++i) {
            void* const entry = dlsym(library, ("_pocl_kernel_" + kernel + "_workgroup" + (i ? "_fast" : "")).c_str());
            if (entry && dladdr(entry, &info)) told.entries[i] = reinterpret_cast<std::uint64_t>(entry), told.base = reinterpret_cast<std::uint64_t>(info.dli_fbase);
        }
        std::strncpy(told.file, path.c_str(), sizeof told.file - 1);
        return;
    }
    throw std::runtime_error("PoCL has loaded no code of " + kernel);
}

[[noreturn]] void be_the_child(const std::string& kernel, const std::function<std::function<void()>()>& prepare, Told& told)
{
    try {
        const std::function<void()> work = prepare();
        tell(kernel, told);
        ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
        raise(SIGSTOP);
        work();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    _exit(1);
}

void resume(pid_t child, __ptrace_request how)
{
    int status = 0;
    if (how != PTRACE_TRACEME && ptrace(how, child, nullptr, nullptr) != 0) throw std::runtime_error("this system does not let processes be stepped");
    if (waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) throw std::runtime_error("the kernel was not entered by the thread that called it");
}

user_regs_struct registers(pid_t child)
{
    user_regs_struct all{};
    ptrace(PTRACE_GETREGS, child, nullptr, &all);
    return all;
}

/// Lets the child run until it is at one of the entries.
void run_to_entry(pid_t child, const Told& told)
{
    constexpr long interrupt = 0xcc;
    long before[2] = {};
    for (int i = 0; i < 2; ++i) {
        if (!told.entries[i]) continue;
        before[i] = ptrace(PTRACE_PEEKTEXT, child, told.entries[i], nullptr);
        ptrace(PTRACE_POKETEXT, child, told.entries[i], (before[i] & ~0xffL) | interrupt);
    }
    resume(child, PTRACE_CONT);
    for (int i = 0; i < 2; ++i)
        if (told.entries[i]) ptrace(PTRACE_POKETEXT, child, told.entries[i], before[i]);
    user_regs_struct at = registers(child);
    --at.rip;  // behind the interrupt
    ptrace(PTRACE_SETREGS, child, nullptr, &at);
}

}  // namespace

SteppedKernel step_through(const std::string& kernel, const std::function<std::function<void()>()>& prepare)
{
    void* const shared = mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("out of memory");
    Told& told = *static_cast<Told*>(shared);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) be_the_child(kernel, prepare, told);
    resume(child, PTRACE_TRACEME);  // it stops by itself
    run_to_entry(child, told);
    const std::uint64_t stack = registers(child).rsp;
    const auto return_address = static_cast<std::uint64_t>(ptrace(PTRACE_PEEKDATA, child, stack, nullptr));
    SteppedKernel stepped{told.file, {}};
    for (;;) {
        const auto address = static_cast<std::uint64_t>(ptrace(PTRACE_PEEKUSER, child, offsetof(user_regs_struct, rip), nullptr));
        if (address == return_address && registers(child).rsp > stack) break;
        ++stepped.counts[address - told.base];
        resume(child, PTRACE_SINGLESTEP);
    }
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    munmap(shared, sizeof(Told));
    return stepped;
}

}  // namespace tyndall::bench

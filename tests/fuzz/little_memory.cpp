/// A machine that gives no more than a gibibyte at once: `new` throws std::bad_alloc beyond. The sanitizer's own ends the program where it cannot serve a request, which is right for our
/// readers, who ask for no more than a file can fill; OpenVDB asks for what the file says and has to be told no.
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t most_at_once = std::size_t{1} << 30;

void* allocate(std::size_t size)
{
    void* memory = size > most_at_once ? nullptr : std::malloc(size > 0 ? size : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

/// The other kinds of `new` and `delete` stay the sanitizer's; OpenVDB leaks the node, 270 KB, at which it finds a file damaged.
extern "C" const char* __asan_default_options() { return "alloc_dealloc_mismatch=0:detect_leaks=0"; }

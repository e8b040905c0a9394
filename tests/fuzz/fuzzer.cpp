/// One fuzzer: libFuzzer calls the target of that name, TYNDALL_FUZZ_TARGET, with bytes that reach further and further into it.
#include "targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    tyndall::fuzz::TYNDALL_FUZZ_TARGET({data, size});
    return 0;
}

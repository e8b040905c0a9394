// write_golden_table FOLDER: writes golden_float.inc and golden_double.inc there. The folder of the repository is host/selftest.
#include <cstdio>
#include <fstream>

#include "tests/hard_cases/golden_text.hpp"

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("usage: write_golden_table host/selftest\n", stderr);
        return 2;
    }
    const std::string folder = argv[1];
    std::ofstream floats(folder + "/golden_float.inc", std::ios::binary), doubles(folder + "/golden_double.inc", std::ios::binary);
    floats << tyndall::test::golden_text<float>();
    doubles << tyndall::test::golden_text<double>();
    return floats.flush() && doubles.flush() ? 0 : 1;
}

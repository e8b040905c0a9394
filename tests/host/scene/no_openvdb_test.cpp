// What a scene with a .vdb file is told by a program that was built without OpenVDB.
#include "scene_text.hpp"

namespace tyndall::test {

TEST(WithoutOpenVdb, TheMessageNamesTheOption)
{
    const TemporaryFolder folder;
    folder.write("smoke.vdb", "anything");
    const auto file = folder.write("scene.xml", around("<medium type=\"heterogeneous\" id=\"m\">\n<volume name=\"sigma_t\" type=\"openvdbvolume\">"
                                                       "<string name=\"filename\" value=\"smoke.vdb\"/></volume></medium>"));
    EXPECT_EQ(fault_of_file(file), file.string() + ":3:45: volume \"openvdbvolume\": smoke.vdb: this tyndall was built without OpenVDB; install libopenvdb-dev and build "
                                                   "with -DTYNDALL_OPENVDB=ON, or convert the file to .vol");
}

}  // namespace tyndall::test

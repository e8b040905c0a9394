// In place of volume_vdb.cpp where Tyndall is built without OpenVDB.
#include "scene/volume_files.hpp"

namespace tyndall {

VolumeFile read_vdb(std::string, const std::string&)  // NOLINT(performance-unnecessary-value-param): the one with OpenVDB keeps it
{
    throw VolumeFault("this tyndall was built without OpenVDB; install libopenvdb-dev and build with -DTYNDALL_OPENVDB=ON, or convert the file to .vol");
}

}  // namespace tyndall

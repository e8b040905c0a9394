// OBJ and PLY: what they may say, and the lies they may tell.
#include <bit>
#include <cstring>

#include "scene/mesh_files.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

template <class Reader>
std::string mesh_fault(Reader reader, const std::string& bytes)
{
    try {
        reader(bytes);
    } catch (const MeshFault& fault) {
        return fault.what();
    }
    return "";
}
std::string obj_fault(const std::string& bytes) { return mesh_fault(read_obj, bytes); }
std::string ply_fault(const std::string& bytes) { return mesh_fault(read_ply, bytes); }

const std::string obj_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string ply_header(const std::string& format, const std::string& vertices, const std::string& faces, const std::string& more = "")
{
    return "ply\nformat " + format + " 1.0\ncomment made in a test\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\n" + more + "element face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}
const std::string ply_corners = "0 0 0\n1 0 0\n0 1 0\n";

TEST(Obj, CornersMayNameTextureAndNormal)
{
    for (const char* face :
         {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f -3 -2 -1", "  f\t1 2 3  # a comment\r"}) {
        const MeshFile file = read_obj(obj_triangle + "vt 0.25 0.5\nvn 0 0 2\n" + face + "\n");
        ASSERT_EQ(file.mesh.triangles.size(), 1u) << face;
        EXPECT_EQ(file.mesh.vertices[file.mesh.triangles[0].y], Vec3(1, 0, 0)) << face;
        const bool has_normals =
            std::string(face).find("1//1") != std::string::npos || std::string(face).find("1/1/1") != std::string::npos;
        EXPECT_EQ(file.mesh.normals.size(), has_normals ? 3u : 0u) << face;
        if (has_normals) {
            EXPECT_EQ(file.mesh.normals[0], Vec3(0, 0, 1)) << "of unit length";
        }
    }
    EXPECT_EQ(read_obj(obj_triangle + "vt 0.25 0.5\nf 1/1 2/1 3/1").mesh.uvs[0], Vec2(.25, .5));
}

TEST(Obj, PolygonsBecomeFansAndSharedCornersAreShared)
{
    const MeshFile file = read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(file.mesh.vertices.size(), 4u);
    ASSERT_EQ(file.mesh.triangles.size(), 2u);
    EXPECT_EQ(file.mesh.triangles[1], glm::uvec3(0, 2, 3));
    EXPECT_TRUE(file.remarks.empty());
}

TEST(Obj, ConcavePolygonsAreRemarkedOn)
{
    const MeshFile file =
        read_obj("v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nf 2 3 4 1\n");  // the fan from the corner that points inwards is the arrow itself
    EXPECT_TRUE(file.remarks.empty());
    const MeshFile folded = read_obj("v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nf 1 2 3 4\n");
    ASSERT_EQ(folded.remarks.size(), 1u);
    EXPECT_NE(folded.remarks[0].find("1 polygons are concave"), std::string::npos);
}

TEST(Obj, PassesOverWhatIsNotGeometry)
{
    EXPECT_EQ(obj_fault("mtllib a.mtl\no thing\ng a b\ns off\nusemtl red\n" + obj_triangle + "l 1 2\nf 1 2 3\n"), "");
    EXPECT_EQ(obj_fault("curv 0 1 1 2\n" + obj_triangle + "f 1 2 3\n"), "line 1: \"curv\" is not supported; Tyndall reads v, vn, vt and f");
}

TEST(Obj, LiesAreToldByLine)
{
    EXPECT_EQ(obj_fault(obj_triangle + "f 1 2 4\n"), "line 4: index 4 is out of range: there are 3 vertices so far");
    EXPECT_EQ(obj_fault(obj_triangle + "f 1 2 0\n"), "line 4: index 0 is out of range: there are 3 vertices so far");
    EXPECT_EQ(obj_fault(obj_triangle + "f 1 2 -4\n"), "line 4: index -4 is out of range: there are 3 vertices so far");
    EXPECT_EQ(obj_fault(obj_triangle + "f 1//1 2//1 3//1\n"), "line 4: index 1 is out of range: there are 0 normals so far");
    EXPECT_EQ(obj_fault(obj_triangle + "f 1/9 2/9 3/9\n"), "line 4: index 9 is out of range: there are 0 texture coordinates so far");
    EXPECT_EQ(obj_fault(obj_triangle + "f 1 2\n"), "line 4: a face with fewer than three corners");
    EXPECT_EQ(obj_fault(obj_triangle + "f 1 2 x\n"), "line 4: \"x\" is not a corner of a face");
    EXPECT_EQ(obj_fault(obj_triangle + "f 1 2 3/1/1/1\n").find("line 4: "), 0u);
    EXPECT_EQ(obj_fault(obj_triangle + "f 1 2 99999999999999999999\n"), "line 4: \"99999999999999999999\" is not a corner of a face");
    EXPECT_EQ(obj_fault(obj_triangle + "f 1 2 /1\n").find("line 4: "), 0u);
    EXPECT_EQ(obj_fault("v 0 0 nan\n"), "line 1: \"nan\" is not a finite number");
    EXPECT_EQ(obj_fault("v 0 0 1e999\n"), "line 1: \"1e999\" is not a finite number");
    EXPECT_EQ(obj_fault("v 0 0\n"), "line 1: v with 2 numbers; it takes 3");
    EXPECT_EQ(obj_fault("v 0 0 1e200\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("vertex 0 has a coordinate"), 0u);
    EXPECT_EQ(obj_fault(obj_triangle), "there is no triangle in it");
    EXPECT_EQ(obj_fault(""), "there is no triangle in it");
    EXPECT_EQ(obj_fault("\x7f"
                        "ELF\x01\x02\n")
                  .find("line 1: "),
              0u);
}

TEST(Obj, LargeFilesTakeLinearTime)
{
    // 400 000 lines without a comment: minutes if each line looked through the rest of the file
    std::string bytes = obj_triangle;
    for (int i = 0; i < 200000; ++i) bytes += "v 0.12345 1.2345 2.3456\nf 1 2 3\n";
    EXPECT_EQ(read_obj(bytes).mesh.triangles.size(), 200000u);
}

TEST(Obj, ZeroNormalsAreReplacedByTheTriangles)
{
    const MeshFile file = read_obj(obj_triangle + "vn 0 0 0\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(file.mesh.normals[0], Vec3(0, 0, 1));
}

TEST(Ply, AsciiIsRead)
{
    const MeshFile file = read_ply(
        ply_header("ascii", "3", "1", "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n") +
        "0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n0 1 0 0 0 1 0 1\n3 0 1 2\n");
    ASSERT_EQ(file.mesh.triangles.size(), 1u);
    EXPECT_EQ(file.mesh.vertices[1], Vec3(1, 0, 0));
    EXPECT_EQ(file.mesh.normals[2], Vec3(0, 0, 1));
    EXPECT_EQ(file.mesh.uvs[2], Vec2(0, 1));
}

template <class Number>
std::string bytes_in_order(Number value, bool big)
{
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);  // this machine is little-endian
    return big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

TEST(Ply, BothByteOrdersAreRead)
{
    for (const bool big : {false, true}) {
        std::string data;
        for (float x : {0.f, 0.f, 0.f, 1.5f, 0.f, 0.f, 0.f, -2.25f, 0.f, 1.f, 1.f, 0.f}) data += bytes_in_order(x, big);
        data += '\x04';
        for (std::int32_t i : {0, 1, 3, 2}) data += bytes_in_order(i, big);
        const MeshFile file = read_ply(ply_header(big ? "binary_big_endian" : "binary_little_endian", "4", "1") + data);
        ASSERT_EQ(file.mesh.triangles.size(), 2u);
        EXPECT_EQ(file.mesh.vertices[1], Vec3(1.5, 0, 0));
        EXPECT_EQ(file.mesh.vertices[2], Vec3(0, -2.25, 0));
        EXPECT_EQ(file.mesh.triangles[1], glm::uvec3(0, 3, 2));
    }
}

TEST(Ply, OtherTypesElementsAndPropertiesArePassedOver)
{
    std::string data =
        "ply\r\nformat binary_little_endian 1.0\r\nelement junk 2\r\nproperty list ushort short numbers\r\nproperty char c\r\nelement "
        "vertex 3\r\nproperty double x\r\n"
        "property uchar red\r\nproperty double y\r\nproperty double z\r\nelement face 1\r\nproperty float weight\r\nproperty list int8 "
        "uint16 vertex_index\r\nend_header\r\n";
    data +=
        bytes_in_order(std::uint16_t{2}, false) + bytes_in_order(std::int16_t{-1}, false) + bytes_in_order(std::int16_t{7}, false) + 'c';
    data += bytes_in_order(std::uint16_t{0}, false) + 'c';
    for (const Vec3& v : {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, .1)})
        data += bytes_in_order(v.x, false) + '\xff' + bytes_in_order(v.y, false) + bytes_in_order(v.z, false);
    data += bytes_in_order(1.f, false) + '\x03';
    for (std::uint16_t i : {0, 1, 2}) data += bytes_in_order(i, false);
    const MeshFile file = read_ply(data);
    ASSERT_EQ(file.mesh.triangles.size(), 1u);
    EXPECT_EQ(file.mesh.vertices[2], Vec3(0, 1, .1));  // doubles stay doubles
}

TEST(Ply, CountsAreCheckedBeforeMemoryIsAskedFor)
{
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        EXPECT_NE(ply_fault(ply_header(format, "4000000000", "1") + "0 0 0\n").find("rows of element \"vertex\" cannot be in the"),
                  std::string::npos)
            << format;
        EXPECT_NE(ply_fault(ply_header(format, "9223372036854775807", "1") + "0 0 0\n").find("cannot be in the"), std::string::npos)
            << format;
    }
    EXPECT_NE(ply_fault(ply_header("ascii", "3", "1") + ply_corners + "200 0 1 2\n").find("a list of 200 items cannot be in the"),
              std::string::npos);
    EXPECT_NE(ply_fault(ply_header("ascii", "3", "1") + ply_corners + "-3 0 1 2\n").find("a list of -3 items"), std::string::npos);
    EXPECT_NE(ply_fault("ply\nformat ascii 1.0\nelement nothing 9000000000000000000\nend_header\n").find("cannot be in the"),
              std::string::npos);
    EXPECT_NE(ply_fault(ply_header("ascii", "99999999999999999999", "1")).find("is not a count"), std::string::npos);
    EXPECT_NE(ply_fault(ply_header("ascii", "-1", "1")).find("is not a count"), std::string::npos);
}

TEST(Ply, LiesAreRefused)
{
    EXPECT_EQ(ply_fault(ply_header("ascii", "3", "1") + ply_corners + "3 0 1 3\n"), "face 0 names vertex 3, out of range: there are 3");
    EXPECT_EQ(ply_fault(ply_header("ascii", "3", "1") + ply_corners + "3 0 1 -1\n"), "face 0 names vertex -1, out of range: there are 3");
    EXPECT_EQ(ply_fault(ply_header("ascii", "3", "1") + ply_corners + "2 0 1\n"), "face 0 has 2 corners");
    EXPECT_EQ(ply_fault(ply_header("ascii", "3", "1") + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"), "\"nan\" is not a finite number");
    EXPECT_EQ(ply_fault(ply_header("ascii", "3", "1") + "0 0 0\n1 0 1e999\n0 1 0\n3 0 1 2\n"), "\"1e999\" is not a finite number");
    EXPECT_EQ(ply_fault(ply_header("ascii", "3", "1") + "0 0 0 1 0 0 0 1 0 3 0"),
              "a list of 3 items cannot be in the 2 bytes that are left");
    EXPECT_EQ(ply_fault(ply_header("ascii", "3", "0") + ply_corners), "there is no triangle in it");
    EXPECT_EQ(ply_fault(""), "the PLY header does not end");
    EXPECT_EQ(ply_fault("obj\n"), "not a PLY file: it does not start with \"ply\"");
    EXPECT_EQ(ply_fault("ply\nend_header\n"), "the PLY header names no format");
    EXPECT_EQ(ply_fault("ply\nformat ascii 2.0\nend_header\n"), "line 2: PLY version \"2.0\" is not supported");
    EXPECT_EQ(ply_fault("ply\nformat morse 1.0\nend_header\n"), "line 2: format \"morse\" is not supported");
    EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n"),
              "line 4: \"real\" is not a type of number");
    EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"), "the vertices have no x, y and z");
    EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n"),
              "element \"face\" stands before element \"vertex\"");
    EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nelement vertex 1\nelement vertex 1\nend_header\n"), "line 4: a second element \"vertex\"");
}

TEST(Ply, BinaryNansAreRefused)
{
    std::string data;
    for (float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, std::bit_cast<float>(0x7fc00000u), 0.f}) data += bytes_in_order(x, false);
    data += '\x03';
    for (std::int32_t i : {0, 1, 2}) data += bytes_in_order(i, false);
    EXPECT_EQ(ply_fault(ply_header("binary_little_endian", "3", "1") + data).find("vertex 2 has a coordinate that is not a number"), 0u);
}

TEST(Ply, EveryTruncationIsRefused)
{
    std::string data;
    for (float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) data += bytes_in_order(x, false);
    data += '\x03';
    for (std::int32_t i : {0, 1, 2}) data += bytes_in_order(i, false);
    const std::string whole = ply_header("binary_little_endian", "3", "1") + data;
    EXPECT_EQ(ply_fault(whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_NE(ply_fault(whole.substr(0, size)), "") << size;
}

TEST(MeshInScene, FaultsNameSceneFileAndReason)
{
    const TemporaryFolder folder;
    folder.write("bad.obj", obj_triangle + "f 1 2 9\n");
    const auto scene = [&](const std::string& name, const std::string& type = "obj") {
        return folder.write(
            "scene.xml", around("<shape type=\"" + type + "\" id=\"thing\">\n <string name=\"filename\" value=\"" + name + "\"/></shape>"));
    };
    const std::string place = (folder.path() / "scene.xml").string() + ":3:2: ";
    EXPECT_EQ(fault_of_file(scene("bad.obj")),
              place + "shape \"thing\": bad.obj: line 4: index 9 is out of range: there are 3 vertices so far");
    EXPECT_EQ(fault_of_file(scene("gone.obj")), place + "cannot find \"gone.obj\" in \"" + folder.path().string() + "\"");
    EXPECT_EQ(fault_of_file(scene("")), place + "shape \"thing\": needs <string name=\"filename\" value=\"...\"/>");
    EXPECT_NE(fault_of_body("<shape type=\"ply\"/>").find("scene.xml:2:1: shape \"ply\": needs <string name=\"filename\""),
              std::string::npos);
    folder.write("flat.obj", "v 0 0 0\nv 0 0 0\nv 1 0 0\nf 1 2 3\n");
    EXPECT_NE(fault_of_file(scene("flat.obj")).find("no triangle of it has an area"), std::string::npos);
}

TEST(MeshInScene, NormalsFollowTheFileFaceNormalsAndTransform)
{
    const TemporaryFolder folder;
    folder.write("t.obj", obj_triangle + "vt 0.25 0.25\nvn 0 1 1\nf 1/1/1 2/1/1 3/1/1\n");
    const auto load = [&](const std::string& inside) {
        return load_scene(
            folder.write("scene.xml", around("<shape type=\"obj\"><string name=\"filename\" value=\"t.obj\"/>" + inside + "</shape>")));
    };
    expect_near(load("").shapes[0].mesh.normals[0], glm::normalize(Vec3(0, 1, 1)), 1e-15);
    EXPECT_TRUE(load("<boolean name=\"face_normals\" value=\"true\"/>").shapes[0].mesh.normals.empty());
    // normals go by the inverse transpose: twice as tall, half as steep
    expect_near(load("<transform name=\"to_world\"><scale y=\"2\"/></transform>").shapes[0].mesh.normals[0], glm::normalize(Vec3(0, .5, 1)),
                1e-15);
    EXPECT_EQ(load("").shapes[0].mesh.uvs[0], Vec2(.25, .75));  // Mitsuba flips v for OBJ
    EXPECT_EQ(load("<boolean name=\"flip_tex_coords\" value=\"false\"/>").shapes[0].mesh.uvs[0], Vec2(.25, .25));
}

TEST(MeshInScene, MissingNormalsAreFaceNormalsAndSaidSo)
{
    const TemporaryFolder folder;
    folder.write("t.ply", ply_header("ascii", "3", "1") + ply_corners + "3 0 1 2\n");
    const auto load = [&](const std::string& inside) {
        return load_scene(folder.write(
            "scene.xml",
            around("<emitter type=\"point\"/><shape type=\"ply\"><string name=\"filename\" value=\"t.ply\"/>" + inside + "</shape>")));
    };
    const Scene flat = load("");
    EXPECT_TRUE(flat.shapes[0].mesh.normals.empty());
    ASSERT_EQ(flat.warnings.size(), 1u);
    EXPECT_NE(flat.warnings[0].find("has no vertex normals and is shaded flat"), std::string::npos);
    EXPECT_TRUE(load("<boolean name=\"face_normals\" value=\"true\"/>").warnings.empty());
}

}  // namespace tyndall::test

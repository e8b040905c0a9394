// <transform> against matrices written out by hand.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "scene/render_space.hpp"
#include "scene/transforms.hpp"
#include "scene/xml_element.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

Mat4 transform(const std::string& steps)
{
    return read_transform(parse_xml("<transform name=\"to_world\">" + steps + "</transform>", "t.xml"));
}

std::string transform_fault(const std::string& steps)
{
    try {
        transform(steps);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

void expect_same(const Mat4& a, const Mat4& b, double tolerance)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) EXPECT_NEAR(a[column][row], b[column][row], tolerance) << "row " << row << " column " << column;
}

// One rotation is a dozen roundings of numbers up to 10: 16 ulp(10).
constexpr double rounding = 16 * 10 * 2.3e-16;

TEST(Transform, EachStepIsGlms)
{
    expect_same(transform(""), Mat4(1), 0);
    expect_same(transform("<translate x=\"1\" z=\"-3\"/>"), glm::translate(Mat4(1), Vec3(1, 0, -3)), 0);
    expect_same(transform("<translate value=\"1 2, 3\"/>"), glm::translate(Mat4(1), Vec3(1, 2, 3)), 0);
    expect_same(transform("<scale y=\"2\"/>"), glm::scale(Mat4(1), Vec3(1, 2, 1)), 0);
    expect_same(transform("<scale value=\"3\"/>"), glm::scale(Mat4(1), Vec3(3)), 0);
    expect_same(transform("<scale value=\"2, 3, 4\"/>"), glm::scale(Mat4(1), Vec3(2, 3, 4)), 0);
    expect_same(transform("<rotate x=\"1\" y=\"2\" z=\"3\" angle=\"77\"/>"),
                glm::rotate(Mat4(1), glm::radians(77.), glm::normalize(Vec3(1, 2, 3))), rounding);
    expect_same(transform("<rotate value=\"0 1 0\" angle=\"-33\"/>"), glm::rotate(Mat4(1), glm::radians(-33.), Vec3(0, 1, 0)), rounding);
}

TEST(Transform, TheFirstListedStepAppliesFirst)
{
    const Mat4 m = transform("<scale x=\"2\"/><rotate z=\"1\" angle=\"90\"/><translate x=\"10\"/>");
    // (1, 0, 0) becomes (2, 0, 0), then (0, 2, 0), then (10, 2, 0): exactly, quarter turns being exact
    EXPECT_EQ(transform_point(m, Vec3(1, 0, 0)), Vec3(10, 2, 0));
}

TEST(Transform, QuarterTurnsAreExact)
{
    EXPECT_EQ(transform_point(rotation(Vec3(1, 0, 0), -90), Vec3(0, 0, 1)), Vec3(0, 1, 0));
    EXPECT_EQ(transform_point(rotation(Vec3(0, 1, 0), 450), Vec3(0, 0, 1)), Vec3(1, 0, 0));
    EXPECT_EQ(transform_point(rotation(Vec3(0, 2, 0), 180), Vec3(1, 0, 3)), Vec3(-1, 0, -3));
}

TEST(Transform, MatrixIsReadRowByRow)
{
    const Mat4 m = transform("<matrix value=\"1 2 3 4  0 1 0 5  0 0 1 6  0 0 0 1\"/>");
    EXPECT_EQ(transform_point(m, Vec3(1, 1, 1)), Vec3(10, 6, 7));
    EXPECT_EQ(transform_point(transform("<matrix value=\"1 2 3 0 1 0 0 0 1\"/>"), Vec3(1, 1, 1)), Vec3(6, 1, 1));
}

TEST(Transform, LookAtLooksAlongLocalZWithXToTheLeft)
{
    const Mat4 m = transform("<lookat origin=\"1, 2, 3\" target=\"1, 2, -5\" up=\"0, 1, 0\"/>");
    EXPECT_EQ(Vec3(m[3]), Vec3(1, 2, 3));
    EXPECT_EQ(Vec3(m[2]), Vec3(0, 0, -1));
    EXPECT_EQ(Vec3(m[1]), Vec3(0, 1, 0));
    EXPECT_EQ(Vec3(m[0]), Vec3(-1, 0, 0));  // looking along -z with y up, right is +x: local x is the left
}

TEST(Transform, LookAtTiltsUpIntoTheImagePlane)
{
    const Mat4 m = look_at(Vec3(3, 1, 2), Vec3(0, 0, 0), Vec3(0, 1, 0), {});
    const Vec3 forward = -glm::normalize(Vec3(3, 1, 2)), left = glm::normalize(glm::cross(Vec3(0, 1, 0), forward));
    expect_near(Vec3(m[2]), forward, 1e-15);
    expect_near(Vec3(m[0]), left, 1e-15);
    expect_near(Vec3(m[1]), glm::cross(forward, left), 1e-15);
}

TEST(Transform, LookAtWithoutUpIsMitsubas)
{
    // the rows that Mitsuba 3.9 prints, with six digits
    const Mat4 m = look_at(Vec3(1, 2, 3), Vec3(0, 1, 0), Vec3(0), {});
    expect_near(Vec3(m[0]), Vec3(-.047733, .952267, -.301511), 5e-7);
    expect_near(Vec3(m[1]), Vec3(.952267, -.047733, -.301511), 5e-7);
    expect_near(Vec3(m[2]), Vec3(-.301511, -.301511, -.904534), 5e-7);
}

TEST(Transform, LookAtWithoutUpIsRigid)
{
    for (const Vec3& target : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(-1, -2, .5)}) {
        const glm::dmat3 m(look_at(Vec3(0), target, Vec3(0), {}));
        const glm::dmat3 product = glm::transpose(m) * m;
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) EXPECT_NEAR(product[c][r], c == r, 1e-14);
        EXPECT_GT(glm::determinant(m), 0);
    }
}

TEST(Transform, WrongStepsAreRefused)
{
    EXPECT_EQ(transform_fault("\n <translte x=\"1\"/>"),
              "t.xml:2:2: <translte> is no step of a <transform> (did you mean \"translate\"?); steps are: translate, rotate, scale, "
              "lookat, matrix");
    EXPECT_EQ(transform_fault("<rotate x=\"1\" angel=\"90\"/>"),
              "t.xml:1:28: <rotate> has no attribute \"angel\" (did you mean \"angle\"?); it takes: x, y, z, value, angle");
    EXPECT_NE(transform_fault("<rotate angle=\"90\"/>").find("axis of length zero"), std::string::npos);
    EXPECT_NE(transform_fault("<rotate x=\"1\"/>").find("needs the attribute \"angle\""), std::string::npos);
    EXPECT_NE(transform_fault("<scale x=\"0\"/>").find("must have an inverse"), std::string::npos);
    EXPECT_NE(transform_fault("<translate x=\"nan\"/>").find("<translate> x = \"nan\" is not a finite number"), std::string::npos);
    EXPECT_NE(transform_fault("<translate x=\"1e200\"/>").find("leads beyond 1e+100"), std::string::npos);
    EXPECT_NE(transform_fault("<translate value=\"1 2\"/>").find("must be three numbers"), std::string::npos);
    EXPECT_NE(transform_fault("<translate value=\"1 2 3\" x=\"1\"/>").find("both \"value\" and x, y, z"), std::string::npos);
    EXPECT_NE(transform_fault("<matrix value=\"1 2 3\"/>").find("has 3 numbers"), std::string::npos);
    EXPECT_NE(transform_fault("<matrix value=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1\"/>").find("row 0 0 0 1"), std::string::npos);
    EXPECT_NE(transform_fault("<lookat origin=\"1,2,3\" target=\"1,2,3\" up=\"0,1,0\"/>").find("same origin and target"),
              std::string::npos);
    EXPECT_NE(transform_fault("<lookat origin=\"0,0,0\" target=\"0,5,0\" up=\"0,1,0\"/>").find("along its up vector"), std::string::npos);
    EXPECT_NE(transform_fault("<lookat origin=\"0,0,0\"/>").find("needs the attribute \"target\""), std::string::npos);
    EXPECT_NE(transform_fault("<scale value=\"2\"><scale/></scale>").find("has nothing inside"), std::string::npos);
}

TEST(Transform, TinyAndHugeScalesHaveAnInverse)
{
    for (const char* scale : {"1e-18", "1e18", "1e-30", "1e30"})
        EXPECT_EQ(transform_fault("<scale value=\"" + std::string(scale) + "\"/>"), "") << scale;
}

}  // namespace tyndall::test

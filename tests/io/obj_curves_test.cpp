#include <gtest/gtest.h>

#include <filesystem>

#include "io/expect.h"
#include "limes/core/error.h"
#include "limes/io/curves.h"
#include "limes/io/io.h"

namespace limes {
namespace {

std::string error_of(std::string_view text) {
  try {
    static_cast<void>(read_obj_curves(text, "c.obj"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

constexpr std::string_view square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjCurves, ReadsOpenAndClosed) {
  const auto curves =
      read_obj_curves(std::string(square) + "l 1 2 3\nl 1/1 2/2 3/3 4/4 -4\nf 1 2 3\n", "c.obj")
          .curves;
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(curves[0].points.size(), 3U);
  EXPECT_TRUE(curves[1].closed);
  ASSERT_EQ(curves[1].points.size(), 4U);
  EXPECT_EQ(curves[1].points[3], Vec3(0, 1, 0));
}

// Some programs write every side on its own line.
TEST(ObjCurves, JoinsLinesThatGoOn) {
  const auto curves =
      read_obj_curves("l 1 2\nl 2 3\nl 3 4\nl 4 1\nl 1 3\n" + std::string(square), "c.obj").curves;
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(curves[0].points.size(), 4U);
  EXPECT_EQ(curves[1].points.size(), 2U);
}

TEST(ObjCurves, NamesWhatIsWrong) {
  const std::string v(square);
  EXPECT_EQ(error_of(v + "l 1 2 5\n"),
            "c.obj:5: vertex 5 does not exist; the file has 4 vertices, numbered from 1");
  EXPECT_EQ(error_of(v + "l 1\n"), "c.obj:5: a polyline with 1 vertex; 2 or more are right");
  EXPECT_NE(error_of(v + "l 1 0\n").find("c.obj:5: vertex 0 does not exist"), std::string::npos);
  EXPECT_NE(error_of(v + "l 1 -9\n").find("c.obj:5: relative vertex -9"), std::string::npos);
  EXPECT_NE(error_of(v + "l 1 x\n").find("c.obj:5: corner 'x'"), std::string::npos);
  EXPECT_NE(error_of(v + "l 1 99999999999999\n").find("does not exist"), std::string::npos);
  EXPECT_NE(error_of(v + "f 1 2 3\n").find("c.obj: no polylines"), std::string::npos);
  EXPECT_NE(error_of("v 0 0 nan\nl 1 1\n").find("c.obj:1: coordinate"), std::string::npos);
}

TEST(ObjCurves, MeshReaderSaysWhatTheyAreFor) {
  try {
    static_cast<void>(read_obj(std::string(square) + "l 1 2\n", "c.obj"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("polylines and no faces"), std::string::npos);
  }
}

TEST(ObjCurves, SurviveARoundTrip) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "limes_curves.obj";
  const std::vector<Polyline> curves{
      {{Vec3(0.1, 0.2, 0.3), Vec3(1e-300, -0.0, 3), Vec3(1, 2, 3)}, true},
      {{Vec3(1. / 3, 0, 0), Vec3(0, 1e17, 0)}, false}};
  write_curves(file, curves);
  const auto read = read_curves(file).curves;
  std::filesystem::remove(file);
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i].closed, curves[i].closed);
    EXPECT_EQ(read[i].points, curves[i].points);
  }
}

}  // namespace
}  // namespace limes

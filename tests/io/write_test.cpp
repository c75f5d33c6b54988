#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "io/expect.h"
#include "limes/io/io.h"

namespace limes {
namespace {

namespace fs = std::filesystem;

/// A new empty folder that goes away with everything in it.
class Write : public testing::Test {
 protected:
  Write() {
    std::string name = (fs::temp_directory_path() / "limes-write-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  ~Write() override {
    std::error_code ignored;
    fs::permissions(folder_, fs::perms::owner_all, ignored);
    fs::remove_all(folder_, ignored);
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    return names;
  }
  static std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// A square and a triangle.
  static Mesh mesh() {
    return read_off("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.1\n4 0 1 2 3\n3 2 1 0\n", "f").mesh;
  }

  fs::path folder_;
};

TEST_F(Write, ObjText) {
  Mesh m = mesh();
  m.tags.creases = {{VertexId(0), VertexId(1), 2.5F}};
  m.tags.corners = {{VertexId(2), 0.1F}};
  m.tags.holes = {FaceId(1)};
  m.tags.boundary = BoundaryRule::none;
  m.groups = {{"two words", {FaceId(1)}}};
  m.parts = {{"two words", {FaceId(0), FaceId(1)}}};
  EXPECT_EQ(written(write_obj, m),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\no two words\nf 1 2 3 4\ng two_words\nf 3 2 1\n"
            "t interpolateboundary 1/0/0 0\nt crease 2/1/0 0 1 2.5\nt corner 1/1/0 2 0.1\n"
            "t hole 1/0/0 1\n");
}

TEST_F(Write, NamesCannotBreakTheFile) {
  Mesh m = mesh();
  m.groups = {{"a\nf 9 9 9", {FaceId(0)}}, {"", {FaceId(1)}}};
  m.parts = {{"end\\", {FaceId(0), FaceId(1)}}};
  const Mesh back = read_obj(written(write_obj, m), "f").mesh;
  EXPECT_EQ(names_of(back.groups), "a_f_9_9_9: 0; _: 1");
  EXPECT_EQ(names_of(back.parts), "end_: 0 1");
}

TEST_F(Write, ExtensionChoosesTheFormat) {
  for (const char* const name : {"a.obj", "a.off", "a.ply", "a.stl", "a.OBJ"}) {
    write_mesh(folder_ / name, mesh());
    EXPECT_EQ(read_mesh(folder_ / name).mesh.points.size(), 4) << name;
  }
  write_mesh(folder_ / "a.vtu", mesh());
  EXPECT_EQ(content(folder_ / "a.vtu").substr(0, 21), "<?xml version=\"1.0\"?>");
  EXPECT_THROW(write_mesh(folder_ / "a.xyz", mesh()), UsageError);
  EXPECT_THROW(write_mesh(folder_ / "a", mesh()), UsageError);
  EXPECT_THROW(static_cast<void>(read_mesh(folder_ / "a.vtu")), InputError);
  EXPECT_EQ(files().size(), 6U);
}

TEST_F(Write, SaysWhatIsLost) {
  Mesh m = mesh();
  m.tags.creases = {{VertexId(0), VertexId(1), 2.5F}};
  m.tags.holes = {FaceId(1)};
  m.tags.boundary = BoundaryRule::none;
  m.groups = {{"a", {FaceId(0)}}};
  EXPECT_TRUE(write_mesh(folder_ / "a.obj", m).empty());
  EXPECT_TRUE(write_mesh(folder_ / "b.off", mesh()).empty());
  const std::string off = (folder_ / "a.off").string();
  EXPECT_EQ(
      write_mesh(off, m),
      (std::vector{off + ": Geomview OFF keeps no hole tags; 1 hole face left out",
                   off + ": Geomview OFF keeps no sharpness; 1 crease lost",
                   off + ": Geomview OFF keeps no rules of subdivision; those of the file lost",
                   off + ": Geomview OFF keeps no names; 1 group lost"}));
  const Mesh back = read_mesh(off).mesh;
  EXPECT_EQ(faces_of(back), (Faces{{0, 1, 2, 3}}));  // the hole is a hole
  EXPECT_EQ(write_mesh(folder_ / "a.stl", mesh()).size(), 1U);
  m = mesh();
  m.groups = {{"a", {FaceId(0)}}, {"b", {FaceId(1)}}};
  m.parts = {{"c", {FaceId(0), FaceId(1)}}};
  EXPECT_EQ(write_mesh(off, m),
            std::vector{off + ": Geomview OFF keeps no names; 2 groups and 1 part lost"});
}

/// Whether somebody who is not root is refused to write a file. In a process of its own: 0 is yes.
int refused_without_rights(const fs::path& file, const Mesh& mesh) {
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0 && setuid(65534) != 0) _exit(2);  // root may write everywhere; nobody not
    try {
      write_mesh(file, mesh);
    } catch (const OutputError&) {
      _exit(0);
    }
    _exit(1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

TEST_F(Write, HolesOnlyNeedAFormatWithTags) {
  Mesh m = mesh();
  m.tags.holes = {FaceId(0), FaceId(1)};
  write_mesh(folder_ / "a.obj", m);
  EXPECT_EQ(read_mesh(folder_ / "a.obj").mesh.tags.holes.size(), 2U);
  EXPECT_THROW(write_mesh(folder_ / "a.off", m), OutputError);
  EXPECT_EQ(files(), std::vector<std::string>{"a.obj"});
}

TEST_F(Write, AFolderWithoutPermission) {
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_exec);
  EXPECT_EQ(refused_without_rights(folder_ / "a.obj", mesh()), 0);
  EXPECT_TRUE(files().empty());
}

TEST_F(Write, AFileWithoutPermissionInAFolderWithIt) {
  fs::permissions(folder_, fs::perms::all);
  std::ofstream(folder_ / "a.obj") << "precious";
  fs::permissions(folder_ / "a.obj", fs::perms::owner_read | fs::perms::others_read);
  EXPECT_EQ(refused_without_rights(folder_ / "a.obj", mesh()), 0);
  EXPECT_EQ(content(folder_ / "a.obj"), "precious");
  EXPECT_EQ(files(), std::vector<std::string>{"a.obj"});
}

TEST_F(Write, LinksAreFollowed) {
  fs::create_directory(folder_ / "there");
  fs::create_symlink("second.off", folder_ / "first.off");  // nothing is at its end yet
  fs::create_symlink(fs::path("there") / "mesh.off", folder_ / "second.off");
  for (int times = 0; times < 2; ++times) {
    write_mesh(folder_ / "first.off", mesh());
    EXPECT_TRUE(fs::is_symlink(folder_ / "first.off"));
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder_ / "there" / "mesh.off")));
  }
  fs::create_symlink("round.off", folder_ / "round.off");
  EXPECT_THROW(write_mesh(folder_ / "round.off", mesh()), OutputError);
  fs::create_symlink("none/mesh.off", folder_ / "nowhere.off");
  EXPECT_THROW(write_mesh(folder_ / "nowhere.off", mesh()), OutputError);
  EXPECT_EQ(files().size(), 5U);
}

TEST_F(Write, AFolderThatDoesNotExist) {
  const std::string file = (folder_ / "none" / "a.obj").string();
  try {
    write_mesh(file, mesh());
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_EQ(std::string(error.what()), file + ": cannot be written: No such file or directory");
  }
}

TEST_F(Write, ADirectoryIsNoTarget) {
  fs::create_directory(folder_ / "a.obj");
  EXPECT_THROW(write_mesh(folder_ / "a.obj", mesh()), OutputError);
  EXPECT_THROW(static_cast<void>(read_mesh(folder_ / "a.obj")), InputError);
  EXPECT_EQ(files(), std::vector<std::string>{"a.obj"});
}

TEST_F(Write, AFullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  fs::create_symlink("/dev/full", folder_ / "a.obj");
  EXPECT_THROW(write_mesh(folder_ / "a.obj", mesh()), OutputError);
}

TEST_F(Write, WhatCannotBeWrittenLeavesTheOldFile) {
  const fs::path file = folder_ / "a.stl";
  write_mesh(file, mesh());
  const std::string before = content(file);
  Mesh huge = mesh();
  huge.points[VertexId(2)][0] = 1e39;  // more than single precision holds
  EXPECT_THROW(write_mesh(file, huge), OutputError);
  EXPECT_EQ(content(file), before);
  huge.points[VertexId(2)][0] = std::numeric_limits<double>::quiet_NaN();
  try {
    write_mesh(folder_ / "a.ply", huge);
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 2"), std::string::npos);
  }
  EXPECT_EQ(files(), std::vector<std::string>{"a.stl"});
}

TEST_F(Write, AWriterThatFailsHalfwayLeavesNothing) {
  const ByteSink failing = [](std::string_view) { throw OutputError("full"); };
  EXPECT_THROW(write_obj(failing, mesh()), OutputError);
  EXPECT_THROW(write_ply(failing, mesh()), OutputError);
  EXPECT_THROW(write_vtu(failing, mesh()), OutputError);
}

TEST_F(Write, FilesThatCannotBeRead) {
  const auto why = [](const fs::path& file) -> std::string {
    try {
      static_cast<void>(read_mesh(file));
      return "";
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
  };
  EXPECT_EQ(why(folder_ / "none.obj"), ": no such file");
  EXPECT_EQ(why(folder_ / "none"), ": no such file");
  EXPECT_EQ(why(folder_), ": is a directory; a mesh file is right");
  std::ofstream(folder_ / "a.xyz") << "v 0 0 0\n";
  EXPECT_EQ(why(folder_ / "a.xyz"),
            ": meshes of type '.xyz' cannot be read; .obj, .off, .ply and .stl can");
  EXPECT_EQ(mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_EQ(why(folder_ / "pipe.obj"), ": is no regular file");
  std::ofstream(folder_ / "secret.obj") << "v 0 0 0\n";
  fs::permissions(folder_ / "secret.obj", fs::perms::none);
  if (geteuid() != 0) {
    EXPECT_EQ(why(folder_ / "secret.obj"), ": Permission denied");
  }
}

TEST_F(Write, TableOfFormats) {
  for (const Format& format : all_formats) {
    EXPECT_EQ(format.extension[0], '.');
    EXPECT_EQ(format.read == nullptr, format.reads.empty());
    EXPECT_EQ(format.write == nullptr, format.writes.empty());
  }
}

}  // namespace
}  // namespace limes

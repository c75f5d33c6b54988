#include <fmt/format.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "limes/core/error.h"
#include "limes/problem/problem.h"
#include "study/problem_draft.h"

namespace limes {
namespace {

class ProblemFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              fmt::format("limes_problem_{}", testing::UnitTest::GetInstance()->random_seed() +
                                                  static_cast<long>(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string message(const std::filesystem::path& file) {
    try {
      (void)read_problem(file);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << file << " was read";
    return {};
  }
  std::filesystem::path folder_;
};

TEST_F(ProblemFile, IsReadFromDisk) {
  const auto file = folder_ / "a.toml";
  std::ofstream(file) << full();
  EXPECT_EQ(read_problem(file).title, "Everything");
  EXPECT_EQ(read_problem(file).file, file);
  const std::vector<std::string> overrides{"mesh.levels=3"};
  EXPECT_EQ(read_problem(file, overrides).mesh.levels, 3);
}

TEST_F(ProblemFile, MayHaveWindowsLinesAndAByteOrderMark) {
  std::string text = "\xef\xbb\xbf";
  for (const char c : Draft().text())
    text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(parse(text).mesh.file, "m.obj");
}

TEST_F(ProblemFile, MustBeAFileOfReasonableSize) {
  EXPECT_NE(message(folder_ / "none.toml").find("none.toml: no such file"), std::string::npos);
  EXPECT_NE(message(folder_).find("is a directory"), std::string::npos);
  const auto large = folder_ / "large.toml";
  std::ofstream(large) << "a";
  std::filesystem::resize_file(large, (16U << 20U) + 1);
  EXPECT_NE(message(large).find("larger than 16 MiB"), std::string::npos);
  EXPECT_NE(message("/dev/null").find("no regular file"), std::string::npos);
}

}  // namespace
}  // namespace limes

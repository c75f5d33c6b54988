#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "limes/core/error.h"
#include "limes/io/io.h"
#include "limes/mesh/adjacency.h"
#include "limes/mesh/defects.h"
#include "limes/mesh/measure.h"
#include "limes/mesh/repair.h"

// Every file under tests/data/hostile against its row in verdicts.tsv (docs/hostile-files.md).

namespace limes {
namespace {

namespace fs = std::filesystem;
const fs::path folder = fs::path(LIMES_TEST_DATA_DIR) / "hostile";

struct Verdict {
  std::string file, reader, counts, says, defects, refine, repair, repaired;
  friend bool operator==(const Verdict&, const Verdict&) = default;
};

void PrintTo(const Verdict& v, std::ostream* out) {
  for (const auto& field :
       {v.file, v.reader, v.counts, v.says, v.defects, v.refine, v.repair, v.repaired})
    *out << field << '\t';
}

std::vector<Verdict> read_verdicts() {
  std::ifstream in(folder / "verdicts.tsv");
  std::vector<Verdict> verdicts;
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '#') continue;
    std::vector<std::string> fields{""};
    for (const char c : line) {
      if (c == '\t')
        fields.emplace_back();
      else
        fields.back() += c;
    }
    if (fields.size() != 8) throw std::runtime_error("verdicts.tsv: bad line: " + line);
    verdicts.push_back(
        {fields[0], fields[1], fields[2], fields[3], fields[4], fields[5], fields[6], fields[7]});
  }
  return verdicts;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  return parts.empty() ? "-" : fmt::format("{}", fmt::join(parts, between));
}

/// The message without the name of the file at its front.
std::string without_name(const std::string& message, const std::string& file) {
  EXPECT_EQ(message.substr(0, file.size()), file);
  return message.substr(std::min(file.size(), message.size()));
}

std::string refinable(const Mesh& mesh) {
  try {
    require_refinable(mesh, "mesh");
    static_cast<void>(Adjacency(mesh.topology));  // must not throw then
    return "yes";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return std::string(error.what()).rfind("mesh:", 0) == 0 ? "no" : error.what();
  }
}

std::string defect_kinds(const Mesh& mesh) {
  std::vector<std::string> kinds;
  for (const Defect& defect : find_defects(mesh)) {
    const std::string kind(name_of(defect.kind));
    if (kinds.empty() || kinds.back() != kind) kinds.push_back(kind);
  }
  return joined(kinds, ",");
}

Verdict judge(const std::string& name) {
  const std::string file = (folder / name).string();
  MeshFile read;
  try {
    read = read_mesh(file);
  } catch (const InputError& error) {
    return {name, "reject", "-", without_name(error.what(), file), "-", "-", "-", "-"};
  }
  std::vector<std::string> says;
  for (const std::string& remark : read.remarks)
    says.push_back(without_name(remark, file));
  const MeshMeasure m = measure(read.mesh);
  Verdict verdict{name,
                  "accept",
                  fmt::format("{} {} {} {} {} {}", m.vertices, m.faces, m.edges, m.components,
                              m.euler, m.boundary_loops),
                  joined(says, " | "),
                  defect_kinds(read.mesh),
                  refinable(read.mesh),
                  "",
                  "no"};
  try {
    const RepairResult repaired = repair(read.mesh);
    verdict.repair = joined(repaired.done, " | ");
    verdict.repaired = refinable(repaired.mesh);
    EXPECT_TRUE(repair(repaired.mesh).done.empty()) << "a second repair finds more to do";
  } catch (const InputError& error) {
    verdict.repair = fmt::format("error {}", error.what());
  }
  return verdict;
}

std::string test_name(const testing::TestParamInfo<Verdict>& row) {
  std::string name = row.param.file;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

class HostileFile : public testing::TestWithParam<Verdict> {};

TEST_P(HostileFile, IsJudgedAsWritten) {
  EXPECT_EQ(judge(GetParam().file), GetParam());
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_P(HostileFile, NeedsLittleMemory) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const rlimit one_gibibyte{rlim_t{1} << 30, rlim_t{1} << 30};
    const rlimit ten_seconds{10, 10};  // against hanging; a file takes milliseconds
    setrlimit(RLIMIT_AS, &one_gibibyte);
    setrlimit(RLIMIT_CPU, &ten_seconds);
    const bool same = judge(GetParam().file) == GetParam();
    _exit(same ? 0 : 1);
  }
  int status = 0;
  rusage usage{};
  ASSERT_EQ(wait4(child, &status, 0, &usage), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "wait status " << status;
  EXPECT_LT(usage.ru_maxrss, 1 << 20) << "KiB";
}
#endif

INSTANTIATE_TEST_SUITE_P(All, HostileFile, testing::ValuesIn(read_verdicts()), test_name);

TEST(HostileFiles, AllHaveAVerdict) {
  std::vector<std::string> judged, present;
  for (const Verdict& v : read_verdicts())
    judged.push_back(v.file);
  for (const char* const sub : {"made", "real"})
    for (const auto& entry : fs::directory_iterator(folder / sub))
      present.push_back(fmt::format("{}/{}", sub, entry.path().filename().string()));
  std::sort(judged.begin(), judged.end());
  std::sort(present.begin(), present.end());
  EXPECT_EQ(judged, present);
  EXPECT_GT(judged.size(), 90U);
}

/// The row of a file in the manual.
std::string row_of(const std::string& manual, const std::string& file) {
  const std::string start = fmt::format("\n| `{}` |", fs::path(file).filename().string());
  // "made" comes before "real"; both have an empty.obj and a moebius.obj
  const std::size_t at = file.rfind("made", 0) == 0 ? manual.find(start) : manual.rfind(start);
  if (at == std::string::npos) return "";
  return manual.substr(at + 1, manual.find('\n', at + 1) - at - 1);
}

TEST(HostileFiles, TheManualTellsTheVerdicts) {
  std::ifstream in(folder / "../../../docs/hostile-files.md");
  const std::string manual{std::istreambuf_iterator<char>(in), {}};
  for (const Verdict& v : read_verdicts()) {
    const std::string row = row_of(manual, v.file);
    EXPECT_EQ(row.find("| rejected: ") != std::string::npos, v.reader == "reject") << v.file;
    EXPECT_EQ(row.find("| read") != std::string::npos, v.reader == "accept") << v.file;
    EXPECT_EQ(row.find("; not refined") != std::string::npos, v.refine == "no") << v.file;
    EXPECT_EQ(row.find(", then refined") != std::string::npos,
              v.refine == "no" && v.repaired == "yes")
        << v.file;
    const std::string rejection = v.reader == "reject" ? v.says.substr(2) : "";
    EXPECT_NE(row.find(rejection), std::string::npos) << v.file;
  }
}

}  // namespace
}  // namespace limes

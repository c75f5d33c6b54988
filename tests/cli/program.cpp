#include "cli/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>

namespace limes::test {

namespace fs = std::filesystem;

namespace {

void redirect(int descriptor, const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(file, descriptor);
  close(file);
}

/// Whether a process has a handler for a signal, or has ended; where the system does not tell, yes.
bool catches(pid_t process, int signal) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:"))
      return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1U) != 0;
  return true;
}

/// Sends the signal so long after the program began to listen, however late that was.
void send(pid_t process, int signal, std::chrono::milliseconds after) {
  constexpr std::chrono::milliseconds pause(1);
  constexpr int most_pauses = 20'000;
  for (int i = 0; i < most_pauses && !catches(process, signal); ++i)
    std::this_thread::sleep_for(pause);
  std::this_thread::sleep_for(after);
  kill(process, signal);
}

}  // namespace

Result run_limes(const std::vector<std::string>& arguments, std::chrono::milliseconds signal_after,
                 int signal) {
  const TempFolder folder;
  const std::string out = folder / "out";
  const std::string err = folder / "err";
  std::string program = LIMES_EXECUTABLE;
  std::vector<std::string> copies = arguments;
  std::vector<char*> argv{program.data()};
  for (std::string& a : copies)
    argv.push_back(a.data());
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child == 0) {
    if (signal_after.count() > 0) std::signal(signal, SIG_DFL);  // whatever started the tests
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  if (signal_after.count() > 0) send(child, signal, signal_after);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return {code, read_file(out), read_file(err), std::int64_t{usage.ru_maxrss} * 1024};
}

TempFolder::TempFolder() {
  std::string name = (fs::temp_directory_path() / "limes_cli_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TempFolder::file(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return (path_ / name).string();
}

std::vector<std::string> TempFolder::list() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_file(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string data_file(const std::string& name) {
  return std::string(LIMES_DATA_DIR "/") + name;
}

int num_lines(const std::string& text) {
  const auto ends = std::count(text.begin(), text.end(), '\n');
  return static_cast<int>(ends) + (text.empty() || text.back() == '\n' ? 0 : 1);
}

void expect_failure(const Result& result, int exit_code, const std::string& reason) {
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(num_lines(result.err), 1) << result.err;
  EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
}

}  // namespace limes::test

#include "limes/core/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <set>
#include <string>
#include <system_error>

#include "limes/core/error.h"

namespace limes {

namespace fs = std::filesystem;

namespace {

/// Whether bytes go there one by one, because nothing could be renamed onto it.
bool is_written_directly(const fs::path& target) {
  std::error_code ignored;
  if (is_standard_output(target)) return true;
  return fs::exists(target, ignored) && !fs::is_regular_file(target, ignored);
}

/// The temporary files that are there. Never destroyed: a process may end while it is in use.
struct Unfinished {
  std::recursive_mutex mutex;
  std::set<fs::path> files;
};
Unfinished& unfinished() {
  static auto* const all = new Unfinished;
  return *all;
}

}  // namespace

void abandon_files() noexcept {
  Unfinished& all = unfinished();
  all.mutex.lock();  // for good
  std::error_code ignored;
  for (const fs::path& file : all.files)
    fs::remove(file, ignored);
}

bool is_standard_output(const fs::path& target) {
  struct stat there {};
  struct stat output {};
  return stat(target.string().c_str(), &there) == 0 && fstat(STDOUT_FILENO, &output) == 0 &&
         there.st_dev == output.st_dev && there.st_ino == output.st_ino;
}

AtomicFile::AtomicFile(const fs::path& target) : shown_(target), target_(target) {
  std::error_code ignored;
  if (fs::is_directory(target_, ignored)) fail("it is a directory");
  open();
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::open() {
  if (is_written_directly(target_)) {
    file_ = std::fopen(target_.string().c_str(), "ab");
    if (!file_) fail_with_errno();
    return;
  }
  std::error_code ignored;
  constexpr int most_links = 40;  // as many as the system follows
  for (int links = 0; fs::is_symlink(target_, ignored); ++links) {
    if (links == most_links) fail("too many symbolic links");
    target_ = target_.parent_path() / fs::read_symlink(target_, ignored);
  }
  // Renaming asks the folder only; a file that is protected shall stay.
  if (fs::exists(target_, ignored) &&
      faccessat(AT_FDCWD, target_.string().c_str(), W_OK, AT_EACCESS) != 0)
    fail_with_errno();
  open_temporary();
}

/// 'x' never takes over a file that exists, so two processes cannot share a temporary file.
void AtomicFile::open_temporary() {
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  for (int attempt = 0; attempt < 1000 && !file_; ++attempt) {
    temporary_ = target_;
    temporary_ += fmt::format(".tmp{}", attempt);
    file_ = std::fopen(temporary_.string().c_str(), "wbx");
    if (!file_ && errno != EEXIST) {
      temporary_.clear();
      fail_with_errno();
    }
  }
  if (!file_) {
    temporary_.clear();
    fail("too many temporary files beside it");
  }
  all.files.insert(temporary_);
}

void AtomicFile::write(std::string_view bytes) {
  LIMES_ASSERT(file_ != nullptr);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail_with_errno();
}

void AtomicFile::finish() {
  LIMES_ASSERT(file_ != nullptr);
  const bool flushed = std::fflush(file_) == 0;
  const int reason = errno;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (!flushed) errno = reason;
  if (!flushed || !closed) fail_with_errno();
}

void AtomicFile::commit() {
  if (file_) finish();
  if (temporary_.empty()) return;
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(error.message());
  all.files.erase(temporary_);
  temporary_.clear();
}

AtomicFile& AtomicFiles::add(const fs::path& target) {
  return *files_.emplace_back(std::make_unique<AtomicFile>(target));
}

void AtomicFiles::commit() {
  for (const auto& file : files_)
    file->finish();
  const std::lock_guard lock(unfinished().mutex);
  for (const auto& file : files_)
    file->commit();
}

void AtomicFile::discard() noexcept {
  if (file_) std::fclose(file_);
  file_ = nullptr;
  std::error_code ignored;
  if (temporary_.empty()) return;
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  fs::remove(temporary_, ignored);
  all.files.erase(temporary_);
}

void AtomicFile::fail(const std::string& reason) const {
  throw OutputError("{}: cannot be written: {}", shown_.string(), reason);
}

void AtomicFile::fail_with_errno() const {
  fail(std::generic_category().message(errno));
}

void require_writable(const fs::path& target) {
  if (std::error_code ignored; fs::is_directory(target, ignored) || !is_written_directly(target))
    const AtomicFile probe(target);
}

void write_file(const fs::path& target, std::string_view bytes) {
  AtomicFile file(target);
  file.write(bytes);
  file.commit();
}

}  // namespace limes

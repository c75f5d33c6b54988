#include "limes/core/atomic_file.h"

#include <cerrno>
#include <string>
#include <system_error>

#include "limes/core/error.h"

namespace limes {

namespace fs = std::filesystem;

AtomicFile::AtomicFile(const fs::path& target) : shown_(target), target_(target) {
  std::error_code ignored;
  if (fs::is_directory(target_, ignored)) fail("it is a directory");
  if (fs::is_symlink(target_, ignored)) {
    const fs::path resolved = fs::weakly_canonical(target_, ignored);
    if (!resolved.empty()) target_ = resolved;
  }
  open();
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::open() {
  std::error_code ignored;
  if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored)) {
    file_ = std::fopen(target_.string().c_str(), "wb");
    if (!file_) fail_with_errno();
    return;
  }
  // 'x' never takes over a file that exists, so two processes cannot share a temporary file
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
}

void AtomicFile::write(std::string_view bytes) {
  LIMES_ASSERT(file_ != nullptr);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail_with_errno();
}

void AtomicFile::commit() {
  LIMES_ASSERT(file_ != nullptr);
  const bool flushed = std::fflush(file_) == 0;
  const int reason = errno;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (!flushed) errno = reason;
  if (!flushed || !closed) fail_with_errno();
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(error.message());
  temporary_.clear();
}

void AtomicFile::discard() noexcept {
  if (file_) std::fclose(file_);
  file_ = nullptr;
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void AtomicFile::fail(const std::string& reason) const {
  throw OutputError("{}: cannot be written: {}", shown_.string(), reason);
}

void AtomicFile::fail_with_errno() const {
  fail(std::generic_category().message(errno));
}

void write_file(const fs::path& target, std::string_view bytes) {
  AtomicFile file(target);
  file.write(bytes);
  file.commit();
}

}  // namespace limes

#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace limes {

/// A file that appears complete or not at all: writes go to a temporary file in the same folder,
/// commit() renames it to the target; without commit() the destructor removes it and an older file
/// stays as it was. Symbolic links are followed, and a file that may not be written is not replaced.
/// A target that is no regular file (/dev/null, a pipe) and standard output are written directly.
class AtomicFile {
 public:
  /// @throws OutputError "PATH: cannot be written: reason", like every member
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  /// All bytes are stored and nothing can be written any more; only the new name is missing.
  void finish();
  /// finish() if that was not done, then the new name.
  void commit();

 private:
  void open();
  void open_temporary();
  void discard() noexcept;
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void fail_with_errno() const;

  std::filesystem::path shown_;      // the target as the caller wrote it
  std::filesystem::path target_;     // links resolved
  std::filesystem::path temporary_;  // empty: written directly
  std::FILE* file_ = nullptr;
};

/// Several files that belong together: none of them appears before the last byte of all is stored, so
/// that a full disk or an interrupt does not leave new ones beside old ones.
class AtomicFiles {
 public:
  /// A file to write. The reference holds until the end. @throws OutputError as AtomicFile does
  AtomicFile& add(const std::filesystem::path& target);
  void commit();

 private:
  std::vector<std::unique_ptr<AtomicFile>> files_;
};

/// For ending the process at once, from any thread: removes the temporary files of everything that is
/// being written; whatever else asks to write or rename files afterwards waits forever.
void abandon_files() noexcept;

/// Whether a path is the file, pipe or terminal of standard output: /dev/stdout, a link to it.
[[nodiscard]] bool is_standard_output(const std::filesystem::path& target);

/// Fails now rather than after the work that makes the bytes. Leaves nothing behind.
/// @throws OutputError as AtomicFile does
void require_writable(const std::filesystem::path& target);

/// The common case: all bytes at once.
void write_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace limes

#include "files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/io/io.h"
#include "limes/mesh/defects.h"
#include "limes/mesh/repair.h"
#include "terminal.h"

namespace limes::app {

namespace fs = std::filesystem;

Mesh load_mesh(const MeshOptions& options) {
  const Progress progress(fmt::format("reading {}", options.file.string()));
  MeshFile file = read_mesh(options.file);
  check_interrupt();
  for (const std::string& sentence : file.remarks)
    remark(sentence);
  if (!options.repair) return std::move(file.mesh);
  RepairResult repaired = repair(file.mesh);
  for (const std::string& sentence : repaired.done)
    remark(fmt::format("{}: repaired: {}", options.file.string(), sentence));
  if (repaired.done.empty()) remark(fmt::format("{}: nothing to repair", options.file.string()));
  return std::move(repaired.mesh);
}

Mesh load_refinable_mesh(const MeshOptions& options) {
  Mesh mesh = load_mesh(options);
  require_refinable(mesh, options.file.string());
  return mesh;
}

void save_mesh(const fs::path& file, const Mesh& mesh) {
  const Progress progress(fmt::format("writing {}", file.string()));
  for (const std::string& sentence : write_mesh(file, mesh))
    remark(sentence);
}

void check_output(const fs::path& file, const RunOptions& run,
                  const std::vector<std::string>& extensions, std::string_view option) {
  const std::string extension = to_lower(file.extension().string());
  if (!extensions.empty() &&
      std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
    throw UsageError("{}: {} does not end in {}", option, quote(file.string()),
                     fmt::join(extensions, ", "));
  if (run.json && is_standard_output(file))
    throw UsageError("{}: {} is standard output, where --json prints; leave one of them out",
                     option, quote(file.string()));
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!fs::is_directory(folder, ignored))
    throw OutputError("{}: cannot be written: there is no folder {}", file.string(),
                      quote(folder.string()));
  require_writable(file);
}

void check_output_folder(const fs::path& folder) {
  if (folder.empty()) return;
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored))
    throw OutputError("{}: cannot be written: it is a file; a folder is right", folder.string());
  fs::path there = fs::absolute(folder);  // the part of the path that exists
  while (!fs::exists(there, ignored) && there.has_relative_path())
    there = there.parent_path();
  if (!fs::is_directory(there, ignored))
    throw OutputError("{}: cannot be made: {} is a file", folder.string(), there.string());
  if (faccessat(AT_FDCWD, there.string().c_str(), W_OK | X_OK, AT_EACCESS) != 0)
    throw OutputError("{}: cannot be written: {}", folder.string(),
                      std::generic_category().message(errno));
}

void check_mesh_output(const fs::path& file, const RunOptions& run) {
  std::vector<std::string> extensions;
  for (const Format& format : all_formats)
    if (format.write) extensions.emplace_back(format.extension);
  check_output(file, run, extensions);
}

std::string read_text_file(const fs::path& path) {
  const std::string name = path.string();
  if (std::error_code ignored; fs::is_directory(path, ignored))
    throw InputError("{}: is a directory; a file is right", name);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"),
                                                             std::fclose);
  if (!file) throw InputError("{}: {}", name, std::generic_category().message(errno));
  std::string bytes;
  std::string chunk(1 << 16, '\0');
  while (const std::size_t size = std::fread(chunk.data(), 1, chunk.size(), file.get()))
    bytes.append(chunk, 0, size);
  if (std::ferror(file.get())) throw InputError("{}: cannot be read", name);
  return bytes;
}

}  // namespace limes::app

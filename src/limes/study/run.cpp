#include "limes/study/run.h"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <system_error>

#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/study/shell_supports.h"

namespace limes {
namespace {

/// Times the phases of a run.
class Phases {
 public:
  Phases(const PhaseCallback& on_phase, std::vector<std::pair<std::string, double>>& timings)
      : on_phase_(on_phase), timings_(timings) {}

  template <class Work>
  auto operator()(const std::string& name, const Work& work) {
    check_interrupt();
    if (on_phase_) on_phase_(name);
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    timings_.emplace_back(name, seconds.count());
    return result;
  }

 private:
  const PhaseCallback& on_phase_;
  std::vector<std::pair<std::string, double>>& timings_;
};

template <class Result>
void write_all(const std::filesystem::path& folder, const Result& result) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError("{}: cannot be made: {}", folder.string(), error.message());
  AtomicFiles files;
  const auto write = [&](const std::string& name, std::string_view bytes) {
    files.add(folder / name).write(bytes);
  };
  AtomicFile& vtu = files.add(folder / "result.vtu");
  write_result_vtu([&](std::string_view bytes) { vtu.write(bytes); }, result);
  for (const ReportFile& file : report_files(result))
    write(file.name, file.bytes);
  write("result.json", result_json(result).dump(2) + "\n");
  check_interrupt();
  files.commit();
}

}  // namespace

PlaneResult run_problem(const Problem& problem, const ModelOptions& options,
                        const PhaseCallback& on_phase) {
  std::vector<std::pair<std::string, double>> timings;
  Phases phase(on_phase, timings);
  PlaneResult result{
      phase("model", [&] { return read_model(problem, options); }), {}, {}, {}, {}, 0, {}};
  result.solution = phase("solve", [&] { return solve_plane(result.model); });
  result.probes = phase("probes", [&] { return probe(result.model, result.solution); });
  for (std::string& remark : remarks_on(result.probes, result.model))
    result.model.remarks.push_back(std::move(remark));
  result.checks = phase("checks", [&] { return check_solution(result.model, result.solution); });
  result.timings = std::move(timings);
  return result;
}

ShellResult run_shell_problem(const Problem& problem, const ModelOptions& options,
                              const PhaseCallback& on_phase) {
  std::vector<std::pair<std::string, double>> timings;
  Phases phase(on_phase, timings);
  ShellResult result{
      phase("model", [&] { return read_shell_model(problem, options); }), {}, {}, {}, {}, 0, {}};
  result.solution = phase("solve", [&] { return solve_shell(result.model); });
  for (std::string& remark : remarks_on_symmetry(result.model))
    result.model.remarks.push_back(std::move(remark));
  result.probes = phase("probes", [&] { return probe(result.model, result.solution); });
  for (const ShellProbe& p : result.probes)
    if (p.distance > 0.01 * result.model.diagonal)
      result.model.remarks.push_back(
          fmt::format("{}: probe '{}' is {:.3g} away from the surface; its values are those of the "
                      "nearest point",
                      problem.file.string(), p.name, p.distance));
  result.checks = phase("checks", [&] { return check_solution(result.model, result.solution); });
  result.timings = std::move(timings);
  return result;
}

void write_results(const std::filesystem::path& folder, const PlaneResult& result) {
  write_all(folder, result);
}

void write_results(const std::filesystem::path& folder, const ShellResult& result) {
  write_all(folder, result);
}

}  // namespace limes

#include "curve_refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "files.h"
#include "limes/core/atomic_file.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/curve/refine_curve.h"
#include "limes/io/curves.h"
#include "terminal.h"

namespace limes::app {
namespace {

CurveScheme choose_curve_scheme(const SchemeOptions& typed) {
  const auto refuse = [&](const std::string& value, const char* option) {
    if (!value.empty()) throw UsageError("{}: {} has no such option", option, typed.scheme);
  };
  refuse(typed.boundary, "--boundary");
  refuse(typed.corners, "--corners");
  refuse(typed.tags, "--tags");
  refuse(typed.split, "--split");
  refuse(typed.weights, "--weights");
  refuse(typed.ring_pull, "--ring-pull");
  if (typed.scheme != "four-point") refuse(typed.tension, "--tension");
  if (typed.tension.empty()) return find_curve_scheme(typed.scheme);
  return find_curve_scheme(typed.scheme, parse_tension(typed.tension));
}

/// Before any work is done.
void require_feasible(const std::vector<Polyline>& curves, const CurveScheme& scheme, int levels,
                      const Run& run, const std::string& file) {
  // Both levels of a step, and what the writer holds.
  constexpr double bytes_per_point = 40;
  for (int level = 1; level <= levels; ++level) {
    double points = 0;
    for (const Polyline& c : curves)
      points += refined_size(c.points.size(), c.closed, scheme, level);
    if (points > 2147483647.0)
      throw InputError(
          "{}: level {} would have {:.0f} points: at most 2147483647 can be numbered; "
          "--levels {} is possible",
          file, level, points, level - 1);
    if (points * bytes_per_point > static_cast<double>(run.memory_limit()))
      throw InputError(
          "{}: level {} would have {:.0f} points: that takes about {} of memory, {} may be "
          "used; --levels {} is possible",
          file, level, points, format_size(points * bytes_per_point),
          format_size(static_cast<double>(run.memory_limit())), level - 1);
  }
}

}  // namespace

void refine_curves(const CurveRefinement& work, const RunOptions& options, const Run& run) {
  const CurveScheme scheme = choose_curve_scheme(work.scheme);
  check_output(work.output, options, {".obj"});
  CurveFile file = read_curves(work.input);
  for (const std::string& sentence : file.remarks)
    remark(sentence);
  require_feasible(file.curves, scheme, work.levels, run, work.input.string());
  std::size_t num_points = 0;
  for (Polyline& curve : file.curves) {
    for (int level = 0; level < work.levels; ++level) {
      check_interrupt();
      curve = naming_file(work.input, [&] { return refine(curve, scheme); });
    }
    num_points += curve.points.size();
  }
  write_curves(work.output, file.curves);
  if (options.json)
    print_object({{"vertices", num_points},
                  {"faces", 0},
                  {"curves", file.curves.size()},
                  {"levels", work.levels},
                  {"seconds", run.seconds()},
                  {"peak_memory", peak_memory()}});
  else if (!is_standard_output(work.output))
    print(fmt::format("{}: {} points in {}\n", work.output.string(), num_points,
                      counted(file.curves.size(), "curve", "curves")));
}

}  // namespace limes::app

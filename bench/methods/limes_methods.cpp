// A table of the ways to evaluate a limit surface: accuracy, set-up, memory, time per point.
//   --points N (per face and method)
// Position errors are against 27 plain refinements (76 close to an extraordinary vertex), relative
// to the model's size 1; those of derivatives are relative to the derivatives by limes, whose own
// tests compare them with differences. Memory is what the heap grew by, for limes the whole mesh.
#include <fmt/format.h>
#include <malloc.h>

#include <cmath>

#include "limes/core/error.h"
#include "limes/subdiv/schemes.h"
#include "measure.h"
#include "method_cases.h"

using namespace bench;

namespace {

using limes::SurfaceJet;

struct Outcome {
  double set_up = 0, per_point = 0;
  std::size_t memory = 0;
  std::vector<SurfaceJet> jets;
};

std::size_t heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Tables, then all places; then the places again, often enough for a clock.
Outcome measured(const Method& method, const FaceCase& c, const std::vector<Place>& places) {
  Outcome out;
  out.jets.reserve(places.size());
  const std::size_t before = heap_in_use();
  Timer timer;
  const Evaluate evaluate = method.prepare(c);
  out.set_up = timer.cpu();
  for (const Place& p : places)
    out.jets.push_back(evaluate(p));
  out.memory = heap_in_use() - before;
  timer.restart();
  int rounds = 0;
  double sink = 0;
  do {
    for (const Place& p : places)
      sink += evaluate(p).x.x();
    ++rounds;
  } while (timer.cpu() < 0.05);
  out.per_point = timer.cpu() / (rounds * static_cast<double>(places.size()));
  if (std::isnan(sink)) throw std::runtime_error(method.name + " gives no number");
  return out;
}

std::vector<limes::Vec3> true_positions(const FaceCase& c, const std::vector<Place>& places) {
  std::vector<limes::Vec3> out;
  for (const Place& p : places)
    out.push_back(limes::test::limit_by_refinement(c.model, limes::find_scheme("catmull-clark"),
                                                   c.face, 0, p.uv,
                                                   p.uv.maxCoeff() < 0.02 ? 76 : 27));
  return out;
}

/// Largest distances of x, of (xu, xv) and of (xuu, xuv, xvv).
struct Errors {
  double position = 0, first = 0, second = 0;
};

double distance(std::initializer_list<limes::Vec3> values,
                std::initializer_list<limes::Vec3> truth) {
  double error = 0, size = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double d = (values.begin()[i] - truth.begin()[i]).norm();
    error = std::isnan(d) ? d : std::max(error, d);
    size = std::max(size, truth.begin()[i].norm());
  }
  return error / size;
}

Errors errors_of(const std::vector<SurfaceJet>& jets, const std::vector<limes::Vec3>& truth,
                 const std::vector<SurfaceJet>& ours) {
  Errors e;
  for (std::size_t i = 0; i < jets.size(); ++i) {
    const SurfaceJet& a = jets[i];
    const SurfaceJet& b = ours[i];
    e.position = std::max(e.position, (a.x - truth[i]).norm());
    const double first = distance({a.xu, a.xv}, {b.xu, b.xv});
    const double second = distance({a.xuu, a.xuv, a.xvv}, {b.xuu, b.xuv, b.xvv});
    e.first = std::isnan(first) ? first : std::max(e.first, first);
    e.second = std::isnan(second) ? second : std::max(e.second, second);
  }
  return e;
}

std::string number(double error) {
  return std::isnan(error) ? "–" : fmt::format("{:.0e}", error);
}

std::string duration(double seconds) {
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", 1e3 * seconds);
  if (seconds >= 1e-6) return fmt::format("{:.3g} µs", 1e6 * seconds);
  return fmt::format("{:.0f} ns", 1e9 * seconds);
}

void print_row(const std::string& face, const Method& method, const Outcome& o, const Errors& e) {
  const bool is_ours = method.name.rfind("limes", 0) == 0;
  fmt::print("| {} | {} | {} | {} | {} | {} | {:.0f} kB | {} |\n", face, method.name,
             number(e.position), is_ours ? "–" : number(e.first), is_ours ? "–" : number(e.second),
             duration(o.set_up), static_cast<double>(o.memory) / 1e3, duration(o.per_point));
}

void print_case(const FaceCase& c, int num_points) {
  const std::vector<Place> places = sample_places(c, num_points);
  const std::vector<limes::Vec3> truth = true_positions(c, places);
  std::vector<SurfaceJet> ours;
  for (const Method& method : all_methods()) {
    if (method.at_boundary_only && c.kind == FaceCase::Kind::inner) continue;
    try {
      const Outcome o = measured(method, c, places);
      if (ours.empty()) ours = o.jets;
      print_row(c.name, method, o, errors_of(o.jets, truth, ours));
    } catch (const limes::InputError& error) {
      fmt::print("| {} | {} | does not apply: {} | | | | | |\n", c.name, method.name, error.what());
    }
  }
}

void run(const Args& args) {
  const int num_points = args.get("points", 200);
  args.require_all_read();
  fmt::print("| method | applies to |\n|---|---|\n");
  for (const Method& method : all_methods())
    fmt::print("| {} | {} |\n", method.name, method.applies_to);
  fmt::print("\n| face | method | position | first | second | set-up | memory | a point |\n");
  fmt::print("|---|---|---|---|---|---|---|---|\n");
  for (const FaceCase& c : face_cases())
    print_case(c, num_points);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("limes_methods", argc, argv, run);
}

// Problem files and overrides: any bytes give a problem or an error of ours, one line long.
// A zero byte ends the file; the texts after it, each ended by a zero byte, are overrides.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "limes/core/error.h"
#include "limes/problem/problem.h"

namespace {

/// What every problem that was read promises.
bool keeps_promises(const limes::Problem& p) {
  bool good = !p.mesh.file.empty() && p.mesh.levels >= 0 && !p.materials.empty();
  const bool poisson = p.model.kind == limes::ModelKind::poisson;
  for (const limes::MaterialSettings& m : p.materials)
    good =
        good && m.thickness > 0 && std::isfinite(m.thickness) && m.conductivity > 0 &&
        std::isfinite(m.conductivity) &&
        (poisson || (m.young > 0 && std::isfinite(m.young) && m.poisson > -1 && m.poisson < 0.5));
  if (p.adapt)
    good = good && p.adapt->share > 0 && p.adapt->share <= 1 && p.adapt->max_dofs > 0 &&
           p.adapt->max_steps > 0 && p.adapt->target_error.value_or(0.5) > 0 &&
           p.adapt->reference_energy.value_or(1) > 0;
  for (const std::string& value : p.values)
    good = good && value.find('\n') == std::string::npos && value.find(" = ") != std::string::npos;
  for (const limes::LoadSettings& load : p.loads)
    for (const limes::Expression& value : load.value)
      (void)value(limes::Vec3(0.1, -2, 3));
  for (const limes::ProbeSettings& probe : p.probes)
    good = good && probe.at.allFinite() && !probe.name.empty();
  return good;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(rest.find('\0'), rest.size());
  const std::string_view file = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  std::vector<std::string> overrides;
  while (!rest.empty()) {
    const std::size_t length = std::min(rest.find('\0'), rest.size());
    overrides.emplace_back(rest.substr(0, length));
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  try {
    if (!keeps_promises(limes::parse_problem(file, "fuzz.toml", overrides))) std::abort();
  } catch (const limes::Error& error) {
    const std::string_view message = error.what();
    if (message.empty() || message.find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}

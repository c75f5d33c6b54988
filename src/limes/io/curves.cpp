#include "limes/io/curves.h"

#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "limes/io/chunk_writer.h"
#include "limes/io/whole_file.h"

namespace limes {

CurveFile read_curves(const std::filesystem::path& file) {
  require_file(file);
  if (to_lower(file.extension().string()) != ".obj")
    throw InputError("{}: curves are read from .obj files", file.string());
  return read_obj_curves(read_bytes(file), file.string());
}

void write_curves(const std::filesystem::path& path, const std::vector<Polyline>& curves) {
  if (to_lower(path.extension().string()) != ".obj")
    throw UsageError("{}: curves are written as .obj", path.string());
  for (const Polyline& curve : curves)
    for (const Vec3& x : curve.points)
      if (!x.allFinite())
        throw OutputError("{}: cannot be written: a curve has a coordinate that is too large",
                          path.string());
  AtomicFile file(path);
  const ByteSink sink = [&](std::string_view bytes) {
    check_interrupt();
    file.write(bytes);
  };
  ChunkWriter out(sink);
  std::int64_t number = 1;
  for (const Polyline& curve : curves) {
    for (const Vec3& x : curve.points)
      out.print("v {} {} {}\n", x[0], x[1], x[2]);
    out.print("l");
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      out.print(" {}", number + static_cast<std::int64_t>(i));
    if (curve.closed) out.print(" {}", number);
    out.print("\n");
    number += static_cast<std::int64_t>(curve.points.size());
  }
  out.flush();
  file.commit();
}

}  // namespace limes

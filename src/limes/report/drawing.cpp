#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/report/canvas.h"

namespace limes {

std::string to_svg(const Drawing& drawing, SvgForm form) {
  SvgCanvas canvas(drawing.width, drawing.height, drawing.description, form);
  drawing.draw(canvas);
  return std::move(canvas).finish();
}

Image to_image(const Drawing& drawing, double density) {
  ImageCanvas canvas(drawing.width, drawing.height, density);
  drawing.draw(canvas);
  return std::move(canvas).finish();
}

void write_drawing(const std::filesystem::path& file, const Drawing& drawing) {
  const std::string extension = to_lower(file.extension().string());
  if (extension == ".svg") {
    write_file(file, to_svg(drawing));
  } else if (extension == ".png") {
    write_png(file, to_image(drawing));
  } else {
    throw UsageError("{}: pictures are written as .svg or .png, not '{}'", file.string(),
                     extension);
  }
}

}  // namespace limes

#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limes/report/colour.h"

namespace limes {

/// Opaque pixels, three bytes each (red, green, blue in sRGB), row by row from the top.
class Image {
 public:
  Image() = default;
  Image(int width, int height, const Colour& background = palette::paper);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  [[nodiscard]] std::uint8_t* row(int y) { return bytes_.data() + offset(0, y); }
  [[nodiscard]] const std::uint8_t* row(int y) const { return bytes_.data() + offset(0, y); }
  [[nodiscard]] std::span<const std::uint8_t, 3> pixel(int x, int y) const {
    return std::span<const std::uint8_t, 3>(bytes_.data() + offset(x, y), 3);
  }
  /// Mixes a colour into one pixel; what lies outside the image is ignored.
  /// @param alpha  0: the pixel stays, 1: the colour replaces it
  void blend(int x, int y, const Colour& colour, float alpha);

  friend bool operator==(const Image&, const Image&) = default;

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x));
  }
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> bytes_;
};

/// The part that is not all background, with `margin` pixels of background around it where the
/// image has them. An image of background only stays as it is.
[[nodiscard]] Image trimmed(const Image& image, const Colour& background, int margin);

/// The bytes of a PNG file: 8-bit RGB, no time stamp, the same for the same pixels.
[[nodiscard]] std::string encode_png(const Image& image);
/// The same as a file that appears complete or not at all. @throws OutputError
void write_png(const std::filesystem::path& file, const Image& image);

/// RFC 4648, section 4, with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace limes

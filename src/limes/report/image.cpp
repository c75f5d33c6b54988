#include "limes/report/image.h"

#include <png.h>

#include <algorithm>
#include <cmath>

#include "limes/core/atomic_file.h"
#include "limes/core/error.h"

namespace limes {
Image::Image(int width, int height, const Colour& background) : width_(width), height_(height) {
  LIMES_ASSERT(width > 0 && height > 0);
  const auto [r, g, b] = to_bytes(background);
  bytes_.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < bytes_.size(); i += 3) {
    bytes_[i] = r;
    bytes_[i + 1] = g;
    bytes_[i + 2] = b;
  }
}

void Image::blend(int x, int y, const Colour& colour, float alpha) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_ || alpha <= 0) return;
  std::uint8_t* p = bytes_.data() + offset(x, y);
  const auto part = [&](std::uint8_t old, float c) {
    const float from = old;
    return static_cast<std::uint8_t>(std::lround(from + std::min(alpha, 1.0F) * (c * 255 - from)));
  };
  p[0] = part(p[0], colour.r);
  p[1] = part(p[1], colour.g);
  p[2] = part(p[2], colour.b);
}

Image trimmed(const Image& image, const Colour& background, int margin) {
  const auto empty = to_bytes(background);
  int left = image.width(), right = -1, top = image.height(), bottom = -1;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const auto pixel = image.pixel(x, y);
      if (std::equal(pixel.begin(), pixel.end(), empty.begin())) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = y;
    }
  }
  if (right < 0) return image;
  left = std::max(left - margin, 0);
  top = std::max(top - margin, 0);
  Image result(std::min(right + margin, image.width() - 1) - left + 1,
               std::min(bottom + margin, image.height() - 1) - top + 1);
  for (int y = 0; y < result.height(); ++y)
    std::copy_n(image.row(top + y) + 3 * left, 3 * result.width(), result.row(y));
  return result;
}

std::string encode_png(const Image& image) {
  LIMES_ASSERT(!image.empty());
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width());
  header.height = static_cast<png_uint_32>(image.height());
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string result(size, '\0');
  if (!png_image_write_to_memory(&header, result.data(), &size, 0, image.bytes().data(), 0,
                                 nullptr)) {
    throw OutputError("PNG of {} x {} pixels: {}", image.width(), image.height(), header.message);
  }
  result.resize(size);
  return result;
}

void write_png(const std::filesystem::path& file, const Image& image) {
  write_file(file, encode_png(image));
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (j < left ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      result += j <= left ? digits[group >> (18 - 6 * j) & 63U] : '=';
  }
  return result;
}

}  // namespace limes

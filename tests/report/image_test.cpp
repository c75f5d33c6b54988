#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "limes/core/error.h"
#include "limes/report/image.h"

namespace limes {
namespace {

/// Reads a PNG with libpng itself.
Image decode(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()))
      << header.message;
  EXPECT_EQ(header.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  EXPECT_TRUE(png_image_finish_read(&header, nullptr, image.row(0), 0, nullptr)) << header.message;
  return image;
}

Image checkered() {
  Image image(37, 21, Colour::hex(0x102030));
  for (int y = 0; y < image.height(); ++y)
    for (int x = (y % 2); x < image.width(); x += 2)
      image.blend(x, y, {static_cast<float>(x) / 36, static_cast<float>(y) / 20, 0.5F}, 1);
  return image;
}

TEST(Image, PngDecodesToTheSamePixels) {
  const Image image = checkered();
  const Image read = decode(encode_png(image));
  ASSERT_EQ(read.width(), 37);
  ASSERT_EQ(read.height(), 21);
  EXPECT_EQ(read.bytes(), image.bytes());
  EXPECT_EQ(read.pixel(1, 0)[0], 0x10);
  EXPECT_EQ(read.pixel(1, 0)[2], 0x30);
  EXPECT_EQ(read.pixel(36, 20)[0], 255);
  EXPECT_EQ(read.pixel(36, 20)[2], 128);
}

TEST(Image, SamePixelsGiveTheSameBytes) {
  EXPECT_EQ(encode_png(checkered()), encode_png(checkered()));
}

TEST(Image, FileHoldsTheEncodedBytes) {
  const auto file = std::filesystem::path(testing::TempDir()) / "limes_report_image.png";
  write_png(file, checkered());
  std::ostringstream read;
  read << std::ifstream(file, std::ios::binary).rdbuf();
  EXPECT_EQ(read.str(), encode_png(checkered()));
  std::filesystem::remove(file);
}

TEST(Image, UnwritableFileIsAnOutputError) {
  EXPECT_THROW(write_png("/nonexistent-folder/x.png", checkered()), OutputError);
}

TEST(Image, BlendMixesAndIgnoresWhatIsOutside) {
  Image image(2, 1, Colour::hex(0x000000));
  image.blend(0, 0, Colour::hex(0xffffff), 0.5F);
  EXPECT_EQ(image.pixel(0, 0)[0], 128);
  EXPECT_EQ(image.pixel(1, 0)[0], 0);
  const Image before = image;
  image.blend(2, 0, Colour::hex(0xffffff), 1);
  image.blend(-1, 0, Colour::hex(0xffffff), 1);
  image.blend(0, 1, Colour::hex(0xffffff), 1);
  EXPECT_EQ(image, before);
}

// The vectors of RFC 4648, section 10.
TEST(Base64, FollowsTheRfc) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace limes

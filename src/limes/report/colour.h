#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace limes {

/// A colour in sRGB, components in [0, 1].
struct Colour {
  float r = 0, g = 0, b = 0;

  /// From 0xRRGGBB.
  static constexpr Colour hex(std::uint32_t rgb) {
    return {static_cast<float>(rgb >> 16 & 255U) / 255, static_cast<float>(rgb >> 8 & 255U) / 255,
            static_cast<float>(rgb & 255U) / 255};
  }
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Nearest of the 256 steps; what lies outside [0, 1] is cut off.
[[nodiscard]] std::array<std::uint8_t, 3> to_bytes(const Colour& colour);
/// "#rrggbb", for SVG and CSS.
[[nodiscard]] std::string to_css(const Colour& colour);
/// (1 - t) a + t b
[[nodiscard]] Colour mix(const Colour& a, const Colour& b, float t);

/// A colour in polar OKLab coordinates: equal steps look equally large.
/// Björn Ottosson, "A perceptual color space for image processing", 2020.
struct OkLch {
  double lightness;  ///< 0 black, 1 white
  double chroma;     ///< 0 grey; sRGB reaches 0.1 to 0.3, depending on lightness and hue
  double hue;        ///< degrees: 30 red, 110 yellow, 145 green, 195 cyan, 265 blue, 330 magenta
};

/// The colour in sRGB; one that sRGB does not have loses chroma until it fits.
[[nodiscard]] Colour to_srgb(const OkLch& colour);

/// Colours for text, lines and categories that go together and stay apart in grey and for the
/// colour-blind.
namespace palette {
inline constexpr Colour ink = Colour::hex(0x1f2328);    ///< text and edges
inline constexpr Colour muted = Colour::hex(0x5c6670);  ///< secondary text
inline constexpr Colour rule = Colour::hex(0xd5dae0);   ///< grid lines
inline constexpr Colour paper = Colour::hex(0xffffff);
inline constexpr Colour clay = Colour::hex(0xb9c6d3);  ///< a shaded surface without a field
inline constexpr Colour no_data = Colour::hex(0xc9c9c9);

inline constexpr Colour green = Colour::hex(0xa9d6a0);
inline constexpr Colour yellow = Colour::hex(0xf7e07f);
inline constexpr Colour orange = Colour::hex(0xf2a65a);
inline constexpr Colour red = Colour::hex(0xd9564a);

/// For the series of a plot, in this order.
inline constexpr std::array series{
    Colour::hex(0x1f5fa8), Colour::hex(0xc8452f), Colour::hex(0x2f8a57), Colour::hex(0x8a4f9e),
    Colour::hex(0xc98a12), Colour::hex(0x3b9db3), Colour::hex(0x6b4a35), Colour::hex(0x555c63)};
}  // namespace palette

}  // namespace limes

#include "fields/colour_map.hpp"

#include <algorithm>
#include <cmath>

namespace drape::fields {
namespace {

/// From the usual notation 0xRRGGBB.
constexpr ScreenColour hex(unsigned rgb) {
  constexpr float full = 255.0F;
  return {static_cast<float>(rgb >> 16U) / full, static_cast<float>((rgb >> 8U) & 0xFFU) / full,
          static_cast<float>(rgb & 0xFFU) / full};
}

constexpr ColourMap viridis{hex(0x440154), hex(0x482475), hex(0x414487), hex(0x355f8d), hex(0x2a788e), hex(0x21918c),
                            hex(0x22a884), hex(0x44bf70), hex(0x7ad151), hex(0xbddf26), hex(0xfde725)};
constexpr ColourMap redBlue{hex(0x053061), hex(0x2166ac), hex(0x4393c3), hex(0x92c5de), hex(0xd1e5f0), hex(0xf7f7f7),
                            hex(0xfddbc7), hex(0xf4a582), hex(0xd6604d), hex(0xb2182b), hex(0x67001f)};

}  // namespace

const ColourMap& magnitudeColours() {
  return viridis;
}

const ColourMap& signedColours() {
  return redBlue;
}

const ColourMap& coloursOf(const sim::fields::FieldInfo& field) {
  return field.hasSign ? redBlue : viridis;
}

ScreenColour colourAt(const ColourMap& map, double place) {
  const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(map.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), map.size() - 2);
  const auto share = static_cast<float>(at - static_cast<double>(below));
  ScreenColour colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    colour[i] = map[below][i] + share * (map[below + 1][i] - map[below][i]);
  }
  return colour;
}

}  // namespace drape::fields

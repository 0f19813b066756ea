#pragma once

#include "sim/fields/field_table.hpp"

#include <array>

namespace drape::fields {

/// A colour as it appears on the screen: red, green and blue from 0 to 1.
using ScreenColour = std::array<float, 3>;

/// Colours at equal distances, linear between them.
using ColourMap = std::array<ScreenColour, 11>;

/// For magnitudes: viridis (van der Walt and Smith 2015, matplotlib; CC0), perceptually uniform from dark to bright,
/// also for people who see few colours.
[[nodiscard]] const ColourMap& magnitudeColours();

/// For quantities with a sign: RdBu (ColorBrewer, Harrower and Brewer 2003), blue below and red above a white middle.
[[nodiscard]] const ColourMap& signedColours();

/// The colours of a field.
[[nodiscard]] const ColourMap& coloursOf(const sim::fields::FieldInfo& field);

/// @param place in the range, 0 at its low end and 1 at its high end; others get the colours of the ends
[[nodiscard]] ScreenColour colourAt(const ColourMap& map, double place);

}  // namespace drape::fields

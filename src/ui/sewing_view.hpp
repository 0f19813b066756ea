#pragma once

#include "sim/model/vector.hpp"
#include "text/sentence.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace drape::ui {

/// What the mode Sew makes of the borders that are picked.
enum class SewingKind { Seam, Band };

/// How much of an open border a click picks.
enum class BorderExtent {
  Corners,  ///< the part between two corners
  Points,   ///< the part between this click and the next one
  Whole     ///< all of it
};

/// A border in the picture, or a part of it.
struct BorderLine {
  std::vector<Vec2> points;  ///< [window units]
  bool isClosed = false;
};

/// A picked border, for the window.
struct PickedSide {
  BorderLine line;
  std::size_t vertices = 0;
  double length = 0.0;  ///< at rest [m]
};

/// A seam in the picture: lines between its pairs [window units].
struct SeamLines {
  std::vector<std::array<Vec2, 2>> pairs;
  bool isWelded = false;
};

/// The state of the mode Sew, for the window.
struct SewingView {
  SewingKind kind = SewingKind::Seam;
  BorderExtent extent = BorderExtent::Corners;
  BorderLine border;                       ///< the whole border under the mouse; may be empty
  BorderLine hovered;                      ///< the part of it that a click picks; may be empty
  std::optional<Vec2> start;               ///< where a part between two clicks starts [window units]
  std::vector<PickedSide> sides;           ///< that are picked, in order: up to two
  std::vector<std::array<Vec2, 2>> pairs;  ///< of vertices that would be sewn, in order [window units]
  text::Sentence problem;                  ///< why the picked borders cannot be sewn; empty: they can
  std::vector<Vec2> places;                ///< the middle of each part between corners [window units]
  std::vector<SeamLines> seams;            ///< of the cloth
  std::optional<double> bandLength;        ///< of the elastic band along the picked border, if there is one [-]
};

}  // namespace drape::ui

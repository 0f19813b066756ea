#pragma once

#include "sim/model/vector.hpp"

#include <map>
#include <string>

namespace drape::ui {

/// A rectangle in window coordinates; (0, 0) is the top left corner of the window.
struct UiRect {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
  bool visible = true;  ///< false when it is scrolled out of view

  [[nodiscard]] bool contains(const Vec2& point) const {
    return point.x() >= x && point.x() < x + width && point.y() >= y && point.y() < y + height;
  }
};

/// Rectangles by name: settings by key, buttons as "button.play" and the like, sections as "section.air".
using UiRects = std::map<std::string, UiRect>;

}  // namespace drape::ui

#include "report/curve_inks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace drape::report {
namespace {

constexpr std::array others{Ink::Curve1, Ink::Curve2, Ink::Curve3, Ink::Curve4, Ink::Curve5, Ink::Curve6};
static_assert(others.size() >= static_cast<std::size_t>(maxHighlighted));

/// The lines of a plot, the most important first: those of `auto`, then by importance, then in their order.
std::vector<std::size_t> linesByImportance(const Plot& plot) {
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    if (plot.curves[i].style == CurveStyle::Line) {
      lines.push_back(i);
    }
  }
  std::stable_sort(lines.begin(), lines.end(), [&](std::size_t a, std::size_t b) {
    const bool autoA = isOfAuto(plot.curves[a].label);
    const bool autoB = isOfAuto(plot.curves[b].label);
    return autoA != autoB ? autoA : !autoA && plot.curves[a].importance > plot.curves[b].importance;
  });
  return lines;
}

}  // namespace

bool isOfAuto(std::string_view label) {
  constexpr std::string_view own = "auto";
  return label.starts_with(own) && (label.size() == own.size() || label[own.size()] == ',' || label[own.size()] == ' ');
}

std::vector<CurveInk> curveInks(const Plot& plot) {
  std::vector<std::size_t> highlighted = linesByImportance(plot);
  highlighted.resize(std::min<std::size_t>(highlighted.size(), maxHighlighted));
  std::sort(highlighted.begin(), highlighted.end());
  std::vector<CurveInk> inks(plot.curves.size());
  int ofAuto = 0;
  std::size_t ofOthers = 0;
  for (std::size_t i = 0; i < inks.size(); ++i) {
    if (plot.curves[i].style != CurveStyle::Line) {
      continue;
    }
    if (!std::binary_search(highlighted.begin(), highlighted.end(), i)) {
      inks[i].ink = Ink::Grey;
    } else if (isOfAuto(plot.curves[i].label)) {
      inks[i] = {Ink::Auto, ofAuto++};
    } else {
      inks[i].ink = others.at(ofOthers++);
    }
  }
  return inks;
}

}  // namespace drape::report

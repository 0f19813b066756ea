#include "report/svg_ink.hpp"

#include <algorithm>
#include <array>

namespace drape::report {
namespace {

struct InkRow {
  Ink ink;
  const char* name;  ///< in the names of classes
  const char* light;
  const char* dark;
};

// The colours of curves can be told apart by colour-blind readers (after Okabe and Ito).
constexpr std::array table{
    InkRow{Ink::Text, "text", "#222222", "#dddddd"},         InkRow{Ink::Faint, "faint", "#dddddd", "#444444"},
    InkRow{Ink::Paper, "paper", "#ffffff", "#16181c"},       InkRow{Ink::Auto, "auto", "#d55e00", "#ff8c42"},
    InkRow{Ink::Curve1, "curve1", "#0072b2", "#4aa8e0"},     InkRow{Ink::Curve2, "curve2", "#009e73", "#35c99b"},
    InkRow{Ink::Curve3, "curve3", "#b0569a", "#e08fc8"},     InkRow{Ink::Curve4, "curve4", "#222222", "#dddddd"},
    InkRow{Ink::Curve5, "curve5", "#b98000", "#f0b840"},     InkRow{Ink::Curve6, "curve6", "#2c8fc4", "#8fd0f5"},
    InkRow{Ink::Grey, "grey", "#bcbcbc", "#5c6066"},         InkRow{Ink::Good, "good", "#bfe5cf", "#1f5a3c"},
    InkRow{Ink::Doubtful, "doubtful", "#ffe39a", "#6b5410"}, InkRow{Ink::Bad, "bad", "#f6b5a8", "#7a2c1e"},
    InkRow{Ink::Dull, "dull", "#c3d6ee", "#28466b"},         InkRow{Ink::None, "none", "#eeeeee", "#2a2d33"}};

const InkRow& rowOf(Ink ink) {
  return *std::find_if(table.begin(), table.end(), [ink](const InkRow& row) { return row.ink == ink; });
}

}  // namespace

std::string lightColour(Ink ink) {
  return rowOf(ink).light;
}

std::string fillClass(Ink ink) {
  return std::string("fill-") + rowOf(ink).name;
}

std::string lineClass(Ink ink) {
  return std::string("line-") + rowOf(ink).name;
}

std::string darkStyle() {
  std::string style;
  for (const InkRow& row : table) {
    style += "." + fillClass(row.ink) + " { fill: " + row.dark + "; } ";
    style += "." + lineClass(row.ink) + " { stroke: " + row.dark + "; }\n";
  }
  return style;
}

}  // namespace drape::report

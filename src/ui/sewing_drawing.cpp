// The borders, pairs and seams of the mode Sew, drawn over the picture.
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace drape::ui {
namespace {

// Colours that stand out from cloth of any colour, in both themes. People who see no red or no green can tell blue and
// orange apart.
const ImVec4 firstColour{0.20F, 0.55F, 1.0F, 1.0F};
const ImVec4 secondColour{1.0F, 0.60F, 0.10F, 1.0F};
const ImVec4 hoverColour{1.0F, 1.0F, 1.0F, 1.0F};
const ImVec4 pairColour{0.93F, 0.95F, 0.98F, 0.85F};
const ImVec4 openColour{0.36F, 0.85F, 0.45F, 0.9F};
const ImVec4 haloColour{0.04F, 0.05F, 0.07F, 0.65F};

// Lengths at scale 1 [window units].
constexpr float pickedWidth = 4.0F;
constexpr float hoveredWidth = 3.0F;
constexpr float borderWidth = 1.5F;
constexpr float pairWidth = 1.2F;
constexpr float haloWidth = 2.0F;  // on both sides together
constexpr float dotRadius = 5.5F;
constexpr float arrowLength = 13.0F;

/// Enough lines between the pairs of a long seam.
constexpr std::size_t maxPairLines = 48;

/// Where and how large things are drawn.
struct Canvas {
  ImDrawList& list;
  float scale;
};

ImVec2 at(const Vec2& point) {
  return {static_cast<float>(point.x()), static_cast<float>(point.y())};
}

ImU32 packed(const ImVec4& colour, float share = 1.0F) {
  return ImGui::GetColorU32(ImVec4(colour.x, colour.y, colour.z, share * colour.w));
}

void drawLine(const Canvas& canvas, std::span<const Vec2> points, bool isClosed, float width, ImU32 colour) {
  std::vector<ImVec2> path;
  std::ranges::transform(points, std::back_inserter(path), at);
  canvas.list.AddPolyline(path.data(), static_cast<int>(path.size()), colour,
                          isClosed ? ImDrawFlags_Closed : ImDrawFlags_None, width * canvas.scale);
}

void drawBorder(const Canvas& canvas, const BorderLine& line, float width, const ImVec4& colour, float share = 1.0F) {
  if (line.points.size() > 1) {
    drawLine(canvas, line.points, line.isClosed, width + haloWidth, packed(haloColour, share));
    drawLine(canvas, line.points, line.isClosed, width, packed(colour, share));
  }
}

void drawDot(const Canvas& canvas, const Vec2& point, const ImVec4& colour) {
  canvas.list.AddCircleFilled(at(point), (dotRadius + 0.5F * haloWidth) * canvas.scale, packed(haloColour));
  canvas.list.AddCircleFilled(at(point), dotRadius * canvas.scale, packed(colour));
}

void drawTriangle(const Canvas& canvas, const Vec2& tip, const Vec2& along, double length, ImU32 colour) {
  const Vec2 foot = tip - length * along;
  const Vec2 across = 0.55 * length * Vec2(-along.y(), along.x());
  canvas.list.AddTriangleFilled(at(tip), at(foot + across), at(foot - across), colour);
}

/// An arrow head along a path.
void drawArrow(const Canvas& canvas, const Vec2& from, const Vec2& to, const ImVec4& colour) {
  const Vec2 along = to - from;
  if (along.norm() < 1e-3) {
    return;
  }
  const auto length = static_cast<double>(arrowLength * canvas.scale);
  const auto halo = static_cast<double>(haloWidth * canvas.scale);
  const Vec2 direction = along.normalized();
  const Vec2 tip = 0.5 * (from + to) + 0.5 * length * direction;
  drawTriangle(canvas, tip + halo * direction, direction, length + 2.0 * halo, packed(haloColour));
  drawTriangle(canvas, tip, direction, length, packed(colour));
}

/// The pairs of the picked borders, and on each side the direction from its first vertex to its last one.
void drawPairs(const Canvas& canvas, const std::vector<std::array<Vec2, 2>>& pairs) {
  if (pairs.empty()) {
    return;
  }
  const std::size_t stride = (pairs.size() + maxPairLines - 1) / maxPairLines;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i % stride == 0 || i + 1 == pairs.size()) {
      drawLine(canvas, pairs[i], false, pairWidth + haloWidth, packed(haloColour, 0.5F));
      drawLine(canvas, pairs[i], false, pairWidth, packed(pairColour));
    }
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const ImVec4& colour = side == 0 ? firstColour : secondColour;
    for (const std::size_t quarter : {1U, 3U}) {
      const std::size_t i = std::min(quarter * pairs.size() / 4, pairs.size() - 1);
      if (i > 0) {
        drawArrow(canvas, pairs[i - 1][side], pairs[i][side], colour);
      }
    }
    drawDot(canvas, pairs.front()[side], colour);
  }
}

/// A seam that is there: lines between its pairs, or a line along it once it is welded.
void drawSeam(const Canvas& canvas, const SeamLines& seam, bool isLit) {
  const float width = isLit ? hoveredWidth : pairWidth;
  BorderLine along;
  for (const std::array<Vec2, 2>& pair : seam.pairs) {
    along.points.push_back(pair[0]);
    if (!seam.isWelded) {
      drawLine(canvas, pair, false, width + haloWidth, packed(haloColour, 0.5F));
      drawLine(canvas, pair, false, width, packed(openColour));
    }
  }
  if (seam.isWelded) {
    drawBorder(canvas, along, width, openColour);
  }
}

}  // namespace

void drawSewing(PanelContext& context, const SewingView& sewing, const UiRect& view) {
  const Canvas canvas{*ImGui::GetBackgroundDrawList(), context.scale};
  const ImVec2 low{static_cast<float>(view.x), static_cast<float>(view.y)};
  canvas.list.PushClipRect(low, {low.x + static_cast<float>(view.width), low.y + static_cast<float>(view.height)});
  for (std::size_t i = 0; i < sewing.seams.size(); ++i) {
    drawSeam(canvas, sewing.seams[i], context.memory.hoveredSeam == i);
  }
  drawBorder(canvas, sewing.border, borderWidth, hoverColour, 0.7F);
  drawBorder(canvas, sewing.hovered, hoveredWidth, hoverColour);
  for (std::size_t i = 0; i < sewing.sides.size(); ++i) {
    drawBorder(canvas, sewing.sides[i].line, pickedWidth, i == 0 ? firstColour : secondColour);
  }
  drawPairs(canvas, sewing.pairs);
  if (sewing.start) {
    drawDot(canvas, *sewing.start, hoverColour);
  }
  canvas.list.PopClipRect();
}

}  // namespace drape::ui

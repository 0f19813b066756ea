#include "io/obj_writer.hpp"

#include <fmt/core.h>

namespace drape::io {
namespace {

void appendNumber(std::string& text, double value) {
  const std::string number = fmt::format("{:.6f}", value);
  text += number == "-0.000000" ? " 0.000000" : " " + number;
}

template <typename Vector>
void appendRows(std::string& text, std::string_view keyword, const std::vector<Vector>& rows) {
  for (const Vector& row : rows) {
    text += keyword;
    for (const double value : row) {
      appendNumber(text, value);
    }
    text += '\n';
  }
}

}  // namespace

std::string objText(const std::vector<Vec3>& positions, const RenderMesh& render, std::string_view comment) {
  std::string text = "# " + std::string(comment) + "\n";
  appendRows(text, "v", positions);
  appendRows(text, "vt", render.uvs);
  for (const Triangle& triangle : render.triangles) {
    text += 'f';
    for (const int corner : triangle) {
      text += ' ' + std::to_string(render.particle[corner] + 1);
      if (!render.uvs.empty()) {
        text += '/' + std::to_string(corner + 1);
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace drape::io

#include "io/obj_writer.hpp"

#include <array>
#include <charconv>

namespace drape {
namespace {

void appendNumber(std::string& text, double value) {
  // The largest double has 309 digits before the point.
  std::array<char, 352> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, 6);
  std::string_view number(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
  if (number == "-0.000000") {
    number.remove_prefix(1);
  }
  text += ' ';
  text += number;
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

}  // namespace drape

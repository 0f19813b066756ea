#include "report/sections/validation_picture.hpp"

#include "report/validation/validation_rows.hpp"
#include "sim/model/vector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace drape::report::sections {
namespace {

constexpr double elevation = 35.0 * std::numbers::pi / 180.0;  // of the view
constexpr double unit = 1e-4;                                  // of the positions [m]

std::vector<Vec3> positionsOf(const ReportRow& shape) {
  std::vector<Vec3> positions;
  const ReportRow& numbers = shape["positions"];
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    positions.emplace_back(unit * numbers[i].get<double>(), unit * numbers[i + 1].get<double>(),
                           unit * numbers[i + 2].get<double>());
  }
  return positions;
}

/// A panel of one shape. The view is along -z, downwards by the elevation.
Drawing::Panel panelOf(const ReportRow& shape, const std::string& caption) {
  const std::vector<Vec3> positions = positionsOf(shape);
  const Vec3 up(0.0, std::cos(elevation), -std::sin(elevation));
  const Vec3 towards(0.0, std::sin(elevation), std::cos(elevation));
  const Vec3 light = Vec3(-0.5, 0.8, 0.45).normalized();
  std::vector<std::pair<double, Drawing::Face>> faces;  // with the distance towards the viewer
  const ReportRow& corners = shape["triangles"];
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    std::array<Vec3, 3> at;
    for (std::size_t corner = 0; corner < at.size(); ++corner) {
      at[corner] = positions.at(corners[i + corner].get<std::size_t>());
    }
    Vec3 normal = (at[1] - at[0]).cross(at[2] - at[0]).normalized();
    normal = normal.dot(towards) < 0.0 ? Vec3(-normal) : normal;
    Drawing::Face face;
    for (std::size_t corner = 0; corner < at.size(); ++corner) {
      face.x[corner] = at[corner].x();
      face.y[corner] = at[corner].dot(up);
    }
    face.light = 0.15 + 0.85 * std::max(0.0, normal.dot(light));
    faces.emplace_back((at[0] + at[1] + at[2]).dot(towards), face);
  }
  std::ranges::stable_sort(faces, {}, [](const auto& face) { return face.first; });
  Drawing::Panel panel{caption, {}};
  for (const auto& [distance, face] : faces) {
    panel.faces.push_back(face);
  }
  return panel;
}

}  // namespace

Drawing pictureOf(const ReportRows& rows) {
  Drawing drawing{.name = "validation-drape", .title = "Cusick's drape test, at rest", .halfWidth = 0.15, .panels = {}};
  for (const ReportRow& row : rows) {
    if (row.contains("shape") && row["shape"].is_object() && !row["results"].empty()) {
      const ReportRow& result = row["results"].back();
      drawing.panels.push_back(panelOf(row["shape"], row.value("name", "") + ": " + validation::figureOf(row, result) +
                                                         " %, " + result.value("note", "")));
    }
  }
  return drawing;
}

}  // namespace drape::report::sections

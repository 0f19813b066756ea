#pragma once

#include "report/number_text.hpp"
#include "report/section.hpp"

#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace drape::report::sections {

/// Whether a row of work_precision is a calm setting with known time and error.
[[nodiscard]] inline bool isCalmRow(const ReportRow& row) {
  return row.value("state", "") == "calm" && std::isfinite(numberIn(row, "us_per_simulated_second")) &&
         std::isfinite(numberIn(row, "error_of_diagonal"));
}

/// A cloth of work_precision.
struct WorkCloth {
  std::string scene;
  bool isFabric = false;
  int resolution = 0;         ///< 0 for a mesh
  double stiffness = 0.0;     ///< of springs [N/m]
  std::string material = {};  ///< "springs", or the preset of a fabric

  [[nodiscard]] auto key() const { return std::tie(scene, isFabric, resolution, stiffness, material); }
  bool operator==(const WorkCloth& other) const { return key() == other.key(); }
  bool operator<(const WorkCloth& other) const { return key() < other.key(); }
};

[[nodiscard]] inline WorkCloth workClothOf(const ReportRow& row) {
  WorkCloth cloth;
  cloth.scene = row.value("scene", "");
  cloth.resolution = resolutionIn(row);
  const double stiffness = numberIn(row, "stiffness");
  cloth.isFabric = !std::isfinite(stiffness);
  cloth.stiffness = cloth.isFabric ? 0.0 : stiffness;
  cloth.material = row.value("material", "springs");
  return cloth;
}

/// A cloth of work_precision at one of its times [s]. Springs come before fabrics.
using WorkClothAt = std::pair<WorkCloth, double>;

[[nodiscard]] inline WorkClothAt workClothAt(const ReportRow& row) {
  return {workClothOf(row), numberIn(row, "time")};
}

/// "hang, 17x17, 10 N/m" or "tshirt, mesh, cotton".
[[nodiscard]] inline std::string titleOf(const WorkCloth& cloth) {
  return cloth.scene + ", " + sizeText(cloth.resolution) + ", " +
         (cloth.isFabric ? cloth.material : text::figure(cloth.stiffness, 6) + " N/m");
}

/// "hang, 17x17, 10 N/m, 0.2 s".
[[nodiscard]] inline std::string clothOf(const ReportRow& row) {
  return titleOf(workClothOf(row)) + ", " + figure(row, "time") + " s";
}

}  // namespace drape::report::sections

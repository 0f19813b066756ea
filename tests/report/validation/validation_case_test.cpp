#include "report/validation/validation_case.hpp"

#include "fabrics/presets.hpp"
#include "messages/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace drape::report::validation {
namespace {

constexpr std::array testResolution{20};

double areaOf(const TestSheet& sheet) {
  return sim::restAreaOf(sheet.mesh);
}

TEST(ValidationCases, ofStaticsAreWithinTheirAimsOnACoarseMeshOfEveryKind) {
  for (const ValidationCase& one : validationTable()) {
    const bool isStatic = one.group == CaseGroup::Membrane || one.group == CaseGroup::Bending;
    if (!isStatic || one.name == "lateral_buckling") {  // which has a test of its own
      continue;
    }
    for (const MeshKind kind : meshKinds) {
      const ValidationSeries series = runValidation(one, kind, testResolution);
      EXPECT_TRUE(series.passes()) << one.name << ' ' << nameOf(kind) << ": "
                                   << series.results.back().comparison.error();
    }
  }
}

TEST(ValidationCases, ofBendingConvergeWithSecondOrderOnGrids) {
  constexpr std::array coarse{8, 16};
  for (const char* name : {"heavy_elastica_1.5", "heavy_elastica_15", "buckling", "stick_slip"}) {
    const ValidationSeries series = runValidation(requireValidationCase(name), MeshKind::Grid, coarse);
    EXPECT_GT(series.order(), 1.5) << name;
    EXPECT_LT(series.order(), 3.0) << name;
  }
}

TEST(ValidationCases, ofLateralBucklingConvergeToTheClosedFormOnEveryKindOfMesh) {
  constexpr std::array resolutions{20, 40};
  for (const MeshKind kind : meshKinds) {
    const ValidationSeries series = runValidation(requireValidationCase("lateral_buckling"), kind, resolutions);
    EXPECT_LT(std::abs(series.results.front().comparison.error()), 0.06) << nameOf(kind);
    EXPECT_LT(std::abs(series.results.back().comparison.error()), 0.02) << nameOf(kind);
  }
}

TEST(ValidationCases, findTheSameHeightOfTheSkirtOnACoarserMesh) {
  constexpr std::array coarse{7};
  const ValidationSeries series = runValidation(requireValidationCase("remeshed_skirt"), MeshKind::Irregular, coarse);
  EXPECT_TRUE(series.passes()) << series.results.front().comparison.error();
  // Waist and hem are 68 cm apart where the skirt starts. It hangs down to less than its length, 70 cm.
  EXPECT_GT(series.results.front().comparison.exact, 0.67);
  EXPECT_LT(series.results.front().comparison.exact, 0.71);
}

TEST(ValidationCases, haveDifferentNamesAndAims) {
  std::set<std::string_view> names;
  for (const ValidationCase& one : validationTable()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_GT(one.aim, 0.0);
    EXPECT_EQ(&requireValidationCase(one.name), &one);
  }
  EXPECT_THROW(static_cast<void>(requireValidationCase("magic")), messages::UsageError);
}

TEST(ValidationSeries, passesByItsFinestResolution) {
  ValidationCase one;
  one.aim = 0.01;
  ValidationSeries series{.validationCase = &one, .kind = MeshKind::Grid, .results = {}};
  EXPECT_FALSE(series.passes());
  series.results.push_back({.resolution = 10, .comparison = {.measured = 1.08, .exact = 1.0}});
  EXPECT_FALSE(series.passes());
  EXPECT_TRUE(std::isnan(series.order()));
  series.results.push_back({.resolution = 20, .comparison = {.measured = 0.995, .exact = 1.0}});
  EXPECT_TRUE(series.passes());
  EXPECT_NEAR(series.order(), 4.0, 1e-9);
  series.results.back().comparison.measured = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(series.passes());
}

TEST(ValidationSeries, passesByEveryResolutionWhereTheCaseSaysSo) {
  ValidationCase one;
  one.aim = 0.01;
  one.everyResolution = true;
  ValidationSeries series{.validationCase = &one, .kind = MeshKind::Grid, .results = {}};
  series.results.push_back({.resolution = 10, .comparison = {.measured = 1.02, .exact = 1.0}});
  series.results.push_back({.resolution = 20, .comparison = {.measured = 1.0, .exact = 1.0}});
  EXPECT_FALSE(series.passes());
  series.results.front().comparison.measured = 1.005;
  EXPECT_TRUE(series.passes());
}

TEST(ValidationCases, leaveSlowMeshesOutOfTheShortForm) {
  const ValidationCase& cotton = requireValidationCase("remeshed_disc_cotton");
  EXPECT_EQ(kindsOf(cotton, true), std::vector<MeshKind>{MeshKind::Alternating});
  EXPECT_EQ(kindsOf(cotton, false).size(), meshKinds.size());
  EXPECT_EQ(kindsOf(requireValidationCase("twist"), true).size(), meshKinds.size());
}

TEST(ValidationCases, testEveryPresetByPeirceAndByCusick) {
  for (const fabrics::Preset& preset : fabrics::presetTable()) {
    EXPECT_EQ(requireValidationCase("peirce_" + std::string(preset.name)).subject, preset.name);
    EXPECT_EQ(requireValidationCase("cusick_" + std::string(preset.name)).subject, preset.name);
  }
}

TEST(ValidationSeries, aSearchStopsOnRequest) {
  std::stop_source source;
  source.request_stop();
  EXPECT_ANY_THROW(static_cast<void>(
      runValidation(requireValidationCase("heavy_elastica_1.5"), MeshKind::Grid, testResolution, source.get_token())));
}

TEST(TestSheet, coversTheRectangleWithEveryKindOfMesh) {
  for (const MeshKind kind : meshKinds) {
    const TestSheet sheet = testSheet({.start = -0.1, .length = 2.0, .width = 0.5, .along = 8, .across = 4}, kind);
    EXPECT_EQ(sheet.mesh.positions.size(), 45U);
    EXPECT_EQ(sheet.mesh.triangles.size(), 64U);
    EXPECT_NEAR(areaOf(sheet), 1.0, 1e-12) << nameOf(kind);
    for (const int vertex : sheet.verticesOf(8, 8)) {
      EXPECT_NEAR(sheet.mesh.positions[vertex].x(), 1.9, 1e-12);
    }
  }
}

TEST(TestSheet, irregularMeshesMoveTheVerticesInsideOnly) {
  const SheetForm form{.length = 1.0, .width = 1.0, .along = 10, .across = 10, .straight = 2};
  const TestSheet grid = testSheet(form, MeshKind::Grid);
  const TestSheet irregular = testSheet(form, MeshKind::Irregular);
  double largest = 0.0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const int vertex = grid.vertex(column, row);
      const double moved = (irregular.mesh.positions[vertex] - grid.mesh.positions[vertex]).cwiseAbs().maxCoeff();
      const bool inside = column > 1 && column < 10 && row > 0 && row < 10;
      EXPECT_EQ(moved > 0.0, inside);
      largest = std::max(largest, moved);
    }
  }
  EXPECT_LE(largest, 0.03);
  EXPECT_GT(largest, 0.02);
}

}  // namespace
}  // namespace drape::report::validation

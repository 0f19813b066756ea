#include "report/validation/test_motion.hpp"

#include "report/validation/validation_case.hpp"
#include "sim/solvers/solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace drape::report::validation {
namespace {

constexpr std::array coarseMesh{8};

double errorOf(const char* name, MeshKind kind = MeshKind::Grid) {
  return runValidation(requireValidationCase(name), kind, coarseMesh).results.back().comparison.error();
}

TEST(FrequencyCases, ofAccurateSolversAreNearTheClosedFormOnACoarseMesh) {
  for (const char* solver : {"auto", "verlet", "pcg", "newton"}) {
    for (const MeshKind kind : meshKinds) {
      EXPECT_NEAR(errorOf((std::string("membrane_") + solver).c_str(), kind), 0.0, 0.015) << solver;
      EXPECT_NEAR(errorOf((std::string("strip_") + solver).c_str(), kind), 0.0, 0.01) << solver;
    }
  }
}

TEST(FrequencyCases, showThatOneIterationIsTooSlow) {
  EXPECT_FALSE(std::abs(errorOf("strip_one_iteration")) < 0.01);
}

TEST(FrequencyCases, ofIterativeSolversNeedTheSubstepsOfTheirWarning) {
  constexpr std::array mesh{16};
  const auto error = [&](const char* name) {
    return runValidation(requireValidationCase(name), MeshKind::Alternating, mesh).results.back().comparison.error();
  };
  EXPECT_FALSE(std::abs(error("strip_xpbd")) < 0.01);
  EXPECT_NEAR(error("strip_xpbd_substeps"), 0.0, 0.002);
}

TEST(FrequencyCases, coverEverySolverThatTakesFabric) {
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    for (const std::string prefix : {"membrane_", "strip_"}) {
      const std::string name = prefix + std::string(solver.name);
      const bool found =
          std::ranges::any_of(validationTable(), [&](const ValidationCase& one) { return one.name == name; });
      EXPECT_EQ(found, solver.takesFabric) << name;
    }
  }
}

TEST(FrequencyCases, halveTheFrequencyOfFourTimesTheMass) {
  const TestSheet sheet = testSheet({.length = 0.5, .width = 0.5, .along = 8, .across = 8}, MeshKind::Grid);
  Oscillation oscillation;
  std::vector<int> frame;
  for (int vertex = 0; vertex < static_cast<int>(sheet.mesh.positions.size()); ++vertex) {
    const Vec3& rest = sheet.mesh.positions[vertex];
    oscillation.equilibrium.push_back(1.1 * rest);
    const double wave = std::sin(2.0 * M_PI * rest.x()) * std::sin(2.0 * M_PI * rest.z());
    const int column = vertex % 9;
    const int row = vertex / 9;
    const bool inside = column % 8 != 0 && row % 8 != 0;
    oscillation.shape.emplace_back(0.0, inside ? 0.002 * wave : 0.0, 0.0);
    if (!inside) {
      frame.push_back(vertex);
    }
  }
  const auto frequencyWith = [&](double density) {
    oscillation.model = clothOf(sheet, {.stretchWarp = 1000.0, .stretchWeft = 1000.0, .shear = 500.0}, density, frame);
    oscillation.period = 0.03 * std::sqrt(density / 0.2);
    return frequencyOf(oscillation, "verlet", {});
  };
  EXPECT_NEAR(frequencyWith(0.2) / frequencyWith(0.8), 2.0, 1e-3);
}

TEST(MotionCases, areWithinTheirAimsOnACoarseMeshOfEveryKind) {
  constexpr std::array coarse{5};
  for (const char* name : {"incline_sticks", "incline_slides", "terminal_velocity", "fall_distance"}) {
    for (const MeshKind kind : meshKinds) {
      const ValidationSeries series = runValidation(requireValidationCase(name), kind, coarse);
      EXPECT_TRUE(series.passes()) << name << ' ' << nameOf(kind) << ": " << series.results.back().comparison.error();
    }
  }
}

TEST(TestMotion, stopsOnRequest) {
  std::stop_source source;
  source.request_stop();
  constexpr std::array coarse{5};
  EXPECT_THROW(static_cast<void>(
                   runValidation(requireValidationCase("fall_distance"), MeshKind::Grid, coarse, source.get_token())),
               sim::StepStopped);
}

}  // namespace
}  // namespace drape::report::validation

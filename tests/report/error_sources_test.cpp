#include "report/error_sources.hpp"

#include "messages/error.hpp"
#include "report/sections/error_sources_view.hpp"
#include "report/sections/sections.hpp"

#include "settings/settings_table.hpp"
#include "sim/fabric/fabric.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <variant>

namespace drape::report {
namespace {

TEST(ErrorSources, findsThatTheMeshMovesAHangingSheetMuchMoreThanTheSolverDoes) {
  ReportOptions options;
  options.quick = true;
  options.scene = "hang";
  const SectionPlan plan = sections::errorSources().plan(options);
  ASSERT_FALSE(plan.cells.empty());
  const ReportRow row = plan.cells.front().measure({{}, {}}).at(1);
  EXPECT_EQ(row["time"], 0.5);
  EXPECT_GT(row["mesh"].get<double>(), 10.0 * row["auto"].get<double>());
  EXPECT_GT(row["implicit"].get<double>(), 10.0 * row["auto"].get<double>());
  EXPECT_GT(row["stiffer"].get<double>(), 10.0 * row["auto"].get<double>());
  EXPECT_GT(row["diagonals"].get<double>(), 10.0 * row["auto"].get<double>()) << "a sheet on two corners is symmetric";
  EXPECT_LT(row["jitter"].get<double>(), 1e-4);
}

TEST(ErrorSources, namesTheLargestSourceAndChaosWhereThatIsLarger) {
  ReportRow row{{"scene", "hang"},      {"resolution", 17}, {"material", "springs"}, {"stiffness", 10.0},
                {"time", 0.2},          {"auto", 1e-5},     {"implicit", 8e-3},      {"mesh", 5e-3},
                {"diagonals", nullptr}, {"stiffer", 1e-3},  {"jitter", 1e-6}};
  const auto dominant = [](const ReportRow& one) {
    return std::get<TextTable>(sections::showErrorSources({}, {one}).back()).rows.at(0).back();
  };
  EXPECT_EQ(dominant(row), "mesh") << "the implicit solver is there for comparison";
  row["jitter"] = 1e-2;
  EXPECT_EQ(dominant(row), "chaos");
}

/// A sheet of jersey that hangs from two corners, in few large cells.
scene::SceneDescription coarseSheet() {
  scene::SceneDescription description = scene::openScene("grid");
  for (const char* expression :
       {"material.model=fabric", "material.preset=jersey", "grid.resolution=9", "time_step=1/150", "solver=auto"}) {
    settings::assignSettingExpression(description.settings, expression);
  }
  return description;
}

settings::Settings withSolver(settings::Settings settings, const char* solver) {
  settings.solver.name = solver;
  return settings;
}

TEST(ErrorSourcesOfAScene, areMostlyTheMeshForAutoAndMostlyTheMethodForOneIteration) {
  const scene::SceneDescription description = coarseSheet();
  ErrorSourcesPlan plan;
  plan.times = {0.2, 0.3};
  const auto ofAuto = measureErrorSources(description, description.settings, plan);
  ASSERT_EQ(ofAuto.size(), 2U);
  EXPECT_EQ(ofAuto[1].time, 0.3);
  for (const sim::ErrorSources& at : ofAuto) {
    EXPECT_EQ(sim::dominantSource(at), sim::ErrorSource::Mesh);
    EXPECT_GT(at.mesh, 5.0 * at.method);
    EXPECT_GT(at.material, 0.0);
    EXPECT_LT(at.start, 1e-4);
  }
  const auto ofOneIteration = measureErrorSources(description, withSolver(description.settings, "one_iteration"), plan);
  EXPECT_EQ(sim::dominantSource(ofOneIteration[0]), sim::ErrorSource::Method);
  EXPECT_EQ(ofOneIteration[0].mesh, ofAuto[0].mesh) << "the mesh is compared by the accurate method";
}

TEST(ErrorSourcesOfAScene, ofTheMeshFallWithTheCells) {
  scene::SceneDescription description = coarseSheet();
  const double coarse = measureErrorSources(description, description.settings, {}).front().mesh;
  settings::assignSettingExpression(description.settings, "grid.resolution=17");
  const double fine = measureErrorSources(description, description.settings, {}).front().mesh;
  EXPECT_LT(fine, 0.75 * coarse);
}

/// The sheet with this number of vertices along a side, after 0.2 s.
std::vector<Vec3> fallenSheet(scene::SceneDescription description, const char* resolution) {
  for (const std::string& expression :
       {"grid.resolution=" + std::string(resolution), std::string("precision=double")}) {
    settings::assignSettingExpression(description.settings, expression);
  }
  description.settings.step.automatic.errorTolerance = 1e-6;
  description.settings.step.automatic.costBudget = 1e6;
  const auto scene = scene::buildScene(description, description.settings);
  const std::vector<double> times{0.2};
  return positionsAt(times, runTrajectory(*scene, scene->settings, checkpointsIn(times[0]), {})).front();
}

TEST(ErrorSourcesOfAScene, ofTheMeshAreNearTheDistanceFromAMeshWithEightTimesTheCellsInARow) {
  const scene::SceneDescription description = coarseSheet();
  const std::vector<Vec3> coarse = fallenSheet(description, "9");
  const std::vector<Vec3> fine = fallenSheet(description, "65");
  double sum = 0.0;
  for (std::size_t v = 0; v < coarse.size(); ++v) {
    sum += (coarse[v] - fine[8 * (v / 9) * 65 + 8 * (v % 9)]).norm();
  }
  const double distance = sum / static_cast<double>(coarse.size());
  const double mesh = measureErrorSources(description, description.settings, {.times = {0.2}}).front().mesh;
  EXPECT_LT(mesh, 1.4 * distance);
  EXPECT_GT(mesh, distance / 1.4);
}

TEST(ErrorSourcesOfAScene, tellsItsProgressAndEndsOnRequest) {
  const scene::SceneDescription description = coarseSheet();
  std::vector<double> parts;
  static_cast<void>(measureErrorSources(description, description.settings, {.times = {0.1}},
                                        [&](double part) { parts.push_back(part); }));
  EXPECT_TRUE(std::ranges::is_sorted(parts));
  EXPECT_DOUBLE_EQ(parts.back(), 1.0);
  struct Stop {};
  EXPECT_THROW(
      static_cast<void>(measureErrorSources(description, description.settings, {}, [](double) { throw Stop(); })),
      Stop);
}

TEST(ErrorSourcesOfAScene, areRefusedForSeams) {
  const scene::SceneDescription description = scene::openScene("sewing");
  EXPECT_THROW(static_cast<void>(measureErrorSources(description, description.settings, {})), messages::InputError);
}

TEST(StifferMaterial, isStifferByATenthInEachCloth) {
  const scene::SceneDescription description = scene::openScene("walk");
  const auto scene = scene::buildScene(description, description.settings);
  const auto stiff = withStifferMaterial(description, description.settings);
  ASSERT_EQ(stiff->model->fabric->materials.list().size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const sim::fabric::Material& own = scene->model->fabric->materials.list()[i];
    const sim::fabric::Material& stiffer = stiff->model->fabric->materials.list()[i];
    EXPECT_DOUBLE_EQ(stiffer.stretchWarp, 1.1 * own.stretchWarp);
    EXPECT_DOUBLE_EQ(stiffer.bendBias, 1.1 * own.bendBias);
    EXPECT_EQ(stiffer.poisson, own.poisson);
  }
  EXPECT_EQ(stiff->model->vertexMass, scene->model->vertexMass);
}

TEST(FinerMesh, hasTheVerticesOfTheMeshAndFourTimesTheTriangles) {
  const scene::SceneDescription description = scene::openScene("walk");
  const auto scene = scene::buildScene(description, description.settings);
  const auto finer = withFinerMesh(description, description.settings);
  EXPECT_EQ(finer->model->triangles.size(), 4 * scene->model->triangles.size());
  EXPECT_EQ(meshDistance(*scene, scene->start.positions, *finer, finer->start.positions), 0.0);
}

TEST(DominantSource, isTheLargestAndChaosWhereThatIsLarger) {
  sim::ErrorSources sources{.time = 0.2, .method = 1e-5, .mesh = 5e-3, .material = 1e-3, .start = 1e-6};
  EXPECT_EQ(sim::dominantSource(sources), sim::ErrorSource::Mesh);
  sources.method = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sim::dominantSource(sources), sim::ErrorSource::Method);
  sources = {.time = 0.2, .method = 1e-5, .mesh = 5e-3, .material = 1e-3, .start = 1e-2};
  EXPECT_EQ(sim::dominantSource(sources), sim::ErrorSource::Chaos);
}

}  // namespace
}  // namespace drape::report

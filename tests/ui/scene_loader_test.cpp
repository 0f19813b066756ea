#include "ui/scene_loader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

namespace drape::ui {
namespace {

SceneLoader::Outcome waitFor(SceneLoader& loader) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (std::chrono::steady_clock::now() < end) {
    if (auto outcome = loader.poll()) {
      return *outcome;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ADD_FAILURE() << "nothing was loaded";
  return {};
}

TEST(SceneLoader, OpensASceneUnderAdjustedSettings) {
  SceneLoader loader;
  loader.open({.scene = "grid"}, [](settings::Settings& settings) { settings.view.surface = "plain"; });
  EXPECT_NE(loader.activity().english().find(scene::openScene("grid").title), std::string::npos);
  const auto outcome = waitFor(loader);
  ASSERT_NE(outcome.scene, nullptr) << outcome.error;
  EXPECT_EQ(outcome.scene->settings.view.surface, "plain");
  EXPECT_EQ(outcome.kind, SceneLoader::Kind::Opened);
  EXPECT_TRUE(loader.activity().empty());
}

TEST(SceneLoader, AFailureIsASentenceAndNoScene) {
  SceneLoader loader;
  loader.open({.scene = "no such scene"}, [](settings::Settings&) {});
  const auto outcome = waitFor(loader);
  EXPECT_EQ(outcome.scene, nullptr);
  EXPECT_NE(outcome.error.english().find("no such scene"), std::string::npos);
}

TEST(SceneLoader, OfThoseThatWaitTheNewestWins) {
  SceneLoader loader;
  const scene::SceneDescription description = scene::openScene("grid");
  settings::Settings settings = description.settings;
  for (const int resolution : {5, 6, 7, 8}) {
    settings.grid.resolution = resolution;
    loader.rebuild(description, settings);
  }
  const auto outcome = waitFor(loader);
  ASSERT_NE(outcome.scene, nullptr) << outcome.error;
  EXPECT_EQ(outcome.scene->settings.grid.resolution, 8);
  EXPECT_EQ(outcome.kind, SceneLoader::Kind::Rebuilt);
}

TEST(SceneLoader, RestoresASceneUnderItsOwnSettings) {
  SceneLoader loader;
  const scene::SceneDescription description = scene::openScene("grid");
  loader.rebuild(description, description.settings, SceneLoader::Kind::Restored);
  const auto outcome = waitFor(loader);
  ASSERT_NE(outcome.scene, nullptr) << outcome.error;
  EXPECT_EQ(outcome.kind, SceneLoader::Kind::Restored);
  EXPECT_EQ(outcome.scene->settings.grid.resolution, description.settings.grid.resolution);
}

TEST(SceneLoader, CancelledJobsNeverArrive) {
  SceneLoader loader;
  loader.open({.scene = "grid"}, [](settings::Settings&) {});
  EXPECT_TRUE(loader.cancel());
  EXPECT_TRUE(loader.activity().empty());
  EXPECT_FALSE(loader.cancel()) << "there is nothing left to cancel";
  loader.open({.scene = "flag"}, [](settings::Settings&) {});
  EXPECT_NE(loader.activity().english().find("flag"), std::string::npos);
  const auto outcome = waitFor(loader);
  ASSERT_NE(outcome.scene, nullptr) << outcome.error;
  EXPECT_EQ(outcome.scene->description.name, "flag");
}

TEST(SceneLoader, ReportsItsProgress) {
  constexpr int side = 150;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "drape-scene-loader-test.obj";
  std::ofstream mesh(file);
  for (int i = 0; i < side * side; ++i) {
    mesh << "v " << 0.01 * (i % side) << ' ' << 0.01 * (i / side) << " 0\n";
  }
  for (int i = 1; i + side < side * side; ++i) {
    if (i % side != 0) {
      mesh << "f " << i << ' ' << i + 1 << ' ' << i + side << '\n';
    }
  }
  mesh.close();
  SceneLoader loader;
  loader.open({.scene = file.string()}, [](settings::Settings&) {});
  std::set<std::string> told;
  std::optional<SceneLoader::Outcome> outcome;
  while (!outcome) {
    told.insert(loader.activity().english());
    outcome = loader.poll();
  }
  EXPECT_NE(outcome->scene, nullptr) << outcome->error;
  EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const std::string& text) {
    return text.find("drape-scene-loader-test.obj': ") != std::string::npos && text.find(" %") != std::string::npos;
  }));
  std::filesystem::remove(file);
}

TEST(CarryViewSettings, TakesOnlyWhatTheUserChangedAboutTheView) {
  settings::Settings own;
  own.view.surface = "plain";
  settings::Settings current = own;
  current.view.wireframe = true;
  current.step.air.drag = 3.0;
  settings::Settings target;
  carryViewSettings(current, own, target);
  EXPECT_TRUE(target.view.wireframe);
  EXPECT_EQ(target.view.surface, settings::Settings().view.surface);
  EXPECT_EQ(target.step.air.drag, settings::Settings().step.air.drag);
}

TEST(WindowDefaults, SetAStrainLimitOnlyWhereTheSceneHasNone) {
  settings::Settings none;
  useWindowDefaults(none);
  EXPECT_EQ(none.step.automatic.strainLimit, 0.01);
  settings::Settings own;
  own.step.automatic.strainLimit = 0.2;
  useWindowDefaults(own);
  EXPECT_EQ(own.step.automatic.strainLimit, 0.2);
}

TEST(WindowDefaults, CheckTheErrorOnlyWithFourCoresOrMore) {
  settings::Settings settings;
  ASSERT_FALSE(settings.measures.errorCheck);
  useWindowDefaults(settings);
  EXPECT_EQ(settings.measures.errorCheck, std::thread::hardware_concurrency() >= 4);
  settings.measures.errorCheck = true;
  useWindowDefaults(settings);
  EXPECT_TRUE(settings.measures.errorCheck) << "the scene asks for it";
}

TEST(WindowDefaults, TakeOneThreadLessThanThereAreCores) {
  settings::Settings none;
  useWindowDefaults(none);
  EXPECT_EQ(none.step.threads, std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1));
  settings::Settings own;
  own.step.threads = 64;
  useWindowDefaults(own);
  EXPECT_EQ(own.step.threads, 64);
}

}  // namespace
}  // namespace drape::ui

#pragma once

#include "messages/error.hpp"
#include "scene/scene.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace drape::scene {

/// A test that opens meshes in metres from the text of an OBJ file.
class MeshTextTest : public ::testing::Test {
 protected:
  /// @param settings of every mesh, "key=value"
  explicit MeshTextTest(std::vector<std::string> settings) : settings_(std::move(settings)) {
    std::filesystem::create_directories(folder_);
  }
  ~MeshTextTest() override { std::filesystem::remove_all(folder_); }
  MeshTextTest(const MeshTextTest&) = delete;
  MeshTextTest& operator=(const MeshTextTest&) = delete;

  /// @param changes of the settings, "key=value"
  std::shared_ptr<const Scene> build(const std::string& text, const std::vector<std::string>& changes = {}) {
    const std::filesystem::path file = folder_ / "mesh.obj";
    std::ofstream(file) << text;
    const SceneDescription description = openScene(file.string());
    settings::Settings settings = description.settings;
    std::vector<std::string> expressions{"unit=m", "up=y"};
    expressions.insert(expressions.end(), settings_.begin(), settings_.end());
    expressions.insert(expressions.end(), changes.begin(), changes.end());
    for (const std::string& expression : expressions) {
      settings::assignSettingExpression(settings, expression);
    }
    return buildScene(description, settings);
  }

  /// The message with which a mesh is refused; empty if it is not.
  std::string refusal(const std::string& text, const std::vector<std::string>& changes = {}) {
    try {
      static_cast<void>(build(text, changes));
      return "";
    } catch (const messages::InputError& error) {
      return error.what();
    }
  }

 private:
  [[nodiscard]] static std::filesystem::path testFolder() {
    const ::testing::TestInfo* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    return std::filesystem::path(::testing::TempDir()) / (std::string(test->test_suite_name()) + "_" + test->name());
  }

  std::filesystem::path folder_ = testFolder();
  std::vector<std::string> settings_;
};

}  // namespace drape::scene

#include "ui/mesh_finder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace drape::ui {
namespace {

class MeshFinderTest : public ::testing::Test {
 protected:
  MeshFinderTest() {
    std::filesystem::create_directories(folder_);
    std::ofstream(file("sheet.obj")) << "v 0 0 0\nv 80 0 0\nv 80 60 0\nv 0 60 0\nf 1 2 3\nf 1 3 4\n";
    std::ofstream(file("bad.obj")) << "no mesh\n";
  }
  ~MeshFinderTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }

  void finish() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (finder_.isReading() && std::chrono::steady_clock::now() < end) {
      finder_.follow();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_FALSE(finder_.isReading());
  }

  MeshFinder finder_;

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(MeshFinderTest, ReadsTheFilesInTheirOrderAndNamesWhatIsWrong) {
  finder_.find({file("bad.obj"), file("sheet.obj"), "mannequin"});
  ASSERT_EQ(finder_.found().size(), 3U);
  EXPECT_FALSE(finder_.found()[1].mesh) << "it is read later";
  finish();
  EXPECT_FALSE(finder_.found()[0].mesh);
  EXPECT_NE(finder_.found()[0].problem.english().find("bad.obj"), std::string::npos) << finder_.found()[0].problem;
  ASSERT_TRUE(finder_.found()[1].mesh);
  EXPECT_EQ(finder_.found()[1].mesh->vertices, 4);
  EXPECT_NEAR(finder_.found()[1].mesh->extent.x(), 80.0, 1e-4) << "in the unit of the file";
  ASSERT_TRUE(finder_.found()[2].mesh);
}

TEST_F(MeshFinderTest, ForgetsFormerFiles) {
  finder_.find({"mannequin", "figure"});
  finder_.find({file("sheet.obj")});
  finish();
  ASSERT_EQ(finder_.found().size(), 1U);
  ASSERT_TRUE(finder_.found()[0].mesh);
  EXPECT_EQ(finder_.found()[0].mesh->vertices, 4) << "and not the mannequin, which was read before";
  finder_.forget();
  EXPECT_TRUE(finder_.found().empty());
  EXPECT_FALSE(finder_.isReading());
}

}  // namespace
}  // namespace drape::ui

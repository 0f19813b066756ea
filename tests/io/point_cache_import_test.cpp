#include "io/point_cache_import.hpp"

#include "input_error.hpp"
#include "io/animation/animation.hpp"
#include "io/animation/number_bytes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace drape::io {
namespace {

namespace fs = std::filesystem;

using animation::appendBytes;

/// A cache of three frames of two vertices.
struct SmallCache {
  std::string mark = std::string("POINTCACHE2\0", 12);
  std::int32_t version = 1;
  std::int32_t vertices = 2;
  std::int32_t frames = 3;
  float framesPerSample = 2.0F;
  std::vector<float> times{0.5F, 0.75F, 1.5F};  // of an MDD [s]
  std::vector<float> numbers{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0};

  [[nodiscard]] std::string pc2() const {
    std::string bytes = mark;
    for (const std::int32_t number : {version, vertices}) {
      appendBytes(bytes, number);
    }
    appendBytes(bytes, 7.0F);  // the number of the first frame
    appendBytes(bytes, framesPerSample);
    appendBytes(bytes, frames);
    for (const float number : numbers) {
      appendBytes(bytes, number);
    }
    return bytes;
  }

  [[nodiscard]] std::string mdd() const {
    std::string bytes;
    for (const std::int32_t number : {frames, vertices}) {
      appendBytes(bytes, number, std::endian::big);
    }
    for (const std::vector<float>& list : {times, numbers}) {
      for (const float number : list) {
        appendBytes(bytes, number, std::endian::big);
      }
    }
    return bytes;
  }
};

class PointCacheImport : public ::testing::Test {
 protected:
  PointCacheImport() { fs::create_directories(folder_); }
  ~PointCacheImport() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path fileOf(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  [[nodiscard]] PointCache read(const std::string& name, const std::string& bytes, std::size_t vertices = 2) const {
    return importPointCache(fileOf(name, bytes), vertices, 24.0);
  }
  [[nodiscard]] std::string problemOf(const std::string& name, const std::string& bytes,
                                      std::size_t vertices = 2) const {
    const std::string problem = inputErrorOf([&] { (void)read(name, bytes, vertices); });
    EXPECT_TRUE(contains(problem, name + ": ")) << problem;
    return problem;
  }

  fs::path folder_ = fs::path(::testing::TempDir()) / "drape_point_caches";
};

TEST_F(PointCacheImport, ReadsThePositionsAndTheTimesOfAPc2) {
  const PointCache cache = read("a.PC2", SmallCache().pc2());
  ASSERT_EQ(cache.frames.size(), 3U);
  EXPECT_EQ(cache.frames[2][1], Eigen::Vector3f(1, 2, 0));
  ASSERT_EQ(cache.times.size(), 3U);
  EXPECT_EQ(cache.times[0], 0.0) << "whatever the number of the first frame";
  EXPECT_DOUBLE_EQ(cache.times[1], 2.0 / 24.0);
  EXPECT_DOUBLE_EQ(cache.times[2], 4.0 / 24.0);
}

TEST_F(PointCacheImport, ReadsThePositionsAndTheTimesOfAnMdd) {
  const PointCache cache = read("a.mdd", SmallCache().mdd());
  ASSERT_EQ(cache.frames.size(), 3U);
  EXPECT_EQ(cache.frames[1][0], Eigen::Vector3f(0, 1, 0));
  EXPECT_EQ(cache.times, (std::vector<double>{0.0, 0.25, 1.0}));
}

TEST_F(PointCacheImport, ReadsWhatTheExportWrites) {
  animation::Clip clip;
  auto mesh = std::make_shared<FileMesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->corners = {0, 1, 2};
  mesh->faceEnds = {3};
  clip.objects = {{"cloth", mesh}};
  clip.rate = 25.0;
  clip.firstFrame = 10;
  clip.frames = 4;
  for (const char* name : {"b.pc2", "b.mdd"}) {
    const auto writer = animation::makeWriter([&](int) { return folder_ / name; }, clip);
    for (int frame = 0; frame < clip.frames; ++frame) {
      writer->add({{{Vec3(0.1 * frame, 0, 0), Vec3(1, 0.2, 0), Vec3(0, 1, 0.3 * frame)}, {}}});
    }
    writer->finish();
    const PointCache cache = importPointCache(folder_ / name, 3, clip.rate);
    ASSERT_EQ(cache.frames.size(), 4U) << name;
    for (int frame = 0; frame < clip.frames; ++frame) {
      EXPECT_NEAR(cache.times[frame], frame / clip.rate, 1e-6) << name;
      EXPECT_EQ(cache.frames[frame][0], Eigen::Vector3f(static_cast<float>(0.1 * frame), 0, 0)) << name;
      EXPECT_EQ(cache.frames[frame][2], Eigen::Vector3f(0, 1, static_cast<float>(0.3 * frame))) << name;
    }
  }
}

TEST_F(PointCacheImport, RefusesAnotherNumberOfVerticesAndNamesBoth) {
  for (const auto& [name, bytes] : {std::pair("a.pc2", SmallCache().pc2()), std::pair("a.mdd", SmallCache().mdd())}) {
    const std::string problem = problemOf(name, bytes, 5);
    EXPECT_TRUE(contains(problem, "it moves 2 vertices, but the file of the mesh has 5")) << problem;
  }
}

TEST_F(PointCacheImport, RefusesAnotherFormat) {
  SmallCache cache;
  cache.mark = std::string("POINTCACHE3\0", 12);
  EXPECT_TRUE(contains(problemOf("a.pc2", cache.pc2()), "does not begin with POINTCACHE2"));
  EXPECT_TRUE(contains(problemOf("a.pc2", SmallCache().mdd()), "does not begin with POINTCACHE2"));
  EXPECT_TRUE(contains(problemOf("a.mdd", SmallCache().pc2()), "which take "));
  cache = {};
  cache.version = 2;
  EXPECT_TRUE(contains(problemOf("a.pc2", cache.pc2()), "has version 2"));
  EXPECT_TRUE(contains(problemOf("a.abc", cache.pc2()), "is a .pc2 or an .mdd file"));
}

TEST_F(PointCacheImport, RefusesAFileThatIsCutOffAtAnyByte) {
  for (const auto& [name, bytes] : {std::pair("a.pc2", SmallCache().pc2()), std::pair("a.mdd", SmallCache().mdd())}) {
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      EXPECT_FALSE(problemOf(name, bytes.substr(0, length)).empty()) << length << " bytes of " << name;
    }
    EXPECT_TRUE(contains(problemOf(name, bytes.substr(0, bytes.size() - 1)), "cut off"));
    EXPECT_TRUE(contains(problemOf(name, bytes + "x"), "damaged, or of another format"));
  }
}

TEST_F(PointCacheImport, RefusesCountsThatNoFileHas) {
  for (const std::int32_t count : {0, -1, std::numeric_limits<std::int32_t>::min()}) {
    SmallCache cache;
    cache.frames = count;
    EXPECT_TRUE(contains(problemOf("a.pc2", cache.pc2()), "both must be at least 1"));
    EXPECT_TRUE(contains(problemOf("a.mdd", cache.mdd()), "both must be at least 1"));
    cache = {};
    cache.vertices = count;
    EXPECT_TRUE(contains(problemOf("a.pc2", cache.pc2()), "both must be at least 1"));
  }
  SmallCache huge;
  huge.frames = std::numeric_limits<std::int32_t>::max();
  huge.vertices = std::numeric_limits<std::int32_t>::max();
  EXPECT_TRUE(contains(problemOf("a.pc2", huge.pc2()), "cut off"));
  EXPECT_TRUE(contains(problemOf("a.mdd", huge.mdd()), "cut off"));
}

TEST_F(PointCacheImport, RefusesPositionsThatAreNoPlaces) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float wrong : {std::nanf(""), infinity, -infinity, 1e30F}) {
    SmallCache cache;
    cache.numbers[10] = wrong;
    for (const std::string& problem : {problemOf("a.pc2", cache.pc2()), problemOf("a.mdd", cache.mdd())}) {
      EXPECT_TRUE(contains(problem, "in frame 1 (counted from 0) the position of vertex 1")) << problem;
    }
  }
}

TEST_F(PointCacheImport, RefusesTimesThatDoNotIncrease) {
  for (const std::vector<float>& times :
       {std::vector<float>{0, 1, 1}, {0, 1, 0.5F}, {0, std::nanf(""), 1}, {std::nanf(""), 1, 2}}) {
    SmallCache cache;
    cache.times = times;
    EXPECT_TRUE(contains(problemOf("a.mdd", cache.mdd()), "its times must increase"));
  }
  for (const float step : {0.0F, -1.0F, std::nanf(""), 1e9F}) {
    SmallCache cache;
    cache.framesPerSample = step;
    EXPECT_TRUE(contains(problemOf("a.pc2", cache.pc2()), "a sample each"));
  }
}

TEST_F(PointCacheImport, NamesAFileThatIsMissing) {
  const std::string problem = inputErrorOf([&] { (void)importPointCache(folder_ / "none.pc2", 2, 24.0); });
  EXPECT_TRUE(contains(problem, "none.pc2: no such file")) << problem;
}

}  // namespace
}  // namespace drape::io

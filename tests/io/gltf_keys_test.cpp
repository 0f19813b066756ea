#include "io/gltf_keys.hpp"

#include "io/gltf_numbers.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace drape::io {
namespace {

using Json = nlohmann::json;

template <typename Number>
std::string bytesOf(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

/// A document with one sampler of keys at `times`.
struct Animation {
  template <typename Number>
  Animation(const std::string& interpolation, const std::vector<float>& times, const std::string& type, int component,
            std::size_t size, const std::vector<Number>& values)
      : buffers{bytesOf(times) + bytesOf(values)} {
    const std::size_t split = times.size() * sizeof(float);
    const auto view = [](std::size_t begin, std::size_t end) {
      return Json{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", end - begin}};
    };
    const auto accessor = [](int view, int type, std::size_t count, const std::string& shape) {
      return Json{{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}};
    };
    document["buffers"] = Json::array({Json{{"byteLength", buffers[0].size()}}});
    document["bufferViews"] = Json::array({view(0, split), view(split, buffers[0].size())});
    document["accessors"] =
        Json::array({accessor(0, 5126, times.size(), "SCALAR"), accessor(1, component, values.size() / size, type)});
    document["animations"][0]["samplers"][0] = {{"input", 0}, {"output", 1}, {"interpolation", interpolation}};
    document = Json::parse(document.dump());  // whole numbers are without a sign then
  }

  [[nodiscard]] const Json& sampler() const { return document["animations"][0]["samplers"][0]; }
  [[nodiscard]] GltfNumbers times() const { return {document, buffers, sampler()["input"].get<std::uint64_t>()}; }
  [[nodiscard]] GltfNumbers values() const { return {document, buffers, sampler()["output"].get<std::uint64_t>()}; }

  std::vector<std::string> buffers;
  Json document;
};

constexpr int real = 5126;

TEST(GltfKeys, ofStepsBecomeTwoKeysAtAlmostTheSameTime) {
  Animation animation("STEP", {0.0F, 1.0F, 3.0F}, "VEC3", real, 3, std::vector<float>{1, 0, 0, 2, 0, 0, 3, 0, 0});
  ASSERT_TRUE(straightenKeys(animation.document, animation.buffers));
  EXPECT_EQ(animation.sampler()["interpolation"], "LINEAR");
  const GltfNumbers times = animation.times();
  const GltfNumbers values = animation.values();
  const std::vector<double> steps{1, 1, 2, 2, 3};
  ASSERT_EQ(times.count(), steps.size());
  ASSERT_EQ(values.count(), steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    EXPECT_EQ(values.value(k, 0), steps[k]);
    EXPECT_TRUE(k == 0 || times.value(k, 0) > times.value(k - 1, 0));
  }
  EXPECT_NEAR(times.value(1, 0), 1.0, 1e-6);
  EXPECT_EQ(times.value(2, 0), 1.0);
  EXPECT_EQ(times.value(4, 0), 3.0);
}

TEST(GltfKeys, ofCurvesFollowTheCubicPolynomialOfTheirTangents) {
  // x = t^3 from 0 to 1 s and from 1 to 2 s: its slopes are 0, 3 and 12.
  Animation animation("CUBICSPLINE", {0.0F, 1.0F, 2.0F}, "VEC3", real, 3,
                      std::vector<float>{0,  0, 0, 0, 0, 0, 0,  0, 0, 3, 0, 0, 1, 0, 0, 3, 0, 0,  //
                                         12, 0, 0, 8, 0, 0, 12, 0, 0});
  ASSERT_TRUE(straightenKeys(animation.document, animation.buffers));
  const GltfNumbers times = animation.times();
  const GltfNumbers values = animation.values();
  ASSERT_EQ(times.count(), values.count());
  ASSERT_GT(times.count(), 200U);
  for (std::size_t k = 0; k < times.count(); ++k) {
    EXPECT_NEAR(values.value(k, 0), std::pow(times.value(k, 0), 3.0), 1e-5) << k;
  }
  EXPECT_EQ(times.value(times.count() - 1, 0), 2.0);
}

TEST(GltfKeys, ofWholeNumbersAreSharesOfTheLargest) {
  Animation animation("STEP", {0.0F, 1.0F}, "VEC4", 5122, 4, std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 32767, 0});
  ASSERT_TRUE(straightenKeys(animation.document, animation.buffers));
  EXPECT_EQ(animation.values().value(0, 3), 1.0);
  EXPECT_EQ(animation.values().value(2, 2), 1.0);
}

TEST(GltfKeys, stayAsTheyAreWhereTheyAreStraightOrDamaged) {
  const std::vector<float> values{1, 0, 0, 2, 0, 0};
  const std::vector<Animation> all{
      {"LINEAR", {0.0F, 1.0F}, "VEC3", real, 3, values},
      {"STEP", {1.0F, 0.0F}, "VEC3", real, 3, values},
      {"STEP", {0.0F, NAN}, "VEC3", real, 3, values},
      {"STEP", {0.0F, 1e30F}, "VEC3", real, 3, values},
      {"STEP", {0.0F, 1.0F, 2.0F}, "VEC3", real, 3, values},
      {"CUBICSPLINE", {0.0F, 1.0F}, "VEC3", real, 3, values},
      {"STEP", {0.0F, 1.0F}, "SCALAR", real, 1, std::vector<float>{0, 1}},
  };
  for (Animation animation : all) {
    const Json before = animation.document;
    EXPECT_FALSE(straightenKeys(animation.document, animation.buffers));
    EXPECT_EQ(animation.document, before);
    EXPECT_EQ(animation.buffers.size(), 1U);
  }
  Animation cut("STEP", {0.0F, 1.0F}, "VEC3", real, 3, values);
  cut.buffers[0].resize(20);
  EXPECT_FALSE(straightenKeys(cut.document, cut.buffers));
}

}  // namespace
}  // namespace drape::io

#include "messages/error.hpp"
#include "scene/scene.hpp"
#include "sim/fabric/fabric.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace drape::scene {
namespace {

/// The scene file of a skirt with these keys of the cloth and these settings.
SceneDescription openSkirt(const std::string& keys, const std::string& settings) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "drape_band.toml";
  std::ofstream(file) << "[cloth]\nmesh = \"builtin:fitted_skirt.obj\"\n" << keys << "\n[settings]\n" << settings;
  SceneDescription description = openScene(file.string());
  std::filesystem::remove(file);
  return description;
}

std::shared_ptr<const Scene> builtSkirt(const std::string& keys, const std::string& settings) {
  const SceneDescription description = openSkirt(keys, settings);
  return buildScene(description, description.settings);
}

constexpr const char* waistBand = "bands = [{ nearest = [0, 1.05, 0], length = 0.8 }]";
constexpr const char* cotton = "material.model = \"fabric\"\nmaterial.preset = \"cotton\"";

bool isAtWaist(const sim::ClothModel& model, const sim::Spring& spring) {
  return model.restPositions[spring.a].y() > 1.0449 && model.restPositions[spring.b].y() > 1.0449;
}

TEST(ElasticBands, shortenTheSpringsOfTheirBorderOnly) {
  const auto plain = builtSkirt("", "")->model;
  const auto banded = builtSkirt(waistBand, "")->model;
  int shortened = 0;
  for (std::size_t s = 0; s < plain->springs.size(); ++s) {
    const double factor = isAtWaist(*plain, plain->springs[s]) ? 0.8 : 1.0;
    EXPECT_NEAR(banded->springs[s].restLength, factor * plain->springs[s].restLength, 1e-12);
    shortened += factor < 1.0 ? 1 : 0;
  }
  EXPECT_GT(shortened, 20);
  EXPECT_EQ(banded->vertexMass, plain->vertexMass);
}

TEST(ElasticBands, shortenTheTrianglesOfAFabricAlongTheirBorder) {
  const auto plain = builtSkirt("", cotton)->model;
  const auto banded = builtSkirt(waistBand, cotton)->model;
  EXPECT_EQ(banded->vertexMass, plain->vertexMass);
  EXPECT_LT(sim::fabric::elasticEnergy(*plain, plain->restPositions), 1e-3);
  EXPECT_GT(sim::fabric::elasticEnergy(*banded, plain->restPositions), 0.1) << "the waist is stretched at the start";
  int shortened = 0;
  for (std::size_t t = 0; t < plain->triangles.size(); ++t) {
    const double ratio = banded->fabric->shape.triangles[t].area / plain->fabric->shape.triangles[t].area;
    EXPECT_TRUE(std::abs(ratio - 1.0) < 1e-9 || std::abs(ratio - 0.8) < 1e-9) << ratio;
    EXPECT_EQ(banded->fabric->shape.triangles[t].isBand, ratio < 0.9);
    shortened += ratio < 0.9 ? 1 : 0;
  }
  EXPECT_GT(shortened, 20);
}

TEST(ElasticBands, doNotCountAsStrain) {
  const auto plain = builtSkirt("", cotton)->model;
  const auto banded = builtSkirt(waistBand, cotton)->model;
  EXPECT_LT(sim::fabric::strainsAlongYarns(*banded, plain->restPositions).front(), 1e-3);
}

TEST(ElasticBands, areAlongAPartOfABorder) {
  const auto banded = [](const std::string& bands) {
    const auto file = std::filesystem::path(::testing::TempDir()) / "drape_band_part.toml";
    std::ofstream(file) << "[cloth]\ngrid = \"vertical\"\nbands = " << bands
                        << "\n[settings]\ngrid.resolution = 5\ngrid.width = 0.4\ngrid.height = 0.4\n";
    const SceneDescription description = openScene(file.string());
    std::filesystem::remove(file);
    return buildScene(description, description.settings);
  };
  const auto lengthBetween = [](const Scene& scene, int a, int b) {
    return scene.model->springs[sim::springBetween(scene.model->springEnds, a, b)].restLength;
  };
  const auto part = banded("[{ vertices = [0, 2, 4], length = 0.8 }, { vertices = [20, 24], length = 0.5 }]");
  EXPECT_NEAR(lengthBetween(*part, 0, 1), 0.08, 1e-12);
  EXPECT_NEAR(lengthBetween(*part, 23, 24), 0.05, 1e-12);
  EXPECT_NEAR(lengthBetween(*part, 0, 5), 0.1, 1e-12) << "another side";
  EXPECT_THROW((void)banded("[{ vertices = [7], length = 0.8 }]"), messages::InputError) << "it is inside";
  EXPECT_THROW((void)banded("[{ vertices = [25], length = 0.8 }]"), messages::InputError) << "there is none";
  EXPECT_THROW((void)banded("[{ vertices = [0], length = 0.8 }, { vertices = [20, 24], length = 0.5 }]"),
               messages::InputError)
      << "two bands along one edge";
}

TEST(ElasticBands, areRefusedWithoutABorderOrALength) {
  const auto problemOf = [](const std::string& keys) -> std::string {
    try {
      (void)openSkirt(keys, "");
    } catch (const messages::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(problemOf("bands = [{ length = 0.8 }]").find("a band needs nearest"), std::string::npos);
  EXPECT_NE(problemOf("bands = [{ nearest = [0, 1, 0], vertices = [1], length = 0.8 }]").find("a band needs nearest"),
            std::string::npos);
  EXPECT_NE(problemOf("bands = [{ nearest = [0, 1, 0] }]").find("a band needs nearest"), std::string::npos);
  EXPECT_NE(problemOf("bands = [{ nearest = [0, 1, 0], length = 5 }]").find("length"), std::string::npos);
  SceneDescription closed = openSkirt(waistBand, "");
  closed.cloth().source = MeshFileSource{"figure.obj", true};
  EXPECT_THROW((void)buildScene(closed, closed.settings), messages::InputError);
}

}  // namespace
}  // namespace drape::scene

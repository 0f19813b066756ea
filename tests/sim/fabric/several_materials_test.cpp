#include "sim/fabric/fabric.hpp"

#include "fabric_cloths.hpp"
#include "sim/model/sim_error.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace drape::sim::fabric {
namespace {

using namespace drape::sim::testing;

const Vec3 warpDirection = Vec3(1.0, 0.3, 0.4).normalized();

/// A soft fabric with equal damping times than `stiff` has.
Material soft() {
  Material material = woven();
  material.stretchWarp = 60.0;
  material.stretchWeft = 40.0;
  material.shear = 9.0;
  material.stiffeningStrain = 0.001;
  material.stiffeningWarp = 80.0;
  material.bendWarp = material.bendWeft = material.bendBias = 4e-6;
  material.stretchDamping = 2e-4;
  material.bendDamping = 3e-3;
  return material;
}

Material stiff() {
  Material material = woven();
  material.stretchDamping = 5e-5;
  material.bendDamping = 1e-3;
  return material;
}

Material undamped(Material material) {
  material.stretchDamping = material.bendDamping = 0.0;
  return material;
}

std::shared_ptr<const ClothModel> modelOf(const ClothMesh& mesh, const TriangleMaterials& materials,
                                          std::vector<int> clothOf = {}) {
  auto springs = buildClothModel(mesh, 0.1 * restAreaOf(mesh), MassLumping::Area, {});
  springs = clothOf.empty() ? springs : withCloths(*springs, std::move(clothOf));
  return withFabric(*springs, materials, warpAlong(warpDirection, mesh.positions, mesh.triangles));
}

/// Two sheets that are not connected, one cloth each.
struct TwoSheets {
  ClothMesh first;
  ClothMesh second;
  ClothMesh both;
};

TwoSheets twoSheets(bool irregular) {
  TwoSheets sheets{.first = sheet(9), .second = sheet(7), .both = {}};
  RandomVectors random(5);
  for (ClothMesh* mesh : {&sheets.first, &sheets.second}) {
    for (Vec3& position : mesh->positions) {
      position += irregular ? random.next(0.02) : Vec3(Vec3::Zero());
    }
  }
  for (Vec3& position : sheets.second.positions) {
    position.y() += 2.0;
  }
  sheets.both = sheets.first;
  const auto offset = static_cast<int>(sheets.first.positions.size());
  sheets.both.positions.insert(sheets.both.positions.end(), sheets.second.positions.begin(),
                               sheets.second.positions.end());
  for (const auto& [a, b, c] : sheets.second.triangles) {
    sheets.both.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return sheets;
}

TriangleMaterials differentMaterials(const TwoSheets& sheets, const Material& first, const Material& second) {
  std::vector<int> indices(sheets.both.triangles.size(), 1);
  std::fill_n(indices.begin(), sheets.first.triangles.size(), 0);
  return {{first, second}, std::move(indices)};
}

/// Both sheets in one model, with different materials.
std::shared_ptr<const ClothModel> joinedModel(const TwoSheets& sheets, const Material& first, const Material& second) {
  std::vector<int> clothOf(sheets.both.positions.size(), 1);
  std::fill_n(clothOf.begin(), sheets.first.positions.size(), 0);
  return modelOf(sheets.both, differentMaterials(sheets, first, second), std::move(clothOf));
}

ClothState partOf(const ClothState& both, std::size_t first, std::size_t count) {
  ClothState state;
  state.positions.assign(both.positions.begin() + first, both.positions.begin() + first + count);
  state.velocities.assign(both.velocities.begin() + first, both.velocities.begin() + first + count);
  return state;
}

/// The largest difference in any position [m] between two cloths in one model and in two.
double differenceFromSeparateModels(bool irregular, Precision precision, const Material& one, const Material& other) {
  const TwoSheets sheets = twoSheets(irregular);
  const auto both = joinedModel(sheets, one, other);
  StepParameters parameters;
  parameters.timeStep = 1.0 / 300.0;
  parameters.substeps = 20;
  parameters.precision = precision;
  const ClothState start = shaken(*both, 0.004, 9);
  const auto moved = [&](const ClothModel& model, ClothState state) {
    Stepper stepper("verlet");
    for (int i = 0; i < 10; ++i) {
      stepper.step(model, parameters, {}, state);
    }
    return state;
  };
  const std::size_t firstCount = sheets.first.positions.size();
  const ClothState together = moved(*both, start);
  const ClothState first = moved(*modelOf(sheets.first, one), partOf(start, 0, firstCount));
  const ClothState second =
      moved(*modelOf(sheets.second, other), partOf(start, firstCount, sheets.second.positions.size()));
  double largest = 0.0;
  for (std::size_t v = 0; v < together.positions.size(); ++v) {
    const Vec3& alone = v < firstCount ? first.positions[v] : second.positions[v - firstCount];
    largest = std::max(largest, (together.positions[v] - alone).norm());
  }
  return largest;
}

TEST(SeveralMaterials, moveAsInSeparateModels) {
  for (const bool irregular : {false, true}) {
    EXPECT_LT(differenceFromSeparateModels(irregular, Precision::Double, undamped(soft()), undamped(stiff())), 1e-12);
    EXPECT_LT(differenceFromSeparateModels(irregular, Precision::Float, undamped(soft()), undamped(stiff())), 1e-5);
  }
}

TEST(SeveralMaterials, dampEachClothByItsOwnTimes) {
  Material equal = soft();
  equal.stretchDamping = stiff().stretchDamping;
  equal.bendDamping = stiff().bendDamping;
  for (const bool irregular : {false, true}) {
    EXPECT_LT(differenceFromSeparateModels(irregular, Precision::Double, soft(), stiff()), 2e-5)
        << "the number of stages differs";
    EXPECT_LT(differenceFromSeparateModels(irregular, Precision::Double, equal, stiff()), 1e-12)
        << "equal times have the same stages";
  }
}

TEST(SeveralMaterials, haveTheEnergyOfEachCloth) {
  const TwoSheets sheets = twoSheets(true);
  const auto both = joinedModel(sheets, soft(), stiff());
  const ClothState state = shaken(*both, 0.01, 4);
  const std::size_t firstCount = sheets.first.positions.size();
  const double first = elasticEnergy(*modelOf(sheets.first, soft()), partOf(state, 0, firstCount).positions);
  const double second = elasticEnergy(*modelOf(sheets.second, stiff()),
                                      partOf(state, firstCount, sheets.second.positions.size()).positions);
  EXPECT_NEAR(elasticEnergy(*both, state.positions), first + second, 1e-9 * (first + second));
}

TEST(SeveralMaterials, haveAnotherFingerprintIfTheyAreExchanged) {
  const TwoSheets sheets = twoSheets(true);
  const auto one = joinedModel(sheets, soft(), stiff());
  const auto other = joinedModel(sheets, stiff(), soft());
  EXPECT_NE(one->fabric->fingerprint, other->fabric->fingerprint);
}

TEST(SeveralMaterials, mustNotMeetAtAVertex) {
  const ClothMesh mesh = sheet(4);
  std::vector<int> indices(mesh.triangles.size(), 0);
  indices.back() = 1;
  try {
    static_cast<void>(modelOf(mesh, TriangleMaterials({soft(), stiff()}, indices)));
    FAIL() << "accepted";
  } catch (const ClothModelError& error) {
    EXPECT_EQ(error.fault(), ClothModelError::Fault::MaterialsMeet);
  }
}

}  // namespace
}  // namespace drape::sim::fabric

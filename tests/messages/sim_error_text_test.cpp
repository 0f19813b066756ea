#include "messages/sim_error_text.hpp"

#include "fabric_cloths.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace drape::messages {
namespace {

/// The message of the InputError that `action` becomes; empty, with a test failure, if it throws none.
template <typename Action>
std::string messageFrom(const Action& action) {
  try {
    static_cast<void>(withInputErrors(action));
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return {};
}

std::string messageOfCloth(const sim::ClothMesh& mesh, double mass, const std::vector<int>& pins = {}) {
  return messageFrom([&] { return sim::buildClothModel(mesh, mass, sim::MassLumping::Area, pins); });
}

TEST(SimErrorText, saysWhyAMeshIsNoCloth) {
  EXPECT_EQ(messageOfCloth({}, 0.1), "a cloth needs at least one triangle; the mesh has 0 vertices and 0 triangles");
  sim::ClothMesh mesh = sim::testing::sheet(3);
  mesh.triangles[2][1] = 99;
  EXPECT_EQ(messageOfCloth(mesh, 0.1), "triangle 2 names vertex 99, but the mesh has only 9 (counted from 0)");
  mesh = sim::testing::sheet(3);
  mesh.positions[4].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(messageOfCloth(mesh, 0.1), "vertex 4 of the mesh has a coordinate that is not a finite number");
}

TEST(SimErrorText, saysWhyMassesAndPinsCannotBe) {
  const sim::ClothMesh mesh = sim::testing::sheet(3);
  EXPECT_EQ(messageOfCloth(mesh, 0.0),
            "the mass of a cloth must be positive and finite, not 0.000000 kg; set mass or density");
  EXPECT_EQ(messageOfCloth(mesh, 0.1, {9}),
            "vertex 9 cannot be pinned: the cloth has only 9 vertices (counted from 0)");
  const auto model = sim::testing::pinnedSheet(3);
  EXPECT_EQ(messageFrom([&] { return sim::withVertexMasses(*model, {1.0}); }),
            "the list of masses has 1 entries for a cloth of 9 vertices");
  EXPECT_EQ(messageFrom([&] { return sim::withPins(*model, {}); }),
            "the list of pins has 0 entries for a cloth of 9 vertices");
  std::vector<double> masses = model->vertexMass;
  masses[3] = -0.5;
  EXPECT_EQ(messageFrom([&] { return sim::withVertexMasses(*model, masses); }),
            "vertex 3 would have a mass of -0.500000 kg; it must be positive and finite");
}

TEST(SimErrorText, saysWhyStiffnessesCannotBe) {
  const auto model = sim::testing::pinnedSheet(3);
  EXPECT_EQ(messageFrom([&] { return sim::withSpringStiffness(*model, {1.0}); }),
            "the list of stiffnesses has 1 entries for a cloth of 16 springs");
  std::vector<double> relative(model->springs.size(), 1.0);
  relative[5] = -2.0;
  EXPECT_EQ(messageFrom([&] { return sim::withSpringStiffness(*model, relative); }),
            "spring 5 would have -2.000000 times the cloth's stiffness; it must be finite and not negative");
  EXPECT_EQ(inWords(sim::ClothModelError(sim::ClothModelError::Fault::TooManySprings, {.count = 65535})),
            "a vertex of the cloth has more than 65535 springs");
}

TEST(SimErrorText, saysWhyAPatternCannotBe) {
  const auto model = sim::testing::pinnedSheet(3);
  EXPECT_EQ(messageFrom([&] { return sim::fabric::withPattern(*model, {}); }),
            "the list of pattern triangles has 0 entries for a cloth of 8 triangles");
  EXPECT_EQ(messageFrom([&] { return sim::withRestSizes(*model, {}, model->vertexArea); }),
            "the list of rest lengths has 0 entries for a cloth of 16 springs");
  const std::vector<double> lengths(model->springs.size(), 1.0);
  EXPECT_EQ(messageFrom([&] { return sim::withRestSizes(*model, lengths, {}); }),
            "the list of areas has 0 entries for a cloth of 9 vertices");
}

TEST(SimErrorText, namesTheSolversThatTakeAFabric) {
  const std::string refusal = takesSpringsOnly("ghost.solver", "kang").english();
  EXPECT_TRUE(
      refusal.starts_with("ghost.solver = kang knows springs only. With material.model = fabric choose one of: "
                          "one_iteration, auto, "))
      << refusal;
  const auto model = sim::testing::asFabric(*sim::testing::pinnedSheet(3), sim::testing::woven());
  sim::ClothState state = sim::stateAtRest(model->restPositions);
  EXPECT_EQ(messageFrom([&] { return sim::Stepper("kang").step(*model, {}, {}, state); }),
            takesSpringsOnly("solver", "kang"));
}

TEST(SimErrorText, namesAnUnknownSolverAndKeepsOtherMessages) {
  EXPECT_EQ(messageFrom([] { return sim::Stepper("magic"); }), "there is no solver 'magic'");
  EXPECT_EQ(messageOf(std::runtime_error("another")), "another");
  EXPECT_EQ(withInputErrors([] { return 3; }), 3);
}

}  // namespace
}  // namespace drape::messages

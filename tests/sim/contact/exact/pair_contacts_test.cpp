#include "sim/contact/exact/pair_contacts.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::sim::contact {
namespace {

constexpr double thickness = 0.004;
constexpr double gap = 0.002;
constexpr double separationStep = 0.0003;

/// The contacts between two crossing edges, one above the other. The triangle of the lower edge is tilted upwards.
/// @param slant sine of the angle of the tilt
std::vector<SubstepContact> contactsOfCrossingEdges(double slant) {
  const ClothMesh mesh{.positions = {{-0.02, gap, 0.0},
                                     {0.02, gap, 0.0},
                                     {0.0, gap + 0.05, 0.0},
                                     {0.0, 0.0, -0.02},
                                     {0.0, 0.0, 0.02},
                                     {0.05 * std::sqrt(1.0 - slant * slant), 0.05 * slant, 0.0}},
                       .triangles = {{0, 1, 2}, {3, 4, 5}}};
  std::vector<Vec3> rest = mesh.positions;
  for (std::size_t v = 3; v < rest.size(); ++v) {
    rest[v].y() -= 1.0;
  }
  const auto model = buildClothModel({.positions = rest, .triangles = mesh.triangles}, 1.0, MassLumping::Uniform, {});
  PairSearch search;
  Workers workers;
  search.update({.model = *model, .distance = 2.0 * thickness, .reach = 2.0 * thickness, .patches = nullptr},
                mesh.positions, mesh.positions, workers);
  std::vector<SubstepContact> found;
  findPairContacts(*model, search,
                   {.thickness = thickness,
                    .margin = 0.25 * thickness,
                    .separationStep = separationStep,
                    .staticFriction = 0.3,
                    .kineticFriction = 0.3,
                    .entangled = {}},
                   mesh.positions, mesh.positions, workers, 1, found);
  std::erase_if(found, [](const SubstepContact& contact) { return !(contact.weights[1] > 0.0); });  // of vertices
  return found;
}

TEST(PairContacts, moveEdgesApartThatAreTooClose) {
  const std::vector<SubstepContact> contacts = contactsOfCrossingEdges(0.0);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].height, gap + separationStep, 1e-12);
  EXPECT_NEAR(contacts[0].normal.y(), 1.0, 1e-12);
}

TEST(PairContacts, moveEdgesNextToASlantedFaceApartMoreSlowlyTheMoreItIsSlanted) {
  for (const auto& [slant, ratio] : {std::pair(0.15, 1.0), std::pair(0.2, 0.5), std::pair(0.27, 0.0)}) {
    const std::vector<SubstepContact> contacts = contactsOfCrossingEdges(slant);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_NEAR(contacts[0].height, gap + ratio * separationStep, 1e-6) << slant;
  }
}

TEST(PairContacts, leaveOutEdgesWhereAFaceIsCloser) {
  EXPECT_TRUE(contactsOfCrossingEdges(0.5).empty());
}

}  // namespace
}  // namespace drape::sim::contact

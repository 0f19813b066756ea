#include "scene/pin_selection.hpp"

#include "messages/error.hpp"

#include <gtest/gtest.h>

namespace drape::scene {
namespace {

const std::vector<Vec3>& ladder() {
  static const std::vector<Vec3> positions{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0),
                                           Vec3(0.5, 0.98, 0)};
  return positions;
}

TEST(PinSelection, isEmptyWhenNothingIsSelected) {
  EXPECT_TRUE(selectPins({}, ladder(), nullptr).empty());
}

TEST(PinSelection, addsUpItsPartsAndNamesEachVertexOnce) {
  PinSelection pins;
  pins.vertices = {4, 1};
  pins.nearest = {Vec3(0.9, 0.1, 0.0)};
  EXPECT_EQ(selectPins(pins, ladder(), nullptr), (std::vector<int>{1, 4}));
}

TEST(PinSelection, takesTheTopByAShareOfTheHeight) {
  PinSelection pins;
  pins.top = 0.0;
  EXPECT_EQ(selectPins(pins, ladder(), nullptr), (std::vector<int>{2, 3}));
  pins.top = 0.05;
  EXPECT_EQ(selectPins(pins, ladder(), nullptr), (std::vector<int>{2, 3, 4}));
}

TEST(PinSelection, takesWhatIsInsideABox) {
  PinSelection pins;
  pins.boxes = {{Vec3(-0.1, 0.5, -1.0), Vec3(0.6, 2.0, 1.0)}};
  EXPECT_EQ(selectPins(pins, ladder(), nullptr), (std::vector<int>{2, 4}));
}

TEST(PinSelection, namesTheVerticesThatThereAreAndTheLine) {
  PinSelection pins;
  pins.vertices = {5};
  pins.where = "a.toml:3";
  pins.whereVertices = "a.toml:4";
  try {
    static_cast<void>(selectPins(pins, ladder(), nullptr));
    FAIL();
  } catch (const messages::InputError& error) {
    EXPECT_STREQ(error.what(), "a.toml:4: pins.vertices contains vertex 5, but the vertices of the cloth are 0 to 4");
  }
}

TEST(PinSelection, refusesAVertexThatIsNotThereAndEdgesOfAMesh) {
  PinSelection pins;
  pins.vertices = {5};
  EXPECT_THROW(static_cast<void>(selectPins(pins, ladder(), nullptr)), messages::InputError);
  pins.vertices.clear();
  pins.edges = {"left"};
  EXPECT_THROW(static_cast<void>(selectPins(pins, ladder(), nullptr)), messages::InputError);
}

}  // namespace
}  // namespace drape::scene

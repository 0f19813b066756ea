// What mesh files of different units, axes and pieces are found to be.
#include "scene/found_mesh.hpp"

#include "garment_shapes.hpp"
#include "messages/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace drape::scene {
namespace {

using io::MeshUse;
using Units = std::vector<std::pair<std::string, double>>;

/// The units and how many of them are in a metre.
const Units& unitsPerMetre() {
  static const Units units{{"m", 1.0}, {"cm", 100.0}, {"mm", 1000.0}, {"inch", 1.0 / 0.0254}, {"foot", 1.0 / 0.3048}};
  return units;
}

class FoundMeshTest : public ::testing::Test {
 protected:
  FoundMeshTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~FoundMeshTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] FoundMesh find(const sim::ClothMesh& mesh) const {
    const std::filesystem::path file = folder_ / "mesh.obj";
    std::ofstream(file) << testing::objText(mesh);
    return findMesh(file.string());
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

sim::ClothMesh joined(sim::ClothMesh first, const sim::ClothMesh& second, const Vec3& shift) {
  const int offset = static_cast<int>(first.positions.size());
  for (const Vec3& position : second.positions) {
    first.positions.push_back(position + shift);
  }
  for (const Triangle& t : second.triangles) {
    first.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return first;
}

double largest(const MeshReading& reading) {
  return *std::ranges::max_element(reading.size);
}

TEST_F(FoundMeshTest, APersonIsAsTallInAnyUnitAndTurn) {
  for (const auto& [unit, perMetre] : unitsPerMetre()) {
    for (const bool zUp : {false, true}) {
      sim::ClothMesh body = testing::figure(45.0);
      const FoundMesh found = find(testing::scaled(zUp ? testing::withZUp(body) : body, perMetre));
      const MeshReading reading = readingOf(found, {}, MeshUse::Body);
      EXPECT_EQ(reading.unit, unit);
      EXPECT_EQ(reading.up, zUp ? "z" : "y") << unit;
      EXPECT_NEAR(reading.size[1], 1.7, 0.1) << unit << ": its height";
      EXPECT_EQ(reading.unitReason, ReadingReason::Shape);
      EXPECT_EQ(reading.upReason, ReadingReason::Shape);
      EXPECT_EQ(unitReasonInWords(found, reading, MeshUse::Body), "the size of a person");
      EXPECT_EQ(found.pieces, 1);
    }
  }
}

TEST_F(FoundMeshTest, ADressFormIsAsTallInAnyUnit) {
  sim::ClothMesh form = testing::figure(45.0);
  std::erase_if(form.triangles, [&](const Triangle& t) {  // its trunk and neck, open below
    const Vec3 centre = (form.positions[t[0]] + form.positions[t[1]] + form.positions[t[2]]) / 3.0;
    return centre.y() < 0.75 || centre.y() > 1.5 || std::abs(centre.x()) > 0.21;
  });
  for (const auto& [unit, perMetre] : unitsPerMetre()) {
    const FoundMesh found = find(testing::scaled(form, perMetre));
    const MeshReading reading = readingOf(found, {}, MeshUse::Body);
    EXPECT_EQ(reading.unit, unit);
    EXPECT_NEAR(reading.size[1], 0.75, 0.05) << unit;
    EXPECT_EQ(unitReasonInWords(found, reading, MeshUse::Body), "the size of a torso");
  }
}

TEST_F(FoundMeshTest, AGarmentOfThreePiecesIsCounted) {
  const sim::ClothMesh shirt = testing::shirt({});
  const sim::ClothMesh cuff = testing::tube(0.1, 0.08, 0.08, 1.0);
  const sim::ClothMesh garment = joined(joined(shirt, cuff, {0.6, 0.2, 0.0}), cuff, {-0.6, 0.2, 0.0});
  const FoundMesh found = find(testing::scaled(garment, 100.0));
  EXPECT_EQ(found.pieces, 3);
  EXPECT_EQ(found.vertices, static_cast<int>(garment.positions.size()));
  EXPECT_EQ(found.triangles, static_cast<int>(garment.triangles.size()));
  const MeshReading reading = readingOf(found, {}, MeshUse::Cloth);
  EXPECT_EQ(reading.unit, "cm");
  EXPECT_EQ(unitReasonInWords(found, reading, MeshUse::Cloth), "the size of a garment");
  EXPECT_EQ(countsInWords(found), "3 pieces, " + std::to_string(found.vertices) + " vertices, " +
                                      std::to_string(found.triangles) + " triangles");
}

TEST_F(FoundMeshTest, NeitherUnitNorUpAxisOfAFlatSheetIsKnown) {
  for (const auto& [across, along] : {std::pair(0, 1), std::pair(0, 2)}) {
    const FoundMesh found = find(testing::sheet(across, along, 0.8, 0.6, 9));
    const MeshReading reading = readingOf(found, {}, MeshUse::Cloth);
    EXPECT_EQ(reading.unitReason, ReadingReason::Unknown);
    EXPECT_EQ(reading.upReason, ReadingReason::Unknown);
    EXPECT_EQ(unitReasonInWords(found, reading, MeshUse::Cloth), "a guess: a flat sheet can have any size");
    EXPECT_EQ(upReasonInWords(reading), "a guess: its shape does not show it");
    EXPECT_EQ(reading.up, "y");
    EXPECT_NEAR(largest(reading), 0.8, 1e-6) << "in the most common unit";
  }
}

TEST_F(FoundMeshTest, AChoiceOfTheUserDecides) {
  const FoundMesh found = find(testing::scaled(testing::figure(45.0), 100.0));
  const MeshReading reading = readingOf(found, {"inch", "x"}, MeshUse::Body);
  EXPECT_EQ(reading.unit, "inch");
  EXPECT_EQ(reading.unitReason, ReadingReason::Chosen);
  EXPECT_EQ(reading.upReason, ReadingReason::Chosen);
  const MeshReading guess = readingOf(found, {}, MeshUse::Body);
  EXPECT_NEAR(reading.size[1], 2.54 * guess.size[0], 1e-9) << "x is up now";
  EXPECT_NEAR(reading.size[0], 2.54 * guess.size[1], 1e-9);
}

TEST_F(FoundMeshTest, WhatTheFormatPrescribesIsNoGuess) {
  FoundMesh found = find(testing::scaled(testing::withZUp(testing::figure(45.0)), 100.0));
  found.format = {1.0, 'y'};
  const MeshReading reading = readingOf(found, {}, MeshUse::Body);
  EXPECT_EQ(reading.unit, "m");
  EXPECT_EQ(reading.up, "y");
  EXPECT_EQ(unitReasonInWords(found, reading, MeshUse::Body), "as the file format prescribes");
  EXPECT_EQ(upReasonInWords(reading), "as the file format prescribes");
}

TEST_F(FoundMeshTest, ABodyThatIsNoPersonIsReadLikeTheCloth) {
  const FoundMesh shirt = find(testing::scaled(testing::withZUp(testing::shirt({})), 100.0));
  const MeshReading cloth = readingOf(shirt, {}, MeshUse::Cloth);
  ASSERT_EQ(cloth.unit, "cm");
  FoundMesh table = shirt;
  table.extent = Vec3(300.0, 300.0, 75.0);
  table.upOfShape = "";
  const MeshReading reading = readingBeside(table, {}, cloth);
  EXPECT_EQ(reading.unit, "cm") << "a table of 3 m";
  EXPECT_EQ(reading.up, "z");
  EXPECT_EQ(unitReasonInWords(table, reading, MeshUse::Body), "a guess: as for the cloth");
  EXPECT_EQ(upReasonInWords(reading), "a guess: as for the cloth");
  EXPECT_EQ(readingBeside(table, {"mm", "y"}, cloth).unit, "mm") << "the user decides";
  const FoundMesh person = find(testing::scaled(testing::figure(45.0), 1000.0));
  EXPECT_EQ(readingBeside(person, {}, cloth).unit, "mm") << "a person has its own unit";
}

TEST_F(FoundMeshTest, BuiltInOnesAreInMetres) {
  for (const char* name : {"mannequin", "figure", "builtin:tshirt.obj"}) {
    const MeshReading reading = readingOf(findMesh(name), {}, MeshUse::Body);
    EXPECT_EQ(reading.unit, "m") << name;
    EXPECT_EQ(reading.up, "y") << name;
    EXPECT_EQ(reading.unitReason, ReadingReason::Format) << name;
  }
}

TEST_F(FoundMeshTest, TheFactsAreOneLineEach) {
  const FoundMesh found = find(testing::figure(45.0));
  const std::vector<text::Sentence> lines = inWords(found, readingOf(found, {}, MeshUse::Body), MeshUse::Body);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_TRUE(lines[0].english().ends_with("m (width x height x depth)")) << lines[0];
  EXPECT_EQ(lines[1], "unit: metres (the size of a person)");
  EXPECT_EQ(lines[2], "up axis: y (by its shape)");
}

TEST(FindMesh, NamesAFileThatCannotBeRead) {
  EXPECT_THROW(static_cast<void>(findMesh("/no/such/body.obj")), messages::InputError);
}

}  // namespace
}  // namespace drape::scene

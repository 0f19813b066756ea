#include "report/sections/set_ups.hpp"
#include "report/sections/work_plan.hpp"

#include "messages/error.hpp"
#include "report/sections/table2_starts.hpp"
#include "report/sections/work_material.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace drape::report {
namespace {

TEST(SetUps, areTheReportsOwnOrOneByName) {
  std::set<std::string> names;
  for (const auto& setUp : sections::comparedSetUps("")) {
    names.insert(setUp.name);
  }
  EXPECT_EQ(names, (std::set<std::string>{"hang", "flag", "crush", "twist", "tshirt", "four_corners", "one_corner",
                                          "one_edge", "tshirt_of_springs"}));
  EXPECT_EQ(sections::comparedSetUps("twist").size(), 1U);
  EXPECT_EQ(sections::comparedSetUps("curtain").at(0).scene, "curtain");
  EXPECT_THROW((void)sections::comparedSetUps("skirt"), messages::InputError);
  EXPECT_THROW((void)sections::comparedSetUps("nothing"), messages::InputError);
}

TEST(SetUps, haveOwnClothsInAFullReportIfTheyNameThem) {
  const auto fourCorners = sections::comparedSetUps("four_corners").at(0);
  const auto cloths = sections::comparedCloths(fourCorners, false, false);
  ASSERT_EQ(cloths.size(), 3U);
  EXPECT_EQ(cloths.at(2).resolution, 49);
  EXPECT_EQ(cloths.at(2).material.stiffness, 3e4);
  EXPECT_FALSE(cloths.at(2).fastMethods);
  EXPECT_TRUE(sections::comparedCloths(fourCorners, false, true).empty()) << "a quick report has few cloths";
  const auto shirt = sections::comparedCloths(sections::comparedSetUps("tshirt_of_springs").at(0), false, false);
  ASSERT_EQ(shirt.size(), 1U);
  EXPECT_EQ(shirt.at(0).resolution, 0);
  EXPECT_TRUE(shirt.at(0).fastMethods);
}

TEST(SetUps, beginAtRestWithTheirPinsWhereTheyBelong) {
  for (const auto& setUp : sections::comparedSetUps("")) {
    if (sections::isMesh(setUp)) {
      continue;
    }
    const auto scene = sections::buildSetUp(setUp, 9, {"stiffness=50"});
    EXPECT_EQ(scene->settings.step.material.stiffness, 50.0);
    EXPECT_EQ(sim::energyOf(*scene->model, scene->settings.step, scene->start).kinetic, 0.0) << setUp.name;
    const auto pins = std::count(scene->model->pinned.begin(), scene->model->pinned.end(), true);
    const std::map<std::string, int> expected{{"hang", 2},     {"flag", 9},         {"crush", 18},    {"twist", 18},
                                              {"one_edge", 9}, {"four_corners", 4}, {"one_corner", 1}};
    EXPECT_EQ(pins, expected.at(setUp.name)) << setUp.name;
  }
}

TEST(SetUps, hangTheTShirtFromItsTopWithItsFabricAndWithoutItsMannequin) {
  const auto tshirt = sections::comparedSetUps("tshirt").at(0);
  ASSERT_TRUE(sections::isMesh(tshirt));
  const auto scene = sections::buildSetUp(tshirt, 0, sections::fabricOf("denim").settings);
  EXPECT_EQ(scene->model->vertexCount(), 2014);
  EXPECT_TRUE(scene->bodies->empty());
  ASSERT_TRUE(scene->model->fabric);
  const double lowestPin = [&] {
    double lowest = 1e9;
    for (std::size_t v = 0; v < scene->model->pinned.size(); ++v) {
      lowest = scene->model->pinned[v] ? std::min(lowest, scene->model->restPositions[v].y()) : lowest;
    }
    return lowest;
  }();
  const auto [bottom, top] = std::minmax_element(scene->model->restPositions.begin(), scene->model->restPositions.end(),
                                                 [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  EXPECT_GE(lowestPin, top->y() - 0.031 * (top->y() - bottom->y()));
  EXPECT_NEAR(scene->model->totalMass() / scene->model->restArea(), 0.324, 1e-3) << "the density of denim";
}

TEST(SetUps, compressTheCrushedSheetAndStretchTheTwistedOne) {
  const auto crush = sections::buildSetUp(sections::comparedSetUps("crush").at(0), 9, {});
  const auto [left, right] = std::minmax_element(crush->start.positions.begin(), crush->start.positions.end(),
                                                 [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
  EXPECT_NEAR(right->x() - left->x(), 0.95, 1e-9);
  const auto twist = sections::buildSetUp(sections::comparedSetUps("twist").at(0), 9, {});
  const Vec3 top = twist->start.positions[8] - twist->start.positions[0];
  const Vec3 bottom = twist->start.positions[80] - twist->start.positions[72];
  EXPECT_NEAR(top.dot(bottom), std::cos(std::atan(1.0)), 1e-9);
  EXPECT_NEAR(twist->start.positions[0].y() - twist->start.positions[72].y(), 1.0, 1e-9);
  EXPECT_GT(sim::maxStretch(*twist->model, twist->start), 0.03);
}

TEST(Jitter, movesFreeVerticesALittleAndEachSeedOtherwise) {
  const auto scene = sections::buildSetUp(sections::comparedSetUps("hang").at(0), 9, {});
  const auto one = sections::jittered(*scene, 1e-6, 1);
  const auto again = sections::jittered(*scene, 1e-6, 1);
  const auto two = sections::jittered(*scene, 1e-6, 2);
  EXPECT_EQ(sim::stateHash(one->start), sim::stateHash(again->start));
  EXPECT_NE(sim::stateHash(one->start), sim::stateHash(two->start));
  for (std::size_t v = 0; v < 81; ++v) {
    const Vec3 move = one->start.positions[v] - scene->start.positions[v];
    EXPECT_LE(move.cwiseAbs().maxCoeff(), 1.0001e-6);
    EXPECT_EQ(move.norm() == 0.0, scene->model->pinned[v]);
  }
}

TEST(Table2Starts, hangAtRestAndSwingAfterwards) {
  const auto startOf = [](const std::string& name) {
    const auto& all = sections::table2Starts();
    return *std::find_if(all.begin(), all.end(),
                         [&](const sections::Table2Start& start) { return start.name == name; });
  };
  const std::vector<std::string> settings{"time_step=1/150", "mass=0.1", "stiffness=10", "precision=double"};
  const auto hanging = sections::buildStart(startOf("hanging, edge"), 9, settings, [] {});
  EXPECT_EQ(sim::energyOf(*hanging->model, hanging->settings.step, hanging->start).kinetic, 0.0);
  // Rotated by 20 degrees about the pinned edge, so the lowest vertices are out of the upright plane by this distance.
  const auto lowest = *std::min_element(hanging->start.positions.begin(), hanging->start.positions.end(),
                                        [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  const Vec3 pin = hanging->start.positions[0];
  EXPECT_NEAR(std::abs(lowest.z() - pin.z()) / (pin.y() - lowest.y()), std::tan(20.0 * std::atan(1.0) / 45.0), 0.02);
  const auto swinging = sections::buildStart(startOf("swinging, edge"), 9, settings, [] {});
  EXPECT_GT(sim::energyOf(*swinging->model, swinging->settings.step, swinging->start).kinetic, 1e-3);
  const auto falling = sections::buildStart(startOf("free fall"), 9, settings, [] {});
  EXPECT_EQ(std::count(falling->model->pinned.begin(), falling->model->pinned.end(), true), 0);
}

}  // namespace
}  // namespace drape::report

#include "fields/probes.hpp"
#include "fields/shown_field.hpp"
#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <vector>

namespace drape::fields {
namespace {

using session::testing::smallGrid;
using sim::fields::FieldInfo;
using sim::fields::fieldTable;
using sim::fields::findField;

session::Snapshot snapshotAfter(int steps, const std::vector<std::string>& settings, bool observed = true) {
  session::Simulation simulation(smallGrid(9, settings));
  if (observed) {
    simulation.apply(session::ObserveCommand{});
  }
  for (int i = 0; i < steps; ++i) {
    simulation.step();
  }
  session::Snapshot snapshot;
  simulation.capture(snapshot);
  return snapshot;
}

TEST(SnapshotFields, HaveOneValueAtEachVertexWhereTheQuantityExists) {
  const session::Snapshot snapshot = snapshotAfter(3, {"material.model=fabric", "solver=auto", "ghost.solver=newton"});
  SnapshotFields fields;
  fields.take(snapshot);
  for (const FieldInfo& field : fieldTable()) {
    EXPECT_EQ(fields.whyMissing(field), "") << field.name;
    EXPECT_EQ(fields.values(field).size(), snapshot.positions.size()) << field.name;
  }
}

TEST(SnapshotFields, SayWhyAQuantityDoesNotExist) {
  const session::Snapshot snapshot = snapshotAfter(0, {"bodies=off"}, false);
  SnapshotFields fields;
  fields.take(snapshot);
  for (const std::string_view missing : {"stress", "body_gap", "contact_pressure", "ghost_error", "speed"}) {
    EXPECT_TRUE(fields.values(*findField(missing)).empty()) << missing;
    const std::string reason = fields.whyMissing(*findField(missing));
    EXPECT_TRUE(reason.ends_with('.')) << missing << ": " << reason;
  }
  EXPECT_EQ(fields.whyMissing(*findField("bending")), "");
}

TEST(SnapshotFields, FollowTheSnapshotAndTheModel) {
  session::Simulation simulation(smallGrid());
  simulation.apply(session::ObserveCommand{});
  session::Snapshot snapshot;
  simulation.capture(snapshot);
  SnapshotFields fields;
  fields.take(snapshot);
  EXPECT_DOUBLE_EQ(fields.values(*findField("speed"))[40], 0.0);
  simulation.step();
  simulation.capture(snapshot);
  fields.take(snapshot);
  EXPECT_GT(fields.values(*findField("speed"))[40], 0.0);
  EXPECT_TRUE(fields.values(*findField("stress")).empty());
  simulation.apply(session::SetSettingCommand{"solver", std::string("auto")});
  simulation.apply(session::SetSettingCommand{"material.model", std::string("fabric")});
  simulation.capture(snapshot);
  fields.take(snapshot);
  EXPECT_FALSE(fields.values(*findField("stress")).empty());
}

TEST(SnapshotFields, OfTheGhostAreItsDistances) {
  const session::Snapshot snapshot = snapshotAfter(20, {"ghost.solver=newton"});
  SnapshotFields fields;
  fields.take(snapshot);
  const auto values = fields.values(*findField("ghost_error"));
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  EXPECT_NEAR(sum / static_cast<double>(values.size()), 1e3 * snapshot.ghost->meanDistance, 1e-9);
}

TEST(Snapshot, HasVelocitiesOnlyWhileSomethingNeedsThem) {
  EXPECT_TRUE(snapshotAfter(2, {}, false).velocities.empty());
  EXPECT_TRUE(snapshotAfter(2, {}, false).contactImpulses.empty());
  EXPECT_FALSE(snapshotAfter(2, {}, true).velocities.empty());
  EXPECT_FALSE(snapshotAfter(2, {"view.colour_map=speed"}, false).velocities.empty());
}

TEST(ShownField, IsOffByDefaultAndComputesNothing) {
  SnapshotFields fields;
  FieldDisplay display;
  const ShownField& shown = display.update(snapshotAfter(1, {}), fields);
  EXPECT_EQ(shown.field, nullptr);
  EXPECT_FALSE(shown.isShown());
}

TEST(ShownField, TakesTheFixedRange) {
  SnapshotFields fields;
  FieldDisplay display;
  const auto snapshot = snapshotAfter(1, {"view.colour_map=strain_warp", "view.colour_low=95", "view.colour_high=130"});
  const ShownField& shown = display.update(snapshot, fields);
  EXPECT_EQ(shown.range, (ColourRange{95.0, 130.0}));
  EXPECT_EQ(shown.note, "");
}

TEST(ShownField, SaysThatAnEmptyRangeIsNotUsed) {
  SnapshotFields fields;
  FieldDisplay display;
  const auto snapshot = snapshotAfter(1, {"view.colour_map=strain_warp", "view.colour_low=130", "view.colour_high=95"});
  const ShownField& shown = display.update(snapshot, fields);
  EXPECT_NE(shown.note, "");
  EXPECT_LT(shown.range.low, shown.range.high);
}

TEST(ShownField, KeepsTheLookOfTheClothWhereTheQuantityDoesNotExist) {
  SnapshotFields fields;
  FieldDisplay display;
  const auto snapshot = snapshotAfter(1, {"view.colour_map=stress"});
  const ShownField& shown = display.update(snapshot, fields);
  EXPECT_FALSE(shown.isShown());
  EXPECT_NE(shown.problem, "");
}

TEST(Probes, HaveAColumnForEachFieldOfEachVertex) {
  const auto snapshot = snapshotAfter(2, {});
  SnapshotFields fields;
  fields.take(snapshot);
  const std::vector vertices{3, 40};
  const std::string titles = probeTitles(vertices);
  const std::string line = probeLine(snapshot.time, probe(fields, vertices));
  EXPECT_EQ(std::ranges::count(titles, ','), static_cast<long>(2 * fieldTable().size()));
  EXPECT_EQ(std::ranges::count(line, ','), static_cast<long>(2 * fieldTable().size()));
  EXPECT_NE(titles.find("vertex 40 strain_warp [%]"), std::string::npos) << titles;
  EXPECT_TRUE(line.ends_with('\n'));
  EXPECT_NE(line.find(",,"), std::string::npos) << "springs have no stress: " << line;
}

}  // namespace
}  // namespace drape::fields

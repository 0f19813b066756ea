#include "app/dressing/dressing_job.hpp"
#include "intersection/intersections.hpp"
#include "shapes.hpp"
#include "sim/model/bounds.hpp"

#include <gtest/gtest.h>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

namespace drape::app {
namespace {

using dressing::testing::ellipsoid;
using dressing::testing::mannequin;
using dressing::testing::modelOf;
using dressing::testing::shifted;
using dressing::testing::tshirt;
using dressing::testing::tube;

/// Dresses in the coordinates of the meshes.
DressingOrder orderOf(const sim::ClothMesh& garment, const sim::ClothMesh& body) {
  DressingOrder order;
  order.names = {text::Sentence::verbatim("tube"), "egg"};
  order.model = modelOf(garment);
  order.attempts = {{garment.positions, body, dressing::PlacementRule::File, true}};
  order.options.step.material.stiffness = 150.0;
  return order;
}

DressingJob::Outcome outcomeOf(DressingJob& job) {
  for (;;) {
    if (auto outcome = job.poll()) {
      return *std::move(outcome);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

std::size_t pairsOf(const std::vector<Vec3>& positions, const sim::ClothMesh& garment, const sim::ClothMesh& body) {
  return intersection::intersectingPairs({positions, garment.triangles}, {body.positions, body.triangles}).size();
}

TEST(DressingJob, endsWithAGarmentThatNoBodyPassesThrough) {
  const sim::ClothMesh body = ellipsoid({0.2, 0.5, 0.2});
  const sim::ClothMesh garment = tube(0.19, 0.4);
  ASSERT_GT(pairsOf(garment.positions, garment, body), 0U);
  DressingJob job(orderOf(garment, body));
  const DressingJob::Outcome outcome = outcomeOf(job);
  EXPECT_FALSE(outcome.hasFailed) << outcome.message;
  ASSERT_TRUE(outcome.placed);
  EXPECT_TRUE(outcome.placed->isStart);
  EXPECT_EQ(pairsOf(outcome.placed->positions, garment, body), 0U);
  EXPECT_NE(outcome.message.english().find("Dressed tube on egg"), std::string::npos) << outcome.message;
  EXPECT_FALSE(job.poll()) << "an outcome is told once";
}

TEST(DressingJob, releasesPins) {
  const sim::ClothMesh body = ellipsoid({0.2, 0.5, 0.2});
  const sim::ClothMesh garment = tube(0.19, 0.4);
  DressingOrder order = orderOf(garment, body);
  order.model = sim::withPins(*order.model, std::vector<bool>(garment.positions.size(), true));
  DressingJob job(std::move(order));
  const DressingJob::Outcome outcome = outcomeOf(job);
  ASSERT_TRUE(outcome.placed) << outcome.message;
  EXPECT_EQ(pairsOf(outcome.placed->positions, garment, body), 0U);
}

TEST(DressingJob, triesTheNextWayWhereOneFails) {
  // Raised by 0.3 m the arms pass through the walls even as lines. The landmarks put the T-shirt back.
  const sim::ClothMesh garment = shifted(tshirt(), {0.0, 0.3, 0.0});
  DressingOrder order = orderOf(garment, mannequin());
  order.attempts.front().isStart = false;
  order.attempts.push_back({garment.positions, mannequin(), dressing::PlacementRule::Auto, true});
  DressingJob job(std::move(order));
  const DressingJob::Outcome outcome = outcomeOf(job);
  EXPECT_FALSE(outcome.hasFailed) << outcome.message;
  ASSERT_TRUE(outcome.placed);
  EXPECT_TRUE(outcome.placed->isStart) << "the second way";
  EXPECT_EQ(pairsOf(outcome.placed->positions, garment, mannequin()), 0U);
}

TEST(DressingJob, saysWhyAGarmentCannotBeWornAndMovesNothing) {
  const sim::ClothMesh garment = shifted(tshirt(), {0.0, 0.3, 0.0});
  DressingJob job(orderOf(garment, mannequin()));
  const DressingJob::Outcome outcome = outcomeOf(job);
  EXPECT_TRUE(outcome.hasFailed);
  EXPECT_FALSE(outcome.placed);
  EXPECT_NE(outcome.message.english().find("the right arm passes through the sleeve's wall"), std::string::npos)
      << outcome.message;
}

TEST(DressingJob, saysWhatIsWrongWithABody) {
  sim::ClothMesh open = ellipsoid({0.2, 0.5, 0.2});
  std::erase_if(open.triangles, [&](const Triangle& t) { return open.positions[t[0]].y() > 0.0; });
  DressingJob job(orderOf(tube(0.19, 0.4), open));
  const DressingJob::Outcome outcome = outcomeOf(job);
  EXPECT_TRUE(outcome.hasFailed);
  EXPECT_NE(outcome.message.english().find("egg: the body has holes"), std::string::npos) << outcome.message;
}

TEST(DressingJob, isCancelled) {
  DressingJob job(orderOf(shifted(tshirt(), {0.0, -0.03, 0.04}), mannequin()));
  job.cancel();
  const DressingJob::Outcome outcome = outcomeOf(job);
  EXPECT_FALSE(outcome.hasFailed);
  EXPECT_FALSE(outcome.placed);
}

TEST(DressingJob, givesTheBitsOfDressingWithoutAThread) {
  const sim::ClothMesh body = ellipsoid({0.2, 0.5, 0.2});
  const sim::ClothMesh garment = tube(0.19, 0.4);
  DressingOrder order = orderOf(garment, body);
  dressing::DressingOptions options = order.options;
  options.rule = dressing::PlacementRule::File;
  const dressing::Dressed expected = dressing::dress(*order.model, garment.positions, body, options);
  DressingJob job(std::move(order));
  const DressingJob::Outcome outcome = outcomeOf(job);
  ASSERT_TRUE(outcome.placed);
  EXPECT_EQ(outcome.placed->positions, expected.positions);
}

TEST(DressingJob, saysThatItStartedWhereTheUserPlacedIt) {
  DressingOrder order = orderOf(tube(0.19, 0.4), ellipsoid({0.2, 0.5, 0.2}));
  order.attempts.front().isByHand = true;
  DressingJob job(std::move(order));
  const DressingJob::Outcome outcome = outcomeOf(job);
  EXPECT_NE(outcome.message.english().find("from where you placed it; "), std::string::npos) << outcome.message;
}

TEST(DressingJob, onlyPlacesIfTheOrderSaysSo) {
  const sim::ClothMesh garment = shifted(tshirt(), {0.7, 0.4, 0.3});
  DressingOrder order = orderOf(garment, mannequin());
  order.attempts.front().rule = dressing::PlacementRule::Auto;
  order.onlyPlaces = true;
  DressingJob job(std::move(order));
  const DressingJob::Outcome outcome = outcomeOf(job);
  EXPECT_FALSE(outcome.hasFailed) << outcome.message;
  EXPECT_FALSE(outcome.placed) << "nothing is dressed";
  ASSERT_TRUE(outcome.pose);
  const std::vector<Vec3> placed = dressing::moved(garment.positions, *outcome.pose);
  EXPECT_LT((sim::boundsOf(placed).center() - sim::boundsOf(tshirt().positions).center()).norm(), 0.1)
      << "about where the T-shirt is worn";
  EXPECT_NE(outcome.message.english().find("placed by neck, sleeves or waist"), std::string::npos) << outcome.message;
}

TEST(DressingJob, cancelsAPlacement) {
  DressingOrder order = orderOf(shifted(tshirt(), {0.7, 0.4, 0.3}), mannequin());
  order.attempts.front().rule = dressing::PlacementRule::Auto;
  order.onlyPlaces = true;
  DressingJob job(std::move(order));
  job.cancel();
  const DressingJob::Outcome outcome = outcomeOf(job);
  EXPECT_FALSE(outcome.pose);
  EXPECT_EQ(outcome.message, "Placing was cancelled");
}

}  // namespace
}  // namespace drape::app

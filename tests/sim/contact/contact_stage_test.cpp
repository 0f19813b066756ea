#include "sim/contact/contact_stage.hpp"

#include "sim/contact/body_world.hpp"
#include "sim/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace drape {
namespace {

TEST(ContactStage, costsNothingAndChangesNothingWhileNothingIsOn) {
  const auto model = testing::pinnedSheet(5);
  ClothState state = testing::shaken(*model, 0.05, 1);
  const std::uint64_t before = stateHash(state);
  StepInputs inputs;
  const std::vector<BodyStep> none;
  inputs.bodies = &none;
  ContactStage stage;
  stage.begin({}, inputs, state);
  const ContactReport report = stage.resolve(*model, {}, inputs, state);
  EXPECT_EQ(stateHash(state), before);
  EXPECT_EQ(stage.unresolved(), nullptr);
  EXPECT_EQ(report.bodySeconds, 0.0);
  EXPECT_EQ(report.selfSeconds, 0.0);
}

}  // namespace
}  // namespace drape

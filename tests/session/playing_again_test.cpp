#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

/// What is played again from a state of the timeline.
namespace drape::session {
namespace {

struct Case {
  std::string scene;
  std::vector<std::string> settings;
};

void PrintTo(const Case& test, std::ostream* stream) {
  *stream << test.scene;
}

class PlayingAgain : public ::testing::TestWithParam<Case> {};

TEST_P(PlayingAgain, RepeatsTheBitsOfTheFirstTime) {
  std::vector<std::string> settings = GetParam().settings;
  settings.emplace_back("timeline.memory=500");
  Simulation simulation(testing::builtIn(GetParam().scene, settings));
  std::map<std::int64_t, std::uint64_t> hashes;
  const auto take = [&](std::int64_t until) {
    while (simulation.stepIndex() < until) {
      simulation.step();
      const std::uint64_t hash = sim::stateHash(simulation.state());
      const auto [first, isNew] = hashes.emplace(simulation.stepIndex(), hash);
      ASSERT_TRUE(isNew || first->second == hash) << "step " << simulation.stepIndex();
    }
  };
  take(90);
  const double end = simulation.state().time;
  for (const double share : {0.5, 0.1, 0.9, 0.0}) {
    simulation.apply(GoToCommand{share * end});
    ASSERT_EQ(simulation.message(), "");
    EXPECT_TRUE(simulation.paused());
    EXPECT_NEAR(simulation.state().time, share * end, 0.02);
    if (simulation.stepIndex() > 0) {
      EXPECT_EQ(sim::stateHash(simulation.state()), hashes.at(simulation.stepIndex()));
    }
    take(100);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PlayingAgain,
                         ::testing::Values(Case{"grid", {"grid.resolution=9"}},
                                           Case{"grid", {"grid.resolution=9", "solver=newton", "time_step=0.01"}},
                                           Case{"fold", {}}, Case{"turning_sphere", {}},
                                           Case{"skirt", {"material.model=fabric"}}),
                         [](const auto& instance) { return instance.param.scene + std::to_string(instance.index); });

}  // namespace
}  // namespace drape::session

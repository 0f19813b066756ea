#include "sim/simd/thread_team.hpp"

#include "sim/solvers/solver.hpp"
#include "simd/simd_meshes.hpp"
#include "simd/sliced_stepping.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace drape::sim {
namespace {

using testing::oneIterationByTeam;
using testing::pinnedCloth;
using testing::shaken;

/// Waits until all other threads of this process are blocked, which Linux reports as state S; false after ten seconds.
bool waitUntilOthersSleep() {
  namespace fs = std::filesystem;
  const std::string own = std::to_string(gettid());
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (std::chrono::steady_clock::now() < end) {
    const bool asleep =
        std::all_of(fs::directory_iterator("/proc/self/task"), fs::directory_iterator(), [&](const fs::path& thread) {
          std::string stat;
          std::getline(std::ifstream(thread / "stat"), stat);
          // "id (name) state ..."
          return thread.filename() == own || stat.find(") S ") != std::string::npos;
        });
    if (asleep) {
      return true;
    }
    std::this_thread::yield();
  }
  return false;
}

TEST(ThreadTeam, letsEveryMemberWorkOnceInEachOfManyRounds) {
  simd::ThreadTeam team;
  std::vector<int> rounds(4, 0);  // not atomic: each belongs to its member, and a round ends before the next begins
  for (int round = 0; round < 1000; ++round) {
    team.run(4, [&](int member) { ++rounds[member]; });
  }
  EXPECT_EQ(rounds, std::vector<int>(4, 1000));
}

TEST(ThreadTeam, runsItsFirstMemberOnTheCallingThread) {
  simd::ThreadTeam team;
  std::thread::id first;
  std::thread::id second;
  team.run(2, [&](int member) { (member == 0 ? first : second) = std::this_thread::get_id(); });
  EXPECT_EQ(first, std::this_thread::get_id());
  EXPECT_NE(second, first);
}

TEST(ThreadTeam, letsNoThreadPassTheBarrierBeforeAllHaveArrived) {
  for (const int count : {1, 2, 3, 7}) {
    simd::ThreadTeam team;
    std::vector<int> written(count, -1);
    std::atomic<int> mistakes = 0;
    team.run(count, [&](int member) {
      for (int meeting = 0; meeting < 200; ++meeting) {
        written[member] = meeting;
        team.arriveAndWait();
        for (const int other : written) {
          mistakes += other != meeting ? 1 : 0;
        }
        team.arriveAndWait();
      }
    });
    EXPECT_EQ(mistakes, 0) << count << " members";
  }
}

TEST(ThreadTeam, growsAndShrinksBetweenRounds) {
  simd::ThreadTeam team;
  for (int again = 0; again < 5; ++again) {
    for (const int count : {1, 4, 2, 2, 1, 6, 3}) {
      std::atomic<int> present = 0;
      std::atomic<int> met = 0;
      team.run(count, [&](int member) {
        present += 1 << member;
        team.arriveAndWait();
        met += present == (1 << count) - 1 ? 1 : 0;
      });
      EXPECT_EQ(present, (1 << count) - 1);
      EXPECT_EQ(met, count);
    }
  }
}

TEST(ThreadTeam, wakesMembersThatFellAsleepForWorkAndForTheEnd) {
  std::atomic<int> sum = 0;
  {
    simd::ThreadTeam team;
    team.run(3, [&](int) { ++sum; });
    ASSERT_TRUE(waitUntilOthersSleep());
    team.run(3, [&](int) { ++sum; });
    ASSERT_TRUE(waitUntilOthersSleep());
  }
  EXPECT_EQ(sum, 6);
}

TEST(SlicedStepInThreads, hasTheSameBitsWithMoreThreadsThanCores) {
  const auto model = testing::pinnedCloth(testing::renumbered(testing::unevenSheet(17, 3), 4));
  for (const int sweeps : {1, 3}) {
    const auto hashWith = [&](int threads) {
      StepParameters parameters;
      parameters.jacobi.sweeps = sweeps;
      parameters.threads = threads;
      parameters.air.drag = 0.5;
      parameters.air.wind = Vec3(1.0, 0.0, 2.0);
      ClothState state = shaken(*model, 0.002, 3);
      testing::oneIterationByTeam<float>(*model, parameters, 4, state);
      return stateHash(state);
    };
    const auto alone = hashWith(1);
    for (const int threads : {2, 3, 2 * static_cast<int>(std::thread::hardware_concurrency()) + 1}) {
      EXPECT_EQ(hashWith(threads), alone) << threads << " threads, " << sweeps << " sweeps";
    }
  }
}

class SolverInThreads : public ::testing::TestWithParam<const char*> {};

TEST_P(SolverInThreads, hasTheSameBitsWhileAnAttachmentPullsAcrossTheBoundaryOfShares) {
  const bool coloured = std::string(GetParam()) == "xpbd";
  const auto model = testing::pinnedSheet(coloured ? 121 : 57);  // enough for two threads
  StepParameters parameters;
  parameters.iteration.iterations = 2;
  parameters.air.drag = coloured ? 0.5 : 0.0;
  parameters.precision = Precision::Float;
  parameters.timeStep = 1.0 / 1500.0;
  parameters.material.damping = 0.001;
  StepInputs inputs;
  inputs.attachment =
      Attachment{{static_cast<int>(model->triangles.size()) / 2, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {20, 2}};
  const auto hashWith = [&](int threads) {
    parameters.threads = threads;
    ClothState state = shaken(*model, 0.002, 3);
    findSolver(GetParam())->make()->steps(*model, parameters, inputs, 3, state);
    EXPECT_TRUE(isFinite(state));
    return stateHash(state);
  };
  EXPECT_EQ(hashWith(2), hashWith(1));
}

INSTANTIATE_TEST_SUITE_P(Each, SolverInThreads,
                         ::testing::Values("one_iteration", "chebyshev", "verlet", "pcg", "xpbd"),
                         [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
}  // namespace drape::sim

#include "session/command_queue.hpp"

#include <gtest/gtest.h>
#include <chrono>
#include <thread>

namespace drape::session {
namespace {

TEST(CommandQueue, givesCommandsBackInOrderAndOnce) {
  CommandQueue queue;
  queue.post(PauseCommand{true});
  queue.post(ResetCommand{});
  std::vector<Command> taken{Command(SingleStepCommand{})};
  queue.drain(taken);
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<PauseCommand>(taken[0]));
  EXPECT_TRUE(std::holds_alternative<ResetCommand>(taken[1]));
  queue.drain(taken);
  EXPECT_TRUE(taken.empty());
}

TEST(CommandQueue, endsAWaitWhenACommandIsPostedOrItIsWoken) {
  constexpr std::chrono::seconds never{3600};
  CommandQueue queue;
  std::thread poster([&queue] { queue.post(ResetCommand{}); });
  queue.await(never);
  poster.join();
  std::vector<Command> taken;
  queue.drain(taken);
  EXPECT_EQ(taken.size(), 1U);
  std::thread waker([&queue] { queue.wake(); });
  queue.await(never);
  waker.join();
}

TEST(CommandQueue, losesNothingFromSeveralThreadsAndKeepsEachThreadsOrder) {
  constexpr int writers = 3;
  constexpr int each = 2000;
  CommandQueue queue;
  std::vector<std::thread> threads;
  for (int w = 0; w < writers; ++w) {
    threads.emplace_back([&queue, w] {
      for (int i = 0; i < each; ++i) {
        queue.post(MoveAttachmentCommand{Vec3(w, i, 0.0)});
      }
    });
  }
  std::vector<int> next(writers, 0);
  std::vector<Command> taken;
  int received = 0;
  while (received < writers * each) {
    queue.drain(taken);
    for (const Command& command : taken) {
      const Vec3& target = std::get<MoveAttachmentCommand>(command).target;
      EXPECT_EQ(static_cast<int>(target.y()), next[static_cast<std::size_t>(target.x())]++);
      ++received;
    }
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
}

}  // namespace
}  // namespace drape::session

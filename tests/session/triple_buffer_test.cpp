#include "session/triple_buffer.hpp"

#include <gtest/gtest.h>
#include <array>
#include <thread>

namespace drape::session {
namespace {

TEST(TripleBuffer, givesTheNewestValueAndKeepsItUntilANewerOneComes) {
  TripleBuffer<int> buffer;
  buffer.writeSlot() = 1;
  buffer.publish();
  EXPECT_EQ(buffer.latest(), 1);
  EXPECT_EQ(buffer.latest(), 1);
  buffer.writeSlot() = 2;
  buffer.publish();
  buffer.writeSlot() = 3;
  buffer.publish();
  EXPECT_EQ(buffer.latest(), 3);
}

TEST(TripleBuffer, doesNotShowWhatIsNotYetPublished) {
  TripleBuffer<int> buffer;
  buffer.writeSlot() = 1;
  buffer.publish();
  EXPECT_EQ(buffer.latest(), 1);
  buffer.writeSlot() = 2;
  EXPECT_EQ(buffer.latest(), 1);
}

TEST(TripleBuffer, neverTearsAValueOrGoesBackBetweenTwoThreads) {
  struct Value {
    std::array<int, 64> numbers{};
  };
  constexpr int last = 20000;
  TripleBuffer<Value> buffer;
  std::thread writer([&buffer] {
    for (int i = 1; i <= last; ++i) {
      buffer.writeSlot().numbers.fill(i);
      buffer.publish();
    }
  });
  int newest = 0;
  while (newest < last) {
    const Value& value = buffer.latest();
    const int first = value.numbers.front();
    EXPECT_GE(first, newest);
    for (const int number : value.numbers) {
      ASSERT_EQ(number, first);
    }
    newest = first;
  }
  writer.join();
}

}  // namespace
}  // namespace drape::session

#include "ui/input_queue.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace drape::ui {
namespace {

constexpr int letter = 65;
constexpr int enter = 257;
constexpr int backspace = 259;

RawKey down(int key) {
  return {.key = key, .action = RawKey::Action::Down, .edits = key >= enter - 1};
}

RawKey up(int key) {
  return {.key = key, .action = RawKey::Action::Up, .edits = key >= enter - 1};
}

/// The number of events of each frame until the queue is empty.
std::vector<std::size_t> framesOf(std::initializer_list<RawEvent> events) {
  InputQueue queue;
  for (const RawEvent& event : events) {
    queue.push(event);
  }
  std::vector<std::size_t> sizes;
  while (!queue.empty() && sizes.size() < 20) {
    sizes.push_back(queue.takeFrame().size());
  }
  return sizes;
}

using Sizes = std::vector<std::size_t>;

TEST(InputQueue, AKeyThatComesUpAtOnceIsDownForAFrame) {
  EXPECT_EQ(framesOf({down(enter), up(enter)}), (Sizes{1, 1}));
}

TEST(InputQueue, TextAndTheReturnAfterItFitIntoOneFrame) {
  EXPECT_EQ(framesOf({RawCharacter{'1'}, RawCharacter{'5'}, down(enter)}), (Sizes{3}));
}

TEST(InputQueue, TextAfterAnEditingKeyComesAFrameLater) {
  EXPECT_EQ(framesOf({down(backspace), RawCharacter{'5'}}), (Sizes{1, 1}));
}

TEST(InputQueue, EveryPressOfAnEditingKeyHasItsOwnFrame) {
  EXPECT_EQ(framesOf({down(backspace), up(backspace), down(backspace), up(backspace), down(enter)}),
            (Sizes{1, 1, 1, 2}));
}

TEST(InputQueue, LettersThatAreTypedFastComeTogether) {
  EXPECT_EQ(framesOf({down(letter), RawCharacter{'a'}, down(letter + 1), RawCharacter{'b'}}), (Sizes{4}));
}

TEST(InputQueue, AClickIsDownForAFrameWhereItWasMade) {
  EXPECT_EQ(framesOf({RawMove{1.0, 1.0}, RawButton{.button = 0, .down = true}, RawMove{9.0, 9.0},
                      RawButton{.button = 0, .down = false}}),
            (Sizes{2, 2}));
}

TEST(InputQueue, AModifierIsStillDownWhenItsClickIsSeen) {
  EXPECT_EQ(framesOf({down(enter), RawButton{.button = 0, .down = true}, up(enter)}), (Sizes{2, 1}));
  EXPECT_EQ(framesOf({up(enter), RawButton{.button = 0, .down = true}}), (Sizes{1, 1})) << "and one that came up is up";
}

TEST(InputQueue, AnEmptyFrameTakesNothing) {
  InputQueue queue;
  EXPECT_TRUE(queue.takeFrame().empty());
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace drape::ui

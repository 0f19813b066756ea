#include "ui/input_queue.hpp"

#include <set>

namespace drape::ui {
namespace {

/// The events of a frame so far, and whether another event still fits into it.
class FrameOfInput {
 public:
  bool takes(const RawMove& /*move*/) const { return buttons_.empty(); }

  bool takes(const RawButton& button) {
    return !keyReleased_ && buttons_.insert(button.button).second;  // a released modifier was down for the click
  }

  bool takes(const RawScroll& /*scroll*/) const { return buttons_.empty(); }

  bool takes(const RawKey& key) {
    if (key.action == RawKey::Action::Repeat) {
      return buttons_.empty();
    }
    const bool presses = key.action == RawKey::Action::Down;
    const bool fits = buttons_.empty() && !(key.edits && presses && edited_) && keys_.insert(key.key).second;
    edited_ = edited_ || (fits && key.edits && presses);
    keyReleased_ = keyReleased_ || !presses;
    return fits;
  }

  bool takes(const RawCharacter& /*character*/) const { return !edited_ && buttons_.empty(); }

  bool takes(const RawFocus& /*focus*/) const { return keys_.empty() && buttons_.empty(); }

 private:
  std::set<int> keys_;     // that changed
  std::set<int> buttons_;  // that changed
  bool edited_ = false;    // whether an editing key was pressed
  bool keyReleased_ = false;
};

}  // namespace

std::vector<RawEvent> InputQueue::takeFrame() {
  std::vector<RawEvent> events;
  FrameOfInput frame;
  while (!waiting_.empty() && std::visit([&](const auto& event) { return frame.takes(event); }, waiting_.front())) {
    events.push_back(waiting_.front());
    waiting_.pop_front();
  }
  return events;
}

}  // namespace drape::ui

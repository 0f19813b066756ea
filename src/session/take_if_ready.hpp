#pragma once

#include <chrono>
#include <future>
#include <optional>

namespace drape::session {

/// The result of a task in the background once it has ended; only once. Never waits. Throws what the task threw.
template <typename Result>
[[nodiscard]] std::optional<Result> takeIfReady(std::future<Result>& task) {
  if (!task.valid() || task.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return std::nullopt;
  }
  return task.get();
}

}  // namespace drape::session

#pragma once

#include <exception>
#include <functional>
#include <stop_token>
#include <string_view>

namespace drape::io {

/// Thrown when the user cancels. It is not an error and is not reported.
class Cancelled : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// Progress and cancellation of a long task. The working thread makes the calls.
struct ImportWatch {
  std::function<void(double share, std::string_view stage)> progress;  ///< share from 0 to 1; may be empty
  std::stop_token stop;                                                ///< a request to stop cancels

  /// Reports progress. Throws Cancelled after a request to stop.
  void tell(double share, std::string_view stage) const {
    if (stop.stop_requested()) {
      throw Cancelled();
    }
    if (progress) {
      progress(share, stage);
    }
  }

  /// The watch for a part of the task: its 0 to 1 is `begin` to `end` of the whole.
  [[nodiscard]] ImportWatch part(double begin, double end) const {
    if (!progress) {
      return {{}, stop};
    }
    return {[whole = progress, begin, end](double share, std::string_view stage) {
              whole(begin + share * (end - begin), stage);
            },
            stop};
  }
};

}  // namespace drape::io

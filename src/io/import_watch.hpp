#pragma once

#include <exception>
#include <functional>
#include <stop_token>
#include <string_view>

namespace drape {

/// Thrown when the user cancels. Not an error: there is nothing to report.
class Cancelled : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// What a long piece of work tells about its progress, and how it is cancelled. Calls come from the thread that works.
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

  /// A watch over a part of the work: its 0 to 1 is `begin` to `end` here.
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

}  // namespace drape

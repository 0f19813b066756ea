#pragma once

#include <cstdint>
#include <string>

namespace drape {

/// A progress bar on standard error when that is a terminal; silent otherwise.
class ProgressBar {
 public:
  ProgressBar(std::string label, std::int64_t total);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  void show(std::int64_t done);

 private:
  std::string label_;
  std::int64_t total_;
  bool terminal_;
  int shownPercent_ = -1;
};

}  // namespace drape

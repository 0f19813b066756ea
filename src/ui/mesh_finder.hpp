#pragma once

#include "ui/found_file.hpp"

#include <future>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace drape::ui {

/// Reads mesh files in the background, one after another, to tell what they contain. Destruction cancels the reading
/// and waits for its end, which takes a fraction of a second.
class MeshFinder {
 public:
  MeshFinder() = default;
  MeshFinder(const MeshFinder&) = delete;
  MeshFinder& operator=(const MeshFinder&) = delete;
  ~MeshFinder();

  /// Reads these files instead of those before. What is known about a file of the same name is read again.
  void find(const std::vector<std::string>& files);
  /// Cancels the reading.
  void forget();

  /// Takes what was read since the last call, and goes on with the next file. Never waits.
  void follow();

  /// One for each file, in the given order.
  [[nodiscard]] std::span<const FoundFile> found() const { return found_; }
  [[nodiscard]] bool isReading() const { return running_.valid() || next_ < found_.size(); }

 private:
  std::vector<FoundFile> found_;
  std::size_t next_ = 0;      // the file that is read next
  bool isCancelled_ = false;  // whether the running one is
  std::stop_source stop_;
  std::future<FoundFile> running_;  // last, since its destructor waits while the other members still exist
};

}  // namespace drape::ui

#pragma once

#include "sim/model/vector.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace drape::app {

/// The folder of an unfinished bake: a checkpoint, the positions of all frames up to it, and their pictures. All
/// functions throw InputError.
class BakeFolder {
 public:
  /// Makes the folder if it does not exist.
  /// @param vertices of the cloth  @param pictures how pictures are drawn; it must be the same when a bake continues
  BakeFolder(std::filesystem::path folder, std::size_t vertices, const std::string& pictures);

  [[nodiscard]] std::string checkpoint() const { return (folder_ / "checkpoint").string(); }
  [[nodiscard]] bool hasCheckpoint() const { return std::filesystem::exists(checkpoint()); }
  [[nodiscard]] std::filesystem::path picture(std::int64_t frame) const;

  /// Keeps that number of frames and removes later ones.
  void keep(std::int64_t frames);
  /// Adds the positions of the next frame [m].
  void append(const std::vector<Vec3>& positions);
  /// Waits until everything is on the disk.
  void synchronise();
  [[nodiscard]] std::vector<Vec3> positions(std::int64_t frame);

  /// Removes the folder after a finished bake.
  void remove();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void require(bool success, const char* what) const;

  std::filesystem::path folder_;
  std::size_t vertices_;
  std::unique_ptr<std::FILE, Closer> positions_;
};

}  // namespace drape::app

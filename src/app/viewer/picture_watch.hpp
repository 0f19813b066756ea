#pragma once

#include "render/camera.hpp"
#include "session/snapshot.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace drape::app {

/// Everything that decides how the scene looks in the window.
struct ScenePicture {
  std::shared_ptr<const scene::Scene> scene;
  std::int64_t version = -1;  ///< Snapshot::pictureVersion
  scene::CameraPose camera;
  double width = 0.0;  ///< of the view [pixels]
  double height = 0.0;
  std::vector<int> picked;  ///< marked vertices

  bool operator==(const ScenePicture&) const = default;
};

/// Tells which parts of the window must be drawn again, so that a window in which nothing changes costs no drawing.
class PictureWatch {
 public:
  struct Parts {
    bool scene = true;   ///< the scene has changed
    bool window = true;  ///< the scene or the panels have changed
  };

  /// The parts that have changed since the last call.
  /// @param panels UserInterface::fingerprint
  [[nodiscard]] Parts changed(ScenePicture scene, std::uint64_t panels);

  /// Everything must be drawn again: the window was covered, or the renderer has drawn something else.
  void forget();

 private:
  ScenePicture scene_;
  std::uint64_t panels_ = 0;  // 0: nothing is drawn yet
};

}  // namespace drape::app

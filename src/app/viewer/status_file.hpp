#pragma once

#include "session/snapshot.hpp"
#include "ui/interaction_controller.hpp"
#include "ui/user_interface.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace drape {

/// What the status file tells about one frame.
struct ViewerStatus {
  const Snapshot& snapshot;
  const Camera& camera;
  const UserInterface& panels;
  UiDisplay display;
  UiStats stats;
  std::int64_t frame = 0;
  double firstFrameSeconds = 0.0;  ///< from the start of the program until the first frame was shown [s]
};

/// The state query for scripts and tests: about every 50 ms it replaces a file by the viewer's state as JSON, in one
/// piece, so that a reader never sees half of it. Settings, pins and the hand are the simulation's own, as the last
/// snapshot has them.
class StatusFile {
 public:
  /// An empty path: nothing is ever written.
  explicit StatusFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// Writes when it is due. Throws InputError when the file cannot be written.
  void update(const ViewerStatus& status);

  /// What stands in the file, for --help.
  static constexpr const char* help =
      "With --status FILE the viewer replaces FILE about every 50 ms by a JSON object for scripts:\n"
      "  sequence, frame          counters of writes and of drawn frames\n"
      "  first_frame_seconds      from the start of the program until its first frame was shown [s]\n"
      "  scene, vertices, pins    what runs, and how many vertices are pinned\n"
      "  paused, step, time       the clock [s]\n"
      "  settings                 all settings in force, by key\n"
      "  energy, max_stretch      [J], [-]\n"
      "  grab                     null, or triangle, target [m], point [m], distance [m], pinned\n"
      "  ghost                    null, or distance [m] (mean) and step_seconds [s]\n"
      "  bodies                   name, on, position [m], shift [m] by hand, x and y of its middle in the window\n"
      "  contacts                 with bodies and itself, and drawn (view.contacts), in the last step\n"
      "  warning                  what is wrong with the solver on this cloth, or empty\n"
      "  camera                   position [m], focal_point [m], view_angle [degrees]\n"
      "  window, view             sizes and the picture's place, in window coordinates\n"
      "  panels, help             whether they are shown\n"
      "  widgets, buttons         rectangles by setting key or name, in window coordinates\n"
      "  cloth_points             places in the window where the cloth can be clicked\n"
      "  free_point               a place in the picture beside the cloth, or null\n"
      "  loading, message         what is being opened, and the last message\n"
      "  loading_share            how much of it is done, 0 to 1; negative: not known\n"
      "  status                   what the status line says";

 private:
  std::filesystem::path file_;
  std::int64_t sequence_ = 0;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace drape

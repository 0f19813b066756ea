#pragma once

#include "session/snapshot.hpp"
#include "ui/interaction_controller.hpp"
#include "ui/user_interface.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>

namespace drape::app {

/// The contents of the status file for one frame.
struct ViewerStatus {
  const session::Snapshot& snapshot;
  const render::Camera& camera;
  const ui::UserInterface& panels;
  const ui::UiDisplay& display;
  const ui::UiStats& stats;
  std::int64_t frame = 0;
  std::int64_t picture = 0;        ///< number of frames that were drawn
  double firstFrameSeconds = 0.0;  ///< from the start of the program to the first frame on screen [s]
};

/// The viewer's state for scripts and tests: about every 50 ms it replaces a file by the state as JSON. The replacement
/// is atomic, so a reader never sees half a file. Settings, pins and attachment come from the last snapshot.
class StatusFile {
 public:
  /// An empty path writes nothing.
  explicit StatusFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// Call it right before a frame takes its input.
  void noteInput();

  /// Writes when it is due. Throws InputError when the file cannot be written.
  void update(const ViewerStatus& status);

  /// The contents of the file, for --help.
  static constexpr const char* help =
      "With --status FILE the viewer replaces FILE about every 50 ms by a JSON object for scripts:\n"
      "  sequence, frame, picture counters of writes, of frames, and of frames that were drawn because they differ\n"
      "  input_seconds            all input before this time of CLOCK_MONOTONIC [s] was taken by an earlier frame\n"
      "  first_frame_seconds      from the start of the program to its first frame on screen [s]\n"
      "  scene, vertices, pins    name, number of vertices, number of pins\n"
      "  paused, step, time       the clock [s]\n"
      "  settings                 all settings, by key\n"
      "  energy, max_stretch      [J], [-]\n"
      "  attachment               null, or triangle, target [m], point [m], distance [m], pinned\n"
      "  ghost                    null, or distance [m] (mean) and step_seconds [s]\n"
      "  bodies                   name, on, position [m], shift [m] by the mouse, figure and clip that move it (or "
      "null),\n"
      "                           x and y of its centre in the window\n"
      "  contacts                 with bodies, with itself, and drawn (view.contacts), in the last step\n"
      "  warning                  when the solver does not suit this cloth; otherwise empty\n"
      "  camera                   position [m], focal_point [m], view_angle [degrees]\n"
      "  window, view             sizes and the position of the picture, in window coordinates\n"
      "  panels, help             whether they are visible\n"
      "  theme                    dark or light\n"
      "  language                 name of the language of the panels, such as en\n"
      "  widgets, buttons         rectangles by setting key or name, in window coordinates\n"
      "  cloth_points             places in the window where the cloth can be clicked\n"
      "  free_point               a place in the picture without cloth, or null\n"
      "  placed                   whether the scene starts where the cloth was dressed\n"
      "  dressing                 null, or what dressing does in words and its share, 0 to 1\n"
      "  piercing                 null, or which body passes through the cloth in words, and pairs of triangles\n"
      "  loading, message         the file that is being opened, and the last message\n"
      "  loading_share            progress, 0 to 1; negative: unknown\n"
      "  status                   the text of the status line";

 private:
  std::filesystem::path file_;
  std::int64_t sequence_ = 0;
  std::chrono::steady_clock::time_point lastInput_;    ///< taken by this frame
  std::chrono::steady_clock::time_point inputBefore_;  ///< taken by the frame before
  std::chrono::steady_clock::time_point next_;
};

}  // namespace drape::app

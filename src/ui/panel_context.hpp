#pragma once

#include "session/snapshot.hpp"
#include "ui/measure_history.hpp"
#include "ui/pending_settings.hpp"
#include "ui/theme.hpp"
#include "ui/ui_output.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace drape::ui {

/// The last values of a measure, for a plot.
class History {
 public:
  void add(float value) {
    values_[next_] = value;
    next_ = (next_ + 1) % capacity;
    count_ = count_ < capacity ? count_ + 1 : capacity;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// 0 is the oldest.
  [[nodiscard]] float at(std::size_t i) const { return values_[(next_ + capacity - count_ + i) % capacity]; }

  static constexpr std::size_t capacity = 240;

 private:
  std::array<float, capacity> values_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

/// A number that is being typed into a slider.
struct TypedText {
  std::string key;  ///< of the setting; empty while nothing is typed
  std::string text;
  int frames = 0;  ///< since the typing began
};

/// The state of the panels that persists between frames.
struct PanelMemory {
  PendingSettings pending;
  TypedText typed;
  std::optional<bool> openSections;  ///< open or close all sections in the next frame
  History stepTimes;                 ///< [ms]
  MeasureHistory measures;
  std::map<std::string, float> textHeights;  ///< of texts that appear and disappear
  std::int64_t lastStep = -1;                ///< the step of the history's last entry
  std::set<std::string> accepted;            ///< lines of the notice that the user answered
  std::string openSurface;                   ///< the body whose surface is visible
  std::string openPath;                      ///< the text of the open field
  std::string fabricName;                    ///< the text of the field that names a fabric
  std::vector<scene::SceneInfo> scenes;      ///< the built-in ones
  std::string hoveredRow;                    ///< the row whose explanation will appear
  double hoveredSince = 0.0;                 ///< [s]
  bool hoveredThisFrame = false;
  bool hasDragged = false;  ///< whether the user has ever dragged the cloth
  std::string status;       ///< the full text of the status line
};

/// The data of a panel while it is drawn.
struct PanelContext {
  const session::Snapshot& snapshot;
  const settings::Settings& settings;       ///< the current values, with the user's latest changes
  const settings::Settings& sceneSettings;  ///< the values of the scene, which a right click restores
  const UiStats& stats;
  const UiFonts& fonts;
  float scale;  ///< of all lengths
  PanelMemory& memory;
  UiRects& widgets;  ///< receives the rectangles of the settings, by key
  UiRects& buttons;  ///< receives all other clickable rectangles
  UiOutput& output;
};

}  // namespace drape::ui

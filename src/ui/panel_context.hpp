#pragma once

#include "session/snapshot.hpp"
#include "ui/measure_history.hpp"
#include "ui/pending_settings.hpp"
#include "ui/theme.hpp"
#include "ui/ui_output.hpp"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// The last values of a measure, for a plot.
class History {
 public:
  void add(float value) {
    values_[static_cast<std::size_t>(next_)] = value;
    next_ = (next_ + 1) % capacity;
    count_ = count_ < capacity ? count_ + 1 : capacity;
  }
  [[nodiscard]] int count() const { return count_; }
  /// 0 is the oldest.
  [[nodiscard]] float at(int i) const {
    return values_[static_cast<std::size_t>((next_ - count_ + i + capacity) % capacity)];
  }

  static constexpr int capacity = 240;

 private:
  std::array<float, capacity> values_{};
  int next_ = 0;
  int count_ = 0;
};

/// A number that is being typed into a slider.
struct TypedText {
  std::string key;  ///< of the setting; empty while nothing is typed
  std::string text;
  int frames = 0;  ///< since it began
};

/// What the panels remember from one frame to the next.
struct PanelMemory {
  PendingSettings pending;
  TypedText typed;
  std::optional<bool> openSections;  ///< all of them, in the frame to come
  History stepTimes;                 ///< [ms]
  MeasureHistory measures;
  std::map<std::string, float> textHeights;  ///< of the texts that come and go
  std::int64_t lastStep = -1;                ///< the step that the history's last entry belongs to
  std::set<std::string> accepted;            ///< lines of the notice that the user has answered
  std::string openSurface;                   ///< the body whose surface is shown
  std::string openPath;                      ///< what is typed in the open field
  std::vector<SceneInfo> scenes;             ///< the built-in ones
  std::string hoveredRow;                    ///< whose explanation is about to be shown
  double hoveredSince = 0.0;                 ///< [s]
  bool hoveredThisFrame = false;
  bool hasDragged = false;  ///< the cloth, ever
  std::string status;       ///< what the status line says, in full
};

/// What a panel sees while it is being drawn.
struct PanelContext {
  const Snapshot& snapshot;
  const Settings& settings;  ///< in force, with the user's latest changes on top
  const Settings& scene;     ///< what the scene itself says: what a right click restores
  const UiStats& stats;
  const UiFonts& fonts;
  float scale;  ///< of all lengths
  PanelMemory& memory;
  UiRects& widgets;  ///< filled with the settings' rectangles, by key
  UiRects& buttons;  ///< filled with all other rectangles that can be clicked
  UiOutput& output;
};

}  // namespace drape

#pragma once

#include "session/snapshot.hpp"
#include "text/catalogue.hpp"
#include "ui/measure_history.hpp"
#include "ui/pending_settings.hpp"
#include "ui/picked_vertices.hpp"
#include "ui/theme.hpp"
#include "ui/ui_output.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
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

/// A row that the search shows: its section opens, it scrolls into sight, and it is marked for a moment.
struct RevealedRow {
  std::string key;         ///< of the setting, or "scene.path"; empty: none
  double since = 0.0;      ///< [s]
  bool isPending = false;  ///< whether it has not scrolled into sight yet
};

/// What the user chose for a figure, until the simulation has it.
struct PendingFigure {
  std::shared_ptr<const scene::Scene> scene;
  std::size_t body = 0;  ///< index into the scene's bodies
  figure::FigureOptions figure;
  double since = 0.0;  ///< [s]
};

/// What the user chose for the keyframes of pins, until the simulation has it.
struct PendingKeyframes {
  std::shared_ptr<const scene::Scene> scene;
  std::vector<int> pins;
  sim::contact::BodyMotion motion;
  double since = 0.0;  ///< [s]
};

/// The state of the panels that persists between frames.
struct PanelMemory {
  PendingSettings pending;
  std::optional<PendingFigure> pendingFigure;
  std::optional<PendingKeyframes> pendingKeyframes;
  std::size_t chosenKey = 0;               ///< of the keyframes of the selected pins
  double bandLength = 0.8;                 ///< of the next elastic band [-]
  std::optional<std::size_t> hoveredSeam;  ///< whose row is under the mouse
  TypedText typed;
  text::Sentence typedNote;              ///< about the keyframe number that is being typed, for the end of the typing
  std::optional<bool> openSections;      ///< open or close all sections in the next frame
  std::map<std::string, bool> sections;  ///< by title, whether the user opened or closed them
  RevealedRow revealed;
  History stepTimes;  ///< [ms]
  MeasureHistory measures;
  std::map<std::string, float> textHeights;  ///< of texts that appear and disappear
  std::int64_t lastStep = -1;                ///< the step of the history's last entry
  std::set<std::string> accepted;            ///< lines of the notice that the user answered
  std::string openSurface;                   ///< the body whose surface is visible
  std::string openPath;                      ///< the text of the open field
  std::string savePath;                      ///< the text of the field that saves the cloth
  std::string scenePath;                     ///< the text of the field that saves the scene
  ExportRequest exported;                    ///< the choices for an export
  std::string fabricName;                    ///< the text of the field that names a fabric
  std::vector<scene::SceneInfo> scenes;      ///< the built-in ones
  std::string hoveredRow;                    ///< the row whose explanation will appear
  double hoveredSince = 0.0;                 ///< [s]
  bool hoveredThisFrame = false;
  PickedVertices picked;
  std::optional<double> scrubbed;  ///< time to which the timeline was dragged last [s]
  bool plotsPicked = false;        ///< whether the values of picked vertices are plotted
  std::size_t plottedField = 0;    ///< of the picked vertices; an index into fieldTable()
  UiRect modeBoxView;              ///< the picture in which the box of a mode is [window units]
  UiRect modeBoxSize;              ///< width and height of that box [window units]
  bool hasDragged = false;         ///< whether the user has ever dragged the cloth
  std::string status;              ///< the full text of the status line
};

/// The data of a panel while it is drawn.
struct PanelContext {
  const session::Snapshot& snapshot;
  const settings::Settings& settings;       ///< the current values, with the user's latest changes
  const settings::Settings& sceneSettings;  ///< the values of the scene, which a right click restores
  const UiStats& stats;
  const UiFonts& fonts;
  const text::Catalogue& texts;  ///< translates what is drawn
  const std::string& language;   ///< the name of its language
  float scale;                   ///< of all lengths
  Theme theme;
  PanelMemory& memory;
  UiRects& widgets;  ///< receives the rectangles of the settings, by key
  UiRects& buttons;  ///< receives all other clickable rectangles
  UiRects& labels;   ///< receives the rectangles of the labels of rows, by their text
  UiOutput& output;
};

}  // namespace drape::ui

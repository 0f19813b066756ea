#pragma once

#include "ui/panel_context.hpp"
#include "ui/search.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace drape::ui {

/// The search over settings, commands and scenes: a box over the picture with a text field and the entries that fit.
/// The arrows choose one, Return or a click takes it.
class CommandPalette {
 public:
  void open(std::vector<SearchEntry> entries);
  void close() { isOpen_ = false; }
  [[nodiscard]] bool isOpen() const { return isOpen_; }

  /// Draws the box. Commands and scenes become requests. A setting is shown in the panel: its key goes to
  /// PanelMemory::revealed.
  void draw(PanelContext& context, const UiRect& view);

 private:
  void find(const PanelContext& context);
  void editText(const PanelContext& context, float width);
  [[nodiscard]] bool readKeys();
  void drawRows(PanelContext& context, float width, int rows);
  bool drawRow(PanelContext& context, const SearchEntry& entry, std::size_t row, float width);
  void take(PanelContext& context, const SearchEntry& entry);

  bool isOpen_ = false;
  bool hadFocus_ = false;  // whether the text field was active in the last frame
  std::string text_;
  std::string searched_;  // the text of found_
  bool isStale_ = false;  // whether found_ belongs to other entries
  bool scrollsUp_ = false;
  std::vector<SearchEntry> entries_;
  std::vector<std::size_t> found_;  // indices into entries_
  std::size_t chosen_ = 0;          // index into found_
  bool follows_ = false;            // whether the chosen row scrolls into sight
  std::optional<std::size_t> clicked_;
};

}  // namespace drape::ui

#pragma once

#include "session/snapshot.hpp"
#include "sim/model/vector.hpp"
#include "ui/ui_output.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace drape::ui {

/// The vertices of the cloth that the user selected, to pin or release them. A left drag selects those in a rectangle,
/// a click the nearest one, or the border nearest to it.
class VertexSelection {
 public:
  /// How a selection changes the one before.
  enum class Change { Replace, Add, Remove };

  /// From a point of the scene to its place in the window.
  using Projection = std::function<Vec2(const Vec3&)>;

  [[nodiscard]] SelectionMode mode() const { return mode_; }
  void use(SelectionMode mode) { mode_ = mode; }
  void clear() { selected_.clear(); }

  /// Starts a drag or a click. @param at in the window
  void press(const Vec2& at, Change change);
  void drag(const Vec2& at);
  /// Selects what the drag or the click means.
  void release(const session::Snapshot& snapshot, const Projection& toWindow);
  void cancelDrag() { start_.reset(); }

  /// Forgets the vertices of another mesh.
  void follow(const session::Snapshot& snapshot);

  /// Sorted.
  [[nodiscard]] const std::vector<int>& vertices() const { return selected_; }
  [[nodiscard]] bool isActive() const { return mode_ != SelectionMode::Off || !selected_.empty(); }

  /// For the window.
  [[nodiscard]] SelectionView view(const session::Snapshot& snapshot, const Projection& toWindow) const;

 private:
  [[nodiscard]] UiRect rectangle() const;

  SelectionMode mode_ = SelectionMode::Off;
  Change change_ = Change::Replace;
  std::optional<Vec2> start_;  // of the drag
  Vec2 end_ = Vec2::Zero();
  std::vector<int> selected_;
  std::weak_ptr<const scene::Scene> scene_;
};

/// The border nearest to a place in the window: the vertices that edges of one triangle connect with the nearest of
/// their kind. Sorted; empty for a closed mesh.
[[nodiscard]] std::vector<int> borderNear(const Vec2& place, const session::Snapshot& snapshot,
                                          const VertexSelection::Projection& toWindow);

/// The pins of a snapshot with these vertices pinned or released. @param vertices sorted
[[nodiscard]] session::SetPinsCommand pinsWith(const session::Snapshot& snapshot, std::span<const int> vertices,
                                               bool pinned);

}  // namespace drape::ui

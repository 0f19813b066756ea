#pragma once

#include "session/snapshot.hpp"
#include "ui/border_picker.hpp"
#include "ui/gizmo.hpp"
#include "ui/ui_output.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace drape::ui {

/// The mode Sew: the user picks two open borders, or parts of them, and sews them together; or one, and sets an elastic
/// band along it. The cloth goes on moving meanwhile.
class SewingMode {
 public:
  [[nodiscard]] bool isOn() const { return isOn_; }

  /// Starts the mode, or makes something else in it.
  void start(SewingKind kind);
  void end();
  void on(const SewingRequest& request, const session::Snapshot& snapshot, UiOutput& output);

  /// Forgets what was picked. False if nothing was.
  bool cancel();
  /// Forgets the borders of another scene.
  void follow(const session::Snapshot& snapshot);

  /// The place of the mouse in the window. @param isOverPicture whether it is in the picture, not over a panel
  void hover(const Vec2& place, bool isOverPicture);
  /// Picks the border at a place. False if there is none.
  /// @param longer whether a part between two clicks takes the longer way
  bool click(const Vec2& place, bool longer, const session::Snapshot& snapshot, const GizmoPicture& picture,
             double scale);

  /// For the window; empty while the mode is off. @param scale of lengths on the screen
  [[nodiscard]] std::optional<SewingView> view(const session::Snapshot& snapshot, const GizmoPicture& picture,
                                               double scale);

 private:
  [[nodiscard]] std::optional<PickedBorder> under(const BorderSpot& spot, bool longer) const;
  void pick(PickedBorder border, const session::Snapshot& snapshot);
  void chooseDirection(const session::Snapshot& snapshot);
  void update(const session::Snapshot& snapshot);
  void sew(const session::Snapshot& snapshot, UiOutput& output);
  void setBand(double length, const session::Snapshot& snapshot, UiOutput& output);
  [[nodiscard]] scene::SeamDescription seam() const;
  [[nodiscard]] std::size_t maxSides() const { return kind_ == SewingKind::Seam ? 2 : 1; }

  bool isOn_ = false;
  SewingKind kind_ = SewingKind::Seam;
  BorderExtent extent_ = BorderExtent::Corners;
  std::optional<Vec2> mouse_;
  std::optional<BorderSpot> start_;  // of a part between two clicks
  std::vector<PickedBorder> sides_;
  bool isReversed_ = false;

  // What follows from the picked sides and the cloth.
  bool isUpdated_ = false;
  std::shared_ptr<const scene::Sewing> sewing_;
  std::shared_ptr<const sim::ClothModel> model_;
  std::vector<sim::SeamPair> pairs_;
  text::Sentence problem_;
  std::optional<double> bandLength_;

  std::shared_ptr<const scene::Scene> scene_;  // of the picker
  std::unique_ptr<BorderPicker> picker_;
  std::vector<int> middles_;  // of the parts between corners
};

/// The seams and bands of a snapshot without one of them.
[[nodiscard]] session::SetSewingCommand withoutSeam(const session::Snapshot& snapshot, std::size_t seam);
[[nodiscard]] session::SetSewingCommand withoutBand(const session::Snapshot& snapshot, std::size_t cloth,
                                                    std::size_t band);
/// The same with another length of a band.
[[nodiscard]] session::SetSewingCommand withBandLength(const session::Snapshot& snapshot, std::size_t cloth,
                                                       std::size_t band, double length);

}  // namespace drape::ui

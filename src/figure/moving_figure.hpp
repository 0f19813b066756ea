#pragma once

#include "figure/motions.hpp"
#include "figure/proportions.hpp"
#include "sim/contact/bodies/body.hpp"

#include <memory>
#include <vector>

namespace drape::figure {

/// How a figure moves, and its size.
struct FigureOptions {
  const Motion* motion = &motions().front();
  double speed = 1.0;  ///< of the motion [-]
  Proportions proportions;

  bool operator==(const FigureOptions&) const = default;
};

/// The range of FigureOptions::speed [-].
inline constexpr double minSpeed = 0.1;
inline constexpr double maxSpeed = 2.0;

/// Whether speed and proportions are in their ranges.
[[nodiscard]] bool isAllowed(const FigureOptions& options);

/// The time in which a figure goes from the rest pose, or from the motion before, to its motion, and to its size [s].
inline constexpr double blendTime = 1.0;

/// The figure and its motion, which can change from a time on. Immutable: a change makes another one.
class MovingFigure final : public sim::contact::Deformation {
 public:
  /// At time 0 and before it stands in the rest pose, as it is built, with velocity 0.
  /// @param positions, triangles of its mesh in the rest pose [m]
  MovingFigure(std::vector<Vec3> positions, std::vector<Triangle> triangles, const FigureOptions& options);

  void positionsAt(double time, std::vector<Vec3>& positions) const override;

  /// What the figure does in the end.
  [[nodiscard]] const FigureOptions& options() const { return parts_.back().options; }
  /// The measures of the figure as it is built.
  [[nodiscard]] const Proportions& built() const { return base_->measures; }

  /// The same figure, which begins another motion or size at a time [s], and blends into it. Before that time it may
  /// differ.
  [[nodiscard]] std::shared_ptr<const MovingFigure> changed(double time, const FigureOptions& options) const;
  /// The same figure with these options from the start.
  [[nodiscard]] std::shared_ptr<const MovingFigure> restarted(const FigureOptions& options) const;

 private:
  /// What stays when the motion or the size changes.
  struct Base {
    std::vector<Triangle> triangles;
    std::vector<SkinWeights> weights;
    FigureShape shape;
    Proportions measures;
  };
  /// What the figure does from a time on, after a blend.
  struct Part {
    double start = 0.0;    ///< [s]
    double cycles = 0.0;   ///< of the motion, at the start
    double heading = 0.0;  ///< added to that of the motion [degrees]
    FigureOptions options;
    std::shared_ptr<const FigureShape> shape;  ///< in its own size

    [[nodiscard]] double cyclesAt(double time) const;
    [[nodiscard]] FigurePose poseAt(double time, const PerJoint<Vec3>& places) const;
  };
  /// The figure between the rest pose of its present size and the skin.
  struct Stage {
    std::shared_ptr<const FigureShape> shape;
    FigurePose pose;
  };

  MovingFigure(std::shared_ptr<const Base> base, std::vector<Part> parts);

  [[nodiscard]] static std::shared_ptr<const FigureShape> sized(const Base& base, const Proportions& proportions);
  [[nodiscard]] std::vector<Part>::const_iterator firstActing(double time) const;
  [[nodiscard]] Stage stageAt(double time) const;

  std::shared_ptr<const Base> base_;
  std::vector<Part> parts_;  ///< at least one, by ascending start
};

/// The figure as a body.
[[nodiscard]] std::shared_ptr<const sim::contact::MeshShape> movingFigure(std::vector<Vec3> positions,
                                                                          std::vector<Triangle> triangles,
                                                                          const FigureOptions& options);

/// The figure that a deformation is; null for others.
[[nodiscard]] std::shared_ptr<const MovingFigure> asFigure(
    const std::shared_ptr<const sim::contact::Deformation>& deformation);

}  // namespace drape::figure

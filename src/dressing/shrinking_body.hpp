#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/model/cloth_model.hpp"

#include <memory>
#include <vector>

namespace drape::dressing {

/// A closed body and the shapes between it and the centre lines of its limbs.
///
/// The positions diffuse along the surface (HeatFlow). A limb of radius r loses its girth in a time of r^2, and its
/// length only in a time of its length squared. So an arm becomes a line while the trunk keeps two thirds of its width.
class ShrinkingBody {
 public:
  /// @param body in the scene [m]; closed, with all triangles counter-clockwise from outside
  explicit ShrinkingBody(sim::ClothMesh body);

  /// The shapes from the full body, frame 0, to the thinnest one: positions of the vertices [m].
  [[nodiscard]] const std::vector<std::vector<Vec3>>& frames() const { return frames_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] std::size_t thinnest() const { return frames_.size() - 1; }

  /// The frame in which arms and legs are lines and have lost little of their length.
  [[nodiscard]] std::size_t centreLines() const { return centreLines_; }

  /// The sum over all frames up to this one of the largest displacement of a vertex from the frame before [m].
  [[nodiscard]] double wayTo(std::size_t frame) const { return ways_[frame]; }

  /// The same body with other shapes between. @param frames as many
  [[nodiscard]] ShrinkingBody withFrames(std::vector<std::vector<Vec3>> frames) const;

  /// The body as it grows from a frame to its full size. No vertex moves faster than `speed` [m/s].
  [[nodiscard]] std::shared_ptr<const sim::contact::MeshShape> growingFrom(std::size_t frame, double speed) const;

 private:
  std::vector<std::vector<Vec3>> frames_;
  std::vector<Triangle> triangles_;
  std::vector<double> ways_;
  std::size_t centreLines_ = 0;
};

}  // namespace drape::dressing

#pragma once

#include "session/snapshot.hpp"
#include "sim/fabric/material.hpp"
#include "sim/fields/stretch_tensor.hpp"
#include "sim/model/vector.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace drape::render {

/// The square of the steepest slope of a wrinkle in cloth that is compressed to `ratio` of its length [-].
///
/// A sine of amplitude A and wavelength L has the steepest slope s = 2 pi A / L. It is longer than L by the factor
/// 1 + (pi A / L)^2 = 1 + s^2 / 4 to first order, and this is 1 / ratio where the cloth keeps its length (Hadap,
/// Bangerter, Volino and Magnenat-Thalmann 1999, Animating wrinkles on clothes, conserve area in the same way). Cloth
/// that is compressed by much less than `buckling` keeps flat. 0 for stretched cloth.
/// @param buckling see sim::fields::bucklingStrain; positive [-]
[[nodiscard]] double squaredWrinkleSlope(double ratio, double buckling);

/// The buckling strain of springs, which have no stiffness in bending: that of stiff woven fabrics [-].
inline constexpr double springBuckling = 0.002;

/// The wavelength of the wrinkles, over the mean edge of the mesh at rest [-]. A sheet buckles in the longest waves
/// that it has room for (Euler), and the mesh itself takes all waves of two edges and more (Nyquist). So the wrinkles
/// are shorter: with half of that, every compressed triangle has room for a whole one.
inline constexpr double edgesPerWrinkle = 1.0;

/// What the shaders need to draw wrinkles at a vertex of the cloth.
struct Wrinkles {
  Eigen::Vector3f place = Eigen::Vector3f::Zero();  ///< in the mesh at rest, in wavelengths
  /// The sum of s^2 d d^T over the directions d of compression, with s^2 of squaredWrinkleSlope [-], and a random part
  /// without a trace. d refers to the mesh at rest. The components xx, yy, zz; then yz, zx, xy.
  Eigen::Vector3f diagonal = Eigen::Vector3f::Zero();
  Eigen::Vector3f mixed = Eigen::Vector3f::Zero();
};

/// The wrinkles of a cloth, which are smaller than its triangles (view.wrinkles).
class WrinkleMap {
 public:
  /// Takes another snapshot of the same simulation, or the same one again. Computes nothing while view.wrinkles is off.
  /// @return whether vertices() are others than before
  bool update(const session::Snapshot& snapshot);

  /// One for each vertex of the cloth.
  [[nodiscard]] std::span<const Wrinkles> vertices() const { return vertices_; }

 private:
  /// A vertex of the model at rest.
  struct VertexAtRest {
    sim::fields::WarpAndWeft frame = sim::fields::WarpAndWeft::Zero();  // zero where no triangle has an area
    Mat3 scatter = Mat3::Zero();                                        // random part of its tensors, for a trace of 1
    double wavelength = 0.0;                                            // [m]
    const sim::fabric::Material* material = nullptr;                    // in the model; null: springs
  };

  void takeModel(const session::Snapshot& snapshot);
  [[nodiscard]] VertexAtRest vertexAtRest(std::size_t vertex, double wavelength) const;
  [[nodiscard]] static Mat3 tensorOf(const VertexAtRest& vertex, const Mat3& stretch);

  std::shared_ptr<const scene::Scene> scene_;
  std::shared_ptr<const sim::ClothModel> model_;
  std::int64_t version_ = -1;
  sim::fields::FieldGeometry geometry_;
  std::vector<sim::fields::WarpAndWeft> frames_;  // of each triangle
  std::vector<VertexAtRest> rest_;
  std::vector<Mat3> stretches_;
  std::vector<Wrinkles> vertices_;
};

}  // namespace drape::render

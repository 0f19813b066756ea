#include "sim/solvers/fabric_constraints.hpp"

#include "sim/fabric/fabric.hpp"
#include "sim/model/colouring.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace drape::sim {
namespace {

using fabric::Corners;

/// Rows are the sides of a triangle, columns its corners: side k goes from corner k to the next one.
Mat3 sidesOfCorners() {
  Mat3 incidence;
  incidence << -1.0, 1.0, 0.0,  //
      0.0, -1.0, 1.0,           //
      1.0, 0.0, -1.0;
  return incidence;
}

/// One triangle's membrane at some positions of its corners.
class LocalMembrane {
 public:
  /// @param inverseMass of the corners [1/kg]; 0 where pinned
  LocalMembrane(const fabric::MembraneTriangle& membrane, double timeStep, const Vec3& inverseMass)
      : membrane_(membrane), squaredStep_(timeStep * timeStep), inverseMass_(inverseMass) {}

  /// Minus h^2 times the forces on the corners, plus p: zero at the solution [kg m].
  [[nodiscard]] Corners residual(const Corners& corners, const Corners& moment) const {
    const Corners sides = corners * incidence_.transpose();
    return moment + squaredStep_ * sides * membrane_.tensions(corners).asDiagonal() * incidence_;
  }

  /// The Newton step dx of FabricConstraints, one column a corner [m].
  [[nodiscard]] Corners step(const Corners& corners, const Corners& moment) const {
    const Vec3 excess = membrane_.excess(corners);
    const Corners sides = corners * incidence_.transpose();
    // H^-1, with one number for each pair of corners: the geometric stiffness is the same in all directions.
    const Mat3 geometric = incidence_.transpose() * membrane_.tensileTensions(excess).asDiagonal() * incidence_;
    const Mat3 mobility =
        (Mat3::Identity() + squaredStep_ * inverseMass_.asDiagonal() * geometric).inverse() * inverseMass_.asDiagonal();
    const Mat3 stiffness = squaredStep_ * membrane_.tangentOfSides(excess);
    const Mat3 sideMobility =
        (sides.transpose() * sides).cwiseProduct(incidence_ * mobility * incidence_.transpose());  // G^T H^-1 G
    const Vec3 undone = sides.cwiseProduct(moment * mobility * incidence_.transpose()).colwise().sum().transpose();
    const Vec3 multipliers = (Mat3::Identity() + stiffness * sideMobility).inverse() *
                             (stiffness * undone - squaredStep_ * membrane_.tensions(excess));
    return (sides * multipliers.asDiagonal() * incidence_ - moment) * mobility;
  }

  /// A step without overshoot, see FabricConstraints. Updates p.
  [[nodiscard]] Corners boundedStep(const Corners& corners, Corners& moment) const {
    constexpr int maxHalvings = 10;
    const Vec3 mass = inverseMass_.unaryExpr([](double w) { return w > 0.0 ? 1.0 / w : 0.0; });
    Corners step = this->step(corners, moment);
    const double slope = residual(corners, moment).cwiseProduct(step).sum();
    const auto overshoots = [&] {
      const Corners moved = moment + step * mass.asDiagonal();
      return residual(corners + step, moved).cwiseProduct(step).sum() > std::abs(slope);
    };
    for (int i = 0; i < maxHalvings && overshoots(); ++i) {
      step *= 0.5;
    }
    moment += step * mass.asDiagonal();
    return step;
  }

 private:
  const fabric::MembraneTriangle& membrane_;
  double squaredStep_;  // h^2 [s^2]
  Vec3 inverseMass_;    // [1/kg]
  Mat3 incidence_ = sidesOfCorners();
};

}  // namespace

FabricConstraints::FabricConstraints(const ClothModel& model) : model_(&model) {
  for (std::size_t v = 0; v < model.vertexMass.size(); ++v) {
    inverseMass_.push_back(model.pinned[v] ? 0.0 : 1.0 / model.vertexMass[v]);
  }
  const RaggedRows<int> corners = RaggedRows<int>::collect(model.triangles.size(), [&](const auto& add) {
    for (std::size_t t = 0; t < model.triangles.size(); ++t) {
      // A degenerate triangle resists nothing, and its corners may be one vertex.
      for (std::size_t k = 0; k < 3 && model.fabric->shape.triangles[t].area > 0.0; ++k) {
        add(t, model.triangles[t][k]);
      }
    }
  });
  membraneColours_ = colourSets(corners, model.vertexMass.size());
  membraneMoment_.resize(model.triangles.size());
  if (model.fabric->bends()) {
    prepareBending(model);
  }
}

void FabricConstraints::prepareBending(const ClothModel& model) {
  const fabric::Fabric& fabric = *model.fabric;
  const fabric::CurvatureMatrix rows = fabric::curvatureMatrix(fabric.shape, fabric.materials, model.vertexMass.size());
  std::vector<std::vector<CurvatureEntry>> entries(model.triangles.size());
  bendingStiffness_.resize(model.triangles.size());
  curvatureMobility_.assign(model.triangles.size(), Mat3::Zero());
  response_.resize(model.triangles.size());
  bendingMultipliers_.resize(model.triangles.size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    bendingStiffness_[t] =
        fabric.bendingScales[t] * fabric.shape.triangles[t].area * fabric::bendMatrix(fabric.materials[t]).diagonal();
    std::map<int, Vec3> weights;
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (fabric::CurvatureMatrix::InnerIterator entry(rows, 3 * static_cast<Eigen::Index>(t) + i); entry; ++entry) {
        weights.try_emplace(static_cast<int>(entry.col()), Vec3::Zero()).first->second[i] = entry.value();
      }
    }
    for (const auto& [vertex, weight] : weights) {
      entries[t].push_back({vertex, weight});
      curvatureMobility_[t] += inverseMass_[vertex] * weight * weight.transpose();
    }
  }
  curvatures_ = RaggedRows<CurvatureEntry>::collect(entries.size(), [&](const auto& add) {
    for (std::size_t t = 0; t < entries.size(); ++t) {
      std::ranges::for_each(entries[t], [&](const CurvatureEntry& entry) { add(t, entry); });
    }
  });
  bendingColours_ = colourSets(
      RaggedRows<int>::collect(entries.size(),
                               [&](const auto& add) {
                                 for (std::size_t t = 0; t < entries.size(); ++t) {
                                   std::ranges::for_each(entries[t],
                                                         [&](const CurvatureEntry& entry) { add(t, entry.vertex); });
                                 }
                               }),
      model.vertexMass.size());
}

void FabricConstraints::begin(double timeStep) {
  std::ranges::fill(membraneMoment_, Corners::Zero());
  std::ranges::fill(bendingMultipliers_, Mat3::Zero());
  if (timeStep == timeStep_) {
    return;
  }
  timeStep_ = timeStep;
  for (std::size_t t = 0; t < response_.size(); ++t) {
    const Vec3 stiffness = timeStep * timeStep * bendingStiffness_[t];
    response_[t] = (Mat3::Identity() + stiffness.asDiagonal() * curvatureMobility_[t]).inverse();
  }
}

void FabricConstraints::project(int threads, Workers& workers, std::span<Vec3> positions) {
  forEachByColour(workers, threads, membraneColours_, [&](std::size_t t) { projectMembrane(t, positions); });
  forEachByColour(workers, threads, bendingColours_, [&](std::size_t t) { projectBending(t, positions); });
}

void FabricConstraints::projectMembrane(std::size_t triangle, std::span<Vec3> positions) {
  const auto& [a, b, c] = model_->triangles[triangle];
  const LocalMembrane local(model_->fabric->membrane[triangle], timeStep_,
                            {inverseMass_[a], inverseMass_[b], inverseMass_[c]});
  const Corners corners = fabric::cornersOf(model_->triangles[triangle], positions);
  const Corners step = local.boundedStep(corners, membraneMoment_[triangle]);
  positions[a] += step.col(0);
  positions[b] += step.col(1);
  positions[c] += step.col(2);
}

void FabricConstraints::projectBending(std::size_t triangle, std::span<Vec3> positions) {
  const std::span<const CurvatureEntry> entries = std::as_const(curvatures_)[triangle];
  // The weights sum to zero, so that differences of positions serve. They are more accurate.
  const Vec3& origin = positions[entries.front().vertex];
  Mat3 curvature = Mat3::Zero();
  for (const CurvatureEntry& entry : entries) {
    curvature += entry.weight * (positions[entry.vertex] - origin).transpose();
  }
  const Vec3 stiffness = timeStep_ * timeStep_ * bendingStiffness_[triangle];
  const Mat3 change = -response_[triangle] * (stiffness.asDiagonal() * curvature + bendingMultipliers_[triangle]);
  bendingMultipliers_[triangle] += change;
  for (const CurvatureEntry& entry : entries) {
    positions[entry.vertex] += inverseMass_[entry.vertex] * (change.transpose() * entry.weight);
  }
}

}  // namespace drape::sim

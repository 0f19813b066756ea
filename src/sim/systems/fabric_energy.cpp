#include "sim/systems/fabric_energy.hpp"

#include <cmath>
#include <numeric>

namespace drape::sim {
namespace {

fabric::Corners sidesOf(const Triangle& triangle, std::span<const Vec3> vectors) {
  fabric::Corners sides;
  sides << vectors[triangle[1]] - vectors[triangle[0]], vectors[triangle[2]] - vectors[triangle[1]],
      vectors[triangle[0]] - vectors[triangle[2]];
  return sides;
}

}  // namespace

void FabricEnergy::prepare(const ClothModel& model, std::span<const Vec3> start, int threads, Workers& workers) {
  model_ = &model;
  workers_ = &workers;
  threads_ = threads;
  start_ = start;
  const std::size_t triangles = model.triangles.size();
  startSides_.resize(triangles);
  startExcess_.resize(triangles);
  sides_.resize(triangles);
  tensions_.resize(triangles);
  energies_.resize(triangles);
  forces_.resize(start.size());
  sizes_.resize(start.size());
  bendingEnergies_.assign(start.size(), 0.0);
  displaced_.resize(start.size());
  workers.forEach(threads, triangles, [&](std::size_t t) {
    const Triangle& triangle = model.triangles[t];
    startSides_[t] = sidesOf(triangle, start);
    startExcess_[t] = model.fabric->membrane[t].excess(fabric::cornersOf(triangle, start));
  });
}

void FabricEnergy::evaluate(std::span<const Vec3> displacement) {
  workers_->forEach(threads_, displaced_.size(), [&](std::size_t v) { displaced_[v] = start_[v] + displacement[v]; });
  workers_->forEach(threads_, sides_.size(), [&](std::size_t t) { evaluateTriangle(t, displacement); });
  workers_->forEach(threads_, forces_.size(), [&](std::size_t v) { gatherVertex(v, displacement); });
}

void FabricEnergy::evaluateTriangle(std::size_t triangle, std::span<const Vec3> displacement) {
  const fabric::Corners change = sidesOf(model_->triangles[triangle], displacement);
  const fabric::Corners& start = startSides_[triangle];
  const Vec3 excess = startExcess_[triangle] + change.cwiseProduct(start + 0.5 * change).colwise().sum().transpose();
  const fabric::MembraneTriangle& membrane = model_->fabric->membrane[triangle];
  sides_[triangle] = start + change;
  tensions_[triangle] = membrane.tensions(excess);
  energies_[triangle] = membrane.energy(excess);
}

void FabricEnergy::gatherVertex(std::size_t vertex, std::span<const Vec3> displacement) {
  const int own = static_cast<int>(vertex);
  Vec3 force = Vec3::Zero();
  double size = 0.0;
  double moved = displacement[vertex].norm();
  for (const int t : model_->vertexTriangles[vertex]) {
    const Triangle& triangle = model_->triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto side = static_cast<Eigen::Index>(k);
      const bool leaves = triangle[k] == own;
      if (leaves || triangle[(k + 1) % 3] == own) {
        const Vec3 pull = tensions_[t][side] * sides_[t].col(side);
        force += leaves ? pull : Vec3(-pull);
        size += pull.norm();
        moved += leaves ? displacement[triangle[(k + 1) % 3]].norm() : 0.0;
      }
    }
  }
  size += model_->fabricStiffness[vertex] * moved;
  if (model_->fabric->bends()) {
    // The rows of the matrix sum to zero, so that differences of positions serve. They are more accurate.
    double energy = 0.0;
    for (fabric::VertexMatrix::InnerIterator entry(model_->fabric->bending, own); entry; ++entry) {
      const Eigen::Index other = entry.col();
      const Vec3 offset = (start_[other] - start_[vertex]) + (displacement[other] - displacement[vertex]);
      force -= entry.value() * offset;
      size += std::abs(entry.value()) * offset.norm();
      energy -= 0.25 * entry.value() * offset.squaredNorm();
    }
    bendingEnergies_[vertex] = energy;
  }
  if (!model_->fabric->restMoments.empty()) {
    const Vec3 moment = model_->fabric->restMoments.forceOn(vertex, displaced_);
    force += moment;
    size += moment.norm();
  }
  forces_[vertex] = force;
  sizes_[vertex] = size;
}

double FabricEnergy::energy() const {
  const fabric::RestMoments& moments = model_->fabric->restMoments;
  return std::accumulate(energies_.begin(), energies_.end(), 0.0) +
         std::accumulate(bendingEnergies_.begin(), bendingEnergies_.end(), 0.0) +
         (moments.empty() ? 0.0 : moments.energy(displaced_));
}

void FabricEnergy::addDerivative(ForceDerivative variant, double factor, std::span<Mat3> diagonal,
                                 std::span<Mat3> pairs) {
  const fabric::Fabric& fabric = *model_->fabric;
  derivatives_.resize(sides_.size());
  workers_->forEach(threads_, sides_.size(), [&](std::size_t t) {
    derivatives_[t] =
        factor * fabric.membrane[t].derivative(fabric::cornersOf(model_->triangles[t], displaced_), variant);
  });
  for (std::size_t t = 0; t < sides_.size(); ++t) {
    const Triangle& triangle = model_->triangles[t];
    const fabric::Mat9& derivative = derivatives_[t];
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Eigen::Index next = (k + 1) % 3;
      const bool ascending = triangle[k] < triangle[next];
      diagonal[triangle[k]] += derivative.block<3, 3>(3 * k, 3 * k);
      const int pair = fabric.pairsOfSides[t][k];
      if (pair < 0) {
        continue;  // both ends are the same vertex
      }
      pairs[pair] += ascending ? derivative.block<3, 3>(3 * next, 3 * k) : derivative.block<3, 3>(3 * k, 3 * next);
    }
  }
  for (std::size_t p = 0; p < fabric.pairs.size(); ++p) {
    pairs[p].diagonal().array() += factor * fabric.pairs[p].bending;
  }
  for (std::size_t v = 0; v < diagonal.size() && fabric.bends(); ++v) {
    const int row = static_cast<int>(v);
    diagonal[v].diagonal().array() += factor * fabric.bending.coeff(row, row);
  }
}

}  // namespace drape::sim

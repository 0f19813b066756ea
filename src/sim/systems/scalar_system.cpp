#include "sim/systems/scalar_system.hpp"

#include <limits>

namespace drape::sim {
namespace {

/// The lower half of M + sum_s w_s L_s for the free vertices.
Eigen::SparseMatrix<double> assemble(const ClothModel& model, const std::vector<std::size_t>& vertices,
                                     const std::vector<int>& rows, const ScalarWeight& weight) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(vertices.size() + model.springs.size());
  for (const std::size_t v : vertices) {
    double diagonal = model.vertexMass[v];
    for (const SpringEnd& end : model.springEnds[v]) {
      diagonal += weight.of(model.springs[end.spring]);
    }
    entries.emplace_back(rows[v], rows[v], diagonal);
  }
  for (const Spring& spring : model.springs) {
    const int a = rows[spring.a];
    const int b = rows[spring.b];
    if (a >= 0 && b >= 0) {
      entries.emplace_back(b, a, -weight.of(spring));  // rows ascend with the vertices, and a < b
    }
  }
  const auto size = static_cast<Eigen::Index>(vertices.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

ScalarSystem::Pattern ScalarSystem::patternOf(const ClothModel& model) {
  Pattern pattern;
  pattern.rows.assign(model.restPositions.size(), -1);
  for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
    if (!model.pinned[v]) {
      pattern.rows[v] = static_cast<int>(pattern.vertices.size());
      pattern.vertices.push_back(v);
    }
  }
  pattern.factor = std::make_unique<Factor>();
  pattern.factor->analyzePattern(assemble(model, pattern.vertices, pattern.rows, {1.0, 1.0, 0.0}));
  return pattern;
}

bool ScalarSystem::prepare(const ClothModel& model, const ScalarWeight& weight) {
  Pattern& pattern = patterns_.get(model, patternOf);
  pattern_ = &pattern;
  if (pattern.weight == weight) {
    return false;
  }
  pattern.factor->factorize(assemble(model, pattern.vertices, pattern.rows, weight));
  pattern.factored = pattern.factor->info() == Eigen::Success;
  pattern.weight = weight;
  return true;
}

Eigen::MatrixXd ScalarSystem::solve(const Eigen::MatrixXd& rightSides) const {
  if (!pattern_->factored) {
    return Eigen::MatrixXd::Constant(rightSides.rows(), rightSides.cols(), std::numeric_limits<double>::quiet_NaN());
  }
  return pattern_->factor->solve(rightSides);
}

}  // namespace drape::sim

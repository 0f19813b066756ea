#include "sim/systems/sparse_system.hpp"

#include "sim/fabric/fabric.hpp"

#include <algorithm>

// The three columns of a free vertex hold the lower triangle of its diagonal block, then the blocks of its neighbours
// of higher index, ascending. So column c begins with 3 - c values of the diagonal block. The rows of its p-th
// neighbour begin 3 p values later.

namespace drape::sim {
namespace {

/// The pairs of vertices that act on each other, seen from each vertex.
const RaggedRows<SpringEnd>& pairEndsOf(const ClothModel& model) {
  return model.fabric ? model.fabric->pairEnds : model.springEnds;
}

}  // namespace

SparseSystem::SparseSystem(const ClothModel& model) {
  Eigen::Index free = 0;
  for (const bool pinned : model.pinned) {
    row_.push_back(pinned ? -1 : static_cast<int>(free++));
  }
  lower_.resize(3 * free, 3 * free);
  reserve(model);
  writePattern(model);
}

bool SparseSystem::isBelow(std::size_t vertex, const SpringEnd& end) const {
  return row_[end.neighbour] > row_[vertex];
}

void SparseSystem::reserve(const ClothModel& model) {
  int* const outer = lower_.outerIndexPtr();
  outer[0] = 0;
  for (std::size_t v = 0; v < row_.size(); ++v) {
    if (row_[v] < 0) {
      continue;
    }
    int below = 0;
    for (const SpringEnd& end : pairEndsOf(model)[v]) {
      below += isBelow(v, end) ? 3 : 0;
    }
    for (int c = 0; c < 3; ++c) {
      const int column = 3 * row_[v] + c;
      outer[column + 1] = outer[column] + 3 - c + below;
    }
  }
  lower_.resizeNonZeros(outer[lower_.cols()]);
}

void SparseSystem::writePattern(const ClothModel& model) {
  for (std::size_t v = 0; v < row_.size(); ++v) {
    for (int c = 0; row_[v] >= 0 && c < 3; ++c) {
      int* inner = lower_.innerIndexPtr() + lower_.outerIndexPtr()[3 * row_[v] + c];
      for (int r = c; r < 3; ++r) {
        *inner++ = 3 * row_[v] + r;
      }
      for (const SpringEnd& end : pairEndsOf(model)[v]) {
        for (int r = 0; isBelow(v, end) && r < 3; ++r) {
          *inner++ = 3 * row_[end.neighbour] + r;
        }
      }
    }
  }
}

void SparseSystem::fill(const ClothModel& model, int threads, Workers& workers, const std::vector<Mat3>& diagonal,
                        const std::vector<Mat3>& pairBlocks) {
  workers.forEach(threads, row_.size(), [&](std::size_t v) {
    if (row_[v] >= 0) {
      fillVertex(model, v, diagonal, pairBlocks);
    }
  });
}

void SparseSystem::fillVertex(const ClothModel& model, std::size_t vertex, const std::vector<Mat3>& diagonal,
                              const std::vector<Mat3>& pairBlocks) {
  for (int c = 0; c < 3; ++c) {
    double* value = lower_.valuePtr() + lower_.outerIndexPtr()[3 * row_[vertex] + c];
    for (int r = c; r < 3; ++r) {
      *value++ = diagonal[vertex](r, c);
    }
    for (const SpringEnd& end : pairEndsOf(model)[vertex]) {
      for (int r = 0; isBelow(vertex, end) && r < 3; ++r) {
        *value++ = pairBlocks[end.spring](r, c);
      }
    }
  }
}

void SparseSystem::add(const ClothModel& model, std::size_t vertex, std::size_t other, const Mat3& block) {
  const std::size_t first = std::min(vertex, other);
  const std::size_t second = std::max(vertex, other);
  if (row_[first] < 0 || row_[second] < 0) {
    return;
  }
  int before = 0;  // values between the diagonal block and the wanted one
  for (const SpringEnd& end : pairEndsOf(model)[first]) {
    before += isBelow(first, end) && end.neighbour < static_cast<int>(second) ? 3 : 0;
  }
  for (int c = 0; c < 3; ++c) {
    double* const column = lower_.valuePtr() + lower_.outerIndexPtr()[3 * row_[first] + c];
    for (int r = first == second ? c : 0; r < 3; ++r) {
      column[first == second ? r - c : 3 - c + before + r] += block(r, c);
    }
  }
}

Eigen::VectorXd SparseSystem::gather(const std::vector<Vec3>& vectors) const {
  Eigen::VectorXd numbers(lower_.rows());
  for (std::size_t v = 0; v < row_.size(); ++v) {
    if (row_[v] >= 0) {
      numbers.segment<3>(Eigen::Index{3} * row_[v]) = vectors[v];
    }
  }
  return numbers;
}

void SparseSystem::scatter(const Eigen::VectorXd& numbers, std::vector<Vec3>& vectors) const {
  for (std::size_t v = 0; v < row_.size(); ++v) {
    vectors[v] = row_[v] < 0 ? Vec3(Vec3::Zero()) : Vec3(numbers.segment<3>(Eigen::Index{3} * row_[v]));
  }
}

}  // namespace drape::sim

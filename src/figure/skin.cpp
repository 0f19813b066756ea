#include "figure/skin.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace drape::figure {
namespace {

constexpr int diffusionPasses = 30;  // each spreads the weights over about half an edge

double distanceToBone(const JointInfo& joint, const Vec3& point) {
  const Vec3 along = joint.end - joint.rest;
  const double t = std::clamp((point - joint.rest).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - joint.rest - t * along).norm();
}

std::size_t nearestJoint(const Vec3& point) {
  std::size_t nearest = 0;
  double minDistance = HUGE_VAL;
  for (std::size_t j = 0; j < jointCount; ++j) {
    const JointInfo& joint = skeleton()[j];
    const double distance = distanceToBone(joint, point) / joint.radius;
    if (distance < minDistance) {
      minDistance = distance;
      nearest = j;
    }
  }
  return nearest;
}

using Row = Eigen::Matrix<double, static_cast<int>(jointCount), 1>;

/// Moves the weights of each vertex halfway to the mean of its neighbours.
void diffuse(std::span<const Triangle> triangles, std::vector<Row>& rows) {
  std::vector<Row> sum(rows.size(), Row::Zero());
  std::vector<double> count(rows.size(), 0.0);
  for (const Triangle& triangle : triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int self = triangle[corner];
      sum[self] += rows[triangle[(corner + 1) % 3]] + rows[triangle[(corner + 2) % 3]];
      count[self] += 2.0;
    }
  }
  for (std::size_t v = 0; v < rows.size(); ++v) {
    if (count[v] > 0.0) {
      rows[v] = 0.5 * rows[v] + 0.5 / count[v] * sum[v];
    }
  }
}

/// The largest weights of a row, which then add up to 1.
SkinWeights largestOf(const Row& row) {
  std::array<int, jointCount> order{};
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return row[a] > row[b]; });
  // The fifth weight is subtracted from the others: a joint leaves the list with the weight 0, without a jump.
  const double next = row[order[SkinWeights::maxJoints]];
  SkinWeights result;
  double sum = 0.0;
  for (std::size_t k = 0; k < SkinWeights::maxJoints; ++k) {
    result.joints[k] = order[k];
    result.weights[k] = row[order[k]] - next;
    sum += result.weights[k];
  }
  for (double& weight : result.weights) {
    weight /= sum;
  }
  return result;
}

/// A rotation and a translation as a dual quaternion.
struct DualQuaternion {
  Eigen::Vector4d real = Eigen::Vector4d::Zero();
  Eigen::Vector4d dual = Eigen::Vector4d::Zero();
};

DualQuaternion dualOf(const Vec3& place, const sim::contact::Pose& pose) {
  const Vec3 shift = pose.position - pose.rotation * place;
  const Eigen::Quaterniond translation(0.0, shift.x(), shift.y(), shift.z());
  return {pose.rotation.coeffs(), 0.5 * (translation * pose.rotation).coeffs()};
}

/// @param dual with a real part of any length
Vec3 moved(const DualQuaternion& dual, const Vec3& point) {
  const double scale = 1.0 / dual.real.norm();
  const Vec3 r = scale * dual.real.head<3>();
  const double rw = scale * dual.real[3];
  const Vec3 d = scale * dual.dual.head<3>();
  const double dw = scale * dual.dual[3];
  return point + 2.0 * r.cross(r.cross(point) + rw * point) + 2.0 * (rw * d - dw * r + r.cross(d));
}

}  // namespace

double SkinWeights::of(Joint joint) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < maxJoints; ++k) {
    sum += joints[k] == static_cast<int>(indexOf(joint)) ? weights[k] : 0.0;
  }
  return sum;
}

std::vector<SkinWeights> smoothWeights(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  std::vector<Row> rows(positions.size(), Row::Zero());
  for (std::size_t v = 0; v < rows.size(); ++v) {
    rows[v][static_cast<Eigen::Index>(nearestJoint(positions[v]))] = 1.0;
  }
  for (int pass = 0; pass < diffusionPasses; ++pass) {
    diffuse(triangles, rows);
  }
  std::vector<SkinWeights> weights;
  weights.reserve(rows.size());
  std::transform(rows.begin(), rows.end(), std::back_inserter(weights), largestOf);
  return weights;
}

void moveSkin(const PerJoint<Vec3>& places, const PerJoint<sim::contact::Pose>& poses,
              std::span<const SkinWeights> weights, std::span<const Vec3> rest, std::span<Vec3> positions) {
  PerJoint<DualQuaternion> duals;
  for (std::size_t j = 0; j < jointCount; ++j) {
    duals[j] = dualOf(places[j], poses[j]);
  }
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const SkinWeights& own = weights[v];
    DualQuaternion sum = duals[own.joints[0]];
    const Eigen::Vector4d first = sum.real;
    sum.real *= own.weights[0];
    sum.dual *= own.weights[0];
    for (std::size_t k = 1; k < SkinWeights::maxJoints && own.weights[k] > 0.0; ++k) {
      const DualQuaternion& each = duals[own.joints[k]];
      // A quaternion and its negative are the same rotation; the sum needs those on one side.
      const double weight = each.real.dot(first) < 0.0 ? -own.weights[k] : own.weights[k];
      sum.real += weight * each.real;
      sum.dual += weight * each.dual;
    }
    positions[v] = moved(sum, rest[v]);
  }
}

}  // namespace drape::figure

#include "sim/motion/unsteady_air.hpp"

#include "sim/forces/external_forces.hpp"
#include "sim/forces/kernels.hpp"
#include "sim/model/normals.hpp"
#include "sim/model/pieces.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

namespace drape::sim {
namespace {

/// C_R, the coefficient of the circulation by rotation, 1/2 C_R c^2 omega.
constexpr double rotationalLift = 1.0;

/// The part of the resistance to rotation that remains. In a descent with C_D = 2, the measured torque
/// (Andersen et al.: mu = 0.2) is 0.24 of that of kernels::plateForce at every point; with C_D = 1.2 it is 0.39.
constexpr double rotationShare = 0.3;

/// A piece is flat where the mean of its unit normals is at least `flat` long, and not where it is at most `bent`.
constexpr double flat = 0.9;
constexpr double bent = 0.7;

/// The forces at the start of a step act while the plate moves by at most this part of its shorter side. Longer steps
/// are unstable for a light plate.
constexpr double maxMotion = 0.25;

/// In a step that resolves the motion, a piece meets at most this part of its own mass of air. It would otherwise be
/// slowed too little: the solver moves the piece without the mass of the air that moves with it.
constexpr double maxAirMass = 0.4;

/// A flat rectangle with the moments of a piece.
struct Plate {
  Vec3 along = Vec3::Zero();   // unit vector along the longer side
  Vec3 across = Vec3::Zero();  // along the shorter side
  Vec3 normal = Vec3::Zero();
  double length = 0.0;  // longer side [m]
  double width = 0.0;   // shorter side [m]
  double area = 0.0;    // of the piece [m^2]

  /// The mass of the air that moves with it along its normal [kg].
  [[nodiscard]] double addedMass(double density) const {
    return addedMassFactor(width, length) * 0.25 * std::numbers::pi * density * area * width;
  }
  /// The moments of inertia of the air that turns with it [kg m^2]; those of strips.
  [[nodiscard]] Mat3 addedInertia(double density) const {
    const double strip = addedMassFactor(width, length) * std::numbers::pi / 128.0 * density * area;
    return strip * (std::pow(width, 3) * along * along.transpose() + std::pow(length, 3) * across * across.transpose());
  }
};

/// A rectangle of the sides a and b has the variances a^2 / 12 and b^2 / 12. Mass that is lumped at the vertices of a
/// coarse mesh makes them too large, so the sides are scaled to the area.
Plate plateOf(const MassMoments& moments, double area) {
  const Mat3 second = 0.5 * moments.inertia.trace() * Mat3::Identity() - moments.inertia;
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(second / moments.mass);
  const auto side = [&](int axis) { return std::sqrt(12.0 * std::max(0.0, axes.eigenvalues()[axis])); };
  const double product = side(1) * side(2);
  const double scale = product > 0.0 ? std::sqrt(area / product) : 0.0;
  return {.along = axes.eigenvectors().col(2),
          .across = axes.eigenvectors().col(1),
          .normal = axes.eigenvectors().col(0),
          .length = scale * side(2),
          .width = scale * side(1),
          .area = area};
}

/// The torque of kernels::plateForce on a flat piece that turns rigidly [N m].
/// @param motion relative to the air
Vec3 torqueOfPlate(const ClothModel& model, std::span<const std::size_t> vertices, const std::vector<Vec3>& positions,
                   const AirParameters& air, const RigidMotion& motion, const Vec3& normal) {
  Vec3 torque = Vec3::Zero();
  for (const std::size_t v : vertices) {
    const Vec3 relative = motion.velocityAt(positions[v]);
    const double speed = relative.norm();
    if (speed > 0.0) {
      const Vec3 force = kernels::plateForce(normal, speed, relative / speed, airFactorsOf(air, model.vertexArea[v]));
      torque += (positions[v] - motion.moments.barycentre).cross(force);
    }
  }
  return torque;
}

/// The time in which something moves by that distance [s].
double timeFor(double distance, double speed) {
  return speed > 0.0 ? distance / speed : std::numeric_limits<double>::infinity();
}

/// The mean of a torque over a step, over its value at the start [-], where the torque is proportional to the angular
/// momentum and opposes it. @param impulse of its value at the start [kg m^2/s]  @param momentum at the start
double slowingOf(double impulse, double momentum) {
  const double decay = momentum > 0.0 ? impulse / momentum : 0.0;
  return decay > 0.0 ? -std::expm1(-decay) / decay : 1.0;
}

/// The angular momentum that a piece keeps in a step since the air resists its rotation less than with
/// kernels::plateForce at every vertex [kg m^2/s]. @param motion relative to the air, without rotation about the normal
Vec3 keptMomentum(const ClothModel& model, std::span<const std::size_t> vertices, const std::vector<Vec3>& positions,
                  const AirParameters& air, const RigidMotion& motion, const Vec3& normal, double time) {
  const auto torqueOf = [&](double share) {
    RigidMotion slower = motion;
    slower.spin *= share;
    return torqueOfPlate(model, vertices, positions, air, slower, normal);
  };
  const Vec3 resistance = torqueOf(1.0);
  const double slowing = slowingOf(time * resistance.norm(), (motion.moments.inertia * motion.spin).norm());
  return slowing * time * (torqueOf(rotationShare) - resistance);
}

/// The matrix of v -> vector x v.
Mat3 crossMatrix(const Vec3& vector) {
  Mat3 matrix;
  matrix << 0.0, -vector.z(), vector.y(), vector.z(), 0.0, -vector.x(), -vector.y(), vector.x(), 0.0;
  return matrix;
}

}  // namespace

double addedMassFactor(double shorter, double longer) {
  return 1.0 / (1.0 + 0.73 * shorter / longer);
}

std::vector<UnsteadyAir::Piece> UnsteadyAir::piecesOf(const ClothModel& model) {
  constexpr int none = -1;
  std::vector<int> pieceOf(model.restPositions.size(), none);
  std::vector<Piece> pieces;
  for (auto& vertices : freePieces(model)) {
    Piece piece{.vertices = std::move(vertices), .triangles = {}};
    for (const std::size_t v : piece.vertices) {
      pieceOf[v] = static_cast<int>(pieces.size());
      piece.area += model.vertexArea[v];
    }
    pieces.push_back(std::move(piece));
  }
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const int piece = pieceOf[model.triangles[t][0]];
    if (piece != none) {
      pieces[piece].triangles.push_back(t);
    }
  }
  std::erase_if(pieces, [](const Piece& piece) { return piece.triangles.empty() || !(piece.area > 0.0); });
  return pieces;
}

double UnsteadyAir::flatnessOf(const ClothModel& model, const Piece& piece, const ClothState& state) {
  const auto meanNormal = [&](std::size_t stride) {
    Vec3 sum = Vec3::Zero();
    double area = 0.0;
    for (std::size_t i = 0; i < piece.triangles.size(); i += stride) {
      const Vec3 normal = doubleAreaNormal(model.triangles[piece.triangles[i]], state.positions);
      sum += normal;
      area += normal.norm();
    }
    return area > 0.0 ? sum.norm() / area : 0.0;
  };
  // Garments are far from flat. A sample of their triangles shows that at little cost.
  constexpr std::size_t sampleSize = 200;
  const std::size_t stride = piece.triangles.size() / sampleSize;
  if (stride > 1 && meanNormal(stride) < 0.5 * bent) {
    return 0.0;
  }
  return std::clamp((meanNormal(1) - bent) / (flat - bent), 0.0, 1.0);
}

UnsteadyAir::Share UnsteadyAir::shareOf(const ClothModel& model, const CommonParameters& parameters, const Piece& piece,
                                        double flatness, const ClothState& state) {
  const RigidMotion motion = rigidMotionOf(model, piece.vertices, state);
  const Plate plate = plateOf(motion.moments, piece.area);
  const double density = flatness * parameters.air.density;
  const Vec3 velocity = motion.velocity - parameters.air.wind;
  const Vec3 spin = motion.spin - plate.normal.dot(motion.spin) * plate.normal;
  const Vec3 momentum = plate.addedMass(density) * velocity.dot(plate.normal) * plate.normal;
  const Vec3 circulation =
      plate.width * plate.along.dot(spin) * plate.along + plate.length * plate.across.dot(spin) * plate.across;
  const Vec3 turning =
      0.5 * rotationalLift * addedMassFactor(plate.width, plate.length) * density * plate.area * circulation;
  const double speed = velocity.norm() + plate.length * spin.norm();
  const double time = std::min(parameters.timeStep, timeFor(maxMotion * plate.width, speed));
  const double airMotion = maxAirMass * motion.moments.mass / (density * plate.area);
  const RigidMotion relative{.moments = motion.moments, .velocity = velocity, .spin = spin};
  const Vec3 kept = keptMomentum(model, piece.vertices, state.positions, parameters.air, relative, plate.normal, time);
  return {.piece = &piece,
          .flatness = flatness,
          .longestStep = timeFor(std::min(maxMotion * plate.width, airMotion), speed),
          .time = time,
          .linear = momentum + 0.5 * time * turning.cross(velocity),
          .angular = plate.addedInertia(density) * spin + flatness * kept,
          .turning = turning};
}

double UnsteadyAir::longestStep() const {
  double longest = std::numeric_limits<double>::infinity();
  for (const Share& share : shares_) {
    longest = std::min(longest, share.longestStep);
  }
  return longest;
}

void UnsteadyAir::begin(const ClothModel& model, const CommonParameters& parameters, const ClothState& state) {
  shares_.clear();
  if (!parameters.air.acts() || !actsAsPlate(model, parameters.air)) {
    return;
  }
  timeStep_ = parameters.timeStep;
  density_ = parameters.air.density;
  wind_ = parameters.air.wind;
  for (const Piece& piece : pieces_.get(model, piecesOf)) {
    const double flatness = flatnessOf(model, piece, state);
    if (flatness > 0.0) {
      shares_.push_back(shareOf(model, parameters, piece, flatness, state));
    }
  }
}

RigidMotion UnsteadyAir::changedBy(const Share& share, const RigidMotion& motion) const {
  const MassMoments& moments = motion.moments;
  const Plate plate = plateOf(moments, share.piece->area);
  const double density = share.flatness * density_;
  const Mat3 addedMass = plate.addedMass(density) * plate.normal * plate.normal.transpose();
  const Mat3 turning = 0.5 * share.time * crossMatrix(share.turning);
  const Vec3 momentum = moments.mass * (motion.velocity - wind_) + share.linear;
  const Vec3 velocity = solveRigid(moments.mass * Mat3::Identity() + addedMass - turning, momentum);
  const Vec3 torque = -velocity.cross(addedMass * velocity);
  RigidMotion changed = motion;
  changed.velocity = wind_ + velocity;
  changed.spin = solveRigid(moments.inertia + plate.addedInertia(density),
                            moments.inertia * motion.spin + share.angular + share.time * torque);
  return changed;
}

double UnsteadyAir::apply(const ClothModel& model, ClothState& state) const {
  double work = 0.0;
  for (const Share& share : shares_) {
    const RigidMotion motion = rigidMotionOf(model, share.piece->vertices, state);
    const RigidMotion changed = changedBy(share, motion);
    const Vec3 turn = changed.spin - motion.spin;
    const Eigen::AngleAxisd rotation(0.5 * timeStep_ * turn.norm(), turn.normalized());
    const Vec3 shift = 0.5 * timeStep_ * (changed.velocity - motion.velocity);
    const Vec3& barycentre = motion.moments.barycentre;
    for (const std::size_t v : share.piece->vertices) {
      const Vec3 arm = state.positions[v] - barycentre;
      state.velocities[v] += changed.velocityAt(state.positions[v]) - motion.velocityAt(state.positions[v]);
      state.positions[v] = barycentre + shift + rotation * arm;
    }
    work += changed.kineticEnergy() - motion.kineticEnergy();
  }
  return work;
}

}  // namespace drape::sim

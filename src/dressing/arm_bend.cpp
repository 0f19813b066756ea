#include "dressing/arm_bend.hpp"

#include "dressing/heat_flow.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace drape::dressing {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double largestTurn = 60.0 * degree;
constexpr double armLength = 0.4;  // of a hanging arm, nearly to the wrist [m]

/// Smooth weights of both arms.
std::vector<Vec3> armWeights(const ShrinkingBody& body, const BodyParts& parts) {
  const std::vector<Vec3>& full = body.frames().front();
  std::vector<Vec3> weights(full.size(), Vec3::Zero());
  for (std::size_t v = 0; v < full.size(); ++v) {
    const BodyPart part = parts.ofVertex(static_cast<int>(v));
    weights[v].x() = part == BodyPart::LeftArm ? 1.0 : 0.0;
    weights[v].y() = part == BodyPart::RightArm ? 1.0 : 0.0;
  }
  constexpr double blend = 0.02;  // of the body's largest side
  const double width = blend * sim::boundsOf(full).sizes().maxCoeff();
  HeatFlow flow({full, body.triangles()});
  flow.setTimeStep(width * width);
  return flow.advance(weights);
}

}  // namespace

ArmBend::ArmBend(const ShrinkingBody& body, const BodyParts& parts) : body_(body), parts_(parts) {
  arms_[1].part = BodyPart::RightArm;
  arms_[1].sleeve = OpeningKind::RightSleeve;
  if (parts.isPerson()) {
    weights_ = armWeights(body, parts);
    for (Arm& arm : arms_) {
      findShoulder(arm);
    }
  }
}

/// The inner end of the arm's centre line.
void ArmBend::findShoulder(Arm& arm) const {
  const std::vector<Vec3>& lines = body_.frames()[body_.centreLines()];
  const double middle = parts_.landmarks()->neck.x();
  double inner = std::numeric_limits<double>::max();
  for (std::size_t v = 0; v < lines.size(); ++v) {
    const double beside = std::abs(lines[v].x() - middle);
    if (parts_.ofVertex(static_cast<int>(v)) == arm.part && beside < inner) {
      inner = beside;
      arm.shoulder = lines[v];
    }
  }
}

/// The point of the centre line at that distance from the shoulder [m]; its end if the arm is shorter.
Vec3 ArmBend::pointOfArm(const Arm& arm, double fromShoulder) const {
  const std::vector<Vec3>& lines = body_.frames()[body_.centreLines()];
  double minOff = std::numeric_limits<double>::max();
  Vec3 found = arm.shoulder;
  for (std::size_t v = 0; v < lines.size(); ++v) {
    const double off = std::abs((lines[v] - arm.shoulder).norm() - fromShoulder);
    if (parts_.ofVertex(static_cast<int>(v)) == arm.part && off < minOff) {
      minOff = off;
      found = lines[v];
    }
  }
  return found;
}

void ArmBend::aim(const GarmentOpenings& openings, std::span<const Vec3> positions) {
  for (Arm& arm : arms_) {
    arm.turn = Eigen::AngleAxisd::Identity();
    const Opening* sleeve = openings.find(arm.sleeve);
    const bool isCape = sleeve == nullptr && openings.find(OpeningKind::Neck) != nullptr;
    if (weights_.empty() || (sleeve == nullptr && !isCape)) {
      continue;
    }
    const Vec3 wanted = isCape ? Vec3(0.0, -armLength, 0.0) : Vec3(centreOf(*sleeve, positions) - arm.shoulder);
    const Vec3 present = pointOfArm(arm, wanted.norm()) - arm.shoulder;
    if (wanted.norm() > 0.0 && present.norm() > 0.0) {
      arm.turn = Eigen::Quaterniond::FromTwoVectors(present, wanted);
      arm.turn.angle() = std::min(arm.turn.angle(), largestTurn);
    }
  }
}

std::vector<Vec3> ArmBend::bent(std::size_t frame) const {
  return turned(frame, std::min(1.0, body_.wayTo(frame) / body_.wayTo(body_.centreLines())));
}

std::vector<Vec3> ArmBend::withFullLength() const {
  return turned(body_.centreLines() / 2, 1.0);  // a hand recedes by 2 cm until then, and by 10 cm at the centre lines
}

/// @param share of the whole turn [-]
std::vector<Vec3> ArmBend::turned(std::size_t frame, double share) const {
  std::vector<Vec3> positions = body_.frames()[frame];
  for (std::size_t k = 0; k < arms_.size() && !weights_.empty(); ++k) {
    const Arm& arm = arms_[k];
    if (arm.turn.angle() * share == 0.0) {
      continue;
    }
    const Mat3 turn = Eigen::AngleAxisd(share * arm.turn.angle(), arm.turn.axis()).toRotationMatrix();
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const Vec3 turned = turn * (positions[v] - arm.shoulder) + arm.shoulder;
      positions[v] += weights_[v][static_cast<Eigen::Index>(k)] * (turned - positions[v]);
    }
  }
  return positions;
}

ShrinkingBody ArmBend::bentBody() const {
  std::vector<std::vector<Vec3>> frames;
  for (std::size_t frame = 0; frame < body_.frames().size(); ++frame) {
    frames.push_back(bent(frame));
  }
  return body_.withFrames(std::move(frames));
}

}  // namespace drape::dressing

#include "figure/motions.hpp"

#include "figure/gaits.hpp"

#include <algorithm>
#include <array>

namespace drape::figure {

std::span<const Motion> motions() {
  static const std::array<Motion, 11> list{{
      {"rest", "Rest pose, in which the garments are fitted", 1.0, 0.0, 0, restPose},
      {"t_pose", "T-pose", 1.0, 0.0, 0, tPose},
      {"a_pose", "A-pose", 1.0, 0.0, 0, aPose},
      {"breathe", "Breathing", 4.0, 0.0, 0, breathe},
      {"walk", "Walk", walkGait.period, walkGait.stride / walkGait.period, 0, walk},
      {"turn", "Turn on the spot", 4.0, 0.0, 1, turnRound},
      {"run", "Run", runGait.period, runGait.stride / runGait.period, 0, run},
      {"skate", "Skate", 2.0, 3.0, 0, skate},
      {"squat", "Squat", 3.0, 0.0, 0, squat},
      {"raise_arms", "Arm raise", 4.0, 0.0, 0, raiseArms},
      {"dance", "Dance", 8.0, 0.0, 0, dance},
  }};
  return list;
}

const Motion* findMotion(std::string_view name) {
  const std::span<const Motion> all = motions();
  const auto found = std::ranges::find(all, name, &Motion::name);
  return found == all.end() ? nullptr : &*found;
}

std::string motionNames() {
  std::string names;
  for (const Motion& motion : motions()) {
    names += (names.empty() ? "" : ", ") + std::string(motion.name);
  }
  return names;
}

void placeArm(Side side, double lower, double forward, double elbow, FigurePose& pose) {
  const double out = side == Side::Left ? 1.0 : -1.0;
  const Joint upper = onSide(Joint::LeftUpperArm, side);
  const Joint fore = onSide(Joint::LeftForearm, side);
  const Vec3 along = (restOf(fore) - restOf(upper)).normalized();
  const Vec3 hinge = along.cross(Vec3::UnitZ()).normalized();
  pose.rotation(upper) = turned(-forward, Vec3::UnitX()) * turned(-out * lower, Vec3::UnitZ());
  pose.rotation(fore) = turned(elbow, hinge);
}

}  // namespace drape::figure

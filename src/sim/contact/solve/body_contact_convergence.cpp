// When contact looks at the cloth again in a step: BodyContact::leftItsTouches.
#include "sim/contact/solve/body_contact.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

// Of the distance that is kept [-]:
constexpr double linearShare = 0.25;  // how far something may be moved before its touches are looked at again
constexpr double flatShare = 0.05;    // by how much a body may lie elsewhere then than the touch has it

}  // namespace

/// Whether something was moved far by planes, or so far by touches that where it is now a body is not where its touch
/// has it.
bool BodyContact::leftItsTouches(const Cloth& cloth, const std::vector<Vec3>* safe,
                                 const std::vector<Vec3>& positions) const {
  const double far = linearShare * largestKeep();
  if (filter_.farthest() > far) {
    return true;
  }
  return std::any_of(found_.touches.begin(), found_.touches.end(), [&](const Touch& touch) {
    const bool stays = std::all_of(touch.vertices.begin(), touch.vertices.end(), [&](int vertex) {
      const auto v = static_cast<std::size_t>(vertex);
      return (positions[v] - (safe != nullptr ? (*safe)[v] : Vec3(cloth.start[v] + touch.bodyMove))).norm() <= far;
    });
    if (stays) {
      return false;
    }
    const NearBody& near = near_[static_cast<std::size_t>(touch.body)];
    const Vec3 place = pointOf(touch, positions);
    const double above = touch.normal.dot(place) - touch.height;
    const double within = flatShare * near.reach.keep;
    return near.overlaps || above <= within ||
           std::abs(gapTo(near, near.step->end.toLocal(place), above + within) - above) > within;
  });
}

/// From a place in a body's frame to the body, at the end of the step [m]; infinite where it is more than `most`.
double BodyContact::gapTo(const NearBody& near, const Vec3& place, double most) const {
  if (near.mesh == nullptr) {
    return BodySearch(*near.step, 0, near.reach).gapAt(place);
  }
  const MeshInStep mesh = near.meshInStep(true);
  return NearestSearch(mesh).anywhere(place, most).gap;
}

}  // namespace drape

#include "report/hardcases/contact_cloth.hpp"

#include "intersection/intersections.hpp"
#include "report/body_intersections.hpp"
#include "report/jittered_start.hpp"
#include "scene/grid_mesh.hpp"
#include "sim/contact/bodies/motion.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace drape::report::hardcases {
settings::Settings contactSettings(const CaseTrial& trial, const std::vector<std::string>& changes) {
  std::vector<std::string> all{"self_collision=exact", "mass_given_as=density", "density=0.15", "mass_lumping=area",
                               "stiffness=200",        "damping=0.01",          "drag=0.3"};
  all.insert(all.end(), changes.begin(), changes.end());
  return trial.settings(all);
}

CaseCloth clothOf(const settings::Settings& settings, sim::ClothMesh mesh) {
  CaseCloth cloth;
  cloth.mesh = std::move(mesh);
  cloth.settings = settings;
  return cloth;
}

sim::ClothMesh sheetMesh(int resolution, double width, double depth) {
  return scene::makeGrid(scene::layoutOf({resolution, width, depth}), scene::GridSource::Plane::Horizontal).cloth;
}

sim::ClothMesh placed(sim::ClothMesh mesh, const Vec3& position, const Vec3& rotation) {
  const sim::contact::Pose pose = sim::contact::poseOf(position, rotation);
  for (Vec3& each : mesh.positions) {
    each = pose.toWorld(each);
  }
  return mesh;
}

ContactCloth::ContactCloth(CaseTrial& trial, const CaseCloth& cloth) : ContactCloth(trial, sceneOf(cloth)) {}

ContactCloth::ContactCloth(CaseTrial& trial, const std::shared_ptr<const scene::Scene>& scene)
    : ContactCloth(trial, scene, EnergyRule::Counted, std::numeric_limits<double>::infinity()) {}

ContactCloth::ContactCloth(CaseTrial& trial, const CaseCloth& cloth, double speedLimit)
    : ContactCloth(trial, sceneOf(cloth), EnergyRule::NotCounted, speedLimit) {}

ContactCloth::ContactCloth(CaseTrial& trial, const std::shared_ptr<const scene::Scene>& scene, EnergyRule rule,
                           double speedLimit)
    : trial_(trial), watched_(trial, withJitteredStart(scene, trial.start()), rule), speedLimit_(speedLimit) {
  watch();
}

void ContactCloth::step(const std::function<double()>& work) {
  watched_.step(work);
  watch();
}

void ContactCloth::run(double seconds) {
  const auto steps = std::lround(seconds / watched_.simulation().settings().step.timeStep);
  for (long i = 0; i < steps; ++i) {
    step();
  }
}

void ContactCloth::watch() {
  const std::vector<Vec3>& positions = watched_.state().positions;
  const std::vector<Triangle>& triangles = watched_.model().triangles;
  const auto self = static_cast<double>(intersection::intersectingPairs({positions, triangles}).size());
  const auto bodies = static_cast<double>(pairsWithBodies(positions, triangles, watched_.simulation().bodies()));
  if (allowed_) {
    trial_.show("pairs with itself, vice closed", "", self);
    trial_.show("pairs with bodies, vice closed", "", bodies);
  } else {
    trial_.expect("pairs with itself", "", self, 0.0);
    trial_.expect("pairs with bodies", "", bodies, 0.0);
  }
  trial_.expect("largest speed", "m/s", largestSpeed(watched_.state()), speedLimit_);
  const sim::contact::ContactReport& contact = watched_.simulation().lastStepReport().contact;
  trial_.show("contacts with itself", "", contact.selfContacts);
  trial_.show("contacts with bodies", "", contact.bodyContacts);
}

void ContactCloth::expectRest(double seconds) {
  constexpr double limit = 0.01;  // [m/s]
  const auto steps = std::lround(seconds / watched_.simulation().settings().step.timeStep);
  for (long i = 0; i < steps; ++i) {
    step();
    trial_.expect("speed at rest", "m/s", largestSpeed(watched_.state()), limit);
  }
}

}  // namespace drape::report::hardcases

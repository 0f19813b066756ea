#include "report/hardcases/momentum_kept.hpp"

#include "sim/motion/momentum.hpp"

namespace drape::report::hardcases {

void expectMomentumKept(CaseTrial& trial, WatchedCloth& watched, int parts, double limit) {
  const auto linearNow = [&] { return sim::linearMomentum(watched.model(), watched.state()); };
  const auto angularNow = [&] {
    return sim::angularMomentum(watched.model(), watched.state(), sim::barycentreOf(watched.model(), watched.state()));
  };
  const Vec3 linear = linearNow();
  const Vec3 angular = angularNow();
  for (int i = 0; i < parts; ++i) {
    watched.run(0.1);
    trial.expect("linear momentum lost", "of itself", (linearNow() - linear).norm() / linear.norm(), limit);
    trial.expect("angular momentum lost", "of itself", (angularNow() - angular).norm() / angular.norm(), limit);
  }
}

}  // namespace drape::report::hardcases

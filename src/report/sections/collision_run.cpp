#include "report/sections/collision_run.hpp"

#include "judge/intersections.hpp"
#include "report/timing.hpp"
#include "sim/stepper.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace drape {
namespace {

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, values.size()));
}

}  // namespace

CollisionRun runCollision(const Scene& scene, double seconds, int lookEvery, const std::function<void()>& mayStop) {
  CollisionRun run;
  const StepParameters& parameters = scene.settings.step;
  Stepper stepper(scene.settings.solver.name);
  ClothState state = scene.start;
  std::vector<double> steps;
  std::vector<double> contacts;
  std::vector<double> selfs;
  int looks = 0;
  int found = 0;
  while (state.time < seconds && run.finite) {
    mayStop();
    ContactReport contact;
    steps.push_back(secondsOf([&] { contact = stepper.step(*scene.model, parameters, {}, state).contact; }));
    contacts.push_back(contact.bodySeconds + contact.selfSeconds);
    selfs.push_back(contact.selfSeconds);
    run.contacts = std::max(run.contacts, contact.bodyContacts + contact.selfContacts);
    run.finite = isFinite(state);
    if (lookEvery > 0 && run.finite && static_cast<int>(steps.size()) % lookEvery == 0) {
      const auto pairs = static_cast<int>(intersectingPairs({state.positions, scene.model->triangles}).size());
      run.intersectingPairs = std::max(run.intersectingPairs, pairs);
      ++looks;
      found += pairs > 0 ? 1 : 0;
    }
  }
  run.steps = static_cast<int>(steps.size());
  run.stepSeconds = meanOf(steps);
  run.contactSeconds = meanOf(contacts);
  run.selfSeconds = meanOf(selfs);
  run.longestContact = quantileOf(contacts, 0.99);
  run.intersectingShare = static_cast<double>(found) / std::max(1, looks);
  return run;
}

}  // namespace drape

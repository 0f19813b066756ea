#include "report/jittered_start.hpp"

#include "report/hardcases/case_trial.hpp"
#include "sim/forces/diagnostics.hpp"

namespace drape::report {

std::shared_ptr<const scene::Scene> withJitteredStart(const std::shared_ptr<const scene::Scene>& scene, int start) {
  constexpr double share = 0.01;  // of the mean edge
  if (start == 0) {
    return scene;
  }
  auto moved = std::make_shared<scene::Scene>(*scene);
  const double size = share * sim::meanEdge(*scene->model);
  hardcases::CaseNumbers random(static_cast<std::uint64_t>(start));
  std::vector<Vec3>& positions = moved->start.positions;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double x = 2.0 * random.next() - 1.0;
    const double y = 2.0 * random.next() - 1.0;
    const double z = 2.0 * random.next() - 1.0;
    positions[v] += scene->model->pinned[v] ? Vec3::Zero().eval() : Vec3(size * Vec3(x, y, z));
  }
  return moved;
}

}  // namespace drape::report

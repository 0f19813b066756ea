#include "report/sections/table2_starts.hpp"

#include "report/sections/section_scene.hpp"
#include "report/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace drape::report::sections {
namespace {

/// The scene's sheet is level; here it is upright, with its back edge up.
Vec3 upright(const Vec3& rest, double) {
  return {rest.x(), -rest.z(), 0.0};
}

SetUp sheet(std::vector<std::string> corners, std::vector<std::string> edges) {
  SetUp setUp{"sheet", "", "grid"};
  setUp.corners = std::move(corners);
  setUp.edges = std::move(edges);
  return setUp;
}

Watch watchOf(const std::function<void()>& checkStop) {
  Watch watch;
  watch.progress = [&checkStop](std::string_view, std::int64_t, std::int64_t) { checkStop(); };
  return watch;
}

/// The rest state, from an upright start with a jitter of up to a millimetre so that it may fold: ten seconds with
/// thick air and damping.
sim::ClothState settled(const scene::Scene& scene, const std::function<void()>& checkStop) {
  constexpr double millimetre = 1e-3;
  constexpr double seconds = 10.0;
  const settings::Settings settings = changedSettings(
      scene, {"solver=pcg", "tolerance=1e-4", "time_step=1/60", "damping=0.05", "drag=5", "lift=0", "wind.x=0"});
  const Trajectory run =
      runTrajectory(*jittered(scene, millimetre, 1), settings, checkpointsIn(seconds), watchOf(checkStop));
  return sim::stateAtRest(run.states.back().positions);
}

/// Rotates the cloth about the line of its pins, which runs along x.
void tilt(const sim::ClothModel& model, sim::ClothState& state) {
  const auto pin =
      static_cast<std::size_t>(std::find(model.pinned.begin(), model.pinned.end(), true) - model.pinned.begin());
  const Vec3 axis = state.positions.at(pin);
  const double angle = startTilt * std::numbers::pi / 180.0;
  const Eigen::AngleAxisd turn(angle, Vec3::UnitX());
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (!model.pinned[v]) {
      state.positions[v] = axis + turn * Vec3(state.positions[v] - axis);
    }
  }
}

std::vector<Table2Start> allStarts() {
  const std::vector<std::string> twoCorners{"top_left", "top_right"};
  const std::vector<std::string> edge{"top"};
  std::vector<Table2Start> starts{
      {"flat, two corners", "lies flat at rest, two pinned corners", sheet(twoCorners, {})},
      {"flat, one corner", "lies flat at rest, one pinned corner", sheet({"top_left"}, {})},
      {"flat, edge", "lies flat at rest, one pinned edge", sheet({}, edge)},
      {"hanging, two corners", "hangs from two corners, tilted by 20 degrees, at rest", sheet(twoCorners, {}), true},
      {"hanging, edge", "hangs from an edge, tilted by 20 degrees, at rest", sheet({}, edge), true},
      {"swinging, two corners", "the start 'hanging, two corners' 0.4 s later, swinging", sheet(twoCorners, {}), true,
       0.4},
      {"swinging, edge", "the start 'hanging, edge' 0.4 s later, swinging", sheet({}, edge), true, 0.4},
      {"free fall", "lies flat at rest, without pins", sheet({}, {})}};
  for (Table2Start& start : starts) {
    start.setUp.place = start.hanging ? upright : nullptr;
  }
  starts.back().setUp.settings = {"pins=none"};
  return starts;
}

}  // namespace

const std::vector<Table2Start>& table2Starts() {
  static const std::vector<Table2Start> starts = allStarts();
  return starts;
}

settings::Settings paperReferenceSettings(const scene::Scene& scene) {
  return changedSettings(scene, {"solver=explicit_euler", std::string("time_step=") + paperReferenceStep});
}

std::shared_ptr<const scene::Scene> buildStart(const Table2Start& start, int resolution,
                                               const std::vector<std::string>& settings,
                                               const std::function<void()>& checkStop) {
  auto scene = buildSetUp(start.setUp, resolution, settings);
  if (start.hanging) {
    sim::ClothState state = settled(*scene, checkStop);
    tilt(*scene->model, state);
    scene = startedFrom(*scene, std::move(state));
  }
  if (start.swing > 0.0) {
    sim::ClothState state =
        runTrajectory(*scene, paperReferenceSettings(*scene), checkpointsIn(start.swing), watchOf(checkStop))
            .states.back();
    state.time = 0.0;
    scene = startedFrom(*scene, std::move(state));
  }
  return scene;
}

}  // namespace drape::report::sections

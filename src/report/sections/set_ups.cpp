#include "report/sections/set_ups.hpp"

#include "report/sections/section_scene.hpp"
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace drape::report::sections {
namespace {

/// An uneven deflection out of the plane, by 1/50 of the length in the middle. It determines the side to which the
/// cloth buckles; otherwise rounding errors would. `along` runs between the pinned edges, `across` along them.
double bend(double along, double across, double length) {
  return 0.02 * length * std::cos(std::numbers::pi * along / length) * (1.0 + 0.3 * across / length);
}

/// A sheet between two edges that are too close to each other.
Vec3 crushed(const Vec3& rest, double length) {
  return {0.95 * rest.x(), rest.y() + bend(rest.x(), rest.z(), length), rest.z()};
}

/// A sheet in the plane z = 0 with its upper edge rotated by 45 degrees against the lower one, about the axis through
/// their midpoints.
Vec3 twisted(const Vec3& standing, double length) {
  const Eigen::AngleAxisd turn(0.25 * std::numbers::pi * (standing.y() / length + 0.5), -Vec3::UnitY());
  return turn * Vec3(standing.x(), standing.y(), bend(standing.y(), standing.x(), length));
}

std::vector<SetUp> ownSetUps() {
  SetUp hang{"hang", "a flat sheet that falls from two pinned corners (the scene grid)", "grid"};
  SetUp flag{
      "flag",
      "a flag in the wind, with damping and with the drag and lift of a thin plate (the scene flag with springs)",
      "flag",
      {"material.model=springs", "air.model=plate", "stiffness=200", "damping=0.002", "density=0.1",
       "self_collision=off"}};
  SetUp crush{"crush", "a horizontal sheet, slightly bent, whose two pinned edges stand at 0.95 of its width", "grid"};
  crush.edges = {"left", "right"};
  crush.place = crushed;
  SetUp twist{
      "twist",
      "an upright sheet, slightly bent, pinned at its upper and lower edge, which are rotated against each other by "
      "45 degrees",
      "grid"};
  twist.edges = {"top", "bottom"};
  twist.place = [](const Vec3& rest, double length) {
    // The scene's sheet is level; here it is upright, with its back edge up.
    return twisted({rest.x(), -rest.z(), 0.0}, length);
  };
  SetUp tshirt{
      "tshirt",
      "a T-shirt of 2,014 vertices whose sleeves and body fall from its shoulders, without air and contact (the "
      "cloth of the scene mannequin)",
      "mannequin",
      {"drag=0", "lift=0", "damping=0", "self_collision=off"}};
  tshirt.top = scene::topOfBareMesh;
  SetUp shirtOfSprings = tshirt;
  shirtOfSprings.name = "tshirt_of_springs";
  shirtOfSprings.help = "the same T-shirt of springs, with damping";
  shirtOfSprings.settings = {"material.model=springs", "damping=0.003", "drag=0", "lift=0", "self_collision=off"};
  shirtOfSprings.cloths = {{0, "3e4"}};
  SetUp fourCorners{"four_corners", "a level sheet that is held at its four corners", "grid"};
  fourCorners.corners = {"top_left", "top_right", "bottom_left", "bottom_right"};
  fourCorners.cloths = {{25, "300"}, {49, "300"}, {49, "3e4"}};
  SetUp oneCorner{
      "one_corner", "a level sheet that falls from one pinned corner, with damping", "grid", {"damping=0.003"}};
  oneCorner.corners = {"top_left"};
  oneCorner.cloths = {{49, "3e4"}};
  SetUp oneEdge{"one_edge", "a level sheet that falls from one pinned edge", "grid"};
  oneEdge.edges = {"top"};
  oneEdge.cloths = {{25, "3e4"}};
  return {hang, flag, crush, twist, tshirt, fourCorners, oneCorner, oneEdge, shirtOfSprings};
}

Vec3 barycentreOf(const std::vector<Vec3>& positions) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& position : positions) {
    sum += position;
  }
  return sum / static_cast<double>(positions.size());
}

}  // namespace

std::shared_ptr<const scene::Scene> buildSetUp(const SetUp& setUp, int resolution,
                                               const std::vector<std::string>& settings) {
  std::vector<std::string> all = setUp.settings;
  all.insert(all.end(), settings.begin(), settings.end());
  scene::PinSelection pins;
  if (isMesh(setUp)) {
    pins.top = setUp.top;
    return meshScene(setUp.scene, all, pins);
  }
  pins.corners = setUp.corners;
  pins.edges = setUp.edges;
  const bool ownPins = !pins.corners.empty() || !pins.edges.empty();
  auto scene = ownPins ? gridScene(setUp.scene, resolution, all, pins) : gridScene(setUp.scene, resolution, all);
  if (setUp.place == nullptr) {
    return scene;
  }
  const settings::Settings::Grid& grid = scene->settings.grid;
  const double length = std::max(grid.width, grid.height);
  const Vec3 middle = barycentreOf(scene->model->restPositions);
  sim::ClothState start = scene->start;
  std::transform(scene->model->restPositions.begin(), scene->model->restPositions.end(), start.positions.begin(),
                 [&](const Vec3& rest) -> Vec3 { return middle + setUp.place(rest - middle, length); });
  return startedFrom(*scene, std::move(start));
}

std::shared_ptr<const scene::Scene> startedFrom(const scene::Scene& scene, sim::ClothState start) {
  auto changed = std::make_shared<scene::Scene>(scene);
  changed->start = std::move(start);
  return changed;
}

std::shared_ptr<const scene::Scene> jittered(const scene::Scene& scene, double amplitude, unsigned seed) {
  // The engine gives the same numbers everywhere; the library's distributions do not.
  std::mt19937 random(seed);
  const auto offset = [&] { return amplitude * (2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0); };
  sim::ClothState start = scene.start;
  for (std::size_t v = 0; v < start.positions.size(); ++v) {
    const Vec3 move(offset(), offset(), offset());
    start.positions[v] += scene.model->pinned[v] ? Vec3::Zero() : move;
  }
  return startedFrom(scene, std::move(start));
}

std::vector<SetUp> comparedSetUps(const std::string& name) {
  std::vector<SetUp> own = ownSetUps();
  if (name.empty()) {
    return own;
  }
  const auto found = std::find_if(own.begin(), own.end(), [&](const SetUp& setUp) { return setUp.name == name; });
  if (found != own.end()) {
    return {*found};
  }
  requireGrid(name);
  // Not every method takes a fabric.
  return {SetUp{name, "the scene " + name + " with springs", name, {"material.model=springs"}}};
}

}  // namespace drape::report::sections

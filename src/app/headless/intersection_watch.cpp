#include "app/headless/intersection_watch.hpp"

#include "judge/intersections.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>

namespace drape {
namespace {

/// A body's surface as it is now, in the world.
BodySurface placed(const BodyWorld& world, std::size_t body) {
  BodySurface surface = surfaceOf(world.bodies()[body].shape);
  const auto vertices = world.vertices(body);
  if (!vertices.empty()) {
    surface.positions.assign(vertices.begin(), vertices.end());
  }
  for (Vec3& position : surface.positions) {
    position = world.pose(body).toWorld(position);
  }
  return surface;
}

/// Pairs of a cloth's and the bodies' triangles. A plane is all that lies under it, not the square that is drawn.
std::size_t pairsWithBodies(const Surface& cloth, const BodyWorld& world) {
  std::size_t pairs = 0;
  BodySurface solids;
  for (std::size_t body = 0; body < world.bodies().size(); ++body) {
    if (!world.isOn(body)) {
      continue;
    }
    const BodySurface surface = placed(world, body);
    if (std::holds_alternative<PlaneShape>(world.bodies()[body].shape)) {
      pairs += trianglesReaching(cloth, {surface.positions[0], surface.positions[1], surface.positions[2]}).size();
      continue;
    }
    const auto first = static_cast<int>(solids.positions.size());
    solids.positions.insert(solids.positions.end(), surface.positions.begin(), surface.positions.end());
    for (const Triangle& t : surface.triangles) {
      solids.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return pairs + intersectingPairs(cloth, Surface{solids.positions, solids.triangles}).size();
}

}  // namespace

void IntersectionWatch::Tally::add(std::int64_t step, std::size_t count) {
  last = count;
  if (count > most) {
    most = count;
    worstStep = step;
  }
}

nlohmann::ordered_json IntersectionWatch::Tally::toJson() const {
  return {{"max", most},
          {"final", last},
          {"worst_step", most > 0 ? nlohmann::ordered_json(worstStep) : nlohmann::ordered_json(nullptr)}};
}

void IntersectionWatch::observe(const Simulation& simulation) {
  if (simulation.stepIndex() % every_ == 0) {
    count(simulation);
  }
}

void IntersectionWatch::finish(const Simulation& simulation) {
  if (simulation.stepIndex() != lastStep_) {
    count(simulation);
  }
}

void IntersectionWatch::count(const Simulation& simulation) {
  const auto start = std::chrono::steady_clock::now();
  const Surface cloth{simulation.state().positions, simulation.model().triangles};
  const std::size_t self = intersectingPairs(cloth).size();
  const std::size_t bodies = pairsWithBodies(cloth, simulation.bodies());
  seconds_.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  lastStep_ = simulation.stepIndex();
  all_.add(lastStep_, self + bodies);
  self_.add(lastStep_, self);
  bodies_.add(lastStep_, bodies);
}

void IntersectionWatch::addTo(nlohmann::ordered_json& json) const {
  constexpr double microseconds = 1e6;
  const nlohmann::ordered_json all = all_.toJson();
  json["intersecting_pairs_max"] = all["max"];
  json["intersecting_pairs_final"] = all["final"];
  json["intersecting_pairs_worst_step"] = all["worst_step"];
  json["intersecting_pairs_self"] = self_.toJson();
  json["intersecting_pairs_bodies"] = bodies_.toJson();
  json["intersection_checks"] = seconds_.size();
  std::vector<double> sorted = seconds_;
  std::sort(sorted.begin(), sorted.end());
  json["intersection_check_us"] = {{"median", sorted[(sorted.size() - 1) / 2] * microseconds},
                                   {"max", sorted.back() * microseconds}};
}

std::string IntersectionWatch::summary() const {
  std::ostringstream text;
  text << "intersecting triangle pairs: ";
  if (all_.most == 0) {
    text << "none";
  } else {
    text << "at most " << all_.most << " (step " << all_.worstStep << "), " << all_.last << " at the end; with bodies ";
    if (bodies_.most == 0) {
      text << "none";
    } else {
      text << "at most " << bodies_.most << " (step " << bodies_.worstStep << "), " << bodies_.last << " at the end";
    }
  }
  text << ", by " << seconds_.size() << (seconds_.size() == 1 ? " check" : " checks");
  return text.str();
}

}  // namespace drape

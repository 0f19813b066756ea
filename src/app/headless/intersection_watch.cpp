#include "app/headless/intersection_watch.hpp"

#include "intersection/intersections.hpp"
#include "report/body_intersections.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>

namespace drape {

void IntersectionWatch::Tally::add(std::int64_t step, std::size_t count) {
  last = count;
  if (count > max) {
    max = count;
    worstStep = step;
  }
}

nlohmann::ordered_json IntersectionWatch::Tally::toJson() const {
  return {{"max", max},
          {"final", last},
          {"worst_step", max > 0 ? nlohmann::ordered_json(worstStep) : nlohmann::ordered_json(nullptr)}};
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
  const std::vector<Vec3>& positions = simulation.state().positions;
  const std::vector<Triangle>& triangles = simulation.model().triangles;
  const std::size_t self = intersectingPairs({positions, triangles}).size();
  const std::size_t bodies = pairsWithBodies(positions, triangles, simulation.bodies());
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
  if (all_.max == 0) {
    text << "none";
  } else {
    text << "at most " << all_.max << " (step " << all_.worstStep << "), " << all_.last << " at the end; with bodies ";
    if (bodies_.max == 0) {
      text << "none";
    } else {
      text << "at most " << bodies_.max << " (step " << bodies_.worstStep << "), " << bodies_.last << " at the end";
    }
  }
  text << ", by " << seconds_.size() << (seconds_.size() == 1 ? " check" : " checks");
  return text.str();
}

}  // namespace drape

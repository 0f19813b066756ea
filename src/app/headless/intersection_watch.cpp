#include "app/headless/intersection_watch.hpp"

#include "intersection/intersections.hpp"
#include "report/body_intersections.hpp"
#include "sim/model/seconds_since.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <chrono>

namespace drape::app {

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

void IntersectionWatch::observe(const session::Simulation& simulation) {
  if (simulation.stepIndex() % every_ == 0) {
    count(simulation);
  }
}

void IntersectionWatch::finish(const session::Simulation& simulation) {
  if (simulation.stepIndex() != lastStep_) {
    count(simulation);
  }
}

void IntersectionWatch::count(const session::Simulation& simulation) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Vec3>& positions = simulation.state().positions;
  const std::vector<Triangle>& triangles = simulation.model().triangles;
  const std::size_t self = intersection::intersectingPairs({positions, triangles}).size();
  const std::size_t bodies = report::pairsWithBodies(positions, triangles, simulation.bodies());
  seconds_.push_back(sim::secondsSince(start));
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

std::string IntersectionWatch::Tally::text() const {
  return max == 0 ? "none" : fmt::format("at most {} (step {}), {} at the end", max, worstStep, last);
}

std::string IntersectionWatch::summary() const {
  return fmt::format("intersecting triangle pairs: {}{}, by {} {}", all_.text(),
                     all_.max == 0 ? "" : "; with bodies " + bodies_.text(), seconds_.size(),
                     seconds_.size() == 1 ? "check" : "checks");
}

}  // namespace drape::app

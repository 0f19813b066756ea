#include "app/headless/intersection_watch.hpp"

#include "judge/intersections.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>

namespace drape {

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
  last_ = intersectingPairs(cloth).size();
  seconds_.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  lastStep_ = simulation.stepIndex();
  if (last_ > most_) {
    most_ = last_;
    worstStep_ = lastStep_;
  }
}

void IntersectionWatch::addTo(nlohmann::ordered_json& json) const {
  constexpr double microseconds = 1e6;
  json["intersecting_pairs_max"] = most_;
  json["intersecting_pairs_final"] = last_;
  json["intersecting_pairs_worst_step"] = most_ > 0 ? nlohmann::ordered_json(worstStep_) : nullptr;
  json["intersection_checks"] = seconds_.size();
  std::vector<double> sorted = seconds_;
  std::sort(sorted.begin(), sorted.end());
  json["intersection_check_us"] = {{"median", sorted[(sorted.size() - 1) / 2] * microseconds},
                                   {"max", sorted.back() * microseconds}};
}

std::string IntersectionWatch::summary() const {
  std::ostringstream text;
  text << "intersecting triangle pairs: ";
  if (most_ == 0) {
    text << "none";
  } else {
    text << "at most " << most_ << " (step " << worstStep_ << "), " << last_ << " at the end";
  }
  text << ", by " << seconds_.size() << (seconds_.size() == 1 ? " check" : " checks");
  return text.str();
}

}  // namespace drape

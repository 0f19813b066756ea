#include "dressing/shrinking_body.hpp"

#include "dressing/heat_flow.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <utility>

namespace drape::dressing {
namespace {

// Times of diffusion, for a body whose box has this longest side: that of a person. They scale with its square.
constexpr double usualSide = 1.75;        // [m]
constexpr double firstTime = 2e-5;        // [m^2] an arm loses half a millimetre
constexpr double lastTime = 0.03;         // [m^2] a trunk keeps about a quarter of its width
constexpr double centreLineTime = 0.008;  // [m^2] an arm keeps 1 % of its width, a leg 30 %
constexpr double timeRatio = 1.25;        // of successive frames
constexpr int framesOfFactorisation = 4;  // that take the same time step

double largestMotion(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  double largest = 0.0;
  for (std::size_t v = 0; v < from.size(); ++v) {
    largest = std::max(largest, (to[v] - from[v]).norm());
  }
  return largest;
}

/// Goes through frames backwards, at a bounded speed, and stays at the full body.
class Growth final : public sim::contact::Deformation {
 public:
  /// @param times when each frame is reached [s]: descending, 0 for the last one
  Growth(std::vector<std::vector<Vec3>> frames, std::vector<double> times)
      : frames_(std::move(frames)), times_(std::move(times)) {}

  void positionsAt(double time, std::vector<Vec3>& positions) const override {
    std::size_t later = frames_.size() - 1;
    while (later > 0 && times_[later] < time) {
      --later;
    }
    positions = frames_[later];
    if (later + 1 < frames_.size() && time < times_[later]) {
      const double share = (times_[later] - time) / (times_[later] - times_[later + 1]);
      for (std::size_t v = 0; v < positions.size(); ++v) {
        positions[v] += share * (frames_[later + 1][v] - positions[v]);
      }
    }
  }

 private:
  std::vector<std::vector<Vec3>> frames_;
  std::vector<double> times_;
};

}  // namespace

ShrinkingBody::ShrinkingBody(sim::ClothMesh body) : triangles_(std::move(body.triangles)), ways_{0.0} {
  body.triangles = triangles_;
  const double side = sim::boundsOf(body.positions).sizes().maxCoeff();
  const double scale = side * side / (usualSide * usualSide);
  HeatFlow flow(body);
  frames_.push_back(std::move(body.positions));
  double step = firstTime;
  for (double time = 0.0; time < lastTime;) {
    if ((frames_.size() - 1) % framesOfFactorisation == 0) {
      step = std::max(firstTime, (timeRatio - 1.0) * time);
      flow.setTimeStep(scale * step);
    }
    time += step;
    frames_.push_back(flow.advance(frames_.back()));
    ways_.push_back(ways_.back() + largestMotion(frames_[frames_.size() - 2], frames_.back()));
    if (time <= centreLineTime) {
      centreLines_ = frames_.size() - 1;
    }
  }
}

ShrinkingBody ShrinkingBody::withFrames(std::vector<std::vector<Vec3>> frames) const {
  ShrinkingBody other = *this;
  other.frames_ = std::move(frames);
  for (std::size_t k = 1; k < other.frames_.size(); ++k) {
    other.ways_[k] = other.ways_[k - 1] + largestMotion(other.frames_[k - 1], other.frames_[k]);
  }
  return other;
}

std::shared_ptr<const sim::contact::MeshShape> ShrinkingBody::growingFrom(std::size_t frame, double speed) const {
  std::vector<double> times;
  for (std::size_t k = 0; k <= frame; ++k) {
    times.push_back((ways_[frame] - ways_[k]) / speed);
  }
  auto shape = std::make_shared<sim::contact::MeshShape>();
  shape->positions = frames_[frame];
  shape->triangles = triangles_;
  shape->deformation = std::make_shared<Growth>(
      std::vector<std::vector<Vec3>>(frames_.begin(), frames_.begin() + static_cast<std::ptrdiff_t>(frame) + 1), times);
  return shape;
}

}  // namespace drape::dressing

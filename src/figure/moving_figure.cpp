#include "figure/moving_figure.hpp"

#include "figure/periodic_curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace drape::figure {
namespace {

constexpr double fullTurn = 360.0;  // [degrees]

FigureShape between(const FigureShape& first, const FigureShape& second, double fraction) {
  FigureShape result;
  for (std::size_t j = 0; j < jointCount; ++j) {
    result.places[j] = (1.0 - fraction) * first.places[j] + fraction * second.places[j];
  }
  result.positions.resize(first.positions.size());
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    result.positions[v] = (1.0 - fraction) * first.positions[v] + fraction * second.positions[v];
  }
  return result;
}

/// How far a blend is that began at a time.
double shareAt(double time, double start) {
  return smoothStep((time - start) / blendTime);
}

}  // namespace

bool isAllowed(const FigureOptions& options) {
  const auto inRange = [&](const ProportionInfo& each) {
    const std::optional<double>& size = options.proportions.*each.value;
    return !size || (*size >= each.min && *size <= each.max);
  };
  return options.motion != nullptr && options.speed >= minSpeed && options.speed <= maxSpeed &&
         std::ranges::all_of(proportionTable(), inRange);
}

double MovingFigure::Part::cyclesAt(double time) const {
  return cycles + (time - start) * options.speed / options.motion->period;
}

FigurePose MovingFigure::Part::poseAt(double time, const PerJoint<Vec3>& places) const {
  const double now = cyclesAt(time);
  FigurePose pose = options.motion->pose(places, fractionOf(now));
  pose.heading += heading + fullTurn * options.motion->turns * std::floor(now);
  return pose;
}

MovingFigure::MovingFigure(std::vector<Vec3> positions, std::vector<Triangle> triangles, const FigureOptions& options) {
  auto base = std::make_shared<Base>();
  base->weights = smoothWeights(positions, triangles);
  base->triangles = std::move(triangles);
  base->shape = {restPlaces(), std::move(positions)};
  base->measures = measured(base->shape, base->triangles, base->weights);
  parts_.push_back({0.0, 0.0, 0.0, options, sized(*base, options.proportions)});
  base_ = std::move(base);
}

MovingFigure::MovingFigure(std::shared_ptr<const Base> base, std::vector<Part> parts)
    : base_(std::move(base)), parts_(std::move(parts)) {}

std::shared_ptr<const FigureShape> MovingFigure::sized(const Base& base, const Proportions& proportions) {
  return std::make_shared<FigureShape>(withProportions(base.shape, base.triangles, base.weights, proportions));
}

/// The last part whose blend is complete, which hides those before it; else the first one.
std::vector<MovingFigure::Part>::const_iterator MovingFigure::firstActing(double time) const {
  const auto complete =
      std::find_if(parts_.rbegin(), parts_.rend(), [&](const Part& part) { return shareAt(time, part.start) >= 1.0; });
  return complete == parts_.rend() ? parts_.begin() : std::prev(complete.base());
}

/// Each part blends from the result of those before it. Sizes come first, since poses need the joints.
MovingFigure::Stage MovingFigure::stageAt(double time) const {
  const auto first = firstActing(time);
  Stage stage{std::shared_ptr<const FigureShape>(base_, &base_->shape), {}};
  for (auto part = first; part != parts_.end(); ++part) {
    const double share = shareAt(time, part->start);
    if (share >= 1.0) {
      stage.shape = part->shape;
    } else if (share > 0.0 && part->shape != stage.shape) {
      stage.shape = std::make_shared<FigureShape>(between(*stage.shape, *part->shape, share));
    }
  }
  for (auto part = first; part != parts_.end(); ++part) {
    stage.pose = blended(stage.pose, part->poseAt(time, stage.shape->places), shareAt(time, part->start));
  }
  return stage;
}

void MovingFigure::positionsAt(double time, std::vector<Vec3>& positions) const {
  if (!(time > 0.0)) {
    positions = base_->shape.positions;
    return;
  }
  positions.resize(base_->shape.positions.size());
  const Stage stage = stageAt(time);
  moveSkin(stage.shape->places, jointPoses(stage.shape->places, stage.pose), base_->weights, stage.shape->positions,
           positions);
}

std::shared_ptr<const MovingFigure> MovingFigure::changed(double time, const FigureOptions& options) const {
  if (!(time > parts_.front().start)) {
    return restarted(options);
  }
  std::vector<Part> parts(firstActing(time), parts_.end());
  const auto isLater = [&](const Part& part) { return part.start >= time && part.start > 0.0; };
  parts.erase(std::find_if(parts.begin(), parts.end(), isLater), parts.end());
  const Part& before = parts.back();
  Part next{time, 0.0, 0.0, options, before.shape};
  if (options.motion == before.options.motion) {
    next.cycles = before.cyclesAt(time);
  }
  if (options.proportions != before.options.proportions) {
    next.shape = sized(*base_, options.proportions);
  }
  // It turns the shorter way to the heading of the new motion.
  const double away = stageAt(time).pose.heading - next.poseAt(time, base_->shape.places).heading;
  next.heading = fullTurn * std::round(away / fullTurn);
  parts.push_back(std::move(next));
  return std::shared_ptr<const MovingFigure>(new MovingFigure(base_, std::move(parts)));
}

std::shared_ptr<const MovingFigure> MovingFigure::restarted(const FigureOptions& options) const {
  return std::shared_ptr<const MovingFigure>(
      new MovingFigure(base_, {Part{0.0, 0.0, 0.0, options, sized(*base_, options.proportions)}}));
}

std::shared_ptr<const sim::contact::MeshShape> movingFigure(std::vector<Vec3> positions,
                                                            std::vector<Triangle> triangles,
                                                            const FigureOptions& options) {
  auto shape = std::make_shared<sim::contact::MeshShape>();
  shape->positions = std::move(positions);
  shape->triangles = std::move(triangles);
  shape->deformation = std::make_shared<MovingFigure>(shape->positions, shape->triangles, options);
  return shape;
}

std::shared_ptr<const MovingFigure> asFigure(const std::shared_ptr<const sim::contact::Deformation>& deformation) {
  return std::dynamic_pointer_cast<const MovingFigure>(deformation);
}

}  // namespace drape::figure

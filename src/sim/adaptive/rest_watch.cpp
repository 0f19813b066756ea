#include "sim/adaptive/rest_watch.hpp"

#include "sim/contact/bodies/body.hpp"
#include "sim/contact/contact_stage.hpp"
#include "sim/diagnostics.hpp"
#include "sim/kernels.hpp"
#include "sim/normals.hpp"
#include "sim/pieces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>

namespace drape {
namespace {

constexpr double ofTolerance = 0.1;
constexpr double ofEdge = 1e-3;
constexpr double restingTime = 1.0;  // [s]
/// A cloth that moves is looked at every so many steps.
constexpr int lookEvery = 16;

/// Fowler, Noll and Vo's hash, 64 bits at a time.
class Mark {
 public:
  void add(std::uint64_t bits) { value_ = (value_ ^ bits) * 0x100000001b3ULL; }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& value) {
    for (int c = 0; c < 3; ++c) {
      add(value[c]);
    }
  }
  void add(const Pose& pose) {
    add(pose.position);
    for (int c = 0; c < 4; ++c) {
      add(pose.rotation.coeffs()[c]);
    }
  }
  /// Never 0, which stands for none.
  [[nodiscard]] std::uint64_t value() const { return std::max<std::uint64_t>(1, value_); }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

bool standsStill(const BodyStep& body) {
  return body.start.position == body.end.position && body.start.rotation.coeffs() == body.end.rotation.coeffs() &&
         std::equal(body.startVertices.begin(), body.startVertices.end(), body.endVertices.begin(),
                    body.endVertices.end());
}

/// Whether every vertex is within that distance [m] of where it was.
bool areNear(const std::vector<Vec3>& places, const std::vector<Vec3>& before, double distance) {
  return places.size() == before.size() &&
         std::equal(places.begin(), places.end(), before.begin(),
                    [&](const Vec3& a, const Vec3& b) { return (a - b).squaredNorm() <= distance * distance; });
}

/// Weight and the air's force on a vertex that does not move [N].
Vec3 pushOn(const ClothModel& model, const StepParameters& parameters, const std::vector<Vec3>& positions,
            std::size_t vertex) {
  Vec3 weight(0.0, -model.vertexMass[vertex] * parameters.gravity, 0.0);
  const double speed = parameters.wind.norm();
  if (speed == 0.0 || (parameters.drag == 0.0 && parameters.lift == 0.0)) {
    return weight;
  }
  const double area = model.vertexArea[vertex];
  const double pressureArea = 0.5 * parameters.airDensity * area;
  const Vec3 normal = vertexNormal(model, positions, static_cast<int>(vertex));
  const Vec3 heading = -parameters.wind / speed;
  return weight + kernels::dragForce(normal, speed, heading, pressureArea * parameters.drag) +
         kernels::risingLiftForce(normal, speed, heading, pressureArea * parameters.lift,
                                  kernels::liftRise(parameters.airDensity) * area);
}

/// Where weight and air take a piece as a whole in a hundredth of a second: 0.5 mm down in still air [m].
Vec3 moveOf(const ClothModel& model, const StepParameters& parameters, const std::vector<Vec3>& positions,
            const std::vector<std::size_t>& piece) {
  constexpr double seconds = 0.01;
  Vec3 force = Vec3::Zero();
  double mass = 0.0;
  for (const std::size_t v : piece) {
    force += pushOn(model, parameters, positions, v);
    mass += model.vertexMass[v];
  }
  return 0.5 * seconds * seconds / mass * force;
}

/// Whether contact took a tenth of a piece's move back at one of its vertices at least.
bool isTakenBack(const std::vector<std::size_t>& piece, const Vec3& move, const std::vector<Vec3>& before,
                 const std::vector<Vec3>& after) {
  constexpr double left = 0.9;
  return std::any_of(piece.begin(), piece.end(),
                     [&](std::size_t v) { return (after[v] - before[v]).dot(move) < left * move.squaredNorm(); });
}

bool isAsLeft(const ClothState& state) {
  return state.positions == *state.memory.anchor &&
         std::all_of(state.velocities.begin(), state.velocities.end(), [](const Vec3& v) { return v.isZero(0.0); });
}

}  // namespace

bool RestWatch::holds(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                      ClothState& state) {
  const Facts& facts = facts_.get(model, factsOf);
  StepMemory& memory = state.memory;
  if (!canRest(facts, parameters, inputs)) {
    memory.anchor.reset();
    memory.restsWith = 0;
    return false;
  }
  if (memory.restsWith != 0) {
    if (isAsLeft(state) && memory.restsWith == markOf(facts, parameters, inputs)) {
      return true;
    }
    memory.anchor.reset();
    memory.restsWith = 0;
  }
  const double distance = std::min(ofTolerance * parameters.errorTolerance, ofEdge * facts.meanEdge);
  if (memory.anchor == nullptr || !areNear(state.positions, *memory.anchor, distance)) {
    memory.anchor.reset();
    if (memory.steps % lookEvery == 0) {
      memory.anchor = std::make_shared<const std::vector<Vec3>>(state.positions);
      memory.anchorTime = state.time;
    }
    return false;
  }
  if (state.time < memory.anchorTime + restingTime) {
    return false;
  }
  if (!isCarried(model, facts, parameters, inputs, state)) {
    memory.anchor.reset();
    return false;
  }
  std::fill(state.velocities.begin(), state.velocities.end(), Vec3::Zero());
  memory.anchor = std::make_shared<const std::vector<Vec3>>(state.positions);
  memory.restsWith = markOf(facts, parameters, inputs);
  return true;
}

/// Free cloth stays in one place only where there is something that may carry it.
bool RestWatch::canRest(const Facts& facts, const StepParameters& parameters, const StepInputs& inputs) {
  const bool fades = parameters.damping > 0.0 || parameters.drag > 0.0;
  const bool held = facts.freePieces.empty() || meetsBodies(parameters, inputs);
  const bool still = inputs.bodies == nullptr || std::all_of(inputs.bodies->begin(), inputs.bodies->end(), standsStill);
  return fades && held && still && !inputs.attachment;
}

/// A trial: every free piece is moved a little to where weight and air push it. It is carried when contact with bodies
/// takes that back. Cloth that lies on other cloth counts as moving: self-collision never lets it lie quite still.
bool RestWatch::isCarried(const ClothModel& model, const Facts& facts, const StepParameters& parameters,
                          const StepInputs& inputs, const ClothState& state) {
  if (facts.freePieces.empty()) {
    return true;
  }
  ClothState trial = state;
  std::vector<Vec3> moves;
  for (const std::vector<std::size_t>& piece : facts.freePieces) {
    moves.push_back(moveOf(model, parameters, state.positions, piece));
    for (const std::size_t v : piece) {
      trial.positions[v] += moves.back();
      trial.velocities[v] = moves.back() / parameters.timeStep;
    }
  }
  StepParameters withBodies = parameters;
  withBodies.contact.self = SelfCollision::Off;
  contact_.begin(withBodies, inputs, state);
  static_cast<void>(contact_.resolve(model, withBodies, inputs, trial));
  std::size_t carried = 0;
  while (carried < moves.size() &&
         isTakenBack(facts.freePieces[carried], moves[carried], state.positions, trial.positions)) {
    ++carried;
  }
  return carried == moves.size();
}

RestWatch::Facts RestWatch::factsOf(const ClothModel& model) {
  Facts facts;
  facts.freePieces = freePieces(model);
  facts.meanEdge = meanEdge(model);
  Mark mark;
  for (std::size_t i = 0; i < model.vertexMass.size(); ++i) {
    mark.add(model.vertexMass[i]);
    mark.add(std::uint64_t{model.pinned[i]});
  }
  for (const Spring& spring : model.springs) {
    mark.add(static_cast<std::uint64_t>(spring.a));
    mark.add(static_cast<std::uint64_t>(spring.b));
    mark.add(spring.restLength);
    mark.add(spring.relativeStiffness);
  }
  facts.mark = mark.value();
  return facts;
}

std::uint64_t RestWatch::markOf(const Facts& facts, const StepParameters& parameters, const StepInputs& inputs) {
  Mark mark;
  mark.add(facts.mark);
  const ContactParameters& contact = parameters.contact;
  for (const double value : {parameters.stiffness, parameters.damping, parameters.gravity, parameters.drag,
                             parameters.lift, parameters.airDensity, parameters.errorTolerance, contact.thickness,
                             contact.selfThickness, contact.staticFriction, contact.kineticFriction}) {
    mark.add(value);
  }
  mark.add(parameters.wind);
  mark.add(std::uint64_t{contact.bodies});
  mark.add(static_cast<std::uint64_t>(contact.self));
  if (inputs.bodies != nullptr) {
    for (const BodyStep& body : *inputs.bodies) {
      mark.add(body.start);
      mark.add(body.surface.thickness);
      mark.add(body.surface.staticFriction);
      mark.add(body.surface.kineticFriction);
      std::for_each(body.startVertices.begin(), body.startVertices.end(), [&](const Vec3& v) { mark.add(v); });
    }
  }
  return mark.value();
}

}  // namespace drape

#include "sim/simd/constraint_run.hpp"

#include "sim/simd/step_origin.hpp"
#include "sim/simd/step_share.hpp"

#include <algorithm>
#include <array>

namespace drape::sim::simd {
namespace {

/// Minimum number of batches of one colour for a thread: about 2 microseconds of work.
constexpr int minBatchesPerThread = 64;

/// The work of one thread in some steps. All threads run the same stages and wait for each other between them.
class XpbdMember {
 public:
  XpbdMember(const ClothModel& model, const CommonParameters& parameters, ConstraintLanes& lanes, ThreadTeam& team,
             int member, int members)
      : model_(model),
        parameters_(parameters),
        lanes_(lanes),
        team_(team),
        member_(member),
        members_(members),
        range_(LaneRange{0, lanes.vertexCount()}.partOf(member, members)),
        timeStep_(static_cast<float>(parameters.timeStep)) {}

  void load(const ClothState& state) { loadVertices(model_, state, lanes_, range_); }
  void store(ClothState& state) const { storeVertices(model_, lanes_, state, range_); }

  void predict(ClothState& state) {
    if (!parameters_.air.acts()) {
      predictVertices(lanes_, timeStep_, static_cast<float>(parameters_.gravity), range_);
    } else {
      store(state);
      team_.arriveAndWait();
      predictWithAir(model_, parameters_, state, lanes_, range_);
    }
    team_.arriveAndWait();
  }

  void project(bool first) {
    const double h = parameters_.timeStep;
    eachColour([&](LaneRange part) {
      projectSprings(lanes_, static_cast<float>(h * h * parameters_.material.stiffness), first, part);
    });
  }

  void findVelocities() {
    velocitiesFromVertices(lanes_, timeStep_, range_);
    team_.arriveAndWait();
    if (parameters_.material.damping > 0.0) {
      eachColour([&](LaneRange part) {
        dampSprings(lanes_, static_cast<float>(parameters_.timeStep * parameters_.material.damping), part);
      });
    }
  }

 private:
  template <typename Visit>
  void eachColour(Visit&& visit) {
    for (std::size_t colour = 0; colour < static_cast<std::size_t>(lanes_.colours()); ++colour) {
      visit(LaneRange{lanes_.colourBegin[colour], lanes_.colourBegin[colour + 1]}.partOf(member_, members_));
      team_.arriveAndWait();
    }
  }

  const ClothModel& model_;
  const CommonParameters& parameters_;
  ConstraintLanes& lanes_;
  ThreadTeam& team_;
  int member_;
  int members_;
  LaneRange range_;
  float timeStep_;
};

/// Moves the corners of the attachment's triangle.
void projectAttachment(const ClothModel& model, double timeStep, const Attachment& attachment,
                       AttachmentConstraint& constraint, ConstraintLanes& lanes) {
  const AttachedCorners corners = attachedCorners(model, attachment);
  const auto lanesOf = [&](std::size_t vertex) {
    return lanes.vertices.data() + 4 * static_cast<std::size_t>(lanes.indexOf[vertex]);
  };
  const auto inverseMassOf = [&](std::size_t vertex) { return static_cast<double>(lanesOf(vertex)[3]); };
  const auto& [a, b, c] = corners.vertices;
  const Vec3 offset = corners.subtracted(attachment.target, [&](std::size_t vertex) {
    return Vec3(lanes.origin + Eigen::Map<const Eigen::Vector3f>(lanesOf(vertex)).cast<double>());
  });
  const auto moves =
      constraint.correct(attachment, corners, timeStep, offset, {inverseMassOf(a), inverseMassOf(b), inverseMassOf(c)});
  for (std::size_t corner = 0; corner < 3; ++corner) {
    Eigen::Map<Eigen::Vector3f>(lanesOf(corners.vertices[corner])) += moves[corner].cast<float>();
  }
}

}  // namespace

void ConstraintRun::xpbd(const ClothModel& model, const CommonParameters& parameters, int iterations,
                         const StepInputs& inputs, int count, ClothState& state) {
  ConstraintLanes& lanes = lanes_.get(model, [](const ClothModel& m) { return ConstraintLanes(m); });
  lanes.origin = stepOrigin<float>(state.positions);
  const int batchesAColour = static_cast<int>(lanes.batches.size()) / std::max(1, lanes.colours());
  const int threads = usefulThreads(batchesAColour, minBatchesPerThread, parameters.threads);
  team_.run(threads, [&](int member) {
    XpbdMember part(model, parameters, lanes, team_, member, threads);
    part.load(state);
    team_.arriveAndWait();
    for (int i = 0; i < count; ++i) {
      part.predict(state);
      if (member == 0) {
        attachment_ = {};
      }
      for (int iteration = 0; iteration < iterations; ++iteration) {
        part.project(iteration == 0);
        if (inputs.attachment) {
          if (member == 0) {
            projectAttachment(model, parameters.timeStep, *inputs.attachment, attachment_, lanes);
          }
          team_.arriveAndWait();
        }
      }
      part.findVelocities();
    }
    part.store(state);
  });
  state.time += count * parameters.timeStep;
}

}  // namespace drape::sim::simd

#include "sim/simd/constraint_run.hpp"

#include "sim/simd/step_share.hpp"

#include <algorithm>
#include <array>

namespace drape {
namespace {

/// Fewest batches of one colour for a thread: about 2 microseconds of work.
constexpr int minBatchesPerThread = 64;

/// The work of one thread in some steps. All threads run the same stages and wait for each other between them.
class XpbdMember {
 public:
  XpbdMember(const ClothModel& model, const StepParameters& parameters, ConstraintLanes& lanes, ThreadTeam& team,
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
    if (parameters_.drag == 0.0 && parameters_.lift == 0.0) {
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
      projectSprings(lanes_, static_cast<float>(h * h * parameters_.stiffness), first, part);
    });
  }

  void findVelocities() {
    velocitiesFromVertices(lanes_, timeStep_, range_);
    team_.arriveAndWait();
    if (parameters_.damping > 0.0) {
      eachColour([&](LaneRange part) {
        dampSprings(lanes_, static_cast<float>(parameters_.timeStep * parameters_.damping), part);
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
  const StepParameters& parameters_;
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
  std::array<float*, 3> corners{};
  Vec3 offset = attachment.target;
  double inverseMass = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto v = static_cast<std::size_t>(model.triangles[static_cast<std::size_t>(attachment.triangle)][c]);
    float* const x = lanes.vertices.data() + 4 * static_cast<std::size_t>(lanes.indexOf[v]);
    const double weight = attachment.barycentric[static_cast<Eigen::Index>(c)];
    offset -= weight * Vec3(static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2]));
    inverseMass += weight * weight * static_cast<double>(x[3]);
    corners[c] = x;
  }
  const Vec3 change = constraint.correct(attachment, timeStep, offset, inverseMass);
  for (std::size_t c = 0; c < 3; ++c) {
    const double share = attachment.barycentric[static_cast<Eigen::Index>(c)] * static_cast<double>(corners[c][3]);
    for (std::size_t k = 0; k < 3; ++k) {
      corners[c][k] += static_cast<float>(share * change[static_cast<Eigen::Index>(k)]);
    }
  }
}

}  // namespace

void ConstraintRun::xpbd(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                         ClothState& state) {
  ConstraintLanes& lanes = lanes_.get(model, [](const ClothModel& m) { return ConstraintLanes(m); });
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
      for (int iteration = 0; iteration < parameters.iterations; ++iteration) {
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

}  // namespace drape

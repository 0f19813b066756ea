// Contact in built-in scenes: the time of contact for a thousand triangles of the cloth and a contact substep, the time
// of whole scenes on one and two threads, the time of cloth at rest, and memory.
#include "bench/heap.hpp"
#include "bench/suite.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "settings/settings_table.hpp"
#include "sim/contact/bodies/world.hpp"
#include "sim/stepping/stepper.hpp"

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace drape::bench {
namespace {

constexpr double targetOfContact = 150.0;          // [us] for a thousand triangles and a contact substep
constexpr double targetWhereNothingIsNear = 50.0;  // likewise
constexpr double targetOfOneThread = 0.7;          // of a simulated second of the scene mannequin [s]
constexpr double targetOfTwoThreads = 0.45;        // likewise
constexpr double targetOfRest = 0.1;               // cloth at rest / cloth that moves

using ScenePtr = std::shared_ptr<const scene::Scene>;

ScenePtr sceneOf(const std::string& name, const std::vector<std::string>& settings, int threads) {
  scene::SceneDescription description = scene::openScene(name);
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(description.settings, expression);
  }
  description.settings.step.threads = threads;
  return scene::buildScene(description, description.settings);
}

/// A scene that runs.
class Run {
 public:
  explicit Run(ScenePtr scene)
      : scene_(std::move(scene)),
        stepper_(scene_->settings.solver.name),
        state_(scene_->start),
        world_(scene_->bodies, state_.time) {}

  sim::StepReport step() {
    const sim::StepParameters& parameters = scene_->settings.step;
    world_.advance(state_.time, parameters.timeStep);
    sim::StepInputs inputs;
    inputs.bodies = &world_.steps();
    const sim::StepReport report = stepper_.step(*scene_->model, parameters, inputs, state_);
    contactSubsteps_ += stepper_.contactSubsteps();
    itself_ += report.contact.selfSeconds;
    bodies_ += report.contact.bodySeconds;
    substeps_ += report.substepContactSeconds;
    return report;
  }

  void run(double seconds) {
    while (state_.time < seconds - 1e-9) {
      step();
    }
  }

  [[nodiscard]] double itself() const { return itself_; }      ///< time of contact with itself [s]
  [[nodiscard]] double bodies() const { return bodies_; }      ///< with bodies [s]
  [[nodiscard]] double substeps() const { return substeps_; }  ///< of impulses in substeps of the solver [s]
  [[nodiscard]] double contact() const { return itself_ + bodies_ + substeps_; }  ///< [s]
  [[nodiscard]] double time() const { return state_.time; }
  /// Contact substeps times thousands of triangles.
  [[nodiscard]] double items() const {
    return contactSubsteps_ * static_cast<double>(scene_->model->triangles.size()) / 1000.0;
  }

 private:
  ScenePtr scene_;
  sim::Stepper stepper_;
  sim::ClothState state_;
  sim::contact::BodyWorld world_;
  double contactSubsteps_ = 0.0;
  double itself_ = 0.0;    // [s]
  double bodies_ = 0.0;    // [s]
  double substeps_ = 0.0;  // [s]
};

/// A part of a scene [s].
struct Interval {
  double begin = 0.0;
  double end = 0.0;
};

/// The time of contact in a part of a scene, for a thousand triangles and a contact substep.
Batch contactIn(const ScenePtr& scene, const Interval& interval, double (Run::*time)() const) {
  const auto increase = [=](double (Run::*figure)() const) {
    Run run(scene);
    run.run(interval.begin);
    const double before = (run.*figure)();
    run.run(interval.end);
    return (run.*figure)() - before;
  };
  return {increase(&Run::items), [=] { return increase(time); }};
}

/// The wall-clock time of a simulated second.
Batch secondOf(const ScenePtr& scene) {
  return {1.0, [scene] {
            Run run(scene);
            return wallSeconds([&] { run.run(1.0); });
          }};
}

void addContact(Suite& suite) {
  const auto add = [&](const char* name, std::optional<Bound> bound, const Interval& interval,
                       double (Run::*time)() const, std::vector<std::string> settings) {
    const std::string scene = std::string(name).substr(0, std::string(name).find(','));
    suite.add({"contact", name, "us/1000 triangles", bound},
              [=] { return contactIn(sceneOf(scene, settings, 1), interval, time); });
  };
  const std::vector<std::string> exact{"grid.resolution=65", "self_collision=exact"};
  const Bound target{Bound::Side::AtMost, targetOfContact};
  const Bound targetFar{Bound::Side::AtMost, targetWhereNothingIsNear};
  const Interval firstSecond{0.0, 1.0};
  constexpr double firstStep = 1.0 / 150.0;  // builds the hierarchy and finds crossings
  add("fold, 65x65, with itself", target, {0.0, 3.0}, &Run::itself, exact);
  add("grid, 65x65, with itself, first step", std::nullopt, {0.0, firstStep}, &Run::itself, exact);
  add("grid, 65x65, with itself, free fall after it", targetFar, {firstStep, 0.3}, &Run::itself, exact);
  add("mannequin, with itself", target, firstSecond, &Run::itself, {});
  add("mannequin, with the body", target, firstSecond, &Run::bodies, {});
  add("mannequin, impulses in substeps", std::nullopt, firstSecond, &Run::substeps, {});
  add("tablecloth, with the body", target, firstSecond, &Run::bodies, {});
}

void addThreads(Suite& suite) {
  constexpr int cores = 2;
  const std::vector<std::pair<std::string, std::vector<std::string>>> cloths{
      {"mannequin in jersey", {}}, {"mannequin in springs", {"material.model=springs"}}};
  for (const auto& [name, settings] : cloths) {
    for (const int threads : {1, 2}) {
      const double bound = threads == 1 ? targetOfOneThread : targetOfTwoThreads;
      suite.add(
          {"contact", name + ", a second, threads: " + std::to_string(threads), "s", Bound{Bound::Side::AtMost, bound}},
          [=, values = settings] { return secondOf(sceneOf("mannequin", values, threads)); }, cores);
    }
  }
  for (const int threads : {1, 2}) {
    suite.add(
        {"contact", "mannequin, contact, threads: " + std::to_string(threads), "us/1000 triangles"},
        [=] {
          return contactIn(sceneOf("mannequin", {}, threads), {0.0, 1.0}, &Run::contact);
        },
        cores);
  }
  suite.addRatio({"contact", "mannequin, contact, 1 thread / 2", "contact/mannequin, contact, threads: 1",
                  "contact/mannequin, contact, threads: 2", Bound{Bound::Side::AtLeast, 1.7}});
}

/// Runs a scene until its cloth sleeps.
std::shared_ptr<Run> asleep(const ScenePtr& scene) {
  constexpr double longest = 60.0;
  auto run = std::make_shared<Run>(scene);
  while (run->time() < longest) {
    const sim::StepReport report = run->step();
    if (report.choice && report.choice->sleeping) {
      return run;
    }
  }
  throw std::runtime_error("the cloth does not come to rest");
}

void addRest(Suite& suite) {
  constexpr int steps = 300;
  const auto stepsOf = [](const std::shared_ptr<Run>& run) {
    return threadSeconds([&] {
      for (int i = 0; i < steps; ++i) {
        run->step();
      }
    });
  };
  suite.add({"contact", "sphere, cloth that moves", "us/step"}, [=]() -> Batch {
    const ScenePtr scene = sceneOf("sphere", {"solver=auto", "grid.resolution=17"}, 1);
    return {steps, [=] { return stepsOf(std::make_shared<Run>(scene)); }};
  });
  suite.add({"contact", "sphere, cloth asleep", "us/step"}, [=]() -> Batch {
    const auto run = asleep(sceneOf("sphere", {"solver=auto", "grid.resolution=17"}, 1));
    return {steps, [=] { return stepsOf(run); }};
  });
  suite.addRatio({"contact", "sphere, asleep / moving", "contact/sphere, cloth asleep",
                  "contact/sphere, cloth that moves", Bound{Bound::Side::AtMost, targetOfRest}});
}

/// The memory that a scene needs with contact beyond that without.
struct ContactMemory {
  int vertices = 0;    // of the cloth
  double bytes = 0.0;  // of the cloth and of the body
};

ContactMemory memoryOfContact(const std::string& subdivide) {
  constexpr double seconds = 0.5;
  ContactMemory memory;
  const auto bytesOf = [&](std::vector<std::string> settings) {
    settings.push_back("subdivide=" + subdivide);
    const ScenePtr scene = sceneOf("mannequin", settings, 1);
    memory.vertices = scene->model->vertexCount();
    const double before = heapInUse();
    Run run(scene);
    run.run(seconds);
    return heapInUse() - before;
  };
  memory.bytes = bytesOf({}) - bytesOf({"bodies=off", "self_collision=off"});
  return memory;
}

/// What each further vertex of the cloth needs [bytes]. The search trees of the body do not count.
double memoryOfAVertex() {
  const ContactMemory coarse = memoryOfContact("0");
  const ContactMemory fine = memoryOfContact("1");
  return (fine.bytes - coarse.bytes) / (fine.vertices - coarse.vertices);
}

}  // namespace

void addContactGroup(Suite& suite) {
  addContact(suite);
  addThreads(suite);
  addRest(suite);
  suite.addFigure({"contact", "mannequin, memory of contact", "bytes/vertex", Bound{Bound::Side::AtMost, 1000.0}},
                  memoryOfAVertex);
}

}  // namespace drape::bench

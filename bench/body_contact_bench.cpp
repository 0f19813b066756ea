// Cost of contact with bodies: cloth falls onto each kind of body and comes to rest.
#include "bench/cloths.hpp"
#include "bench/suite.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "sim/contact/bodies/world.hpp"
#include "sim/stepping/stepper.hpp"

#include <string>

namespace drape::bench {
namespace {

constexpr int steps = 450;        // 1.5 s
constexpr double target = 150.0;  // [us] per step and thousand triangles of the cloth

/// The cloth and the body, in the syntax of scene files.
struct Fall {
  std::string name;
  std::string cloth;
  std::string body;
};

constexpr const char* settings = R"(
[settings]
grid.width = 1.3
grid.height = 1.3
grid.resolution = 41
solver = "xpbd"
substeps = 4
time_step = "1/300"
stiffness = 300
damping = 0.003
density = 0.2
drag = 0.6
lift = 0.3
)";

std::vector<Fall> falls() {
  const auto sheet = [](const std::string& height) {
    return "[cloth]\ngrid = \"horizontal\"\nposition = [0, " + height + ", 0]\n";
  };
  return {
      {"sphere", sheet("0.33"), "shape = \"sphere\"\nradius = 0.3\n"},
      {"box", sheet("0.33"), "shape = \"box\"\nsize = [0.6, 0.6, 0.6]\n"},
      {"mesh, sphere", sheet("0.33"), ""},
      {"mesh, table", sheet("0.76"), "shape = \"mesh\"\nmesh = \"builtin:table.obj\"\n"},
      {"mesh, mannequin", "[cloth]\nmesh = \"builtin:tshirt.obj\"\n",
       "shape = \"mesh\"\nmesh = \"builtin:mannequin.obj\"\n"},
  };
}

std::shared_ptr<const scene::Scene> sceneOf(const Fall& fall) {
  std::string text = fall.cloth + settings;
  if (!fall.body.empty()) {
    text += "[[bodies]]\nname = \"body\"\n" + fall.body;
  }
  const scene::SceneDescription description = scene::parseScene(text, fall.name, fall.name, ".");
  return scene::buildScene(description, description.settings);
}

/// The bodies of the scene; a sphere as a mesh with its drawn surface.
std::shared_ptr<const std::vector<sim::contact::Body>> bodiesOf(const scene::Scene& scene) {
  if (!scene.bodies->empty()) {
    return scene.bodies;
  }
  const sim::contact::BodySurface surface = sim::contact::surfaceOf(sim::contact::SphereShape{0.3});
  sim::contact::Body body;
  body.shape = std::make_shared<const sim::contact::MeshShape>(
      sim::contact::MeshShape{surface.positions, surface.triangles, {}, 1.0, false});
  body.motion.keyframes = {{0.0, Vec3::Zero(), Vec3::Zero()}};
  return std::make_shared<const std::vector<sim::contact::Body>>(1, body);
}

/// Runs a whole fall. Returns the time of its steps without contact, or of contact alone per thousand triangles.
Batch fallOn(const Fall& fall, bool contact) {
  const auto scene = sceneOf(fall);
  const auto bodies = bodiesOf(*scene);
  const double thousands = static_cast<double>(scene->model->triangles.size()) / 1000.0;
  return {steps * (contact ? thousands : 1.0), [scene, bodies, contact] {
            sim::Stepper stepper(scene->settings.solver.name);
            sim::ClothState state = scene->start;
            sim::contact::BodyWorld world(bodies, state.time);
            const sim::StepParameters& parameters = scene->settings.step;
            double inContact = 0.0;
            const double all = threadSeconds([&] {
              for (int i = 0; i < steps; ++i) {
                world.advance(state.time, parameters.timeStep);
                sim::StepInputs inputs;
                inputs.bodies = &world.steps();
                inContact += stepper.step(*scene->model, parameters, inputs, state).contact.bodySeconds;
              }
            });
            return contact ? inContact : all - inContact;
          }};
}

}  // namespace

void addBodyContactGroup(Suite& suite) {
  for (const Fall& fall : falls()) {
    suite.add({"body-contact", fall.name + ", the step", "us/step"}, [fall] { return fallOn(fall, false); });
    suite.add({"body-contact", fall.name + ", contact", "us/step/1000 triangles", Bound{Bound::Side::AtMost, target}},
              [fall] { return fallOn(fall, true); });
  }
}

}  // namespace drape::bench

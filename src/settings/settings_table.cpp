#include "settings/settings_table.hpp"
#include "settings/number_text.hpp"
#include "sim/solver.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace drape {
namespace {

using enum SettingGroup;

std::vector<std::string> solverNames() {
  std::vector<std::string> names;
  for (const SolverInfo& solver : solverTable()) {
    names.emplace_back(solver.name);
  }
  return names;
}

std::vector<std::string> ghostNames() {
  std::vector<std::string> names = solverNames();
  names.insert(names.begin(), "off");
  return names;
}

ChoiceLabel solverLabel(std::string_view word) {
  const SolverInfo* solver = findSolver(word);
  if (solver == nullptr) {
    return {"Off", "There is no second cloth."};
  }
  return {solver->title, solver->help.substr(0, solver->help.find(". ") + 1)};
}

template <typename Enum>
struct Word {
  Enum value;
  std::string_view word;
  ChoiceLabel label;
};
template <typename Enum>
Word(Enum, std::string_view, ChoiceLabel) -> Word<Enum>;

constexpr std::array integrations{
    Word{Integration::BackwardEuler, "backward_euler", {"Backward Euler", "First order, robust, damps fast motion."}},
    Word{Integration::Theta,
         "theta",
         {"Theta scheme", "Up to second order: extrapolates a shorter step of backward Euler."}},
    Word{Integration::Bdf2, "bdf2", {"BDF2", "Second order, from the last two states."}}};

constexpr std::array derivatives{
    Word{ForceDerivative::Stabilised,
         "stabilised",
         {"Stabilised", "Exact where springs are stretched, safe where they are compressed: the paper's."}},
    Word{ForceDerivative::Exact,
         "exact",
         {"Exact", "The true derivative; it loses stability where springs are compressed."}},
    Word{ForceDerivative::Scalar,
         "scalar",
         {"Scalar (Desbrun)", "As stiff across a spring as along it; never blows up, damps much."}},
    Word{ForceDerivative::Axial, "axial", {"Axial (Volino)", "Along the spring only; blows up in stiff cloth."}},
    Word{ForceDerivative::TensionOnly,
         "tension_only",
         {"Tension only (Choi, Ko)", "Nothing where springs are compressed; rattles with a single sweep."}}};

constexpr std::array precisions{
    Word{Precision::Float, "float", {"Float", "Seven digits: fast, and as accurate as the eye can tell."}},
    Word{Precision::Double, "double", {"Double", "Sixteen digits: for comparisons and very small steps."}}};

constexpr std::array selfCollisions{
    Word{SelfCollision::Off, "off", {"Off", "The cloth passes through itself; costs nothing."}},
    Word{SelfCollision::Hash,
         "hash",
         {"Hashed vertices",
          "The paper's: vertex to vertex, about as dear as the step; sharp folds and slack meshes leak."}}};

std::vector<std::string> unitWords() {
  return {"auto", "m", "dm", "cm", "mm", "inch"};
}

/// Metres per unit, as a number.
bool isUnitFactor(std::string_view text) {
  const std::optional<double> factor = parseNumber(text);
  return factor && *factor >= 1e-6 && *factor <= 1e3;
}

ChoiceLabel unitLabel(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, ChoiceLabel>, 6> labels{
      {{"auto", {"Guessed", "The unit in which the mesh has the size of something that people wear."}},
       {"m", {"Metres", "One unit of the file is a metre."}},
       {"dm", {"Decimetres", "One unit of the file is a tenth of a metre."}},
       {"cm", {"Centimetres", "One unit of the file is a hundredth of a metre."}},
       {"mm", {"Millimetres", "One unit of the file is a thousandth of a metre."}},
       {"inch", {"Inches", "One unit of the file is 0.0254 m."}}}};
  const auto found = std::find_if(labels.begin(), labels.end(), [&](const auto& entry) { return entry.first == word; });
  return found == labels.end() ? ChoiceLabel{} : found->second;
}

ChoiceLabel pinsLabel(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, ChoiceLabel>, 4> labels{
      {{"scene", {"As the scene says", "What the scene file names."}},
       {"shape", {"By shape", "The neck, the waist or the shoulders of a garment, two corners of a flat sheet."}},
       {"top", {"Top", "The topmost 3 % of the height."}},
       {"none", {"None", "Nothing is held: the cloth falls until it lands on something solid."}}}};
  const auto found = std::find_if(labels.begin(), labels.end(), [&](const auto& entry) { return entry.first == word; });
  return found == labels.end() ? ChoiceLabel{} : found->second;
}

/// A choice between the values of an enumeration, each with its word.
template <const auto& words, auto ref>
ChoiceField choiceOf() {
  return {[](const Settings& settings) {
            Settings copy = settings;
            const auto found =
                std::find_if(words.begin(), words.end(), [&](const auto& entry) { return entry.value == ref(copy); });
            return std::string(found->word);
          },
          [](Settings& settings, const std::string& word) {
            const auto found =
                std::find_if(words.begin(), words.end(), [&](const auto& entry) { return entry.word == word; });
            ref(settings) = found->value;
          },
          [] {
            std::vector<std::string> list;
            for (const auto& entry : words) {
              list.emplace_back(entry.word);
            }
            return list;
          },
          [](std::string_view word) {
            const auto found =
                std::find_if(words.begin(), words.end(), [&](const auto& entry) { return entry.word == word; });
            return found == words.end() ? ChoiceLabel{} : found->label;
          }};
}

/// True when the cloth or its ghost is moved by a solver of backward-Euler steps.
bool solvesBackwardEuler(const Settings& settings) {
  const auto solves = [](const std::string& name) {
    const SolverInfo* solver = findSolver(name);
    return solver != nullptr && solver->backwardEuler;
  };
  return solves(settings.solver.name) || solves(settings.ghost.solver);
}

/// True when the cloth or its ghost is moved by a solver that takes the substeps that it is told.
bool takesSubsteps(const Settings& settings) {
  const SolverInfo* solver = findSolver(settings.solver.name);
  return solver == nullptr || !solver->choosesSubsteps;
}

bool collidesWithItself(const Settings& settings) {
  return settings.step.contact.self != SelfCollision::Off;
}

bool showsGhost(const Settings& settings) {
  return settings.ghost.solver != "off";
}

// Each row: key, title, unit, group, effect, field {accessor, range ...}, help [, key and value that it decides [,
// scope [, when it has an effect]]].
// clang-format off
const std::array table{
    SettingInfo{"solver", "Solver", "-", Advanced, SettingEffect::Step,
        ChoiceField{[](const Settings& s) { return s.solver.name; }, [](Settings& s, const std::string& word) { s.solver.name = word; }, solverNames, solverLabel},
        "The method that advances the cloth by one time step."},
    SettingInfo{"time_step", "Time step", "s", Advanced, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.timeStep; }, 1e-5, 0.1, true},
        "Simulated time that one step covers. Smaller steps are more accurate and cost more."},
    SettingInfo{"substeps", "Substeps", "-", Advanced, SettingEffect::Step,
        IntegerField{[](Settings& s) -> int& { return s.step.substeps; }, 1, 1000},
        "Equal parts that each time step is taken in. Costs as much as a time step shorter by that factor. auto chooses its "
        "own.",
        {}, {}, SettingScope::Everywhere, takesSubsteps},
    SettingInfo{"integration", "Integration", "-", Advanced, SettingEffect::Step,
        choiceOf<integrations, [](Settings& s) -> Integration& { return s.step.integration; }>(),
        "How an implicit step's end is found. Backward Euler is robust and damps; theta and bdf2 are of second order, "
        "more accurate for the same work, and less robust in stiff cloth.",
        {}, {}, SettingScope::Everywhere, solvesBackwardEuler},
    SettingInfo{"theta", "Theta", "-", Advanced, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.theta; }, 0.5, 1.0, false},
        "Where in the step the theta scheme looks: 0.5 is the implicit midpoint rule, accurate and easily unstable; 1 is "
        "backward Euler; 0.75 holds in nearly all scenes.",
        {}, {}, SettingScope::Everywhere,
        [](const Settings& s) { return solvesBackwardEuler(s) && s.step.integration == Integration::Theta; }},
    SettingInfo{"sweeps", "Sweeps", "-", Advanced, SettingEffect::Step,
        IntegerField{[](Settings& s) -> int& { return s.step.sweeps; }, 1, 99},
        "Block-Jacobi sweeps a step; 1 is the paper's method. More sweeps solve the step's linear system better. Must be "
        "odd unless relaxation is 0.8 or less."},
    SettingInfo{"relaxation", "Relaxation", "-", Advanced, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.relaxation; }, 0.1, 1.0, false},
        "How far a sweep goes towards its answer: 1 is Jacobi as in the paper, less is damped Jacobi."},
    SettingInfo{"derivative", "Derivative", "-", Advanced, SettingEffect::Step,
        choiceOf<derivatives, [](Settings& s) -> ForceDerivative& { return s.step.derivative; }>(),
        "The springs' force derivative: stabilised where compressed (the paper), exact, scalar (Desbrun), axial (Volino) "
        "or of tension only (Choi and Ko)."},
    SettingInfo{"iterations", "Iterations", "-", Advanced, SettingEffect::Step,
        IntegerField{[](Settings& s) -> int& { return s.step.iterations; }, 1, 1000},
        "Iterations a step of a method that takes a fixed number of them."},
    SettingInfo{"spectral_radius", "Spectral radius", "-", Advanced, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.spectralRadius; }, 0.0, 0.9999, false},
        "What the acceleration takes for the largest eigenvalue of the iteration. Too small accelerates little, too large "
        "overshoots."},
    SettingInfo{"tolerance", "Tolerance", "-", Advanced, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.tolerance; }, 1e-14, 0.5, true},
        "A solve ends when its residual is smaller than this share of the first one."},
    SettingInfo{"max_iterations", "Most iterations", "-", Advanced, SettingEffect::Step,
        IntegerField{[](Settings& s) -> int& { return s.step.maxIterations; }, 1, 100000},
        "A solve that has not reached its tolerance by then goes on with what it has, and says so."},
    SettingInfo{"auto.work", "Work allowed", "M/s", Advanced, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.costBudget; }, 0.01, 1e6, true},
        "Evaluations of a spring, in millions for a second of simulated time, that auto may spend. A core does about a "
        "thousand million in a second of the clock. Follows from auto.budget where that is given.",
        {}, {}, SettingScope::Everywhere, [](const Settings& s) { return s.automatic.budget == 0.0; }},
    SettingInfo{"auto.soften", "Keep pace", "-", Advanced, SettingEffect::Step,
        FlagField{[](Settings& s) -> bool& { return s.step.soften; }},
        "What auto does where the work allowed does not suffice for cloth so stiff and fine. Off: a step takes what it "
        "needs, and the clock falls behind. On: springs are softened to what the work carries."},
    SettingInfo{"auto.budget", "Time allowed", "ms", Advanced, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.automatic.budget; }, 0.0, 1000.0, false},
        "Computing time that auto may spend on each sixtieth of a second of motion, which is what a screen shows at a time. "
        "What that pays for is measured while it runs, so that the motion depends on the machine; a recorded session is "
        "played back the same all the same. 0: auto.work counts, and no clock."},
    SettingInfo{"auto.tolerance", "Error allowed", "m", Advanced, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.errorTolerance; }, 1e-12, 1.0, true},
        "Mean position error that auto lets 0.2 s of motion build up, as far as the work allowed goes."},
    SettingInfo{"keep_momentum", "Keep momentum", "-", Advanced, SettingEffect::Step,
        FlagField{[](Settings& s) -> bool& { return s.step.keepMomentum; }},
        "Gives the linear and angular momentum back that a step took from cloth that nothing holds. Pieces with pinned "
        "vertices stay as they are."},
    SettingInfo{"precision", "Precision", "-", Advanced, SettingEffect::Step,
        choiceOf<precisions, [](Settings& s) -> Precision& { return s.step.precision; }>(),
        "The numbers that a step calculates with. Float is about twice as fast; double for comparisons with other programs "
        "and for very small steps. States are kept and written in double."},
    SettingInfo{"threads", "Threads", "-", Advanced, SettingEffect::Step,
        IntegerField{[](Settings& s) -> int& { return s.step.threads; }, 1, 64},
        "Threads that one step may use. The result is the same to the last bit, whatever the number."},
    SettingInfo{"speed", "Speed", "-", Simulation, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.playback.speed; }, 0.01, 4.0, true},
        "Simulated seconds per second of the clock in the viewer; below 1 is slow motion."},
    SettingInfo{"gravity", "Gravity", "m/s^2", Simulation, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.gravity; }, 0.0, 1000.0, false},
        "Acceleration downwards, along -y."},

    SettingInfo{"ghost.solver", "Solver", "-", Ghost, SettingEffect::Step,
        ChoiceField{[](const Settings& s) { return s.ghost.solver; }, [](Settings& s, const std::string& word) { s.ghost.solver = word; }, ghostNames, solverLabel},
        "The method that moves a second cloth, to compare with the first; off: there is none. It begins where the first one "
        "is, shares all other settings, and leaves the first one as it is."},
    SettingInfo{"ghost.substeps", "Substeps", "-", Ghost, SettingEffect::Step,
        IntegerField{[](Settings& s) -> int& { return s.ghost.substeps; }, 1, 1000},
        "Equal parts that each time step of the second cloth is taken in.",
        {}, {}, SettingScope::Everywhere, showsGhost},
    SettingInfo{"ghost.offset", "Offset", "m", Ghost, SettingEffect::View,
        NumberField{[](Settings& s) -> double& { return s.ghost.offset; }, -10.0, 10.0, false},
        "How far to the right of its place the second cloth is drawn; 0 lays it over the first. It moves where the first one does.",
        {}, {}, SettingScope::Everywhere, showsGhost},

    SettingInfo{"stiffness", "Stiffness", "N/m", Material, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.stiffness; }, 0.0, 1e7, true},
        "Stiffness of every spring against stretching and compression."},
    SettingInfo{"damping", "Damping", "N s/m", Material, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.damping; }, 0.0, 100.0, true},
        "Damping of every spring: force for each metre per second that its ends differ in velocity."},
    SettingInfo{"mass_given_as", "Mass given as", "-", Material, SettingEffect::Mass,
        ChoiceField{[](const Settings& s) { return s.material.massGivenAs; }, [](Settings& s, const std::string& word) { s.material.massGivenAs = word; },
            +[] { return std::vector<std::string>{"density", "mass"}; }},
        "Whether density or mass decides how heavy the cloth is. Setting either of them chooses it."},
    SettingInfo{"density", "Density", "kg/m^2", Material, SettingEffect::Mass,
        NumberField{[](Settings& s) -> double& { return s.material.density; }, 1e-3, 100.0, true},
        "Mass of a square metre of cloth. Silk is about 0.06, cotton 0.15, denim 0.4.",
        "mass_given_as", "density"},
    SettingInfo{"mass", "Mass", "kg", Material, SettingEffect::Mass,
        NumberField{[](Settings& s) -> double& { return s.material.mass; }, 1e-6, 1000.0, true},
        "Mass of the whole cloth.", "mass_given_as", "mass"},
    SettingInfo{"mass_lumping", "Mass lumping", "-", Advanced, SettingEffect::Mass,
        ChoiceField{[](const Settings& s) { return s.material.lumping; }, [](Settings& s, const std::string& word) { s.material.lumping = word; },
            +[] { return std::vector<std::string>{"area", "uniform"}; }},
        "How the mass is spread over the vertices: by the area around each, or the same for all as in the paper."},

    SettingInfo{"self_collision", "Self-collision", "-", Contact, SettingEffect::Step,
        choiceOf<selfCollisions, [](Settings& s) -> SelfCollision& { return s.step.contact.self; }>(),
        "How the cloth is kept from passing through itself."},
    SettingInfo{"self_thickness", "Self thickness", "m", Contact, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.contact.selfThickness; }, 0.0, 1.0, false},
        "How far vertices of different layers are kept apart; 0 takes three quarters of the mean edge. With much less than "
        "that, vertices slip through between others.",
        {}, {}, SettingScope::Everywhere, collidesWithItself},
    SettingInfo{"self_friction", "Self friction", "-", Contact, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.contact.kineticFriction; }, 0.0, 2.0, false},
        "Friction of cloth that slides on cloth.",
        {}, {}, SettingScope::Everywhere, collidesWithItself},
    SettingInfo{"self_static_friction", "Self static", "-", Contact, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.contact.staticFriction; }, 0.0, 2.0, false},
        "Friction that holds layers of cloth together until they slide.",
        {}, {}, SettingScope::Everywhere, collidesWithItself},

    SettingInfo{"drag", "Drag", "-", Air, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.drag; }, 0.0, 10.0, false},
        "Drag coefficient C_D: the air's resistance along the relative velocity, 1/2 rho C_D S |n.v| |v| at each vertex."},
    SettingInfo{"lift", "Lift", "-", Air, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.lift; }, 0.0, 10.0, false},
        "Lift coefficient C_L: the air's force across the relative velocity, strongest where the surface is along it."},
    SettingInfo{"air_density", "Air density", "kg/m^3", Air, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.airDensity; }, 0.0, 1000.0, false},
        "Density rho of the air; 1.225 at sea level, 1000 is water."},
    SettingInfo{"wind.x", "Wind x", "m/s", Air, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.wind.x(); }, -100.0, 100.0, false},
        "Velocity of the air to the right. Wind acts through drag and lift."},
    SettingInfo{"wind.y", "Wind y", "m/s", Air, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.wind.y(); }, -100.0, 100.0, false},
        "Velocity of the air upwards. Wind acts through drag and lift."},
    SettingInfo{"wind.z", "Wind z", "m/s", Air, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.wind.z(); }, -100.0, 100.0, false},
        "Velocity of the air towards the front. Wind acts through drag and lift."},

    SettingInfo{"bodies", "Bodies", "-", Contact, SettingEffect::Step,
        FlagField{[](Settings& s) -> bool& { return s.step.contact.bodies; }},
        "Keeps the cloth out of the scene's bodies. Costs nothing in scenes without any."},
    SettingInfo{"cloth_thickness", "Thickness", "m", Contact, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.step.contact.thickness; }, 0.001, 0.05, true},
        "Thickness of the cloth in contact: bodies keep half of it and their own thickness away."},
    SettingInfo{"view.contacts", "Draw contacts", "-", Contact, SettingEffect::View,
        FlagField{[](Settings& s) -> bool& { return s.view.contacts; }},
        "Draws where the cloth touched something in the last step, and in which direction it was kept out."},

    SettingInfo{"unit", "Mesh unit", "-", Scene, SettingEffect::Scene,
        ChoiceField{[](const Settings& s) { return s.mesh.unit; }, [](Settings& s, const std::string& word) { s.mesh.unit = word; },
            unitWords, unitLabel, isUnitFactor, "metres per unit from 1e-06 to 1000"},
        "Unit of the coordinates in a mesh file: a word, or metres per unit such as 0.0254. auto guesses it from the "
        "size. Opened mesh files start with auto, scene files with m.",
        {}, {}, SettingScope::MeshFile},
    SettingInfo{"up", "Mesh up axis", "-", Scene, SettingEffect::Scene,
        ChoiceField{[](const Settings& s) { return s.mesh.up; }, [](Settings& s, const std::string& word) { s.mesh.up = word; },
            +[] { return std::vector<std::string>{"auto", "y", "z", "x", "-y", "-z"}; }},
        "The axis of a mesh file that points up. The mesh is turned so that this axis becomes y. auto guesses y or z "
        "from the shape. Opened mesh files start with auto, scene files with y.",
        {}, {}, SettingScope::MeshFile},
    SettingInfo{"weld_tolerance", "Weld tolerance", "-", Advanced, SettingEffect::Scene,
        NumberField{[](Settings& s) -> double& { return s.mesh.weldTolerance; }, 0.0, 0.01, false},
        "Vertices of a mesh that are nearer to each other than this share of its diagonal become one.", {}, {}, SettingScope::MeshFile},
    SettingInfo{"outliers", "Far vertices", "-", Scene, SettingEffect::Scene,
        ChoiceField{[](const Settings& s) { return s.mesh.outliers; }, [](Settings& s, const std::string& word) { s.mesh.outliers = word; },
            +[] { return std::vector<std::string>{"refuse", "leave_out"}; }},
        "What happens when vertices of a mesh file lie far from all others: the file is refused, or they are left out "
        "with their faces.",
        {}, {}, SettingScope::MeshFile},
    SettingInfo{"pins", "Pins", "-", Scene, SettingEffect::Scene,
        ChoiceField{[](const Settings& s) { return s.mesh.pins; }, [](Settings& s, const std::string& word) { s.mesh.pins = word; },
            +[] { return std::vector<std::string>{"scene", "shape", "top", "none"}; }, pinsLabel},
        "What holds the cloth: the pins of the scene, pins chosen from its shape, its topmost vertices, or nothing. "
        "Opened mesh files start with shape."},
    SettingInfo{"grid.resolution", "Grid resolution", "-", Scene, SettingEffect::Scene,
        IntegerField{[](Settings& s) -> int& { return s.grid.resolution; }, 2, 1025},
        "Vertices along the shorter side of a grid.", {}, {}, SettingScope::Grid},
    SettingInfo{"grid.width", "Grid width", "m", Scene, SettingEffect::Scene,
        NumberField{[](Settings& s) -> double& { return s.grid.width; }, 0.01, 100.0, true},
        "Extent of a grid along its rows.", {}, {}, SettingScope::Grid},
    SettingInfo{"grid.height", "Grid height", "m", Scene, SettingEffect::Scene,
        NumberField{[](Settings& s) -> double& { return s.grid.height; }, 0.01, 100.0, true},
        "Extent of a grid across its rows.", {}, {}, SettingScope::Grid},
    SettingInfo{"hand.stiffness", "Hand stiffness", "N/m", Scene, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.hand.stiffness; }, 0.1, 1e5, true},
        "Stiffness of the spring by which the mouse pulls at the cloth."},
    SettingInfo{"hand.max_force", "Hand force", "N", Scene, SettingEffect::Step,
        NumberField{[](Settings& s) -> double& { return s.hand.maxForce; }, 0.01, 1000.0, true},
        "The largest force of the mouse. The force also stays below what stretches the cloth around the held point by "
        "about a fifth."},

    SettingInfo{"view.wireframe", "Wireframe", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](Settings& s) -> bool& { return s.view.wireframe; }},
        "Draws the edges of the triangles, which are the springs."},
    SettingInfo{"view.surface", "Surface", "-", SettingGroup::View, SettingEffect::View,
        ChoiceField{[](const Settings& s) { return s.view.surface; }, [](Settings& s, const std::string& word) { s.view.surface = word; },
            +[] { return std::vector<std::string>{"checker", "plain"}; }},
        "What the cloth looks like: a checker along its texture coordinates, or one colour."},
    SettingInfo{"view.ground", "Ground", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](Settings& s) -> bool& { return s.view.ground; }},
        "Draws the ground. The ground stops the cloth even when it is not drawn; the Contact panel switches that off."},
    SettingInfo{"view.shadows", "Shadows", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](Settings& s) -> bool& { return s.view.shadows; }},
        "Draws shadows."},
    SettingInfo{"view.pins", "Pins", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](Settings& s) -> bool& { return s.view.pins; }},
        "Draws a dot at each pinned vertex. Pictures saved with F12 never show them."},
    SettingInfo{"view.font_scale", "Font scale", "-", SettingGroup::View, SettingEffect::View,
        NumberField{[](Settings& s) -> double& { return s.view.fontScale; }, 0.0, 4.0, false},
        "Size of the panels' text; 0 takes the monitor's own scale."},

    SettingInfo{"energy_balance", "Energy balance", "-", Advanced, SettingEffect::Step,
        FlagField{[](Settings& s) -> bool& { return s.measures.energyBalance; }},
        "Works out in every step what damping, air, hand and the method itself gave or took. Costs another pass over the forces."},
};
// clang-format on

}  // namespace

std::span<const SettingInfo> settingsTable() {
  return table;
}

const SettingInfo* findSetting(std::string_view key) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const SettingInfo& row) { return row.key == key; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace drape

#include "settings/settings_table.hpp"
#include "fabrics/presets.hpp"
#include "sim/fields/field_table.hpp"
#include "sim/solvers/self_collision.hpp"
#include "sim/solvers/solver.hpp"
#include "text/number_text.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace drape::settings {
namespace {

using enum SettingGroup;

std::vector<std::string> solverNames() {
  std::vector<std::string> names;
  for (const sim::SolverInfo& solver : sim::solverTable()) {
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
  const sim::SolverInfo* solver = sim::findSolver(word);
  if (solver == nullptr) {
    return {"Off", "There is no second cloth."};
  }
  return {solver->title, solver->help.substr(0, solver->help.find(". ") + 1)};
}

std::vector<std::string> colourMapNames() {
  std::vector<std::string> names{"off"};
  for (const sim::fields::FieldInfo& field : sim::fields::fieldTable()) {
    names.emplace_back(field.name);
  }
  return names;
}

ChoiceLabel colourMapLabel(std::string_view word) {
  const sim::fields::FieldInfo* field = sim::fields::findField(word);
  return field == nullptr ? ChoiceLabel{"Off", "The cloth has its own look."} : ChoiceLabel{field->title, field->help};
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
    Word{sim::Integration::BackwardEuler,
         "backward_euler",
         {"Backward Euler", "First order, robust, damps fast motion."}},
    Word{sim::Integration::Theta,
         "theta",
         {"Theta scheme", "Up to second order: extrapolates a shorter backward Euler step."}},
    Word{sim::Integration::Bdf2, "bdf2", {"BDF2", "Second order: uses the last two states."}}};

constexpr std::array derivatives{
    Word{sim::ForceDerivative::Stabilised,
         "stabilised",
         {"Stabilised", "The paper's: exact for stretched springs, stable for compressed ones."}},
    Word{sim::ForceDerivative::Exact,
         "exact",
         {"Exact", "The true derivative. It can be unstable where springs are compressed."}},
    Word{sim::ForceDerivative::Scalar,
         "scalar",
         {"Scalar (Desbrun)", "As stiff across a spring as along it. Always stable, damps much."}},
    Word{sim::ForceDerivative::Axial,
         "axial",
         {"Axial (Volino)", "Acts along the spring only. Unstable in stiff cloth."}},
    Word{sim::ForceDerivative::TensionOnly,
         "tension_only",
         {"Tension only (Choi, Ko)", "Zero for compressed springs. Vibrates with a single sweep."}}};

constexpr std::array precisions{
    Word{sim::Precision::Float, "float", {"Float", "Seven digits. Fast, and the error is too small to see."}},
    Word{sim::Precision::Double, "double", {"Double", "Sixteen digits. For comparisons and very small steps."}}};

constexpr std::array airModels{
    Word{sim::AirModel::Auto, "auto", {"Automatic", "A thin plate's for a fabric, the paper's for springs."}},
    Word{sim::AirModel::Paper,
         "paper",
         {"Paper's", "Eqs. 18 to 20: lift is largest where the cloth is parallel to the wind, and jumps there."}},
    Word{sim::AirModel::Plate,
         "plate",
         {"Thin plate",
          "Measured on falling plates: lift with sin 2a of the angle of attack a, drag with sin^2 a. "
          "Free flat sheets flutter and tumble."}}};

constexpr std::array selfCollisions{
    Word{sim::contact::SelfCollision::Auto,
         "auto",
         {"Automatic", "Exact with the solver auto, hashed vertices with all others."}},
    Word{sim::contact::SelfCollision::Off, "off", {"Off", "The cloth passes through itself. Costs nothing."}},
    Word{sim::contact::SelfCollision::Hash,
         "hash",
         {"Hashed vertices",
          "The paper's: keeps vertices apart. Costs about as much as the step. Sharp folds and loose meshes leak."}},
    Word{
        sim::contact::SelfCollision::Exact,
        "exact",
        {"Exact",
         "Vertices against triangles and edges against edges. Prevents intersections unless pins or bodies force them. "
         "Costs more than the step where layers meet."}}};

/// Metres per unit, as a number.
bool isUnitFactor(std::string_view text) {
  const std::optional<double> factor = text::parseNumber(text);
  return factor && *factor >= 1e-6 && *factor <= 1e3;
}

/// A word of a choice that is stored as text.
struct TextWord {
  std::string_view word;
  ChoiceLabel label;
};

constexpr std::array units{TextWord{"auto", {"Guessed", "The unit that gives the mesh the size of a garment."}},
                           TextWord{"m", {"Metres", "One unit of the file is a metre."}},
                           TextWord{"dm", {"Decimetres", "One unit of the file is a tenth of a metre."}},
                           TextWord{"cm", {"Centimetres", "One unit of the file is a hundredth of a metre."}},
                           TextWord{"mm", {"Millimetres", "One unit of the file is a thousandth of a metre."}},
                           TextWord{"inch", {"Inches", "One unit of the file is 0.0254 m."}},
                           TextWord{"foot", {"Feet", "One unit of the file is 0.3048 m."}}};

constexpr std::array pinSources{
    TextWord{"scene", {"From the scene", "The pins that the scene file defines."}},
    TextWord{"shape", {"By shape", "The neck, the waist or the shoulders of a garment. Two corners of a flat sheet."}},
    TextWord{"top", {"Top", "The topmost 3 % of the height."}},
    TextWord{"none", {"None", "No pins: the cloth falls until it lands on something solid."}}};

constexpr std::array surfaces{
    TextWord{"auto", {"Automatic", "A checker on springs. A fabric looks like itself."}},
    TextWord{"checker", {"Checker", "Squares along the texture coordinates. They show how the cloth stretches."}},
    TextWord{"plain", {"Plain", "One colour for each side."}},
    TextWord{"fabric", {"Fabric", "The structure and the colours of the fabric in material.preset."}}};

constexpr std::array colourRanges{
    TextWord{"auto", {"Automatic", "Follows the values, leaves out the most extreme ones, and stays steady."}},
    TextWord{"fixed", {"Fixed", "From the lowest to the highest value below."}}};

template <const auto& words>
std::vector<std::string> wordsIn() {
  std::vector<std::string> list;
  for (const auto& entry : words) {
    list.emplace_back(entry.word);
  }
  return list;
}

template <const auto& words>
ChoiceLabel labelIn(std::string_view word) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& entry) { return entry.word == word; });
  return found == words.end() ? ChoiceLabel{} : found->label;
}

/// A choice between the values of an enumeration, each with its word.
template <const auto& words, auto ref>
ChoiceField choiceOf() {
  return {[](const Settings& settings) {
            const auto found = std::find_if(words.begin(), words.end(),
                                            [&](const auto& entry) { return entry.value == ref(settings); });
            return std::string(found->word);
          },
          [](Settings& settings, const std::string& word) {
            const auto found =
                std::find_if(words.begin(), words.end(), [&](const auto& entry) { return entry.word == word; });
            ref(settings) = found->value;
          },
          wordsIn<words>, labelIn<words>};
}

/// A choice that is stored as text. The arguments are the other fields of ChoiceField.
template <auto ref>
ChoiceField textOf(decltype(ChoiceField::choices) choices, decltype(ChoiceField::label) label = nullptr,
                   decltype(ChoiceField::accepts) accepts = nullptr, std::string_view otherTexts = {}) {
  return {[](const Settings& settings) { return ref(settings); },
          [](Settings& settings, const std::string& word) { ref(settings) = word; },
          choices,
          label,
          accepts,
          otherTexts};
}

constexpr std::array materialModels{
    TextWord{"springs", {"Springs", "The paper's: every edge of the mesh is a spring."}},
    TextWord{"fabric", {"Fabric", "A sheet that resists stretch, shear and bending along warp and weft."}}};

constexpr std::array warpSources{
    TextWord{"auto", {"Automatic", "Along V of the texture coordinates where they are a flat pattern, else vertical."}},
    TextWord{"vertical", {"Vertical", "The vertical of the rest shape, along each triangle."}},
    TextWord{"uv", {"UVs", "Along V of the mesh's texture coordinates."}}};

constexpr std::array restShapes{
    TextWord{"mesh", {"Mesh", "The cloth is unstressed in the shape of its mesh."}},
    TextWord{"uv", {"UVs", "The cloth is unstressed in the flat sewing pattern of its texture coordinates."}}};

constexpr std::array restCurvatures{
    TextWord{"flat", {"Flat", "The fabric tends to unroll, as woven cloth does that was cut from a flat piece."}},
    TextWord{"mesh", {"Mesh", "Curves and creases of the mesh stay: they are free of bending moments."}}};

std::vector<std::string> fabricNames() {
  std::vector<std::string> names;
  for (const fabrics::Preset& preset : fabrics::presetTable()) {
    names.emplace_back(preset.name);
  }
  return names;
}

ChoiceLabel fabricLabel(std::string_view word) {
  const fabrics::Preset* preset = fabrics::findPreset(word);
  return preset == nullptr ? ChoiceLabel{} : ChoiceLabel{preset->title, preset->source};
}

std::vector<OwnChoice> ownFabricChoices(const Settings& settings) {
  std::vector<OwnChoice> choices;
  if (settings.fabric.own) {
    for (const OwnFabric& fabric : *settings.fabric.own) {
      choices.push_back({fabric.name, fabric.name,
                         fabric.source.empty() ? text::Sentence("A fabric of your own.")
                                               : text::Sentence("Your own: {}", fabric.source)});
    }
  }
  return choices;
}

/// Whether the fabric has the values of the preset or the own fabric with that name.
bool hasValuesOf(const Settings& settings, std::string_view name) {
  const Settings::Fabric& fabric = settings.fabric;
  if (const fabrics::Preset* preset = fabrics::findPreset(name)) {
    return preset->material == fabric.moduli && preset->density == fabric.density;
  }
  const OwnFabric* own = findOwnFabric(fabric.own, name);
  return own != nullptr && own->material == fabric.moduli && own->density == fabric.density;
}

/// The fabric whose values these are. It follows from the values, so it is right after any change.
std::string presetOf(const Settings& settings) {
  const std::string& chosen = settings.fabric.preset;
  if (hasValuesOf(settings, chosen)) {
    return chosen;
  }
  for (const std::string& name : fabricNames()) {
    if (hasValuesOf(settings, name)) {
      return name;
    }
  }
  return chosen.empty() ? std::string(noPreset) : chosen + std::string(changedMark);
}

/// Of "cotton, changed" the name of the fabric. Empty for a text without the mark.
std::string_view nameOfChanged(std::string_view text) {
  return text.ends_with(changedMark) ? text.substr(0, text.size() - changedMark.size()) : std::string_view();
}

bool isCustomFabric(std::string_view text) {
  return text == noPreset || !nameOfChanged(text).empty();
}

/// A changed fabric keeps its values: they follow as single settings.
void setPreset(Settings& settings, const std::string& name) {
  if (const fabrics::Preset* preset = fabrics::findPreset(name)) {
    settings.fabric.moduli = preset->material;
    settings.fabric.density = preset->density;
    settings.fabric.preset = name;
    useFriction(settings, name);
  } else if (const OwnFabric* own = findOwnFabric(settings.fabric.own, name)) {
    useFabric(settings, OwnFabric(*own));
  } else {
    settings.fabric.preset = nameOfChanged(name);
  }
}

/// Whether the solver of the cloth or of its ghost takes backward Euler steps.
bool solvesBackwardEuler(const Settings& settings) {
  const auto solves = [](const std::string& name) {
    const sim::SolverInfo* solver = sim::findSolver(name);
    return solver != nullptr && solver->backwardEuler;
  };
  return solves(settings.solver.name) || solves(settings.ghost.solver);
}

/// Whether the solver of the cloth uses the setting `substeps`.
bool takesSubsteps(const Settings& settings) {
  const sim::SolverInfo* solver = sim::findSolver(settings.solver.name);
  return solver == nullptr || !solver->choosesSubsteps;
}

bool actsAsPlate(const Settings& settings) {
  return settings.step.air.model == sim::AirModel::Plate ||
         (settings.step.air.model == sim::AirModel::Auto && usesFabric(settings));
}

bool collidesWithItself(const Settings& settings) {
  return settings.step.contact.self != sim::contact::SelfCollision::Off;
}

bool collidesByHash(const Settings& settings) {
  return sim::actingSelfCollision(settings.step.contact.self, sim::findSolver(settings.solver.name)) ==
         sim::contact::SelfCollision::Hash;
}

bool showsGhost(const Settings& settings) {
  return settings.ghost.solver != "off";
}

bool usesSprings(const Settings& settings) {
  return !usesFabric(settings);
}

/// Whether the name of the fabric and its warp count: for the cloth itself or for its look.
bool namesFabric(const Settings& settings) {
  return usesFabric(settings) || settings.view.surface == "fabric";
}

bool showsColourMap(const Settings& settings) {
  return settings.view.colourMap != "off";
}

bool weighsAsGiven(const Settings& settings) {
  return !weighsAsFabric(settings);
}

// Each row: key, title, unit, group, effect, field {accessor, range ...}, help [, key and value that it also sets [,
// scope [, when it has an effect [, its former key [, whether it is a preset]]]]].
// clang-format off
const std::array table{
    SettingInfo{"solver", "Solver", "-", Advanced, SettingEffect::Step,
        textOf<[](auto& s) -> auto& { return s.solver.name; }>(solverNames, solverLabel),
        "The method that advances the cloth by one time step."},
    SettingInfo{"time_step", "Time step", "s", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.timeStep; }, 1e-5, 0.1, true},
        "Simulated time of one step. Smaller steps are more accurate and cost more."},
    SettingInfo{"substeps", "Substeps", "-", Advanced, SettingEffect::Step,
        IntegerField{[](auto& s) -> auto& { return s.step.substeps; }, 1, 1000},
        "Number of equal parts of each time step. Costs as much as a time step that is smaller by this factor. auto "
        "chooses its own number.",
        {}, {}, SettingScope::Everywhere, takesSubsteps},
    SettingInfo{"integration", "Integration", "-", Advanced, SettingEffect::Step,
        choiceOf<integrations, [](auto& s) -> auto& { return s.step.integration; }>(),
        "Time integration of an implicit step. backward_euler is robust and damps motion. theta and bdf2 are of "
        "second order: more accurate for the same cost, and less robust in stiff cloth.",
        {}, {}, SettingScope::Everywhere, solvesBackwardEuler},
    SettingInfo{"theta", "Theta", "-", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.theta; }, 0.5, 1.0, false},
        "Point of the step at which the theta scheme evaluates the forces. 0.5 is the implicit midpoint rule: "
        "accurate, but easily unstable. 1 is backward Euler. 0.75 is stable in nearly all scenes.",
        {}, {}, SettingScope::Everywhere,
        [](const Settings& s) { return solvesBackwardEuler(s) && s.step.integration == sim::Integration::Theta; }},
    SettingInfo{"sweeps", "Sweeps", "-", Advanced, SettingEffect::Step,
        IntegerField{[](auto& s) -> auto& { return s.step.jacobi.sweeps; }, 1, 99},
        "Number of block-Jacobi sweeps per step. The paper uses 1. More sweeps solve the linear system of the step "
        "more accurately. Must be odd unless relaxation is 0.8 or less."},
    SettingInfo{"relaxation", "Relaxation", "-", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.jacobi.relaxation; }, 0.1, 1.0, false},
        "Share of each Jacobi update that is applied. 1 is Jacobi as in the paper. Less is damped Jacobi."},
    SettingInfo{"derivative", "Derivative", "-", Advanced, SettingEffect::Step,
        choiceOf<derivatives, [](auto& s) -> auto& { return s.step.derivative; }>(),
        "Derivative of the spring forces: stabilised for compressed springs (the paper), exact, scalar (Desbrun), "
        "axial (Volino) or tension only (Choi and Ko)."},
    SettingInfo{"iterations", "Iterations", "-", Advanced, SettingEffect::Step,
        IntegerField{[](auto& s) -> auto& { return s.step.iteration.iterations; }, 1, 1000},
        "Number of iterations per step, for methods with a fixed number."},
    SettingInfo{"spectral_radius", "Spectral radius", "-", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.iteration.spectralRadius; }, 0.0, 0.9999, false},
        "Estimate of the largest eigenvalue of the iteration, which the acceleration uses. A small value "
        "accelerates little. A large value overshoots."},
    SettingInfo{"tolerance", "Tolerance", "-", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.iteration.tolerance; }, 1e-14, 0.5, true},
        "A solve ends when its residual is smaller than this share of the first residual."},
    SettingInfo{"max_iterations", "Max iterations", "-", Advanced, SettingEffect::Step,
        IntegerField{[](auto& s) -> auto& { return s.step.iteration.maxIterations; }, 1, 100000},
        "Maximum number of iterations of a solve. A solve that reaches it before its tolerance reports that, and "
        "the step uses what it found."},
    SettingInfo{"auto.cost", "Cost budget", "M/s", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.automatic.costBudget; }, 0.01, 1e6, true},
        "Maximum number of spring evaluations of auto, in millions per second of simulated time. One core does "
        "about 1000 million per second. auto.budget sets this value while it is not 0.",
        {}, {}, SettingScope::Everywhere, [](const Settings& s) { return s.automatic.budget == 0.0; }, "auto.work"},
    SettingInfo{"auto.soften", "Soften springs", "-", Advanced, SettingEffect::Step,
        FlagField{[](auto& s) -> auto& { return s.step.automatic.soften; }},
        "When the cost budget is too small for stiff and fine cloth: off slows the simulation down, on softens the "
        "springs, or takes implicit steps where pins hold the cloth taut. Counts while material.model is springs."},
    SettingInfo{"auto.strain", "Strain limit", "-", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.automatic.strainLimit; }, 0.0, 1.0, false},
        "When the cost budget is too small for a stiff fabric: auto lowers the stretch stiffness as long as the strain "
        "along warp and weft stays below this value. Shear, bending and mass keep their values. 0: the full stiffness. "
        "In the window a scene that leaves it at 0 begins with 0.01. Counts while material.model is fabric.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"auto.budget", "Time budget", "ms", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.automatic.budget; }, 0.0, 1000.0, false},
        "Computing time of auto for each 1/60 s of motion. 0: auto.cost counts instead. Drape measures the cost "
        "during the run, so the motion depends on the machine. A recorded session replays exactly all the same."},
    SettingInfo{"auto.tolerance", "Error tolerance", "m", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.automatic.errorTolerance; }, 1e-12, 1.0, true},
        "Mean position error that auto allows in 0.2 s of motion, as far as the cost budget permits."},
    SettingInfo{"keep_momentum", "Keep momentum", "-", Advanced, SettingEffect::Step,
        FlagField{[](auto& s) -> auto& { return s.step.keepMomentum; }},
        "Restores the linear and angular momentum that a step took from free cloth. Does not change pieces with "
        "pinned vertices."},
    SettingInfo{"precision", "Precision", "-", Advanced, SettingEffect::Step,
        choiceOf<precisions, [](auto& s) -> auto& { return s.step.precision; }>(),
        "Number format of the calculation. float is about twice as fast. double is for comparisons with other "
        "programs and for very small steps. States are stored and written in double."},
    SettingInfo{"threads", "Threads", "-", Advanced, SettingEffect::Step,
        IntegerField{[](auto& s) -> auto& { return s.step.threads; }, 1, 64},
        "Maximum number of threads of one step. Any number gives the same result to the last bit. The window begins with "
        "one thread less than the computer has cores."},
    SettingInfo{"speed", "Speed", "-", Simulation, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.playback.speed; }, 0.01, 4.0, true},
        "Simulated seconds per second of real time in the viewer. Below 1 is slow motion."},
    SettingInfo{"gravity", "Gravity", "m/s^2", Simulation, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.gravity; }, 0.0, 1000.0, false},
        "Acceleration downwards, along -y."},

    SettingInfo{"ghost.solver", "Solver", "-", Ghost, SettingEffect::Step,
        textOf<[](auto& s) -> auto& { return s.ghost.solver; }>(ghostNames, solverLabel),
        "Method that moves a second cloth, for comparison with the first. off: no second cloth. It starts where the "
        "first cloth is, shares all other settings and does not affect the first cloth."},
    SettingInfo{"ghost.substeps", "Substeps", "-", Ghost, SettingEffect::Step,
        IntegerField{[](auto& s) -> auto& { return s.ghost.substeps; }, 1, 1000},
        "Number of equal parts of each time step of the second cloth.",
        {}, {}, SettingScope::Everywhere, showsGhost},
    SettingInfo{"ghost.offset", "Offset", "m", Ghost, SettingEffect::View,
        NumberField{[](auto& s) -> auto& { return s.ghost.offset; }, -10.0, 10.0, false},
        "Distance by which the second cloth is drawn to the right. 0 draws it over the first. Its simulated "
        "position does not change.",
        {}, {}, SettingScope::Everywhere, showsGhost},

    SettingInfo{"material.model", "Model", "-", Material, SettingEffect::Fabric,
        textOf<[](auto& s) -> auto& { return s.material.model; }>(wordsIn<materialModels>, labelIn<materialModels>),
        "What the cloth is made of. springs: a spring on every edge of the mesh, as in the paper. fabric: a sheet with "
        "warp and weft, whose stiffness does not depend on the mesh."},
    SettingInfo{"material.preset", "Fabric", "-", Material, SettingEffect::Fabric,
        ChoiceField{presetOf, setPreset, fabricNames, fabricLabel, isCustomFabric, noPreset, ownFabricChoices},
        "A fabric by name: a built-in one, or one of your own (docs/guide/fabrics.md). It sets all fabric values except "
        "the direction of warp. \"cotton, changed\" and custom set no value: the values are given one by one. Counts "
        "while material.model is fabric, and for the look while view.surface is fabric.",
        {}, {}, SettingScope::Everywhere, namesFabric, {}, true},
    SettingInfo{"fabric.stretch_warp", "Stretch warp", "N/m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.stretchWarp; }, 0.1, 1e6, true},
        "Stretch modulus of the fabric along warp: force per width and strain.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.stretch_weft", "Stretch weft", "N/m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.stretchWeft; }, 0.1, 1e6, true},
        "Stretch modulus of the fabric along weft: force per width and strain.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.shear", "Shear", "N/m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.shear; }, 0.1, 1e6, true},
        "Shear modulus of the fabric between warp and weft: shear force per width and angle in radians.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.poisson", "Poisson", "-", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.poisson; }, -0.95, 0.95, false},
        "Contraction of the fabric across a stretch. For equal stretch moduli it is Poisson's ratio.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.stiffening_strain", "Stiffen above", "-", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.stiffeningStrain; }, 0.0, 10.0, false},
        "Strain (Green's) along warp or weft above which the fabric stiffens.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.stiffening_warp", "Stiffen warp", "N/m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.stiffeningWarp; }, 0.0, 1e6, true},
        "What the stretch modulus along warp gains above fabric.stiffening_strain.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.stiffening_weft", "Stiffen weft", "N/m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.stiffeningWeft; }, 0.0, 1e6, true},
        "What the stretch modulus along weft gains above fabric.stiffening_strain.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.bend_warp", "Bend warp", "N m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.bendWarp; }, 0.0, 1.0, true},
        "Bending stiffness of the fabric along warp: moment per width and curvature. 1e-05 is about that of a shirt, "
        "1e-04 that of denim.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.bend_weft", "Bend weft", "N m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.bendWeft; }, 0.0, 1.0, true},
        "Bending stiffness of the fabric along weft: moment per width and curvature.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.bend_bias", "Bend bias", "N m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.bendBias; }, 0.0, 1.0, true},
        "Bending stiffness of the fabric along the bias, at 45 degrees to warp. Must be at least a quarter of the sum of "
        "fabric.bend_warp and fabric.bend_weft.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.stretch_damping", "Damp stretch", "s", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.stretchDamping; }, 0.0, 1.0, true},
        "Time constant of the damping of stretch and shear: a strain rate causes the stress of a strain of the rate "
        "times this.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.bend_damping", "Damp bending", "s", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.moduli.bendDamping; }, 0.0, 1.0, true},
        "Time constant of the damping of bending. A vibration of the angular frequency omega decays at the rate "
        "omega^2 / 2 times this.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.warp_from", "Warp from", "-", Material, SettingEffect::Fabric,
        textOf<[](auto& s) -> auto& { return s.fabric.warpFrom; }>(wordsIn<warpSources>, labelIn<warpSources>),
        "Where warp runs before fabric.warp_angle turns it. uv: along V of the mesh's texture coordinates (UVs), which "
        "must be neither degenerate nor mirrored. vertical: vertical at rest, or along x where the cloth is level. "
        "auto: uv where the UVs are the rest shape, or a flat pattern, stretched by less than 1.5 nearly everywhere; else "
        "vertical.",
        {}, {}, SettingScope::Everywhere, namesFabric},
    SettingInfo{"fabric.warp_angle", "Warp angle", "degrees", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.warpAngle; }, -90.0, 90.0, false},
        "Angle by which warp is turned about the normal of the cloth from its direction by fabric.warp_from. 45 is cut on "
        "the bias.",
        {}, {}, SettingScope::Everywhere, namesFabric},
    SettingInfo{"fabric.rest_shape", "Rest shape", "-", Material, SettingEffect::Fabric,
        textOf<[](auto& s) -> auto& { return s.fabric.restShape; }>(wordsIn<restShapes>, labelIn<restShapes>),
        "The shape in which the fabric is unstressed against stretch and shear. uv: the sewing pattern in the mesh's "
        "texture coordinates (UVs), which must be neither degenerate nor mirrored. Its area then sets the mass of a given "
        "density, and warp runs along V. mesh: each triangle of the mesh as it is.",
        {}, {}, SettingScope::MeshFile, usesFabric},
    SettingInfo{"fabric.rest_curvature", "Rest curvature", "-", Material, SettingEffect::Fabric,
        textOf<[](auto& s) -> auto& { return s.fabric.restCurvature; }>(wordsIn<restCurvatures>, labelIn<restCurvatures>),
        "The shape in which the fabric has no bending moments. flat: it tends to unroll. mesh: it keeps the curvature of "
        "the mesh, as moulded, pressed or pleated cloth does.",
        {}, {}, SettingScope::MeshFile, usesFabric},
    SettingInfo{"fabric.uv_scale", "UV scale", "m", Material, SettingEffect::Fabric,
        NumberField{[](auto& s) -> auto& { return s.fabric.uvScale; }, 0.0, 100.0, true},
        "Size of a UV unit while fabric.rest_shape is uv. 0: the pattern gets the area of the mesh.",
        {}, {}, SettingScope::MeshFile, restsOnPattern},
    SettingInfo{"fabric.own_density", "Own density", "-", Material, SettingEffect::Mass,
        FlagField{[](auto& s) -> auto& { return s.fabric.ownDensity; }},
        "Whether fabric.density sets the weight of the cloth while material.model is fabric. Setting density or mass "
        "switches it off.",
        {}, {}, SettingScope::Everywhere, usesFabric},
    SettingInfo{"fabric.density", "Fabric density", "kg/m^2", Material, SettingEffect::Mass,
        NumberField{[](auto& s) -> auto& { return s.fabric.density; }, 1e-3, 100.0, true},
        "Mass per square metre of the fabric.",
        {}, {}, SettingScope::Everywhere, weighsAsFabric},
    SettingInfo{"stiffness", "Stiffness", "N/m", Material, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.material.stiffness; }, 0.0, 1e7, true},
        "Stiffness of every spring against stretching and compression. Counts while material.model is springs.",
        {}, {}, SettingScope::Everywhere, usesSprings},
    SettingInfo{"damping", "Damping", "N s/m", Material, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.material.damping; }, 0.0, 100.0, true},
        "Damping of every spring: force per metre per second of relative velocity between its ends. Counts while "
        "material.model is springs.",
        {}, {}, SettingScope::Everywhere, usesSprings},
    SettingInfo{"mass_given_as", "Mass given as", "-", Material, SettingEffect::Mass,
        textOf<[](auto& s) -> auto& { return s.material.massGivenAs; }>(
            [] { return std::vector<std::string>{"density", "mass"}; }),
        "Whether density or mass sets the weight of the cloth. Setting either of them selects it.",
        "fabric.own_density", "off", SettingScope::Everywhere, weighsAsGiven},
    SettingInfo{"density", "Density", "kg/m^2", Material, SettingEffect::Mass,
        NumberField{[](auto& s) -> auto& { return s.material.density; }, 1e-3, 100.0, true},
        "Mass per square metre of cloth. Silk is about 0.06, cotton 0.15, denim 0.4.",
        "mass_given_as", "density", SettingScope::Everywhere, weighsAsGiven},
    SettingInfo{"mass", "Mass", "kg", Material, SettingEffect::Mass,
        NumberField{[](auto& s) -> auto& { return s.material.mass; }, 1e-6, 1000.0, true},
        "Mass of the whole cloth.", "mass_given_as", "mass", SettingScope::Everywhere, weighsAsGiven},
    SettingInfo{"mass_lumping", "Mass lumping", "-", Advanced, SettingEffect::Mass,
        textOf<[](auto& s) -> auto& { return s.material.lumping; }>(
            [] { return std::vector<std::string>{"area", "uniform"}; }),
        "Distribution of the mass over the vertices: by the area around each vertex, or equal for all as in the "
        "paper."},

    SettingInfo{"self_collision", "Self-collision", "-", Contact, SettingEffect::Step,
        choiceOf<selfCollisions, [](auto& s) -> auto& { return s.step.contact.self; }>(),
        "Method that keeps the cloth from passing through itself."},
    SettingInfo{"self_thickness", "Self thickness", "m", Contact, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.contact.selfThickness; }, 0.0, 1.0, false},
        "Distance between vertices of different layers. 0 uses three quarters of the mean edge length. At much "
        "smaller values vertices slip through between others. Counts while self_collision is hash.",
        {}, {}, SettingScope::Everywhere, collidesByHash},
    SettingInfo{"self_friction", "Self friction", "-", Contact, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.contact.kineticFriction; }, 0.0, 2.0, false},
        "Friction of cloth that slides on cloth.",
        {}, {}, SettingScope::Everywhere, collidesWithItself},
    SettingInfo{"self_static_friction", "Self static", "-", Contact, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.contact.staticFriction; }, 0.0, 2.0, false},
        "Friction that holds layers of cloth together until they slide.",
        {}, {}, SettingScope::Everywhere, collidesWithItself},

    SettingInfo{"body_friction", "Body friction", "-", Contact, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.contact.bodyFriction; }, 0.0, 10.0, false},
        "Factor on the friction of the bodies, which are set for cotton. A fabric that is chosen in material.preset sets "
        "it, and the friction of cloth on cloth."},

    SettingInfo{"air.model", "Air model", "-", Air, SettingEffect::Step,
        choiceOf<airModels, [](auto& s) -> auto& { return s.step.air.model; }>(),
        "Law of drag and lift."},
    SettingInfo{"drag", "Drag", "-", Air, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.air.drag; }, 0.0, 10.0, false},
        "Drag coefficient C_D of the air's resistance along the relative velocity. The force on a vertex of area S is "
        "1/2 rho C_D S times the speed times its part along the normal. As a thin plate: of cloth that faces the wind."},
    SettingInfo{"lift", "Lift", "-", Air, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.air.lift; }, 0.0, 10.0, false},
        "Lift coefficient C_L: the air's force perpendicular to the relative velocity, strongest where the surface "
        "is parallel to it."},
    SettingInfo{"air.edge_drag", "Edge drag", "-", Air, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.air.edgeDrag; }, 0.0, 1.0, false},
        "Drag coefficient of cloth that is parallel to the wind. Values above the drag count as the drag.",
        {}, {}, SettingScope::Everywhere, actsAsPlate},
    SettingInfo{"air_density", "Air density", "kg/m^3", Air, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.air.density; }, 0.0, 1000.0, false},
        "Density rho of the air. Air at sea level has 1.225, water 1000."},
    SettingInfo{"wind.x", "Wind x", "m/s", Air, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.air.wind.x(); }, -100.0, 100.0, false},
        "Velocity of the air to the right. Wind acts through drag and lift."},
    SettingInfo{"wind.y", "Wind y", "m/s", Air, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.air.wind.y(); }, -100.0, 100.0, false},
        "Velocity of the air upwards. Wind acts through drag and lift."},
    SettingInfo{"wind.z", "Wind z", "m/s", Air, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.air.wind.z(); }, -100.0, 100.0, false},
        "Velocity of the air towards the front. Wind acts through drag and lift."},

    SettingInfo{"bodies", "Bodies", "-", Contact, SettingEffect::Step,
        FlagField{[](auto& s) -> auto& { return s.step.contact.bodies; }},
        "Keeps the cloth out of the scene's bodies. Costs nothing in scenes without bodies."},
    SettingInfo{"cloth_thickness", "Thickness", "m", Contact, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.step.contact.thickness; }, 0.001, 0.05, true},
        "Thickness of the cloth in contact. The cloth keeps a distance of half of it, plus the body's own "
        "thickness. With exact self-collision its layers keep the whole of it."},
    SettingInfo{"view.contacts", "Draw contacts", "-", Contact, SettingEffect::View,
        FlagField{[](auto& s) -> auto& { return s.view.contacts; }},
        "Draws the contacts of the last step with their normals."},
    SettingInfo{"view.intersections", "Draw intersections", "-", Contact, SettingEffect::View,
        FlagField{[](auto& s) -> auto& { return s.view.intersections; }},
        "Draws the lines along which the cloth intersects itself, in red."},

    SettingInfo{"unit", "Mesh unit", "-", Scene, SettingEffect::Scene,
        textOf<[](auto& s) -> auto& { return s.mesh.unit; }>(
            wordsIn<units>, labelIn<units>, isUnitFactor, "metres per unit from 1e-06 to 1000"),
        "Unit of the coordinates in a mesh file: a word, or metres per unit such as 0.0254. auto guesses it from the "
        "size. Opened mesh files start with auto, scene files with m.",
        {}, {}, SettingScope::MeshFile},
    SettingInfo{"up", "Mesh up axis", "-", Scene, SettingEffect::Scene,
        textOf<[](auto& s) -> auto& { return s.mesh.up; }>(
            [] { return std::vector<std::string>{"auto", "y", "z", "x", "-y", "-z"}; }),
        "The axis of a mesh file that points up. The mesh is turned so that this axis becomes y. auto guesses y or z "
        "from the shape. Opened mesh files start with auto, scene files with y.",
        {}, {}, SettingScope::MeshFile},
    SettingInfo{"weld_tolerance", "Weld tolerance", "-", Advanced, SettingEffect::Scene,
        NumberField{[](auto& s) -> auto& { return s.mesh.weldTolerance; }, 0.0, 0.01, false},
        "Merges mesh vertices that are closer to each other than this share of the mesh's diagonal.", {}, {}, SettingScope::MeshFile},
    SettingInfo{"outliers", "Far vertices", "-", Scene, SettingEffect::Scene,
        textOf<[](auto& s) -> auto& { return s.mesh.outliers; }>(
            [] { return std::vector<std::string>{"refuse", "leave_out"}; }),
        "What happens when vertices of a mesh file lie far from all others: the file is refused, or they are left out "
        "with their faces.",
        {}, {}, SettingScope::MeshFile},
    SettingInfo{"subdivide", "Subdivision", "-", Scene, SettingEffect::Scene,
        IntegerField{[](auto& s) -> auto& { return s.mesh.subdivide; }, 0, 3},
        "How often each triangle of a mesh file is divided into four. The shape stays the same, and wrinkles become finer. "
        "Each division makes the computing time of a step about eight times as long.",
        {}, {}, SettingScope::MeshFile},
    SettingInfo{"pins", "Pins", "-", Scene, SettingEffect::Scene,
        textOf<[](auto& s) -> auto& { return s.mesh.pins; }>(wordsIn<pinSources>, labelIn<pinSources>),
        "Vertices that are fixed: the pins of the scene, pins chosen from the shape, the topmost vertices, or none. "
        "Opened mesh files start with shape."},
    SettingInfo{"grid.resolution", "Grid resolution", "-", Scene, SettingEffect::Scene,
        IntegerField{[](auto& s) -> auto& { return s.grid.resolution; }, 2, 1025},
        "Number of vertices along the shorter side of a grid.", {}, {}, SettingScope::Grid},
    SettingInfo{"grid.width", "Grid width", "m", Scene, SettingEffect::Scene,
        NumberField{[](auto& s) -> auto& { return s.grid.width; }, 0.01, 100.0, true},
        "Length of the rows of a grid.", {}, {}, SettingScope::Grid},
    SettingInfo{"grid.height", "Grid height", "m", Scene, SettingEffect::Scene,
        NumberField{[](auto& s) -> auto& { return s.grid.height; }, 0.01, 100.0, true},
        "Length of the columns of a grid.", {}, {}, SettingScope::Grid},
    SettingInfo{"attachment.stiffness", "Mouse stiffness", "N/m", Scene, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.attachment.stiffness; }, 0.1, 1e5, true},
        "Stiffness of the mouse spring, which pulls the cloth.",
        {}, {}, SettingScope::Everywhere, nullptr, "hand.stiffness"},
    SettingInfo{"attachment.max_force", "Mouse force", "N", Scene, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.attachment.maxForce; }, 0.01, 1000.0, true},
        "Maximum force of the mouse spring. The force is also limited to about what stretches the cloth around the "
        "attached point by a fifth.",
        {}, {}, SettingScope::Everywhere, nullptr, "hand.max_force"},

    SettingInfo{"view.wireframe", "Wireframe", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](auto& s) -> auto& { return s.view.wireframe; }},
        "Draws the edges of the triangles, which are the springs."},
    SettingInfo{"view.surface", "Surface", "-", SettingGroup::View, SettingEffect::View,
        textOf<[](auto& s) -> auto& { return s.view.surface; }>(
            wordsIn<surfaces>, labelIn<surfaces>),
        "Look of the cloth: a checker along its texture coordinates, one colour, or the woven or knitted structure and "
        "the colours of the fabric in material.preset. auto draws springs as a checker, and a fabric as itself."},
    SettingInfo{"view.colour_map", "Colour map", "-", SettingGroup::View, SettingEffect::View,
        textOf<[](auto& s) -> auto& { return s.view.colourMap; }>(colourMapNames, colourMapLabel),
        "Colours the cloth by a quantity, with a legend. off shows the cloth's own look."},
    SettingInfo{"view.colour_range", "Colour range", "-", SettingGroup::View, SettingEffect::View,
        textOf<[](auto& s) -> auto& { return s.view.colourRange; }>(wordsIn<colourRanges>, labelIn<colourRanges>),
        "Values at the ends of the legend. auto follows the values of the cloth. fixed takes view.colour_low and "
        "view.colour_high.",
        {}, {}, SettingScope::Everywhere, showsColourMap},
    SettingInfo{"view.colour_low", "Lowest value", "-", SettingGroup::View, SettingEffect::View,
        NumberField{[](auto& s) -> auto& { return s.view.colourLow; }, -1e6, 1e6, false},
        "Value at the low end of the legend, in the unit of the colour map.",
        "view.colour_range", "fixed", SettingScope::Everywhere, showsColourMap},
    SettingInfo{"view.colour_high", "Highest value", "-", SettingGroup::View, SettingEffect::View,
        NumberField{[](auto& s) -> auto& { return s.view.colourHigh; }, -1e6, 1e6, false},
        "Value at the high end of the legend, in the unit of the colour map.",
        "view.colour_range", "fixed", SettingScope::Everywhere, showsColourMap},
    SettingInfo{"view.ground", "Ground", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](auto& s) -> auto& { return s.view.ground; }},
        "Draws the ground. The ground stops the cloth even when it is not drawn. The Contact panel switches this "
        "contact off."},
    SettingInfo{"view.shadows", "Shadows", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](auto& s) -> auto& { return s.view.shadows; }},
        "Draws shadows."},
    SettingInfo{"view.occlusion", "Ambient occlusion", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](auto& s) -> auto& { return s.view.occlusion; }},
        "Darkens folds, and surfaces that lie close to each other, where less light of the room arrives."},
    SettingInfo{"view.wrinkles", "Wrinkles", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](auto& s) -> auto& { return s.view.wrinkles; }},
        "Draws wrinkles that are smaller than the triangles, where the mesh is compressed. They change the light only, not "
        "the motion or the exports. The wireframe, colour maps and the ghost have none."},
    SettingInfo{"view.pins", "Pins", "-", SettingGroup::View, SettingEffect::View,
        FlagField{[](auto& s) -> auto& { return s.view.pins; }},
        "Draws a dot at each pinned vertex. Pictures saved with F12 never show them."},
    SettingInfo{"view.font_scale", "Font scale", "-", SettingGroup::View, SettingEffect::View,
        NumberField{[](auto& s) -> auto& { return s.view.fontScale; }, 0.0, 4.0, false},
        "Size of the text in the panels. 0 uses the scale of the monitor."},

    SettingInfo{"timeline.memory", "Timeline memory", "MB", Advanced, SettingEffect::Step,
        NumberField{[](auto& s) -> auto& { return s.timeline.memory; }, 0.0, 16000.0, true},
        "Memory for the states of the last minute, to which the slider below the picture returns. With less memory, states "
        "are farther apart. 0 records none. The window starts with 200."},
    SettingInfo{"energy_balance", "Energy balance", "-", Advanced, SettingEffect::Step,
        FlagField{[](auto& s) -> auto& { return s.measures.energyBalance; }},
        "Computes in every step how much energy damping, air, mouse spring and the method itself add or remove. "
        "Costs one more force evaluation."},
    SettingInfo{"error_check", "Error check", "-", Advanced, SettingEffect::Step,
        FlagField{[](auto& s) -> auto& { return s.measures.errorCheck; }},
        "Compares 0.2 s of the motion with a more accurate one every 5 s, and shows the position error, or that it cannot be "
        "known because tiny differences grow too fast. Uses another core for a few steps, for stiff and fine cloth all the "
        "time; does not change the motion. The window starts with it on machines with four or more cores."},
};
// clang-format on

}  // namespace

Settings::Settings() {
  step.precision = sim::Precision::Float;
  step.contact.self = sim::contact::SelfCollision::Auto;
  setPreset(*this, "cotton");
}

std::span<const SettingInfo> settingsTable() {
  return table;
}

const SettingInfo* findSetting(std::string_view key) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const SettingInfo& row) {
    return row.key == key || (!row.formerKey.empty() && row.formerKey == key);
  });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace drape::settings

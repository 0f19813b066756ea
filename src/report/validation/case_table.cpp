#include "fabrics/presets.hpp"
#include "report/validation/cases.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The table of the validation cases.
namespace drape::report::validation {
namespace {

constexpr CaseGroup membraneGroup = CaseGroup::Membrane;
constexpr CaseGroup bendingGroup = CaseGroup::Bending;
constexpr CaseGroup motionGroup = CaseGroup::Motion;

constexpr std::array frequencyResolutions{8, 16, 32};
constexpr std::array coarseResolutions{5, 10, 20};
constexpr std::array stripResolutions{6, 8, 12};
constexpr std::array discResolutions{12, 24, 48};
constexpr std::array remeshedResolutions{18, 34, 48};  // a half, two and four times the vertices of 24 cells
constexpr std::array oneKind{MeshKind::Alternating};
constexpr std::array otherKinds{MeshKind::Grid, MeshKind::Irregular};
constexpr std::array lateralResolutions{20, 40, 80};
constexpr std::array skirtResolutions{7, 14, 20};  // a half, two and four times the vertices of 10 cells
constexpr std::array skirtKind{MeshKind::Irregular};

/// The lowest mode of the stretched membrane with a solver.
ValidationCase membraneWith(std::string_view solver, std::string_view reason = {}) {
  return {.group = CaseGroup::Frequency,
          .name = "membrane_" + std::string(solver),
          .title = "Stretched square membrane, lowest mode",
          .compared = "frequency, sqrt(S / density) sqrt(2) / (2 L)",
          .unit = "1/s",
          .aim = 0.01,
          .run = membraneMode11,
          .resolutions = frequencyResolutions,
          .subject = solver,
          .reason = reason};
}

/// The lowest mode of the clamped strip with a solver.
ValidationCase stripWith(std::string_view solver, std::string_view reason = {}) {
  return {.group = CaseGroup::Frequency,
          .name = "strip_" + std::string(solver),
          .title = "Clamped strip, lowest mode",
          .compared = "frequency, 3.516 sqrt(B / density) / (2 pi L^2)",
          .unit = "1/s",
          .aim = 0.01,
          .run = stripMode,
          .resolutions = frequencyResolutions,
          .subject = solver,
          .reason = reason};
}

/// The same with as many substeps as the warning of the solver asks for.
ValidationCase substeppedStripWith(std::string_view solver) {
  ValidationCase strip = stripWith(solver);
  strip.name += "_substeps";
  strip.title = "Clamped strip, lowest mode, with the substeps of the solver's warning";
  strip.run = substeppedStripMode;
  strip.kinds = oneKind;
  return strip;
}

/// A case of a solver that moves a sheet.
ValidationCase motionOf(const char* name, const char* title, const char* compared, const char* unit,
                        Comparison (*run)(const CaseMesh&)) {
  return {.group = motionGroup,
          .name = name,
          .title = title,
          .compared = compared,
          .unit = unit,
          .aim = 0.01,
          .run = run,
          .resolutions = coarseResolutions,
          .subject = "auto"};
}

/// Peirce's cantilever of a preset along warp.
ValidationCase peirceOf(const fabrics::Preset& preset) {
  const std::string name(preset.name);
  return {.group = bendingGroup,
          .name = "peirce_" + name,
          .title = "Peirce's cantilever, " + name + " along warp",
          .compared = "overhang at a chord of 41.5 degrees, from the heavy elastica",
          .unit = "m",
          .aim = 0.01,
          .run = peirceWarp,
          .subject = preset.name};
}

/// The same along weft.
ValidationCase peirceAlongWeftOf(const fabrics::Preset& preset) {
  ValidationCase weft = peirceOf(preset);
  weft.name += "_weft";
  weft.title = "Peirce's cantilever, " + std::string(preset.name) + " along weft";
  weft.run = peirceWeft;
  return weft;
}

/// Why the drape coefficient of a preset is outside its range; empty where it is within.
std::string_view reasonOutsideRange(std::string_view preset) {
  struct Reason {
    std::string_view preset;
    std::string_view reason;
  };
  static constexpr std::array reasons{
      Reason{"silk",
             "The preset has the shear stiffness of a stiff silk, 136 N/m; with 20 N/m the coefficient is 54. Its "
             "bending length of 18 mm is that of fabrics with 35 to 50 %. Published silks are lighter and softer."},
      Reason{"jersey",
             "The preset has the bending stiffness that Wang et al. measured, which is several times that of light "
             "jerseys in drape tests."},
      Reason{"rubber", "No equilibrium was found: the folds would touch, and the search ignores contact."}};
  const auto* const found = std::ranges::find_if(reasons, [&](const Reason& one) { return one.preset == preset; });
  return found == reasons.end() ? std::string_view() : found->reason;
}

std::string_view comparedWith(const std::optional<fabrics::DrapeRange>& range) {
  if (!range) {
    return "drape coefficient, no range is known";
  }
  return range->estimated ? "drape coefficient, estimated range" : "drape coefficient, usual range";
}

/// Cusick's drape test of a preset.
ValidationCase cusickOf(const fabrics::Preset& preset) {
  const std::string name(preset.name);
  return {.group = CaseGroup::Drape,
          .name = "cusick_" + name,
          .title = "Cusick's drape test, " + name,
          .compared = std::string(comparedWith(preset.drape)),
          .unit = "%",
          .aim = 0.001,
          .run = cusick,
          .resolutions = discResolutions,
          .kinds = oneKind,
          .shortResolutions = static_cast<std::size_t>(preset.drape ? 2 : 1),
          .subject = preset.name,
          .reason = reasonOutsideRange(preset.name)};
}

constexpr std::string_view lockingReason =
    "Flat triangles of a fabric that hardly stretches cannot bend in two directions at once, so a coarse mesh is too "
    "stiff where folds begin.";

constexpr std::string_view lockingReasonOfCotton =
    "Flat triangles of a fabric that hardly stretches cannot bend in two directions at once, so a coarse mesh is too "
    "stiff where folds begin. On the irregular mesh with 48 cells no equilibrium was found.";

ValidationCase remeshedDiscOf(const fabrics::Preset& preset) {
  const std::string name(preset.name);
  return {.group = CaseGroup::Drape,
          .name = "remeshed_disc_" + name,
          .title = "Cusick's disc of " + name + ", remeshed",
          .compared = "drape coefficient, within 3 points of that with 24 cells",
          .unit = "%",
          .aim = 0.001,
          .run = remeshedDisc,
          .resolutions = remeshedResolutions,
          .everyResolution = true,
          .shortResolutions = 1,
          .subject = preset.name,
          .reason = lockingReason};
}

ValidationCase capeCase() {
  return {.group = CaseGroup::Drape,
          .name = "remeshed_cape",
          .title = "Round cape of denim, 12 cm long, remeshed",
          .compared = "mean depth of the hem, compared with that with 24 cells",
          .unit = "m",
          .aim = 0.02,
          .run = remeshedCape,
          .resolutions = remeshedResolutions,
          .kinds = oneKind,
          .everyResolution = true,
          .shortResolutions = 1,
          .subject = "denim",
          .reason = lockingReason};
}

ValidationCase skirtCase() {
  return {.group = CaseGroup::Drape,
          .name = "remeshed_skirt",
          .title = "Built-in skirt of denim, remeshed",
          .compared = "mean height from waist to hem, compared with that of 10 cells",
          .unit = "m",
          .aim = 0.02,
          .run = remeshedSkirt,
          .resolutions = skirtResolutions,
          .kinds = skirtKind,
          .everyResolution = true,
          .shortResolutions = 1,
          .subject = "denim"};
}

constexpr std::string_view gainsEnergy =
    "The explicit Euler method gains energy in every oscillation that nothing damps, at any time step.";
constexpr std::string_view tooFewIterations =
    "The number of iterations in a step is fixed and too small for this mesh, so the motion is too slow.";
constexpr std::string_view tooFewIterationsOfStrip =
    "The number of iterations in a step is fixed and too small for this mesh: the fastest vibration of the membrane "
    "turns by 60 to 900 rad in a step of a hundredth of the period. So the motion is too slow, and the solver warns.";
constexpr std::string_view tooFewIterationsOfXpbd =
    "The number of iterations in a step is fixed and too small for this mesh: the fastest vibration of the membrane "
    "turns by 60 to 900 rad in a step of a hundredth of the period. So the motion is too slow, and the solver warns. "
    "With the substeps that its warning asks for the error is below 0.3 % (strip_xpbd_substeps).";

// clang-format off
std::vector<ValidationCase> membraneCases() {
  return {
    {membraneGroup, "end_load_modulus", "Strip under an end load: stiffness",
        "E h from the strain in the middle, with Saint Venant-Kirchhoff's law", "N/m", 0.005, endLoadModulus},
    {membraneGroup, "end_load_poisson", "Strip under an end load: contraction",
        "Poisson's ratio from the strains in the middle", "", 0.005, endLoadPoisson},
    {membraneGroup, "own_weight", "Strip that hangs from one end",
        "elongation by its own weight, from the nonlinear law integrated over the strip", "m", 0.005, ownWeight},
    {membraneGroup, "picture_frame", "Picture frame",
        "shear modulus from the work of the frame at 0.3 rad", "N/m", 0.005, pictureFrame},
    {membraneGroup, "bias_extension", "Strip cut along the bias under an end load",
        "modulus along the bias, 4 / (S_11 + S_22 + 2 S_12 + 1 / G)", "N/m", 0.005, biasExtension},
    {membraneGroup, "hanging_strip", "Strip that hangs from both ends",
        "sag of the catenary", "m", 0.005, hangingStrip},
  };
}

std::vector<ValidationCase> elasticaCases() {
  return {
    {bendingGroup, "heavy_elastica_1.5", "Clamped strip under its weight, Gamma = 1.5",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaSmall},
    {bendingGroup, "heavy_elastica_5", "Clamped strip under its weight, Gamma = 5",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaMedium},
    {bendingGroup, "heavy_elastica_15", "Clamped strip under its weight, Gamma = 15",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaLarge},
    {bendingGroup, "heavy_elastica_46", "Clamped strip under its weight, Gamma = 46",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaHanging},
  };
}

std::vector<ValidationCase> plateCases() {
  return {
    {bendingGroup, "buckling", "Compressed strip with hinged ends",
        "load per width at which the flat strip becomes unstable, pi^2 B / L^2", "N/m", 0.01, buckling},
    {bendingGroup, "twist", "Square plate on a saddle",
        "twist stiffness of a plate whose corners are moved to y = k x z, energy 2 D_33 k^2 an area", "N m", 0.01, twist},
    {.group = bendingGroup, .name = "lateral_buckling", .title = "Strip on edge, clamped at one end",
        .compared = "weight at which it buckles sideways, from the eigenvalue problem of B = D_11 b and C = 4 D_33 b",
        .unit = "N/m^2", .aim = 0.01, .run = lateralBuckling, .resolutions = lateralResolutions,
        .reason = "The strip has few cells across its width, where the twist varies; the error falls with finer meshes."},
    {bendingGroup, "stick_slip", "Clamped strip, pressed upright onto a floor by a tenth of its length",
        "friction below which its lower end slips, from the elastica", "", 0.01, stickSlip},
  };
}

std::vector<ValidationCase> frequencyCases() {
  return {
    membraneWith("auto"),
    membraneWith("verlet"),
    membraneWith("explicit_euler", gainsEnergy),
    membraneWith("one_iteration", tooFewIterations),
    membraneWith("chebyshev", tooFewIterations),
    membraneWith("pcg"),
    membraneWith("newton"),
    membraneWith("vbd", tooFewIterations),
    membraneWith("xpbd", tooFewIterations),
    stripWith("auto"),
    stripWith("verlet"),
    stripWith("explicit_euler", gainsEnergy),
    stripWith("one_iteration", tooFewIterations),
    stripWith("chebyshev", tooFewIterations),
    stripWith("pcg"),
    stripWith("newton"),
    stripWith("vbd", tooFewIterationsOfStrip),
    stripWith("xpbd", tooFewIterationsOfXpbd),
    substeppedStripWith("xpbd"),
    {.group = CaseGroup::Frequency, .name = "membrane_22", .title = "Stretched square membrane, mode 2, 2",
        .compared = "frequency, sqrt(S / density) sqrt(8) / (2 L)", .unit = "1/s", .aim = 0.01, .run = membraneMode22,
        .resolutions = frequencyResolutions, .subject = "auto"},
  };
}

std::vector<ValidationCase> motionCases() {
  return {
    motionOf("incline_sticks", "Sheet on an incline: where it begins to slide",
        "slope, the coefficient of static friction", "", inclineSticks),
    motionOf("incline_slides", "Sheet on an incline: acceleration",
        "acceleration, g (sin a - mu cos a)", "m/s^2", inclineSlides),
    motionOf("terminal_velocity", "Falling sheet: terminal velocity",
        "speed at which drag carries the weight", "m/s", terminalVelocity),
    motionOf("fall_distance", "Falling sheet: distance",
        "distance after the time v / g, a v^2 / g log(cosh(1 / a)), with the terminal velocity v and the added mass in a",
        "m", fallDistance),
    {.group = motionGroup, .name = "flutter_tumble", .title = "Falling strip: from fluttering to tumbling",
        .compared = "Froude number from which it tumbles, 0.67 (Belmonte et al. 1998)", .unit = "", .aim = 0.2,
        .run = froudeOfTumbling, .resolutions = stripResolutions, .kinds = oneKind, .everyResolution = true,
        .shortResolutions = 1, .subject = "auto"},
  };
}
// clang-format on

/// One case for each preset, in the order of their table.
std::vector<ValidationCase> ofEveryPreset(ValidationCase (*caseOf)(const fabrics::Preset&)) {
  std::vector<ValidationCase> cases;
  std::ranges::transform(fabrics::presetTable(), std::back_inserter(cases), caseOf);
  return cases;
}

std::vector<ValidationCase> remeshedCases() {
  const fabrics::Preset& cotton = *fabrics::findPreset("cotton");
  const fabrics::Preset& denim = *fabrics::findPreset("denim");
  ValidationCase cottonDisc = remeshedDiscOf(cotton);
  cottonDisc.kinds = oneKind;
  cottonDisc.slowKinds = otherKinds;
  cottonDisc.reason = lockingReasonOfCotton;
  return {cottonDisc, remeshedDiscOf(denim), capeCase(), skirtCase()};
}

std::vector<ValidationCase> allCases() {
  std::vector<ValidationCase> all;
  const auto append = [&](std::vector<ValidationCase> cases) { std::ranges::move(cases, std::back_inserter(all)); };
  append(membraneCases());
  append(elasticaCases());
  append(ofEveryPreset(peirceOf));
  append({peirceAlongWeftOf(*fabrics::findPreset("denim"))});
  append(plateCases());
  append(frequencyCases());
  append(motionCases());
  append(ofEveryPreset(cusickOf));
  append(remeshedCases());
  return all;
}

}  // namespace

std::span<const ValidationCase> validationTable() {
  static const std::vector<ValidationCase> table = allCases();
  return table;
}

}  // namespace drape::report::validation

#include "report/validation/cases.hpp"

#include <array>

/// The table of the validation cases.
namespace drape::report::validation {
namespace {

constexpr CaseGroup membraneGroup = CaseGroup::Membrane;
constexpr CaseGroup bendingGroup = CaseGroup::Bending;
constexpr CaseGroup motionGroup = CaseGroup::Motion;

constexpr std::array frequencyResolutions{8, 16, 32};
constexpr std::array coarseResolutions{5, 10, 20};
constexpr std::array discResolutions{12, 24, 48};
constexpr std::array remeshedResolutions{18, 34, 48};  // a half, two and four times the vertices of 24 cells
constexpr std::array oneKind{MeshKind::Alternating};
constexpr std::array lateralResolutions{20, 40, 80};
constexpr std::array skirtResolutions{7, 14, 20};  // a half, two and four times the vertices of 10 cells
constexpr std::array skirtKind{MeshKind::Irregular};

/// The lowest mode of the stretched membrane with a solver.
constexpr ValidationCase membraneWith(std::string_view name, std::string_view solver, std::string_view reason = {}) {
  return {.group = CaseGroup::Frequency,
          .name = name,
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
constexpr ValidationCase stripWith(std::string_view name, std::string_view solver, std::string_view reason = {}) {
  return {.group = CaseGroup::Frequency,
          .name = name,
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
constexpr ValidationCase substeppedStripWith(std::string_view name, std::string_view solver) {
  ValidationCase strip = stripWith(name, solver);
  strip.title = "Clamped strip, lowest mode, with the substeps of the solver's warning";
  strip.run = substeppedStripMode;
  strip.kinds = oneKind;
  return strip;
}

/// A case of a solver that moves a sheet.
constexpr ValidationCase motionOf(std::string_view name, std::string_view title, std::string_view compared,
                                  std::string_view unit, Comparison (*run)(const CaseMesh&)) {
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
constexpr ValidationCase peirceOf(std::string_view name, std::string_view preset, std::string_view title,
                                  Comparison (*run)(const CaseMesh&) = peirceWarp) {
  return {.group = bendingGroup,
          .name = name,
          .title = title,
          .compared = "overhang at a chord of 41.5 degrees, from the heavy elastica",
          .unit = "m",
          .aim = 0.01,
          .run = run,
          .subject = preset};
}

/// Cusick's drape test of a preset.
constexpr ValidationCase cusickOf(std::string_view name, std::string_view preset, std::string_view title,
                                  std::string_view compared, std::string_view reason = {}) {
  return {.group = CaseGroup::Drape,
          .name = name,
          .title = title,
          .compared = compared,
          .unit = "%",
          .aim = 0.001,
          .run = cusick,
          .resolutions = discResolutions,
          .kinds = oneKind,
          .subject = preset,
          .reason = reason};
}

constexpr std::string_view usual = "drape coefficient, usual range";
constexpr std::string_view estimated = "drape coefficient, estimated range";
constexpr std::string_view unknown = "drape coefficient, no range is known";
constexpr std::string_view lockingReason =
    "Flat triangles of a fabric that hardly stretches cannot bend in two directions at once, so a coarse mesh is too "
    "stiff where folds begin.";

constexpr ValidationCase remeshedDiscOf(std::string_view name, std::string_view preset, std::string_view title,
                                        std::span<const MeshKind> kinds) {
  return {.group = CaseGroup::Drape,
          .name = name,
          .title = title,
          .compared = "drape coefficient, within 3 points of that with 24 cells",
          .unit = "%",
          .aim = 0.001,
          .run = remeshedDisc,
          .resolutions = remeshedResolutions,
          .kinds = kinds,
          .everyResolution = true,
          .subject = preset,
          .reason = lockingReason};
}

constexpr ValidationCase remeshedCapeOf(std::string_view name, std::string_view preset, std::string_view title,
                                        std::span<const MeshKind> kinds) {
  return {.group = CaseGroup::Drape,
          .name = name,
          .title = title,
          .compared = "mean depth of the hem, compared with that with 24 cells",
          .unit = "m",
          .aim = 0.02,
          .run = remeshedCape,
          .resolutions = remeshedResolutions,
          .kinds = kinds,
          .everyResolution = true,
          .subject = preset,
          .reason = lockingReason};
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
constexpr std::array casesOfValidation{
    ValidationCase{membraneGroup, "end_load_modulus", "Strip under an end load: stiffness",
        "E h from the strain in the middle, with Saint Venant-Kirchhoff's law", "N/m", 0.005, endLoadModulus},
    ValidationCase{membraneGroup, "end_load_poisson", "Strip under an end load: contraction",
        "Poisson's ratio from the strains in the middle", "", 0.005, endLoadPoisson},
    ValidationCase{membraneGroup, "own_weight", "Strip that hangs from one end",
        "elongation by its own weight, from the nonlinear law integrated over the strip", "m", 0.005, ownWeight},
    ValidationCase{membraneGroup, "picture_frame", "Picture frame",
        "shear modulus from the work of the frame at 0.3 rad", "N/m", 0.005, pictureFrame},
    ValidationCase{membraneGroup, "bias_extension", "Strip cut along the bias under an end load",
        "modulus along the bias, 4 / (S_11 + S_22 + 2 S_12 + 1 / G)", "N/m", 0.005, biasExtension},
    ValidationCase{membraneGroup, "hanging_strip", "Strip that hangs from both ends",
        "sag of the catenary", "m", 0.005, hangingStrip},
    ValidationCase{bendingGroup, "heavy_elastica_1.5", "Clamped strip under its weight, Gamma = 1.5",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaSmall},
    ValidationCase{bendingGroup, "heavy_elastica_5", "Clamped strip under its weight, Gamma = 5",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaMedium},
    ValidationCase{bendingGroup, "heavy_elastica_15", "Clamped strip under its weight, Gamma = 15",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaLarge},
    ValidationCase{bendingGroup, "heavy_elastica_46", "Clamped strip under its weight, Gamma = 46",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaHanging},
    peirceOf("peirce_silk", "silk", "Peirce's cantilever, silk along warp"),
    peirceOf("peirce_cotton", "cotton", "Peirce's cantilever, cotton along warp"),
    peirceOf("peirce_denim", "denim", "Peirce's cantilever, denim along warp"),
    peirceOf("peirce_canvas", "canvas", "Peirce's cantilever, canvas along warp"),
    peirceOf("peirce_wool", "wool", "Peirce's cantilever, wool along warp"),
    peirceOf("peirce_linen", "linen", "Peirce's cantilever, linen along warp"),
    peirceOf("peirce_jersey", "jersey", "Peirce's cantilever, jersey along warp"),
    peirceOf("peirce_nylon", "nylon", "Peirce's cantilever, nylon along warp"),
    peirceOf("peirce_polyester", "polyester", "Peirce's cantilever, polyester along warp"),
    peirceOf("peirce_felt", "felt", "Peirce's cantilever, felt along warp"),
    peirceOf("peirce_leather", "leather", "Peirce's cantilever, leather along warp"),
    peirceOf("peirce_rubber", "rubber", "Peirce's cantilever, rubber along warp"),
    peirceOf("peirce_denim_weft", "denim", "Peirce's cantilever, denim along weft", peirceWeft),
    ValidationCase{bendingGroup, "buckling", "Compressed strip with hinged ends",
        "load per width at which the flat strip becomes unstable, pi^2 B / L^2", "N/m", 0.01, buckling},
    ValidationCase{bendingGroup, "twist", "Square plate on a saddle",
        "twist stiffness of a plate whose corners are moved to y = k x z, energy 2 D_33 k^2 an area", "N m", 0.01, twist},
    ValidationCase{.group = bendingGroup, .name = "lateral_buckling", .title = "Strip on edge, clamped at one end",
        .compared = "weight at which it buckles sideways, from the eigenvalue problem of B = D_11 b and C = 4 D_33 b",
        .unit = "N/m^2", .aim = 0.01, .run = lateralBuckling, .resolutions = lateralResolutions,
        .reason = "The strip has few cells across its width, where the twist varies; the error falls with finer meshes."},
    ValidationCase{bendingGroup, "stick_slip", "Clamped strip, pressed upright onto a floor by a tenth of its length",
        "friction below which its lower end slips, from the elastica", "", 0.01, stickSlip},
    membraneWith("membrane_auto", "auto"),
    membraneWith("membrane_verlet", "verlet"),
    membraneWith("membrane_explicit_euler", "explicit_euler", gainsEnergy),
    membraneWith("membrane_one_iteration", "one_iteration", tooFewIterations),
    membraneWith("membrane_chebyshev", "chebyshev", tooFewIterations),
    membraneWith("membrane_pcg", "pcg"),
    membraneWith("membrane_newton", "newton"),
    membraneWith("membrane_vbd", "vbd", tooFewIterations),
    membraneWith("membrane_xpbd", "xpbd", tooFewIterations),
    stripWith("strip_auto", "auto"),
    stripWith("strip_verlet", "verlet"),
    stripWith("strip_explicit_euler", "explicit_euler", gainsEnergy),
    stripWith("strip_one_iteration", "one_iteration", tooFewIterations),
    stripWith("strip_chebyshev", "chebyshev", tooFewIterations),
    stripWith("strip_pcg", "pcg"),
    stripWith("strip_newton", "newton"),
    stripWith("strip_vbd", "vbd", tooFewIterationsOfStrip),
    stripWith("strip_xpbd", "xpbd", tooFewIterationsOfXpbd),
    substeppedStripWith("strip_xpbd_substeps", "xpbd"),
    ValidationCase{.group = CaseGroup::Frequency, .name = "membrane_22", .title = "Stretched square membrane, mode 2, 2",
        .compared = "frequency, sqrt(S / density) sqrt(8) / (2 L)", .unit = "1/s", .aim = 0.01, .run = membraneMode22,
        .resolutions = frequencyResolutions, .subject = "auto"},
    motionOf("incline_sticks", "Sheet on an incline: where it begins to slide",
        "slope, the coefficient of static friction", "", inclineSticks),
    motionOf("incline_slides", "Sheet on an incline: acceleration",
        "acceleration, g (sin a - mu cos a)", "m/s^2", inclineSlides),
    motionOf("terminal_velocity", "Falling sheet: terminal velocity",
        "speed at which drag carries the weight", "m/s", terminalVelocity),
    motionOf("fall_distance", "Falling sheet: distance",
        "distance after the time v / g, v^2 / g log(cosh(1)), with the terminal velocity v", "m", fallDistance),
    cusickOf("cusick_silk", "silk", "Cusick's drape test, silk", usual,
        "The preset has the shear stiffness of a stiff silk, 136 N/m; with 20 N/m the coefficient is 54. Its bending "
        "length of 18 mm is that of fabrics with 35 to 50 %. Published silks are lighter and softer."),
    cusickOf("cusick_cotton", "cotton", "Cusick's drape test, cotton", usual),
    cusickOf("cusick_denim", "denim", "Cusick's drape test, denim", usual),
    cusickOf("cusick_canvas", "canvas", "Cusick's drape test, canvas", estimated),
    cusickOf("cusick_wool", "wool", "Cusick's drape test, wool", usual),
    cusickOf("cusick_linen", "linen", "Cusick's drape test, linen", estimated),
    cusickOf("cusick_jersey", "jersey", "Cusick's drape test, jersey", estimated,
        "The preset has the bending stiffness that Wang et al. measured, which is several times that of light jerseys "
        "in drape tests."),
    cusickOf("cusick_nylon", "nylon", "Cusick's drape test, nylon", unknown),
    cusickOf("cusick_polyester", "polyester", "Cusick's drape test, polyester", unknown),
    cusickOf("cusick_felt", "felt", "Cusick's drape test, felt", unknown),
    cusickOf("cusick_leather", "leather", "Cusick's drape test, leather", usual,
        "The preset is a homogeneous sheet. Its bending length of 37 mm is twice that of leather with such a "
        "coefficient: layers of leather differ, and it bends more easily than its stretch stiffness suggests."),
    cusickOf("cusick_rubber", "rubber", "Cusick's drape test, rubber", unknown,
        "No equilibrium was found: the folds would touch, and the search ignores contact."),
    remeshedDiscOf("remeshed_disc_cotton", "cotton", "Cusick's disc of cotton, remeshed", oneKind),
    remeshedDiscOf("remeshed_disc_denim", "denim", "Cusick's disc of denim, remeshed", meshKinds),
    remeshedCapeOf("remeshed_cape", "denim", "Round cape of denim, 12 cm long, remeshed", oneKind),
    ValidationCase{.group = CaseGroup::Drape, .name = "remeshed_skirt", .title = "Built-in skirt of denim, remeshed",
        .compared = "mean height from waist to hem, compared with that of 10 cells", .unit = "m", .aim = 0.02,
        .run = remeshedSkirt, .resolutions = skirtResolutions, .kinds = skirtKind, .everyResolution = true,
        .subject = "denim"},
};
// clang-format on

}  // namespace

std::span<const ValidationCase> validationTable() {
  return casesOfValidation;
}

}  // namespace drape::report::validation

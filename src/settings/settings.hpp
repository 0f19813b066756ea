#pragma once

#include "settings/own_fabrics.hpp"
#include "sim/fabric/material.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/solvers/step_parameters.hpp"

#include <string>

namespace drape::settings {

/// All values that a user can change, with their defaults. The table (settings_table.cpp) holds the name, unit, range
/// and help of each. The panels, the command line, the scene files and the documentation use that table.
struct Settings {
  /// The library calculates in double by default. The programs use float where a solver supports it: it is at least as
  /// fast, and its error is too small to see (docs/guide/performance.md).
  Settings();

  sim::StepParameters step;

  struct SolverChoice {
    std::string name = "auto";
  } solver;

  /// Settings of the solver `auto` that are not in `step`.
  struct Auto {
    double budget = 0.0;  ///< computing time for each 1/60 s of motion [ms]; 0: step.automatic.costBudget counts
  } automatic;

  struct Material {
    std::string model = "springs";        ///< "springs" or "fabric"
    std::string massGivenAs = "density";  ///< which of the next two counts: "density" or "mass"
    double density = 0.15;                ///< [kg/m^2]
    double mass = 0.1;                    ///< [kg]
    std::string lumping = "area";         ///< "area" or "uniform"
  } material;

  /// Counts while material.model is "fabric". Starts as one of the presets (fabrics/presets.hpp).
  struct Fabric {
    sim::fabric::Material moduli;
    double density = 0.0;           ///< [kg/m^2]
    bool ownDensity = true;         ///< whether `density` counts instead of that of Material
    std::string preset = {};        ///< the fabric that was chosen last, whose values may be changed since; empty: none
    OwnFabrics own;                 ///< the user's fabrics, and those of the scene file
    std::string warpFrom = "auto";  ///< where warp runs: "auto", "vertical" or "uv" (along V of the mesh's UVs)
    double warpAngle = 0.0;         ///< by which warp is turned from there, in the plane of each triangle [degrees]
    std::string restShape = "mesh";      ///< "mesh" or "uv" (the pattern in the mesh's UVs)
    std::string restCurvature = "flat";  ///< the shape without bending moments: "flat" or "mesh"
    double uvScale = 0.0;                ///< size of a UV unit in the pattern [m]; 0: it has the area of the mesh
  } fabric;

  sim::AttachmentSpring attachment{.stiffness = 500.0, .maxForce = 10.0};

  struct Playback {
    double speed = 1.0;  ///< simulated seconds per second of real time, on a fast machine [-]
  } playback;

  struct Mesh {
    std::string unit = "m";           ///< of the file's coordinates: a word, metres per unit, or "auto" (guessed)
    std::string up = "y";             ///< the file's axis that points up, or "auto" (guessed)
    double weldTolerance = 1e-6;      ///< share of the bounding box's diagonal [-]
    std::string outliers = "refuse";  ///< vertices far from all others: "refuse" or "leave_out"
    int subdivide = 0;                ///< how often each triangle is divided into four
    std::string pins = "scene";       ///< "scene", "shape", "top" or "none"
  } mesh;

  struct Grid {
    int resolution = 17;  ///< vertices along the shorter side
    double width = 1.0;   ///< [m]
    double height = 1.0;  ///< [m]
  } grid;

  /// A second cloth, for comparison. It shares all other settings with the first.
  struct Ghost {
    std::string solver = "off";  ///< "off" or a solver's name
    int substeps = 1;            ///< number of equal parts of a step [-]
    double offset = 0.0;         ///< distance to the right at which it is drawn [m]
  } ghost;

  struct Measures {
    bool energyBalance = false;  ///< compute the energy balance in every step
    bool errorCheck = false;     ///< compare with a more accurate motion now and then
  } measures;

  struct Timeline {
    double memory = 0.0;  ///< for the states of the last minute [1e6 bytes]; 0: none are recorded
  } timeline;

  struct View {
    bool wireframe = false;
    std::string surface = "auto";  ///< "auto" (checker for springs, else fabric), "checker", "plain" or "fabric"
    bool ground = true;
    bool shadows = true;
    bool occlusion = true;  ///< ambient occlusion
    bool wrinkles = false;  ///< wrinkles that are smaller than the triangles
    bool contacts = false;
    bool intersections = false;
    bool pins = true;
    std::string colourMap = "off";     ///< "off" or a field (sim/fields/field_table.hpp)
    std::string colourRange = "auto";  ///< "auto" or "fixed"
    double colourLow = 0.0;            ///< of a fixed range, in the unit of the field
    double colourHigh = 1.0;           ///< likewise
    double fontScale = 0.0;            ///< 0: from the monitor's scale
  } view;
};

/// Whether the cloth is a fabric, not springs.
[[nodiscard]] inline bool usesFabric(const Settings& settings) {
  return settings.material.model == "fabric";
}

/// Whether the rest shape of the fabric is the sewing pattern in the texture coordinates of the mesh.
[[nodiscard]] inline bool restsOnPattern(const Settings& settings) {
  return usesFabric(settings) && settings.fabric.restShape == "uv";
}

/// Whether the fabric's own density sets the mass of the cloth.
[[nodiscard]] inline bool weighsAsFabric(const Settings& settings) {
  return usesFabric(settings) && settings.fabric.ownDensity;
}

/// What must be rebuilt when a setting changes.
enum class SettingEffect {
  Step,    ///< nothing: the next step uses it
  Mass,    ///< the masses of the model
  Fabric,  ///< the fabric of the model, and its masses
  Scene,   ///< the scene: the mesh is built or imported again
  View,    ///< the picture only
};

/// The cloths that a setting applies to. It is hidden for others.
enum class SettingScope { Everywhere, Grid, MeshFile };

/// The panel that shows a setting.
enum class SettingGroup { Material, Air, Simulation, Contact, Scene, View, Ghost, Advanced };

}  // namespace drape::settings

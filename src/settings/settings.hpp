#pragma once

#include "sim/cloth_model.hpp"
#include "sim/step_parameters.hpp"

#include <string>

namespace drape {

/// Every value that a user can change, with its default. What it is called, its unit, its range and its explanation
/// stand in the table (settings_table.cpp), from which the panels, the command line, the scene files and the
/// documentation are made.
struct Settings {
  /// The library calculates in double unless told otherwise; the programs in float, where a method has it, which is at
  /// least as fast and in what one sees as accurate (docs/guide/performance.md).
  Settings() { step.precision = Precision::Float; }

  StepParameters step;

  struct SolverChoice {
    std::string name = "auto";
  } solver;

  /// Of the solver `auto`, beside what stands in `step`.
  struct Auto {
    double budget = 0.0;  ///< computing time for each sixtieth of a second of motion [ms]; 0: step.costBudget counts
  } automatic;

  struct Material {
    std::string massGivenAs = "density";  ///< which of the two below counts: "density" or "mass"
    double density = 0.15;                ///< [kg/m^2]
    double mass = 0.1;                    ///< [kg]
    std::string lumping = "area";         ///< "area" or "uniform"
  } material;

  struct Hand {
    double stiffness = 500.0;  ///< [N/m]
    double maxForce = 10.0;    ///< [N]
  } hand;

  struct Playback {
    double speed = 1.0;  ///< simulated seconds per second of the clock, when the machine keeps up [-]
  } playback;

  struct Mesh {
    std::string unit = "m";           ///< of the file's coordinates: a word, metres per unit, or "auto": it is guessed
    std::string up = "y";             ///< the file's axis that points up, or "auto": it is guessed
    double weldTolerance = 1e-6;      ///< relative to the bounding box's diagonal [-]
    std::string outliers = "refuse";  ///< vertices far from all others: "refuse" or "leave_out"
    std::string pins = "scene";       ///< "scene", "shape", "top" or "none"
  } mesh;

  struct Grid {
    int resolution = 17;  ///< vertices along the shorter side
    double width = 1.0;   ///< [m]
    double height = 1.0;  ///< [m]
  } grid;

  /// A second cloth beside the first, for comparison. All that is not said here is as for the first.
  struct Ghost {
    std::string solver = "off";  ///< "off" or a solver's name
    int substeps = 1;            ///< equal parts that a step is taken in [-]
    double offset = 0.0;         ///< how far to the right it is drawn [m]
  } ghost;

  struct Measures {
    bool energyBalance = false;  ///< where the energy goes is worked out in every step
  } measures;

  struct View {
    bool wireframe = false;
    std::string surface = "checker";  ///< "checker" or "plain"
    bool ground = true;
    bool shadows = true;
    bool contacts = false;
    bool pins = true;
    double fontScale = 0.0;  ///< 0: from the monitor's scale
  } view;
};

/// What has to be made anew when a setting changes.
enum class SettingEffect {
  Step,   ///< nothing: the next step uses it
  Mass,   ///< the masses of the model
  Scene,  ///< the scene: the mesh is built or imported again
  View,   ///< the picture only
};

/// Which cloth a setting concerns; for others it is not shown.
enum class SettingScope { Everywhere, Grid, MeshFile };

/// The panel that a setting is shown in.
enum class SettingGroup { Material, Air, Simulation, Contact, Scene, View, Ghost, Advanced };

}  // namespace drape

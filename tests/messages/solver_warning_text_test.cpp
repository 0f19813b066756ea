#include "messages/solver_warning_text.hpp"

#include "sim/solvers/solver.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <optional>
#include <string>

namespace drape::messages {
namespace {

using Kind = sim::SolverWarning::Kind;
using sim::testing::pinnedSheet;

/// The warning of a solver on a sheet of n x n vertices; empty if there is none.
std::string warningOf(const char* solver, int n, const sim::StepParameters& parameters) {
  const std::optional<sim::SolverWarning> warning = sim::findSolver(solver)->warning(*pinnedSheet(n), parameters);
  return warning ? inWords(*warning).english() : std::string();
}

sim::StepParameters with(double stiffness, double timeStep = 1.0 / 150.0) {
  sim::StepParameters parameters;
  parameters.material.stiffness = stiffness;
  parameters.timeStep = timeStep;
  return parameters;
}

TEST(StepInWords, roundsTheDenominatorUpToThreeDigits) {
  EXPECT_EQ(stepInWords(1.0 / 240.0), "1/240 s");
  EXPECT_EQ(stepInWords(1.0 / 240.4), "1/241 s");
  EXPECT_EQ(stepInWords(1.0 / 24041.0), "1/24100 s");
  EXPECT_EQ(stepInWords(1.0 / 1.5), "1/2 s");
  EXPECT_EQ(stepInWords(2.5), "2.5 s");
}

TEST(SolverWarningText, namesTheStabilityLimitAndTheSubsteps) {
  EXPECT_EQ(warningOf("verlet", 17, with(10.0)),
            "The time step is above this mesh's stability limit of 1/241 s: the cloth can blow up. Use 2 substeps.");
  EXPECT_EQ(warningOf("verlet", 17, with(10.0, 1.0 / 241.0)), "") << "the step that was named must do";
  EXPECT_EQ(inWords({.kind = Kind::StepTooLong, .substeps = 1001.0, .seconds = 1.0 / 150150.0}),
            "The time step is above this mesh's stability limit of 1/151000 s: the cloth can blow up. Use softer or "
            "heavier cloth or an implicit solver.");
}

TEST(SolverWarningText, saysHowFastEnergyDoubles) {
  EXPECT_EQ(warningOf("explicit_euler", 17, with(10.0, 1e-4)),
            "Explicit Euler gains energy at any time step. At this one the energy of the fastest motion doubles every "
            "0.03 s. Use much shorter steps, add damping or choose another solver.");
}

TEST(SolverWarningText, describesTheLimitsOfOneIteration) {
  EXPECT_EQ(
      warningOf("one_iteration", 33, with(1e3, 1.0 / 30.0)),
      "The time step is too long for this fine and stiff mesh: flat cloth gains energy and can blow up. Use 4 substeps "
      "or a solver that solves for all springs at once.");
  EXPECT_EQ(
      warningOf("one_iteration", 17, with(10.0)),
      "One sweep is too few at this stiffness and time step: the cloth is slack and loses momentum. Use 4 substeps or "
      "more sweeps.");
  EXPECT_EQ(inWords({.kind = Kind::TooFewSweeps, .substeps = 2000.0, .iterations = 3}),
            "3 sweeps are too few at this stiffness and time step: the cloth is slack and loses momentum. Use more "
            "sweeps.");
  EXPECT_EQ(inWords({.kind = Kind::IndefiniteMatrix, .substeps = 3.0}),
            "With this force derivative stiff cloth can blow up at this time step. Use 3 substeps or the stabilised "
            "derivative.");
}

TEST(SolverWarningText, saysWhereOneConstantMatrixIsSluggishOrTooLittleIterated) {
  for (const char* solver : {"kang", "desbrun", "meyer"}) {
    EXPECT_EQ(warningOf(solver, 17, with(10.0)),
              "At this stiffness and time step folding meets as much resistance as stretching: the cloth moves far too "
              "slowly. Use 11 substeps or softer cloth.");
  }
  EXPECT_NE(warningOf("local_global", 17, with(1000.0))
                .find("softer than specified, and it can gain energy. Use 4 substeps or more iterations."),
            std::string::npos);
}

TEST(SolverWarningText, saysThatIterationsAreTooFew) {
  EXPECT_EQ(inWords({.kind = Kind::TooFewIterations, .substeps = 4.0, .iterations = 1}),
            "1 iteration is too few for this stiffness and time step: the cloth is softer than specified, and it can "
            "gain energy. Use 4 substeps "
            "or more iterations.");
  EXPECT_EQ(inWords({.kind = Kind::TooFewIterations, .substeps = 4000.0, .iterations = 3}),
            "3 iterations are too few for this stiffness and time step: the cloth is softer than specified, and it can "
            "gain energy. Use more "
            "iterations, or a solver that solves for all springs at once.");
  EXPECT_EQ(inWords({.kind = Kind::AcceleratedTooLittle}),
            "Too few iterations for this stiffness and time step: the cloth is slack. Use more iterations, a larger "
            "spectral radius or substeps.");
}

TEST(SolverWarningText, saysThatIterationsOvershoot) {
  sim::StepParameters parameters = with(1000.0);
  parameters.iteration.iterations = 3;
  parameters.iteration.spectralRadius = 0.95;
  EXPECT_EQ(warningOf("vbd", 5, parameters),
            "With 3 iterations a spectral radius of 0.95 overshoots: the cloth can blow up. Use 6 iterations or a "
            "smaller spectral radius.");
  EXPECT_EQ(
      inWords({.kind = Kind::Overshoots}),
      "The iterations overshoot at this stiffness and time step: the cloth may oscillate. Use more iterations or a "
      "smaller spectral radius.");
}

TEST(SolverWarningText, saysThatNewtonIsSlowAndXpbdInexact) {
  EXPECT_EQ(
      warningOf("newton", 33, {}),
      "Newton's method factorises a large matrix several times in each step: on so fine a mesh it is too slow for "
      "interactive use.");
  sim::StepParameters parameters = with(10.0, 1.0 / 60000.0);
  parameters.precision = sim::Precision::Float;
  EXPECT_EQ(
      warningOf("xpbd", 9, parameters),
      "Substeps below 1/6000 s are too short for XPBD in float: velocities become inexact. Use double precision.");
}

TEST(SolverWarningText, describesSofteningAndSlowMotion) {
  sim::SolverWarning softened{
      .kind = Kind::Softened, .stiffnessScale = 0.00192, .neededCost = 1234567.0, .softenedByChoice = true};
  EXPECT_EQ(
      inWords(softened),
      "The cost budget is too small for this stiff and fine cloth: the springs keep 0.19 % of their stiffness, and "
      "coarse levels carry the tension. The full stiffness needs auto.cost = 1234567.");
  softened.softenedByChoice = false;
  EXPECT_EQ(
      inWords(softened),
      "At full stiffness a step of this cloth would take several seconds: the springs keep 0.19 % of their stiffness, "
      "and coarse levels carry the tension. The full stiffness needs auto.cost = 1234567.");
  EXPECT_EQ(
      inWords({.kind = Kind::SlowMotion, .costRatio = 10.04}),
      "This stiff and fine cloth costs up to 10 times the cost budget, so it moves in slow motion. Softer springs "
      "keep real time (auto.soften = on).");
}

TEST(SolverWarningText, offersASlowFabricALimitOnStrainAndNoSofterSprings) {
  EXPECT_EQ(
      inWords({.kind = Kind::SlowFabric, .costRatio = 3.0}),
      "This stiff and fine fabric costs up to 3 times the cost budget, so it moves in slow motion. A lower stretch "
      "stiffness keeps real time where the strain stays small (auto.strain = 0.01).");
}

TEST(SolverWarningText, offersALiftThatDoesNotJump) {
  EXPECT_EQ(inWords({.kind = Kind::LimitedLift}),
            "The paper's lift jumps where cloth lies along the wind. The solver auto limits it there to the lift of a "
            "thin plate, and other solvers do not. The air model of a thin plate has no jump (air.model = plate).");
}

}  // namespace
}  // namespace drape::messages

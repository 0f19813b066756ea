#pragma once

namespace drape::sim {

/// Why a solver does not suit a cloth: a code, with the numbers that its comment names. src/messages makes the text.
struct SolverWarning {
  enum class Kind {
    StepTooLong,       ///< a substep is above the stability limit `seconds`; `substeps`
    GainsEnergy,       ///< no substep is stable: the energy of the fastest motion doubles every `seconds`
    IndefiniteMatrix,  ///< stiff cloth can blow up with this force derivative; `substeps`
    FlatClothGains,    ///< flat cloth, fine and stiff, gains energy and can blow up; `substeps`
    TooFewSweeps,      ///< `iterations` sweeps leave stiff cloth slack, and it loses momentum; `substeps`
    TooFewIterations,  ///< `iterations` iterations make cloth softer than specified, so it can gain energy; `substeps`
    StiffFolds,        ///< folding meets the resistance of stretching, so cloth moves too slowly; `substeps`
    AcceleratedTooLittle,  ///< too few accelerated iterations: the cloth is slack
    Overshoots,            ///< accelerated iterations overshoot at this stiffness: the cloth may oscillate
    SpectralRadius,        ///< `iterations` with `spectralRadius` overshoot on any cloth; `neededIterations` do not
    InexactInFloat,        ///< substeps below `seconds` make velocities inexact in float
    TooSlow,               ///< the mesh is too fine for interactive use
    Softened,              ///< the cost budget leaves the springs `stiffnessScale`; `neededCost`, `softenedByChoice`
    SlowMotion,            ///< the step costs `costRatio` times the cost budget
    SlowFabric,            ///< the same, and the stretch stiffness of the fabric may not be lowered
    LimitedLift,           ///< eq. 20 jumps at zero incidence, and the solver limits it there
  };

  Kind kind = Kind::StepTooLong;
  double substeps = 0.0;          ///< a whole number that avoids the warning [-]; may exceed what settings allow
  double seconds = 0.0;           ///< a limit or a doubling time, see Kind [s]
  int iterations = 0;             ///< present iterations or sweeps of a step [-]
  int neededIterations = 0;       ///< iterations that avoid the warning [-]
  double spectralRadius = 0.0;    ///< present spectral radius [-]
  double stiffnessScale = 1.0;    ///< remaining fraction of the stiffness [-]
  double neededCost = 0.0;        ///< cost budget for the full stiffness [million spring evaluations per second]
  double costRatio = 0.0;         ///< planned cost over the cost budget [-]
  bool softenedByChoice = false;  ///< true if auto.soften is on, false if the cloth is too stiff for any step
};

}  // namespace drape::sim

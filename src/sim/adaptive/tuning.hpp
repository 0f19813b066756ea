#pragma once

namespace drape::sim::adaptive {

/// The tuned constants of the solver `auto`. h is a substep [s], H the time step [s], omega the largest local angular
/// frequency of the mesh [1/s] (sim/forces/stability.hpp). A force evaluation computes all springs once.
struct AutoTuning {
  // Stability of the explicit schemes.

  /// Preferred h omega of Verlet, as a fraction of its estimated limit [-]. Larger: fewer substeps, larger energy
  /// oscillations and more retries. Smaller: more substeps than needed.
  double preferredFraction = 0.9;
  /// The same for a fabric, which also never exceeds it [-]. Stretch raises its frequencies: a strain of 15 % by 22 %,
  /// and more where slivers are softened. Larger: stretched fabrics become unstable. Smaller: more substeps than
  /// needed.
  double fabricFraction = 0.87;
  /// Largest h omega of Verlet, as a fraction of its estimated limit [-]. The true limit of a sheet is at least 9 %
  /// above the estimate. Larger: steps near the limit become unstable. Smaller: springs are clamped earlier.
  double limitFraction = 1.02;
  /// h omega to which springs are clamped [-]. Crumpled cloth is up to 1.22 times as fast as its rest shape. Larger:
  /// stiffer cloth, more retries. Smaller: softer cloth.
  double clampHOmega = 1.8;
  /// The same where damping is integrated in stages [-]. The stages are stable up to h omega = 1.62 for the worst
  /// combination of spring and damping rates. Larger: unstable from 1.62 on. Smaller: softer cloth.
  double clampHOmegaWithDampingStages = 1.5;
  /// Force evaluations for H omega = 1 from which on the fourth-order scheme is used [-]. A substep takes 4 evaluations
  /// and is stable up to about h omega = 2.5. Larger: Verlet is used longer. Smaller than 1.6: unstable.
  double fourthOrderEvaluations = 2.0;
  /// Maximum number of damping stages in a substep in float, and in any precision [-]. Rounding errors grow with the
  /// square of the number of stages. Larger: more rounding error. Smaller: double precision, or more substeps, is used
  /// earlier.
  double maxDampingStagesInFloat = 100.0;
  double maxDampingStages = 10000.0;

  // Cost.

  /// Minimum number of force evaluations of a step [-]. Larger: simple scenes cost more. Smaller: small budgets give
  /// poor motion.
  double minEvaluations = 4.0;
  /// Maximum number of force evaluations that a cost budget can allow in a step [-]. Protects the conversion to an
  /// integer.
  double maxBudgetedEvaluations = 1e6;
  /// Maximum number of spring evaluations in a step whose springs keep their stiffness [-]: several seconds of
  /// computation. Larger: the viewer waits longer. Smaller: springs are softened without `auto.soften` earlier.
  double maxSpringEvaluations = 2e9;
  /// Cost of a force evaluation of a fabric without bending and with it, in evaluations of springs
  /// (docs/experiments/2026-11-23-fabric-pass.md) [-].
  double membraneCost = 1.35;
  double fabricCost = 2.05;
  /// Cost of the coarse levels in a step, apart from that in its substeps, in force evaluations [-]. Larger: small
  /// budgets keep the full stiffness at higher stiffness, and are exceeded further. Smaller: cloth is softened whose
  /// full stiffness takes hardly longer.
  double levelOverhead = 10.0;
  /// Cost of a force evaluation in double, in evaluations in float (docs/theory/auto.md#precision) [-].
  double doubleCost = 3.0;

  // Accuracy.

  /// Force evaluations of the first step, before an error estimate exists: `firstEvaluations` plus
  /// `firstLimitFactor` times those that a stable step needs [-]. Larger: the first steps are slower. Smaller: they
  /// can exceed the error tolerance.
  double firstEvaluations = 64.0;
  double firstLimitFactor = 2.0;
  /// Maximum number of evaluations that the tolerance can ask for, as a multiple of those that a stable step needs, but
  /// of no fewer than `minLimitEvaluations` [-]. In chaotic motion the error estimate never falls below the tolerance.
  /// Larger: such motion costs more. Smaller: tight tolerances are missed.
  double maxLimitFactor = 8.0;
  double minLimitEvaluations = 8.0;
  /// Below this tolerance the maximum rises with its inverse square root [m], by up to this factor [-]. Larger: chaotic
  /// motion costs more at tight tolerances. Smaller: slow errors of first order stay larger than the tolerance,
  /// although the budget is not used up.
  double tightTolerance = 1e-5;
  double maxTightening = 8.0;
  /// Steps between error estimates after the first ones [-]. An estimate costs as much as two steps. Larger: cheaper,
  /// slower adaptation.
  int estimateInterval = 128;
  /// The first steps are not used for estimates where the tolerance asks for more than this many times the evaluations
  /// in the budget [-], until step `earlyEstimateEnd`. Larger: more effort for an estimate that can change little.
  double unreachableFactor = 4.0;
  int earlyEstimateEnd = 16;
  /// The number of evaluations falls to this fraction at most after one estimate [-]. Larger: slower adaptation.
  double maxDecrease = 0.5;
  /// Rings of neighbours over which the error is averaged before its norm is taken [-]. Larger: more of the short waves
  /// is ignored. Smaller: vibrations and rounding count as error.
  int errorSmoothingRings = 3;

  // Coarse levels.

  /// Clamped springs that keep at least this much of their stiffness at the median vertex use no coarse levels [-].
  /// Larger: levels are used more often. Smaller: cloth is softer where levels would help.
  double enoughStiffness = 0.5;
  /// No coarse levels are used where the load stretches the clamped springs at the pins by less than this [-]. Larger:
  /// levels are used less, so hanging cloth stretches more. Smaller: levels disturb cloth that is hardly loaded.
  double smallStrain = 0.001;
  /// Fraction of the wind's largest force that counts as load of the pins [-]. Cloth moves with the wind, so the
  /// full force would overestimate the load.
  double windLoadFraction = 0.1;
  /// Levels with at most this many aggregates are not coarsened further [-].
  int minAggregates = 12;
  /// A level is not used when this fraction of the stiffness, or less, is missing [-].
  double negligibleStiffness = 1e-6;
  /// h omega of a level, as a fraction of that of the springs: at most `maxLevelFraction`, and such that the sum of the
  /// squares over all levels is at most `levelFractionSquares` [-]. All levels move the same vertices, so the squares
  /// of their frequencies add. Larger: stiffer, more retries, and energy gain with many levels. Smaller: softer cloth.
  double maxLevelFraction = 0.85;
  double levelFractionSquares = 2.9;

  // Taut cloth.

  /// Cloth counts as taut if a force as large as its weight moves it by at most this fraction of its diagonal on
  /// average, in any direction [-]. Larger: implicit steps slow down cloth that can swing. Smaller: taut cloth is
  /// softened.
  double tautReach = 0.03;
  /// Stiffness of the springs in the test for that, in weights over the diagonal [-]; less if the cloth is softer.
  /// Larger: the test takes longer. Smaller: taut cloth sags too far in it.
  double tautStiffness = 2000.0;
  /// The test takes a coarse level with at most this many aggregates, if there is one [-].
  int maxAggregatesOfTautCloth = 100;
  /// Implicit steps for one measurement of the energy [-]. Larger: cheaper, energy grows longer before it is removed.
  int tautEnergySteps = 8;
  /// Steps between two tests while pins move [-].
  int tautSteps = 32;

  // Energy guard and retries.

  /// Allowed growth of the energy that a stable scheme conserves, as a fraction of the reference energy: summed over
  /// all steps, and in a step that is retried [-]. Larger: instabilities are noticed later. Smaller: more retries.
  double maxSchemeDrift = 0.01;
  double maxSchemeDriftOfRetry = 0.002;
  /// Part of m g D (D: diagonal of the rest shape) in the reference energy of that test [-]. Larger: less sensitive for
  /// cloth that hardly moves.
  double fallEnergyFraction = 0.1;
  /// Allowed drift of the energy at the ends of steps, as a fraction of the reference energy [-]. Kinetic energy above
  /// that is removed. Larger: visible energy gain. Smaller: more damping of violent motion.
  double maxEnergyDrift = 0.004;
  /// The same for the energy with the full stiffness of softened springs; energy above that is removed from the rates
  /// of stretch only [-].
  double maxVisibleDrift = 0.001;
  /// From this drift on the step is retried instead [-]. Larger: more kinetic energy is removed at once.
  double maxRemovedEnergy = 0.05;
  /// From this fraction of `maxEnergyDrift` on the energy is measured in each step [-]. Larger: drift can be noticed
  /// late.
  double calmDriftFraction = 0.5;
  /// Force evaluations for one energy measurement in calm cloth [-]. Larger: cheaper, drift is noticed later.
  double evaluationsPerMeasurement = 24.0;
  /// Retries of a step before it is taken in parts [-]. Each doubles the substeps or softens the springs.
  int maxRetries = 3;
  /// Largest retry level that a step starts with [-].
  int maxRetryLevel = 2;
  /// Error of the kinetic energy of free cloth by rounding, in unit roundoffs of that of its motion as a whole [-].
  double kineticRounding = 100.0;
  /// Sweeps in which the energy guard removes energy from the rates of stretch before it slows down all motion [-].
  /// Larger: less of the swinging motion is removed, at a higher cost.
  int stretchingSweeps = 4;
  /// The same in a step in which only the energy with the full stiffness is too large [-].
  int visibleSweeps = 1;
  /// Steps without a retry after which the retry level falls by one [-]. Larger: more careful for longer.
  int calmSteps = 16;
  /// Factor on the clamping limit in a retry of softened springs [-], until it falls below `minRetryHOmega`; then the
  /// substeps are doubled. Smaller: softer cloth after a retry.
  double retryClampFactor = 0.8;
  double minRetryHOmega = 1.7;
  /// Equal parts in which a step is taken after all retries failed [-]. Larger: the many substeps of a violent moment
  /// are taken for a shorter time.
  int partsOfStep = 8;
  /// Retries of such a part before the fallback solver takes it [-]. Each doubles the substeps or softens the springs.
  /// Larger: more violent starts keep their energy, and a step can take longer.
  int maxRetriesOfPart = 7;

  // Rounding.

  /// Energy that rounding in float adds in a substep, in m omega^2 d^2 with d the rounding error of a position [-].
  /// It was measured (docs/theory/auto.md#precision).
  double roundingHeat = 0.02;
  /// Mean position error of N force evaluations in float, in d sqrt(N) [-]. It was measured
  /// (docs/theory/auto.md#precision).
  double roundingDrift = 0.25;
  /// Allowed heating by rounding, as a fraction of the energy of a fall by the cloth's diagonal, in a second [1/s].
  /// Larger: float gains visible energy. Smaller: double is used more often.
  double maxHeatingInMotion = 0.002;
  /// Smallest g D in that comparison [m^2/s^2], so that cloth without gravity need not be computed in double.
  double minFallEnergy = 1.0;
  /// Allowed heating by rounding of cloth that damping or drag bring to rest [W/kg]. Larger: float keeps cloth moving.
  double maxHeatingAtRest = 1e-7;
  /// The same while contacts act [W/kg]. Friction and the inelastic contacts remove energy, too.
  double maxHeatingInContact = 2e-4;
  /// Cloth with a higher mean speed than this is not coming to rest [m/s], except springs in contact: float would delay
  /// their rest. Vibration by rounding in float stays far below. Larger: double is used more often.
  double slowSpeed = 0.03;
  /// Steps in double after the energy of a fabric grew in float [-]. Larger: fewer attempts in float.
  int doubleSteps = 64;
  /// Cloth with a smaller g D than this [m^2/s^2] may have no energy but that of rounding. The energy guard then adds
  /// `roundingMargin` times the energy of rounding to its reference energy [-]. Its limit is a hundredth of the
  /// reference, so rounding may be ten times the estimate.
  double minGuardedFallEnergy = 1e-2;
  double roundingMargin = 1000.0;

  // Multiple time stepping of fabrics.

  /// Longest time between two kicks by bending, times its highest angular frequency [-]. Larger: cheaper, but resonance
  /// with the membrane can add energy.
  double maxBendingHOmega = 0.4;
  /// Longest time between two kicks by the air [s]. The air's force lags by half of it.
  double maxAirTime = 2.5e-4;
  /// Maximum number of substeps between two kicks by bending and air [-], odd. Larger: hardly cheaper, more resonance.
  int maxSlowInterval = 5;
  /// Steps in which bending and air act in every substep after the energy grew [-]. Larger: fewer attempts with longer
  /// intervals.
  int everySubstepSteps = 64;
  /// Cost of a kick by bending and of one by the air, in kicks by the membrane [-].
  double bendingCost = 1.0;
  double airCost = 0.15;

  // Stretch stiffness of fabrics.

  /// Maximum number of levels of the stretch stiffness [-]. A level has the stiffness of the one before, divided by the
  /// square root of 2.
  int maxStretchLevel = 24;
  /// Factor on the strain that cloth at rest would have with the next lower stiffness [-]. The stiffness falls only if
  /// the product is below the limit. Larger: stiffer cloth. Smaller: the stiffness can fall and rise in turn.
  double strainMargin = 1.15;
  /// `maxRatio` of fabric::RateLimit for the stiffness of the smallest triangles [-]. Larger: more substeps on
  /// meshes with a few small triangles. Smaller: more triangles become softer.
  double maxTriangleRatio = 4.0;
  /// A lower stretch stiffness is used if a step then takes less than this fraction of the force evaluations [-].
  /// Without shear and bending the fraction is 0.84.
  double minStretchGain = 0.96;
  /// Factor on the strain of cloth at rest for the first step [-]. A load that acts suddenly on elastic cloth stretches
  /// it by twice the strain at rest.
  double suddenLoadFactor = 2.0;
  /// Time between two measurements of the strain without an attachment [s]. Larger: cheaper, the stiffness rises later.
  double strainCheckInterval = 1.0 / 100.0;
  /// The stiffness rises if the strain would exceed the limit after this time at its present rate [s]. Larger: stiffer
  /// cloth. Smaller: the strain exceeds the limit when loads rise quickly.
  double strainForecastTime = 1.0 / 30.0;
  /// Maximum number of levels by which the stiffness rises after a measurement [-]. Larger: a wrong forecast costs
  /// more.
  int maxStretchRise = 4;
  /// Time from a rise of the stiffness to the check whether the strain is imposed [s]. Cloth settles in that time.
  double strainSettlingTime = 0.2;
  /// The strain is imposed if more than this fraction of it is left after a rise of the stiffness [-]. The stiffness
  /// rises at least twofold.
  double imposedStrainFraction = 0.8;
  /// Strain counts as imposed only at a mean speed below this [m/s]. The loads of faster cloth change.
  double maxSpeedOfImposedStrain = 0.1;
  /// The stiffness falls after the strain has allowed it for this time [s], by as many levels as the largest strain in
  /// this time allows. Smaller: it rises and falls often.
  double strainCalmTime = 0.5;

  // Sleep detection.

  /// Cloth sleeps when no vertex moved further than this fraction of the error tolerance, or this fraction of the mean
  /// edge length, for `sleepTime` [-], [-], [s]. Larger distances, shorter time: slow motion stops. The opposite: cloth
  /// sleeps late.
  double sleepToleranceFraction = 0.1;
  double sleepEdgeFraction = 1e-3;
  double sleepTime = 1.0;
  /// Cloth that settles sleeps when its mean displacement in `sleepTime` was below this fraction of the error tolerance
  /// [-]. Larger: slow creep stops. Smaller: cloth that contact moves back and forth by hundredths of a millimetre
  /// stays awake.
  double settledToleranceFraction = 0.3;
  /// Cloth in wind is disturbed before it sleeps, by this fraction of the distance above [-]. Larger: visible.
  /// Smaller: the disturbance is lost in rounding, or an instability is not noticed within `sleepTime`.
  double disturbance = 0.01;
  /// Steps between two reference positions of moving cloth [-]. Larger: cheaper, sleep begins later.
  int sleepCheckInterval = 16;
  /// Cloth in contact settles after so many intervals [-] of that time [s] in which its mean displacement was below the
  /// error tolerance, and the largest one below this multiple of it [-] (adaptive::settle). The error tolerance is that
  /// of 0.2 s, so the interval should not be shorter.
  int settlingIntervals = 2;
  double settlingInterval = 0.25;
  double maxSettlingRatio = 25.0;
  /// Time constant of the velocity of settling cloth [s]. The motion of a hem is critically damped.
  double settlingTime = 0.1;
  /// Time of the trial fall that tests for support [s]: 0.5 mm down in still air.
  double supportTrialTime = 0.01;
  /// A piece is supported where contact leaves at most this fraction of the trial displacement [-].
  double maxFreeFraction = 0.9;
};

inline constexpr AutoTuning tuning;

}  // namespace drape::sim::adaptive

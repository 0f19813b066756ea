#include "report/report_json.hpp"

#include "report/settings_json.hpp"

#include <cmath>

namespace drape::report {
namespace {

using Json = nlohmann::ordered_json;

Json vectorJson(const Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Json momentumJson(const Momentum& momentum) {
  return {{"linear", vectorJson(momentum.linear)}, {"angular", vectorJson(momentum.angular)}};
}

Json energyJson(const sim::Energy& energy) {
  return {{"total", energy.total()},
          {"kinetic", energy.kinetic},
          {"elastic", energy.elastic},
          {"potential", energy.potential}};
}

Json balanceJson(const sim::EnergyBalance& balance) {
  return {{"change", balance.change()},         {"damping", balance.damping()}, {"air", balance.air()},
          {"attachment", balance.attachment()}, {"contact", balance.contact()}, {"integrator", balance.integrator()}};
}

Json checkpointJson(const CheckpointReport& at, double diagonal) {
  Json json;
  json["time"] = at.time;
  json["eps"] = at.displacement.eps;
  json["squared_cosine"] = at.displacement.squaredCosine;
  json["vertices"] = at.displacement.vertices;
  json["still_vertices"] = at.displacement.stillVertices;
  json["still_motion"] = at.displacement.stillMotion;
  json["mean_error"] = at.meanError;
  json["rms_error"] = at.rmsError;
  json["mean_error_of_diagonal"] = at.meanError / diagonal;
  json["rms_error_of_diagonal"] = at.rmsError / diagonal;
  json["motion_kept"] = at.motionKept;
  json["max_stretch"] = at.maxStretch;
  json["energy"] = energyJson(at.energy);
  json["energy_balance"] = balanceJson(at.balance);
  json["momentum"] = momentumJson(at.momentum);
  json["reference_momentum"] = momentumJson(at.referenceMomentum);
  json["reference_max_stretch"] = at.referenceStretch;
  json["reference_energy"] = energyJson(at.referenceEnergy);
  json["trusted"] = at.trusted;
  return json;
}

Json summaryJson(const ErrorSummary& summary, double diagonal) {
  return {{"time", summary.time},
          {"mean_eps", summary.meanEps},
          {"mean_squared_cosine", summary.meanSquaredCosine},
          {"mean_error", summary.meanError},
          {"rms_error", summary.rmsError},
          {"mean_error_of_diagonal", summary.meanError / diagonal},
          {"motion_kept", summary.motionKept}};
}

Json runJson(const Trajectory& run, const settings::Settings& settings) {
  return {{"solver", settings.solver.name},      {"time_step", settings.step.timeStep},
          {"checkpoints", run.checkpoints()},    {"finite", run.finite},
          {"unsolved_steps", run.unsolvedSteps}, {"largest_residual", run.largestResidual}};
}

std::string kindWord(ReferenceKind kind) {
  switch (kind) {
    case ReferenceKind::SameStep:
      return "same_step";
    case ReferenceKind::Converged:
      return "converged";
    case ReferenceKind::Solver:
      break;
  }
  return "solver";
}

Json referenceJson(const Reference& reference) {
  Json json = runJson(reference.trajectory, reference.settings);
  json["kind"] = kindWord(reference.kind);
  json["trusted_checkpoints"] = reference.trusted;
  json["doubt"] = reference.doubt;
  if (reference.kind == ReferenceKind::SameStep) {
    json["largest_step_residual"] = reference.trajectory.largestStepResidual;
  }
  if (reference.kind == ReferenceKind::Converged) {
    Json halvings = Json::array();
    for (const Halving& halving : reference.halvings) {
      halvings.push_back({{"time_step", halving.timeStep},
                          {"difference", halving.difference},
                          {"trusted_checkpoints", halving.trusted}});
    }
    json["halvings"] = halvings;
    json["differences"] = reference.differences;
  }
  json["settings"] = settingsJson(reference.settings);
  return json;
}

}  // namespace

nlohmann::ordered_json measurementJson(const Measurement& measurement) {
  Json json;
  json["scene"] = measurement.scene->description.name;
  json["vertices"] = measurement.scene->model->vertexCount();
  json["diagonal"] = measurement.report.diagonal;
  json["restarted"] = measurement.own.restarted;
  json["method"] = runJson(measurement.own, measurement.settings);
  json["method"]["settings"] = settingsJson(measurement.settings);
  json["reference"] = referenceJson(measurement.reference);
  json["summaries"] = Json::array();
  for (const ErrorSummary& summary : measurement.summaries) {
    json["summaries"].push_back(summaryJson(summary, measurement.report.diagonal));
  }
  json["checkpoints"] = Json::array();
  for (const CheckpointReport& checkpoint : measurement.report.checkpoints) {
    json["checkpoints"].push_back(checkpointJson(checkpoint, measurement.report.diagonal));
  }
  return json;
}

}  // namespace drape::report

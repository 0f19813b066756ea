#pragma once

#include "session/snapshot.hpp"
#include "sim/fields/field_table.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace drape::fields {

/// The fields of the cloth in a snapshot. Each is computed when it is asked for, once for each version of the snapshot.
class SnapshotFields {
 public:
  /// Takes another snapshot of the same simulation, or the same one again. It must live until the next call.
  void take(const session::Snapshot& snapshot);

  /// Why a field has no values in this snapshot, in one sentence; empty if it has some.
  [[nodiscard]] std::string whyMissing(const sim::fields::FieldInfo& field) const;

  /// One value a vertex, in the field's unit; NaN where it is not defined. Empty if the field has no values. Valid
  /// until the next take().
  [[nodiscard]] std::span<const double> values(const sim::fields::FieldInfo& field);

 private:
  [[nodiscard]] sim::fields::FieldInputs inputs() const;
  void placeBodies();

  const session::Snapshot* snapshot_ = nullptr;
  std::shared_ptr<const scene::Scene> scene_;
  std::shared_ptr<const sim::ClothModel> model_;
  std::int64_t version_ = -1;
  sim::fields::FieldGeometry geometry_;
  std::unique_ptr<sim::fields::BodyGaps> bodies_;  // of the scene
  bool meetsBodies_ = false;
  std::map<const sim::fields::FieldInfo*, std::vector<double>> values_;  // of this version
};

}  // namespace drape::fields

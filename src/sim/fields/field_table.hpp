#pragma once

#include "sim/fields/field_inputs.hpp"

#include <span>
#include <string_view>

namespace drape::sim::fields {

/// What must exist for a field to be defined.
enum class FieldNeed { Positions, Velocities, Fabric, Body, Contact, Ghost };

/// A quantity with one value at each vertex of the cloth, declared once. Colour maps, picked vertices and files of
/// probes read it here.
struct FieldInfo {
  std::string_view name;   ///< in settings and files: "strain_warp"
  std::string_view title;  ///< on the panel: "Stretch along warp"
  std::string_view unit;   ///< as in all of Drape: "N/m"
  std::string_view help;   ///< its meaning, in one or two sentences
  FieldNeed need;
  bool hasSign;      ///< whether values below `neutral` mean the opposite of values above it
  double neutral;    ///< the value of undeformed cloth at rest, in `unit`
  double minExtent;  ///< of a range of colours on one side of `neutral`, so that rounding is not shown, in `unit`
  /// Writes one value a vertex, in `unit`; NaN where it is not defined. Reads only what `need` and `canCompute` name.
  void (*compute)(const FieldInputs& inputs, std::span<double> values);
};

/// All fields. A new field is one row.
[[nodiscard]] std::span<const FieldInfo> fieldTable();

/// The field with that name, or nullptr.
[[nodiscard]] const FieldInfo* findField(std::string_view name);

/// Whether the inputs have what the field needs.
[[nodiscard]] bool canCompute(const FieldInfo& field, const FieldInputs& inputs);

}  // namespace drape::sim::fields

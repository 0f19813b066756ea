#pragma once

#include "fields/colour_range.hpp"
#include "fields/snapshot_fields.hpp"

#include <span>
#include <string>

namespace drape::fields {

/// The colour map over the cloth (view.colour_map) in one picture.
struct ShownField {
  const sim::fields::FieldInfo* field = nullptr;  ///< null: the colour map is off
  std::string problem;             ///< why the field has no values, in one sentence; the cloth then keeps its look
  std::string note;                ///< about the range, in one sentence; mostly empty
  std::span<const double> values;  ///< one a vertex, in the field's unit; NaN where it is not defined
  ColourRange range;

  /// Whether the cloth has the colours of the field.
  [[nodiscard]] bool isShown() const { return field != nullptr && !values.empty(); }
};

/// Computes the colour map for the pictures of a simulation. Costs nothing while the colour map is off.
class FieldDisplay {
 public:
  /// The result is valid until the next call, and as long as the snapshot.
  const ShownField& update(const session::Snapshot& snapshot, SnapshotFields& fields);

 private:
  ShownField shown_;
  AutomaticRange range_;
};

}  // namespace drape::fields

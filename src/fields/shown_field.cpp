#include "fields/shown_field.hpp"

namespace drape::fields {

const ShownField& FieldDisplay::update(const session::Snapshot& snapshot, SnapshotFields& fields) {
  const settings::Settings::View& view = snapshot.settings.view;
  shown_ = {};
  shown_.field = sim::fields::findField(view.colourMap);
  if (shown_.field == nullptr) {
    return shown_;
  }
  fields.take(snapshot);
  shown_.values = fields.values(*shown_.field);
  shown_.problem = fields.whyMissing(*shown_.field);
  if (!shown_.isShown()) {
    return shown_;
  }
  shown_.range = range_.update(*shown_.field, shown_.values, snapshot.time);
  if (view.colourRange == "fixed") {
    if (view.colourLow < view.colourHigh) {
      shown_.range = {view.colourLow, view.colourHigh};
    } else {
      shown_.note = "The lowest value is not below the highest one, so the range is automatic.";
    }
  }
  return shown_;
}

}  // namespace drape::fields

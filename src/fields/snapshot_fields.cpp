#include "fields/snapshot_fields.hpp"

#include "scene/cloth_material.hpp"

#include <utility>

namespace drape::fields {

using sim::fields::FieldInfo;
using sim::fields::FieldInputs;
using sim::fields::FieldNeed;

void SnapshotFields::take(const session::Snapshot& snapshot) {
  snapshot_ = &snapshot;
  if (snapshot.scene == scene_ && snapshot.model == model_ && snapshot.version == version_) {
    return;
  }
  values_.clear();
  version_ = snapshot.version;
  if (snapshot.scene != scene_) {
    bodies_ = std::make_unique<sim::fields::BodyGaps>(snapshot.scene->bodies);
  }
  if (snapshot.scene != scene_ || snapshot.model != model_) {
    geometry_ = sim::fields::fieldGeometryOf(
        *snapshot.model, scene::warpDirections(*snapshot.model, snapshot.scene->cloths, snapshot.settings));
  }
  scene_ = snapshot.scene;
  model_ = snapshot.model;
  placeBodies();
}

void SnapshotFields::placeBodies() {
  std::vector<sim::fields::BodyPlace> places;
  for (const session::BodyStatus& body : snapshot_->bodies) {
    places.push_back({body.on && snapshot_->settings.step.contact.bodies, body.pose, body.vertices});
  }
  meetsBodies_ = bodies_->moveTo(std::move(places));
}

FieldInputs SnapshotFields::inputs() const {
  return {.model = *model_,
          .geometry = geometry_,
          .positions = snapshot_->positions,
          .velocities = snapshot_->velocities,
          .ghost = snapshot_->ghost ? std::span<const Vec3>(snapshot_->ghost->positions) : std::span<const Vec3>(),
          .contactImpulses = snapshot_->contactImpulses,
          .timeStep = snapshot_->settings.step.timeStep,
          .bodies = meetsBodies_ ? bodies_.get() : nullptr};
}

std::string SnapshotFields::whyMissing(const FieldInfo& field) const {
  if (canCompute(field, inputs())) {
    return {};
  }
  switch (field.need) {
    case FieldNeed::Fabric:
      return "Springs have no stress. Set Model in the section Material to a fabric.";
    case FieldNeed::Body:
      return "There is no body in contact with this cloth.";
    case FieldNeed::Contact:
      return "The contact pressure is known after the next step.";
    case FieldNeed::Ghost:
      return "There is no ghost. Choose a solver in the section Ghost.";
    case FieldNeed::Velocities:
    case FieldNeed::Positions:
      break;
  }
  return "The speed is known after the next step.";
}

std::span<const double> SnapshotFields::values(const FieldInfo& field) {
  if (!canCompute(field, inputs())) {
    return {};
  }
  const auto [entry, isNew] = values_.try_emplace(&field);
  if (isNew) {
    entry->second.resize(snapshot_->positions.size());
    field.compute(inputs(), entry->second);
  }
  return entry->second;
}

}  // namespace drape::fields

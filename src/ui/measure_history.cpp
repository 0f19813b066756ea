#include "ui/measure_history.hpp"

namespace drape::ui {

void MeasureHistory::add(const session::Snapshot& snapshot) {
  if (snapshot.scene != scene_) {
    samples_.clear();
    scene_ = snapshot.scene;
  }
  samples_.add({.time = snapshot.time,
                .energy = snapshot.energy,
                .balance = snapshot.balance,
                .ghostDistance = snapshot.ghost ? std::optional(snapshot.ghost->meanDistance) : std::nullopt,
                .choice = snapshot.stepReport.choice,
                .accuracy = snapshot.accuracy},
               newestTime(snapshot));
}

}  // namespace drape::ui

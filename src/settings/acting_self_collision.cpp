#include "settings/acting_self_collision.hpp"
#include "settings/settings_table.hpp"
#include "sim/solvers/self_collision.hpp"

#include <variant>

namespace drape::settings {

std::string actingSelfCollision(const Settings& settings) {
  Settings acting = settings;
  sim::contact::SelfCollision& method = acting.step.contact.self;
  method = sim::actingSelfCollision(method, sim::findSolver(settings.solver.name));
  return std::get<std::string>(settingValue(acting, requireSetting("self_collision")));
}

}  // namespace drape::settings

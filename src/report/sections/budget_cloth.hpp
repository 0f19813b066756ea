#pragma once

#include "report/section.hpp"
#include "report/sections/contact_reference.hpp"
#include "report/sections/method_curves.hpp"

#include <memory>
#include <optional>
#include <string>

namespace drape::report::sections {

/// A cloth in its scene, with bodies and contact, for which a method is chosen.
struct BudgetCloth {
  std::string kind;                           ///< "garment on a body", or "own"
  std::string name;                           ///< of the scene
  std::shared_ptr<const scene::Scene> scene;  ///< with the time step and the self-collision of all methods
  int checkpoints = 15;  ///< the errors count at the last one; fewer where the reference is not good enough then
  double maxCost = 0.0;  ///< slower settings are stopped [ms per frame]
  double referenceSeconds = 20.0;                  ///< see contactReference
  std::optional<ContactReference> reference = {};  ///< made on first use
};

/// The scene with the same contact for all methods: `self_collision = auto`, whose meaning depends on the solver,
/// becomes what it is for the scene's solver. Steps are float where the scene does not say otherwise.
/// @param settings "key=value", in place of the scene's
[[nodiscard]] std::shared_ptr<const scene::Scene> withSettledContact(const scene::Scene& scene,
                                                                     const std::vector<std::string>& settings);

/// Whether the cloth can touch anything: "off", "bodies", "itself" or "bodies and itself".
[[nodiscard]] std::string contactText(const scene::Scene& scene);

/// Runs a setting of a curve and compares it with the reference. The row has the keys of work_precision that apply.
[[nodiscard]] ReportRow measureBudgetSetting(BudgetCloth& cloth, const MethodCurve& curve, const std::string& value,
                                             const CellContext& context);

}  // namespace drape::report::sections

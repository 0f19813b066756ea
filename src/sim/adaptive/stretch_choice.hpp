#pragma once

#include "sim/adaptive/auto_options.hpp"
#include "sim/adaptive/step_memory.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/local_rates.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace drape::sim::adaptive {

/// Everything, apart from the model and the state, on which the stretch stiffness depends. It holds references and must
/// not outlive what they refer to.
struct StretchConditions {
  const CommonParameters& parameters;
  const AutoOptions& options;  ///< strainLimit must be above 0
  bool meetsBodies = false;    ///< contact::meetsBodies
  bool isAttached = false;     ///< an attachment acts
};

/// Chooses the stretch stiffness of a fabric.
///
/// The weight of a garment stretches woven fabric by less than 0.1 %, which is invisible. But the stretch stiffness
/// decides how short the substeps are. So the stretch stiffness is lowered as far as the cost budget needs, and only
/// while the strain along warp and weft stays below AutoOptions::strainLimit. Shear, bending and mass keep their
/// values. The few smallest triangles are an exception: the limit on their stiffness is tighter than without a strain
/// limit (fabric::withTighterRateLimit).
///
/// Each material has its own stiffness, because a soft knit may be strained beyond the limit beside a woven fabric that
/// is not. Only materials that shorten the substeps become softer.
///
/// For the first step the strain under weight and wind is estimated, as for loads that act suddenly. Later steps
/// measure the strain, which contact, the attachment and inertia also cause. The stiffness rises as soon as the strain
/// exceeds the limit, or would soon exceed it at its present rate. It falls after a time in which the strain stayed so
/// small that softer cloth would meet the limit too. A body can impose strain, for example one that is wider than the
/// garment. A higher stiffness does not reduce imposed strain, so it does not count. The stiffness of cloth that sleeps
/// does not change, and that of cloth that settles does not fall, which would move it again.
class StretchChoice {
 public:
  /// The cloth for the next step: `model` itself, or a softer one. Updates the memory.
  /// @param model must have a fabric
  /// @return valid until the next call
  [[nodiscard]] const ClothModel& choose(const ClothModel& model, const StretchConditions& conditions,
                                         const ClothState& state, StepMemory& memory);

  /// The factor on the stretch moduli at a level [-].
  [[nodiscard]] static double scaleOf(int level);

 private:
  using Levels = std::vector<int>;  // one a material

  /// The local rate of a vertex.
  struct VertexRates {
    double full = 0.0;  // omega^2 at level 0 [1/s^2]
    double soft = 0.0;  // omega^2 without stretch stiffness [1/s^2]
    int material = 0;
  };

  /// A cloth at the combinations of levels that were used recently.
  struct Softer {
    std::shared_ptr<const ClothModel> stiffest;  // null if it is the cloth itself
    std::map<Levels, std::shared_ptr<const ClothModel>> models;
    LocalRates rates;  // of the cloth itself
    std::vector<VertexRates> vertexRates;
  };

  [[nodiscard]] static Softer softerOf(const ClothModel& model);
  [[nodiscard]] static const ClothModel& at(Softer& softer, const ClothModel& model, const Levels& levels);
  [[nodiscard]] static std::vector<double> highestRates(const Softer& softer, const Levels& levels);
  [[nodiscard]] static Levels firstLevels(const Softer& softer, const ClothModel& model,
                                          const StretchConditions& conditions);
  [[nodiscard]] static Levels loweredOnce(const Softer& softer, const ClothModel& model,
                                          const StretchConditions& conditions, const Levels& levels,
                                          const std::vector<bool>& mayFall);
  [[nodiscard]] static Levels lowered(const Softer& softer, const ClothModel& model,
                                      const StretchConditions& conditions, const Levels& levels, const Levels& falls);
  static void update(const Softer& softer, const ClothModel& model, const StretchConditions& conditions,
                     std::span<const double> forecasts, double time, StepMemory& memory);
  static void measureAndUpdate(const Softer& softer, const ClothModel& model, const StretchConditions& conditions,
                               const ClothState& state, StepMemory& memory);

  ModelCache<Softer> softer_;
};

}  // namespace drape::sim::adaptive

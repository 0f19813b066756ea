#pragma once

#include "sim/contact/contact_parameters.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::sim::contact {

/// The input of body contact: the motion of a cloth over a contact substep, as the solver predicted it.
struct ClothStep {
  const ClothModel& model;
  const CommonParameters& parameters;
  const ContactParameters& contact;
  const std::vector<Vec3>& start;      ///< positions at the start of the contact substep [m]
  const std::vector<Vec3>& predicted;  ///< positions at its end, without contact [m]
};

}  // namespace drape::sim::contact

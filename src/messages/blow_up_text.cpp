#include "messages/blow_up_text.hpp"

namespace drape::messages {

std::string remedyForBlowUp(const sim::ClothModel& model) {
  return model.fabric ? "Use a smaller time step or a softer fabric." : "Use a smaller time step or a lower stiffness.";
}

}  // namespace drape::messages

#pragma once

#include "session/command.hpp"
#include "sim/model/cloth_model.hpp"

namespace drape::report::hardcases {

/// An attachment to a single vertex, by a triangle of which it is a corner. @param target [m]
[[nodiscard]] session::AttachCommand attachTo(const sim::ClothModel& model, int vertex, const Vec3& target);

}  // namespace drape::report::hardcases

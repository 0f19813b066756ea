#pragma once

#include "render/picking.hpp"
#include "session/snapshot.hpp"

#include <optional>

namespace drape::ui {

/// The first point of a body's drawn surface that a ray hits, where the body is now. Its point is in the scene [m].
[[nodiscard]] std::optional<render::Hit> pickBody(const render::Ray& ray, const sim::contact::Body& body,
                                                  const session::BodyStatus& status);

}  // namespace drape::ui

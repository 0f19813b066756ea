#include "ui/body_picking.hpp"

namespace drape::ui {

std::optional<render::Hit> pickBody(const render::Ray& ray, const sim::contact::Body& body,
                                    const session::BodyStatus& status) {
  sim::contact::BodySurface surface = sim::contact::surfaceOf(body.shape);
  if (!status.vertices.empty()) {
    surface.positions = status.vertices;
  }
  const render::Ray local{status.pose.toLocal(ray.origin), status.pose.rotation.conjugate() * ray.direction};
  std::optional<render::Hit> hit = render::pick(local, surface.positions, surface.triangles);
  if (hit) {
    hit->point = status.pose.toWorld(hit->point);
  }
  return hit;
}

}  // namespace drape::ui

#pragma once

#include "render/smooth_mesh.hpp"
#include "session/snapshot.hpp"

#include <memory>
#include <vector>

namespace drape::render {

/// The bodies of a scene on the graphics card. Bodies at rest are uploaded once.
class BodyDrawing {
 public:
  /// Takes over the bodies of a scene.
  void takeScene(const scene::Scene& scene);

  /// Takes over their positions and which of them are on.
  void take(const session::Snapshot& snapshot);

  /// Draws the active bodies with the current program.
  void draw() const;

  /// Adds the meshes of the active bodies, which cast shadows.
  void addMeshes(std::vector<const SmoothMesh*>& meshes) const;

  /// The bounds of the active bodies, without infinite planes.
  [[nodiscard]] Eigen::AlignedBox3d bounds() const;

 private:
  struct Drawn {
    std::size_t body = 0;         // index into the scene's bodies
    std::vector<Vec3> positions;  // of the drawn vertices, in the body's own frame [m]
    std::vector<int> source;      // the body mesh's vertex for each drawn vertex
    bool endless = false;
    bool on = false;
    bool placed = false;
    bool deformed = false;  // whether it had vertices of its own when it was placed last
    sim::contact::Pose pose;
    SmoothMesh mesh;
  };

  void place(const session::BodyStatus& status, Drawn& drawn);

  std::vector<std::unique_ptr<Drawn>> bodies_;
  std::vector<Vec3> moved_;
};

}  // namespace drape::render

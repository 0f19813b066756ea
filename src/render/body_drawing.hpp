#pragma once

#include "render/smooth_mesh.hpp"
#include "session/snapshot.hpp"

#include <memory>
#include <vector>

namespace drape {

/// The bodies of a scene on the graphics card. Those that stand still are sent once.
class BodyDrawing {
 public:
  /// Takes over which bodies there are.
  void takeScene(const Scene& scene);

  /// Takes over where they are and which are on.
  void take(const Snapshot& snapshot);

  /// Draws all that are on with the program in use.
  void draw() const;

  /// Adds the meshes of those that are on: what throws shadows.
  void addMeshes(std::vector<const SmoothMesh*>& meshes) const;

  /// Around those that are on, planes left out: they have no end.
  [[nodiscard]] Eigen::AlignedBox3d bounds() const;

 private:
  struct Drawn {
    std::size_t body = 0;         // index into the scene's bodies
    std::vector<Vec3> positions;  // of the drawn vertices, in the body's own frame [m]
    std::vector<int> source;      // for each drawn vertex that of the body's mesh
    bool endless = false;
    bool on = false;
    bool placed = false;
    Pose pose;
    SmoothMesh mesh;
  };

  void place(const BodyStatus& status, Drawn& drawn);

  std::vector<std::unique_ptr<Drawn>> bodies_;
  std::vector<Vec3> moved_;
};

}  // namespace drape

#pragma once

#include "sim/contact/cloth_clusters.hpp"
#include "sim/contact/mesh_in_step.hpp"
#include "sim/contact/plane_search.hpp"
#include "sim/workers.hpp"

#include <vector>

namespace drape {

/// Looks for what is near a box or a mesh in one step: where vertices, edges and triangles of the cloth are about to
/// come nearer than they may, and planes between every triangle and what of the body it could meet.
///
/// Clusters of the cloth find the body's patches near them. Vertices look for their nearest point as far as they are
/// about to go; but planes are looked for when it is known where touches let the cloth go, which mostly is near.
class MeshSearch {
 public:
  /// A step begins, or a pass: what pierced the mesh is forgotten.
  void begin() { piercings_.clear(); }

  /// Adds touches to `findings`, in an order that does not depend on the threads.
  /// @param cloth with room for all the way to its target
  void findTouches(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                   const ClothClusters& clusters, Workers& workers, int threads, Findings& findings);

  /// Adds barriers to `findings`, after findTouches.
  /// @param cloth its target is where touches let it go, with room for that
  /// @return true when some of the cloth pierces the mesh of which findTouches did not know: it should be asked again
  bool findPlanes(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth, const ClothClusters& clusters,
                  Workers& workers, int threads, Findings& findings);

  /// How far the mesh's nearest point to a vertex of the cloth moves in the body's frame [m]; zero where none is near.
  [[nodiscard]] Vec3 moveAt(const MeshInStep& mesh, int vertex) const;

 private:
  class Near;
  void touchVertices(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth, Findings& findings) const;
  void pushOut(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth, Findings& findings) const;

  std::vector<std::vector<int>> patches_;  // of the body near each cluster
  std::vector<NearVertex> nearest_;        // to each vertex
  std::vector<OwnPlane> planes_;           // of each triangle of the cloth
  std::vector<Piercing> piercings_;        // in the order of the cloth's triangles as clusters have them
  std::vector<bool> pierces_;              // for each triangle of the cloth
  std::vector<bool> caught_;               // for each vertex whether a triangle of it pierces
};

}  // namespace drape

#pragma once

#include "sim/model/cloth_model.hpp"

#include <string>
#include <vector>

namespace drape::scene::testing {

/// A garment or a body for tests, y up, in metres.
struct TestShape {
  std::string name;
  sim::ClothMesh mesh;
};

/// Sizes of the parts of a garment [m]; 0 for missing parts.
struct GarmentSizes {
  double height = 0.7;        ///< of the trunk, from hem to shoulder
  double chest = 0.24;        ///< half its width
  double depth = 0.5;         ///< its depth, as a share of its width [-]
  double flare = 1.0;         ///< width of the hem over that of the chest [-]
  double sleeve = 0.2;        ///< from the shoulder to the cuff, along the arm
  double sleeveAngle = 45.0;  ///< below the horizontal [degrees]; 0: a T
  double neck = 0.09;         ///< half the width of the neck
  double neckDepth = 0.06;    ///< depth of the neck in front
  double frontGap = 0.0;      ///< half the width of a gap from neck to hem, as of a vest
};

/// A shirt, a dress, or a tank top (no sleeves): a shell with openings for neck, arms and hem.
[[nodiscard]] sim::ClothMesh shirt(const GarmentSizes& sizes);

/// Trousers with legs of that length below the crotch [m].
[[nodiscard]] sim::ClothMesh trousers(double legs);

/// Briefs: trousers whose legs end obliquely at the hips, so that their openings face sideways, too.
[[nodiscard]] sim::ClothMesh briefs();

/// A robe of 1.7 m with wide sleeves, and a hood that is open towards +z.
[[nodiscard]] sim::ClothMesh hoodedRobe();

/// An apron in front of the xy plane, with a band around the neck that is behind it.
[[nodiscard]] sim::ClothMesh apron();

/// A tube around the y axis, from y = 0 up; half widths at the hem and at the top [m]. A skirt or a strapless top.
[[nodiscard]] sim::ClothMesh tube(double height, double hem, double top, double depth);

/// A cape around the neck, open towards +z by that angle [degrees]. Its neckline has a radius of 0.1 m, its hem one of
/// 0.45 m.
[[nodiscard]] sim::ClothMesh openCape(double gap, double length);

/// A sock: one opening, and a foot towards +z.
[[nodiscard]] sim::ClothMesh sock();

/// A figure, 1.7 m tall, with its arms at that angle below the horizontal [degrees]. Closed.
[[nodiscard]] sim::ClothMesh figure(double armAngle);

/// A flat sheet with its edges along two axes (0: x, 1: y, 2: z).
[[nodiscard]] sim::ClothMesh sheet(int across, int along, double width, double height, int resolution);

/// Rotates a mesh from y up to z up.
[[nodiscard]] sim::ClothMesh withZUp(sim::ClothMesh mesh);

/// All positions times a factor.
[[nodiscard]] sim::ClothMesh scaled(sim::ClothMesh mesh, double factor);

/// OBJ text of a mesh.
[[nodiscard]] std::string objText(const sim::ClothMesh& mesh);

/// One of each shape, in usual sizes.
[[nodiscard]] std::vector<TestShape> testShapes();

}  // namespace drape::scene::testing

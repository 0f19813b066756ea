#pragma once

#include <array>

namespace drape::fabrics {

/// How a fabric is made. shaders/structure.glsl draws each; the numbers are the same there.
enum class Structure {
  Woven = 0,
  Knit = 1,    ///< single jersey: stitches on the front, bumps on the back
  Fibres = 2,  ///< without yarns, as felt
  Grain = 3,   ///< leather
  Smooth = 4,
};

/// How warp and weft cross. In column i (a warp yarn) the weft is on top in the rows j with (j - step i) mod repeat <
/// weftOnTop, as seen from the front. The back shows the opposite. weftOnTop is below 1 where crowded warp yarns hide a
/// part of the weft.
struct Weave {
  int repeat = 2;
  int step = 1;
  float weftOnTop = 1.0F;
};

/// A colour as it appears on the screen, 0 to 1.
using Colour = std::array<float, 3>;

/// The look of a fabric. All values are estimates by eye; the yarn counts are usual for fabrics of that name.
struct Look {
  Structure structure = Structure::Woven;
  Weave weave = {};           ///< of woven fabric
  float columns = 1000.0F;    ///< warp yarns, wales of a knit, fibres or cells of the grain [1/m]
  float rows = 1000.0F;       ///< weft yarns, courses of a knit [1/m]
  Colour warp = {};           ///< if not woven: the front
  Colour weft = {};           ///< if not woven: the back
  float relief = 0.5F;        ///< steepest slope of a yarn's side [-]
  float roughness = 0.6F;     ///< width of the highlight along a yarn: slope of the microfacets [-]
  float anisotropy = 0.0F;    ///< by how much the highlight is wider across a yarn than along it [-]
  float shine = 1.0F;         ///< reflectance, in units of that of a usual plastic [-]
  float sheen = 0.1F;         ///< brightness of the fibres that stand off, at a grazing view [-]
  float unevenness = 0.1F;    ///< variation of brightness between yarns [-]
  float translucency = 1.0F;  ///< light that passes through, in units of that of the checker's cloth [-]
};

}  // namespace drape::fabrics

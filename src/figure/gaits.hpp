#pragma once

namespace drape::figure {

/// The measures of a gait. Its curves are in gaits.cpp.
struct Gait {
  double period = 1.0;    ///< of two steps [s]
  double stride = 1.0;    ///< the way in a period [m]
  double stance = 0.6;    ///< the share of the period in which a foot is on the ground [-]
  double ahead = 0.05;    ///< how far the middle of a foot's way lies in front of the hips [m]
  double drop = 0.04;     ///< of the hips below their rest position, on average [m]
  double bob = 0.018;     ///< amplitude of the hips' height [m]
  double bobPhase = 0.0;  ///< where the hips are lowest, as a share of the period [-]
  double sway = 0.02;     ///< amplitude of the hips to the side [m]
  double lean = 3.0;      ///< of the trunk, forwards [degrees]
};

inline constexpr Gait walkGait{1.12, 1.12, 0.62, 0.060, 0.042, 0.017, 0.04, 0.020, 2.0};
inline constexpr Gait runGait{0.72, 1.75, 0.36, 0.040, 0.070, 0.030, 0.14, 0.012, 9.0};

}  // namespace drape::figure

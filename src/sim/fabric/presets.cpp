#include "sim/fabric/presets.hpp"

#include <algorithm>
#include <array>

namespace drape::sim::fabric {
namespace {

/// Contraction of woven and knitted fabric where the source has none [-].
constexpr double wovenPoisson = 0.2;
constexpr double knitPoisson = 0.3;

/// Damping times [s], estimates: a loss factor of about 0.2 at the frequencies of garments. These are 3 Hz for bending,
/// 150 Hz for stretch of woven fabric and 12 Hz for stretch of knits.
constexpr double bendDamping = 10e-3;
constexpr double rubberDamping = 3e-3;  // of bending: natural rubber has a lower loss factor
constexpr double stretchDamping = 0.2e-3;
constexpr double knitDamping = 2.5e-3;

/// The moduli of a homogeneous sheet.
/// @param young Young's modulus [Pa]  @param thickness [m]  @param poisson Poisson's ratio [-]  @param damping of
/// bending [s]
constexpr Material sheetOf(double young, double thickness, double poisson, double damping = bendDamping) {
  const double stretch = young * thickness;
  const double bend = young * thickness * thickness * thickness / 12.0;
  return {.stretchWarp = stretch / (1.0 - poisson * poisson),
          .stretchWeft = stretch / (1.0 - poisson * poisson),
          .shear = stretch / (2.0 * (1.0 + poisson)),
          .poisson = poisson,
          .bendWarp = bend,
          .bendWeft = bend,
          .bendBias = bend,
          .stretchDamping = stretchDamping,
          .bendDamping = damping};
}

/// Kinetic friction of a cotton sock on dry skin, the mean of Zhang and Mak 1999, In vivo friction properties of human
/// skin [-].
constexpr double cottonOnSkin = 0.51;

// Friction: nylon (0.37) and rubber (as silicone, 0.61) on skin are means of Zhang and Mak 1999. All others are
// estimates: filament yarns slide more easily than spun yarns, and smooth weaves more easily than rough ones.
//
// KES-FB, the Kawabata evaluation system, measures bending in gf cm^2/cm (98 uN m) and shear in gf/(cm degree) (56
// N/m). Where the source has no second slope, the first one doubles at a strain that few garments reach.
constexpr std::array presets{
    MaterialPreset{.name = "silk",
                   .title = "Silk",
                   .density = 0.083,
                   .material = {.stretchWarp = 1030.0,
                                .stretchWeft = 2380.0,
                                .shear = 136.0,
                                .poisson = wovenPoisson,
                                .stiffeningStrain = 0.05,
                                .stiffeningWarp = 1030.0,
                                .stiffeningWeft = 2380.0,
                                .bendWarp = 5e-6,
                                .bendWeft = 5e-6,
                                .bendBias = 4e-6,
                                .stretchDamping = stretchDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.15e-3,
                   .friction = {0.25, 0.2, 0.35},
                   .source = "Clyde et al. 2017: density, stretch and shear (moduli times thickness). Bending: the "
                             "lowest of that paper's fabrics. Contraction, stiffening and thickness: estimates."},
    MaterialPreset{.name = "cotton",
                   .title = "Cotton",
                   .density = 0.104,
                   .material = {.stretchWarp = 3940.0,
                                .stretchWeft = 6330.0,
                                .shear = 272.0,
                                .poisson = wovenPoisson,
                                .stiffeningStrain = 0.05,
                                .stiffeningWarp = 3940.0,
                                .stiffeningWeft = 6330.0,
                                .bendWarp = 10e-6,
                                .bendWeft = 8e-6,
                                .bendBias = 7e-6,
                                .stretchDamping = stretchDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.2e-3,
                   .friction = {0.4, 0.3, cottonOnSkin},
                   .source =
                       "Clyde et al. 2017: density, stretch and shear (moduli times thickness). Bending: estimate "
                       "from 0.05 to 0.15 gf cm^2/cm for shirting (KES-FB). Others: estimates."},
    MaterialPreset{.name = "denim",
                   .title = "Denim",
                   .density = 0.324,
                   .material = {.stretchWarp = 205.0,
                                .stretchWeft = 1014.0,
                                .shear = 53.0,
                                .poisson = wovenPoisson,
                                .stiffeningStrain = 0.05,
                                .stiffeningWarp = 205.0,
                                .stiffeningWeft = 1014.0,
                                .bendWarp = 64e-6,
                                .bendWeft = 97e-6,
                                .bendBias = 73e-6,
                                .stretchDamping = stretchDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.65e-3,
                   .friction = {0.5, 0.4, 0.55},
                   .source =
                       "Wang et al. 2011, denim of 99 % cotton: density, stretch, shear and bending. Contraction, "
                       "stiffening and thickness: estimates."},
    MaterialPreset{.name = "canvas",
                   .title = "Canvas",
                   .density = 0.294,
                   .material = {.stretchWarp = 1990.0,
                                .stretchWeft = 7330.0,
                                .shear = 743.0,
                                .poisson = wovenPoisson,
                                .stiffeningStrain = 0.05,
                                .stiffeningWarp = 1990.0,
                                .stiffeningWeft = 7330.0,
                                .bendWarp = 84e-6,
                                .bendWeft = 84e-6,
                                .bendBias = 70e-6,
                                .stretchDamping = stretchDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.6e-3,
                   .friction = {0.5, 0.4, 0.55},
                   .source = "Clyde et al. 2017: density, stretch and shear (moduli times thickness). Bending: the "
                             "highest of that paper's fabrics. Contraction, stiffening and thickness: estimates."},
    MaterialPreset{.name = "wool",
                   .title = "Wool",
                   .density = 0.22,
                   .material = {.stretchWarp = 1500.0,
                                .stretchWeft = 1000.0,
                                .shear = 40.0,
                                .poisson = wovenPoisson,
                                .stiffeningStrain = 0.05,
                                .stiffeningWarp = 1500.0,
                                .stiffeningWeft = 1000.0,
                                .bendWarp = 14e-6,
                                .bendWeft = 10e-6,
                                .bendBias = 9e-6,
                                .stretchDamping = stretchDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.5e-3,
                   .friction = {0.45, 0.35, 0.45},
                   .source = "Estimate for suiting from KES-FB: bending 0.1 to 0.15 gf cm^2/cm, shear 0.5 to 1 gf/(cm "
                             "degree)."},
    MaterialPreset{.name = "linen",
                   .title = "Linen",
                   .density = 0.18,
                   .material = {.stretchWarp = 6000.0,
                                .stretchWeft = 5000.0,
                                .shear = 60.0,
                                .poisson = wovenPoisson,
                                .stiffeningStrain = 0.05,
                                .stiffeningWarp = 6000.0,
                                .stiffeningWeft = 5000.0,
                                .bendWarp = 28e-6,
                                .bendWeft = 22e-6,
                                .bendBias = 18e-6,
                                .stretchDamping = stretchDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.35e-3,
                   .friction = {0.4, 0.3, 0.45},
                   .source =
                       "Estimate: stretches as little as cotton, and bends two to three times as stiffly, as flax "
                       "yarns do."},
    MaterialPreset{.name = "jersey",
                   .title = "Jersey (knit)",
                   .density = 0.187,
                   .material = {.stretchWarp = 17.0,
                                .stretchWeft = 34.0,
                                .shear = 37.0,
                                .poisson = knitPoisson,
                                .stiffeningStrain = 0.1,
                                .stiffeningWarp = 29.0,
                                .stiffeningWeft = 379.0,
                                .bendWarp = 23e-6,
                                .bendWeft = 14e-6,
                                .bendBias = 25e-6,
                                .stretchDamping = knitDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.6e-3,
                   .friction = {0.5, 0.4, 0.51},
                   .source =
                       "Wang et al. 2011, knit of cotton and polyester: density, stretch, shear, bending, and "
                       "slopes of 46 and 413 N/m at 17 % strain. Contraction, the strain at which it stiffens, and "
                       "thickness: estimates."},
    MaterialPreset{.name = "nylon",
                   .title = "Nylon-spandex",
                   .density = 0.204,
                   .material = {.stretchWarp = 48.0,
                                .stretchWeft = 105.0,
                                .shear = 61.0,
                                .poisson = knitPoisson,
                                .stiffeningStrain = 0.2,
                                .stiffeningWarp = 96.0,
                                .stiffeningWeft = 210.0,
                                .bendWarp = 60e-6,
                                .bendWeft = 51e-6,
                                .bendBias = 59e-6,
                                .stretchDamping = knitDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.6e-3,
                   .friction = {0.3, 0.25, 0.37},
                   .source = "Wang et al. 2011, nylon with spandex: density, stretch, shear and bending. Contraction, "
                             "stiffening and thickness: estimates."},
    MaterialPreset{.name = "polyester",
                   .title = "Polyester",
                   .density = 0.128,
                   .material = {.stretchWarp = 2002.0,
                                .stretchWeft = 2027.0,
                                .shear = 19.0,
                                .poisson = wovenPoisson,
                                .stiffeningStrain = 0.05,
                                .stiffeningWarp = 2002.0,
                                .stiffeningWeft = 2027.0,
                                .bendWarp = 52e-6,
                                .bendWeft = 31e-6,
                                .bendBias = 41e-6,
                                .stretchDamping = stretchDamping,
                                .bendDamping = bendDamping},
                   .thickness = 0.3e-3,
                   .friction = {0.3, 0.25, 0.4},
                   .source =
                       "Wang et al. 2011, polyester tablecloth: density, stretch, shear and bending. Contraction, "
                       "stiffening and thickness: estimates."},
    MaterialPreset{.name = "felt",
                   .title = "Felt",
                   .density = 0.22,
                   .material = sheetOf(1e6, 1.2e-3, 0.3),
                   .thickness = 1.2e-3,
                   .friction = {0.55, 0.45, 0.5},
                   .source = "Estimate: a homogeneous sheet with a Young's modulus of 1 MPa, about that of soft wool "
                             "felt, and 1.2 mm."},
    MaterialPreset{.name = "leather",
                   .title = "Leather",
                   .density = 0.6,
                   .material = sheetOf(5e6, 0.9e-3, 0.4),
                   .thickness = 0.9e-3,
                   .friction = {0.6, 0.5, 0.6},
                   .source =
                       "Estimate: a homogeneous sheet with a Young's modulus of 5 MPa, about that of soft garment "
                       "leather at small strain, and 0.9 mm."},
    MaterialPreset{.name = "rubber",
                   .title = "Rubber sheet",
                   .density = 0.38,
                   .material = sheetOf(1.2e6, 0.4e-3, 0.5, rubberDamping),
                   .thickness = 0.4e-3,
                   .friction = {1.0, 0.8, 0.61},
                   .source =
                       "Estimate: a homogeneous incompressible sheet with a Young's modulus of 1.2 MPa, about that "
                       "of soft natural rubber, and 0.4 mm."},
};

}  // namespace

std::span<const MaterialPreset> presetTable() {
  return presets;
}

double skinFrictionRatio(const FabricFriction& friction) {
  return friction.skin / cottonOnSkin;
}

const MaterialPreset* findPreset(std::string_view name) {
  const auto found =
      std::find_if(presets.begin(), presets.end(), [&](const MaterialPreset& preset) { return preset.name == name; });
  return found == presets.end() ? nullptr : &*found;
}

}  // namespace drape::sim::fabric

#include "fabrics/presets.hpp"

#include <algorithm>
#include <array>

namespace drape::fabrics {
namespace {

using sim::fabric::Material;

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

/// The same material with another bending stiffness in all directions [N m].
constexpr Material withBending(Material material, double bending) {
  material.bendWarp = material.bendWeft = material.bendBias = bending;
  return material;
}

/// Kinetic friction of a cotton sock on dry skin, the mean of Zhang and Mak 1999, In vivo friction properties of human
/// skin [-].
constexpr double cottonOnSkin = 0.51;

constexpr Weave plainWeave{.repeat = 2, .step = 1, .weftOnTop = 1.0F};
constexpr Weave threeOneTwill{.repeat = 4, .step = 1, .weftOnTop = 0.75F};
constexpr Weave twoTwoTwill{.repeat = 4, .step = 1, .weftOnTop = 2.0F};
constexpr Weave satin{.repeat = 5, .step = 2, .weftOnTop = 0.8F};

constexpr std::string_view oftenQuoted = "Often quoted for Cusick's test of such fabrics, without one source.";
constexpr std::string_view stiffCotton = "Estimate: the range of stiff cottons.";

// Friction: nylon (0.37) and rubber (as silicone, 0.61) on skin are means of Zhang and Mak 1999. All others are
// estimates: filament yarns slide more easily than spun yarns, and smooth weaves more easily than rough ones.
//
// KES-FB, the Kawabata evaluation system, measures bending in gf cm^2/cm (98 uN m) and shear in gf/(cm degree) (56
// N/m). Where the source has no second slope, the first one doubles at a strain that few garments reach.
//
// clang-format off
constexpr std::array presets{
    Preset{
        .name = "silk", .title = "Silk", .density = 0.083,
        .material = {.stretchWarp = 1030.0, .stretchWeft = 2380.0, .shear = 136.0, .poisson = wovenPoisson,
                     .stiffeningStrain = 0.05, .stiffeningWarp = 1030.0, .stiffeningWeft = 2380.0,
                     .bendWarp = 5e-6, .bendWeft = 5e-6, .bendBias = 4e-6,
                     .stretchDamping = stretchDamping, .bendDamping = bendDamping},
        .thickness = 0.15e-3, .friction = {.selfStatic = 0.25, .selfKinetic = 0.2, .skin = 0.35},
        .source = "Clyde et al. 2017: density, stretch and shear (moduli times thickness). Bending: the lowest of that "
                  "paper's fabrics. Contraction, stiffening and thickness: estimates.",
        .drape = DrapeRange{.lower = 20.0, .upper = 40.0, .source = oftenQuoted},
        .look = {.structure = Structure::Woven, .weave = satin, .columns = 8000.0F, .rows = 4500.0F,
                 .warp = {0.50F, 0.05F, 0.11F}, .weft = {0.42F, 0.06F, 0.11F}, .relief = 0.25F, .roughness = 0.20F,
                 .anisotropy = 1.0F, .shine = 2.6F, .sheen = 0.10F, .unevenness = 0.06F, .translucency = 0.9F}},
    Preset{
        .name = "cotton", .title = "Cotton", .density = 0.104,
        .material = {.stretchWarp = 3940.0, .stretchWeft = 6330.0, .shear = 272.0, .poisson = wovenPoisson,
                     .stiffeningStrain = 0.05, .stiffeningWarp = 3940.0, .stiffeningWeft = 6330.0,
                     .bendWarp = 10e-6, .bendWeft = 8e-6, .bendBias = 7e-6,
                     .stretchDamping = stretchDamping, .bendDamping = bendDamping},
        .thickness = 0.2e-3, .friction = {.selfStatic = 0.4, .selfKinetic = 0.3, .skin = cottonOnSkin},
        .source = "Clyde et al. 2017: density, stretch and shear (moduli times thickness). Bending: estimate from 0.05 "
                  "to 0.15 gf cm^2/cm for shirting (KES-FB). Others: estimates.",
        .drape = DrapeRange{.lower = 60.0, .upper = 76.0, .source = oftenQuoted},
        .look = {.structure = Structure::Woven, .weave = plainWeave, .columns = 3200.0F, .rows = 2800.0F,
                 .warp = {0.40F, 0.53F, 0.72F}, .weft = {0.82F, 0.87F, 0.92F}, .relief = 0.55F, .roughness = 0.70F,
                 .shine = 0.6F, .sheen = 0.12F, .unevenness = 0.10F}},
    Preset{
        .name = "denim", .title = "Denim", .density = 0.324,
        .material = {.stretchWarp = 205.0, .stretchWeft = 1014.0, .shear = 53.0, .poisson = wovenPoisson,
                     .stiffeningStrain = 0.05, .stiffeningWarp = 205.0, .stiffeningWeft = 1014.0,
                     .bendWarp = 64e-6, .bendWeft = 97e-6, .bendBias = 73e-6,
                     .stretchDamping = stretchDamping, .bendDamping = bendDamping},
        .thickness = 0.65e-3, .friction = {.selfStatic = 0.5, .selfKinetic = 0.4, .skin = 0.55},
        .source = "Wang et al. 2011, denim of 99 % cotton: density, stretch, shear and bending. Contraction, stiffening "
                  "and thickness: estimates.",
        .drape = DrapeRange{.lower = 70.0, .upper = 90.0, .source = oftenQuoted},
        .look = {.structure = Structure::Woven, .weave = threeOneTwill, .columns = 2500.0F, .rows = 1700.0F,
                 .warp = {0.11F, 0.20F, 0.35F}, .weft = {0.76F, 0.78F, 0.78F}, .relief = 0.75F, .roughness = 0.75F,
                 .shine = 0.5F, .sheen = 0.06F, .unevenness = 0.15F, .translucency = 0.3F}},
    Preset{
        .name = "canvas", .title = "Canvas", .density = 0.294,
        .material = {.stretchWarp = 1990.0, .stretchWeft = 7330.0, .shear = 743.0, .poisson = wovenPoisson,
                     .stiffeningStrain = 0.05, .stiffeningWarp = 1990.0, .stiffeningWeft = 7330.0,
                     .bendWarp = 84e-6, .bendWeft = 84e-6, .bendBias = 70e-6,
                     .stretchDamping = stretchDamping, .bendDamping = bendDamping},
        .thickness = 0.6e-3, .friction = {.selfStatic = 0.5, .selfKinetic = 0.4, .skin = 0.55},
        .source = "Clyde et al. 2017: density, stretch and shear (moduli times thickness). Bending: the highest of that "
                  "paper's fabrics. Contraction, stiffening and thickness: estimates.",
        .drape = DrapeRange{.lower = 75.0, .upper = 95.0, .estimated = true, .source = stiffCotton},
        .look = {.structure = Structure::Woven, .weave = plainWeave, .columns = 1100.0F, .rows = 1000.0F,
                 .warp = {0.62F, 0.58F, 0.46F}, .weft = {0.66F, 0.62F, 0.50F}, .relief = 0.75F, .roughness = 0.80F,
                 .shine = 0.4F, .sheen = 0.08F, .unevenness = 0.08F, .translucency = 0.4F}},
    Preset{
        .name = "wool", .title = "Wool", .density = 0.22,
        .material = {.stretchWarp = 1500.0, .stretchWeft = 1000.0, .shear = 40.0, .poisson = wovenPoisson,
                     .stiffeningStrain = 0.05, .stiffeningWarp = 1500.0, .stiffeningWeft = 1000.0,
                     .bendWarp = 14e-6, .bendWeft = 10e-6, .bendBias = 9e-6,
                     .stretchDamping = stretchDamping, .bendDamping = bendDamping},
        .thickness = 0.5e-3, .friction = {.selfStatic = 0.45, .selfKinetic = 0.35, .skin = 0.45},
        .source = "Estimate for suiting from KES-FB: bending 0.1 to 0.15 gf cm^2/cm, shear 0.5 to 1 gf/(cm degree).",
        .drape = DrapeRange{.lower = 40.0, .upper = 70.0, .source = oftenQuoted},
        .look = {.structure = Structure::Woven, .weave = twoTwoTwill, .columns = 2300.0F, .rows = 2000.0F,
                 .warp = {0.27F, 0.28F, 0.31F}, .weft = {0.38F, 0.38F, 0.40F}, .relief = 0.50F, .roughness = 0.85F,
                 .shine = 0.3F, .sheen = 0.20F, .unevenness = 0.22F, .translucency = 0.3F}},
    Preset{
        .name = "linen", .title = "Linen", .density = 0.18,
        .material = {.stretchWarp = 6000.0, .stretchWeft = 5000.0, .shear = 60.0, .poisson = wovenPoisson,
                     .stiffeningStrain = 0.05, .stiffeningWarp = 6000.0, .stiffeningWeft = 5000.0,
                     .bendWarp = 28e-6, .bendWeft = 22e-6, .bendBias = 18e-6,
                     .stretchDamping = stretchDamping, .bendDamping = bendDamping},
        .thickness = 0.35e-3, .friction = {.selfStatic = 0.4, .selfKinetic = 0.3, .skin = 0.45},
        .source = "Estimate: stretches as little as cotton, and bends two to three times as stiffly, as flax yarns do.",
        .drape = DrapeRange{.lower = 60.0, .upper = 85.0, .estimated = true, .source = stiffCotton},
        .look = {.structure = Structure::Woven, .weave = plainWeave, .columns = 1600.0F, .rows = 1500.0F,
                 .warp = {0.70F, 0.67F, 0.60F}, .weft = {0.77F, 0.74F, 0.67F}, .relief = 0.65F, .roughness = 0.55F,
                 .shine = 0.7F, .sheen = 0.08F, .unevenness = 0.24F}},
    Preset{
        .name = "jersey", .title = "Jersey (knit)", .density = 0.187,
        .material = {.stretchWarp = 17.0, .stretchWeft = 34.0, .shear = 37.0, .poisson = knitPoisson,
                     .stiffeningStrain = 0.1, .stiffeningWarp = 29.0, .stiffeningWeft = 379.0,
                     .bendWarp = 23e-6, .bendWeft = 14e-6, .bendBias = 25e-6,
                     .stretchDamping = knitDamping, .bendDamping = bendDamping},
        .thickness = 0.6e-3, .friction = {.selfStatic = 0.5, .selfKinetic = 0.4, .skin = 0.51},
        .source = "Wang et al. 2011, knit of cotton and polyester: density, stretch, shear, bending, and slopes of 46 "
                  "and 413 N/m at 17 % strain. Contraction, the strain at which it stiffens, and thickness: estimates.",
        .drape = DrapeRange{.lower = 20.0, .upper = 50.0, .estimated = true, .source = "Estimate: the range of knits."},
        .look = {.structure = Structure::Knit, .columns = 700.0F, .rows = 900.0F,
                 .warp = {0.70F, 0.50F, 0.23F}, .weft = {0.66F, 0.48F, 0.24F}, .relief = 0.70F, .roughness = 0.80F,
                 .shine = 0.4F, .sheen = 0.18F, .unevenness = 0.05F, .translucency = 0.7F}},
    Preset{
        .name = "nylon", .title = "Nylon-spandex", .density = 0.204,
        .material = {.stretchWarp = 48.0, .stretchWeft = 105.0, .shear = 61.0, .poisson = knitPoisson,
                     .stiffeningStrain = 0.2, .stiffeningWarp = 96.0, .stiffeningWeft = 210.0,
                     .bendWarp = 60e-6, .bendWeft = 51e-6, .bendBias = 59e-6,
                     .stretchDamping = knitDamping, .bendDamping = bendDamping},
        .thickness = 0.6e-3, .friction = {.selfStatic = 0.3, .selfKinetic = 0.25, .skin = 0.37},
        .source = "Wang et al. 2011, nylon with spandex: density, stretch, shear and bending. Contraction, stiffening "
                  "and thickness: estimates.",
        .look = {.structure = Structure::Knit, .columns = 1400.0F, .rows = 2200.0F,
                 .warp = {0.06F, 0.33F, 0.40F}, .weft = {0.07F, 0.29F, 0.35F}, .relief = 0.40F, .roughness = 0.32F,
                 .shine = 2.0F, .sheen = 0.12F, .unevenness = 0.03F, .translucency = 0.4F}},
    Preset{
        .name = "polyester", .title = "Polyester", .density = 0.128,
        .material = {.stretchWarp = 2002.0, .stretchWeft = 2027.0, .shear = 19.0, .poisson = wovenPoisson,
                     .stiffeningStrain = 0.05, .stiffeningWarp = 2002.0, .stiffeningWeft = 2027.0,
                     .bendWarp = 52e-6, .bendWeft = 31e-6, .bendBias = 41e-6,
                     .stretchDamping = stretchDamping, .bendDamping = bendDamping},
        .thickness = 0.3e-3, .friction = {.selfStatic = 0.3, .selfKinetic = 0.25, .skin = 0.4},
        .source = "Wang et al. 2011, polyester tablecloth: density, stretch, shear and bending. Contraction, stiffening "
                  "and thickness: estimates.",
        .look = {.structure = Structure::Woven, .weave = plainWeave, .columns = 2400.0F, .rows = 2200.0F,
                 .warp = {0.87F, 0.86F, 0.83F}, .weft = {0.85F, 0.84F, 0.82F}, .relief = 0.45F, .roughness = 0.38F,
                 .shine = 1.2F, .sheen = 0.06F, .unevenness = 0.04F}},
    Preset{
        .name = "felt", .title = "Felt", .density = 0.22,
        .material = sheetOf(1e6, 1.2e-3, 0.3),
        .thickness = 1.2e-3, .friction = {.selfStatic = 0.55, .selfKinetic = 0.45, .skin = 0.5},
        .source = "Estimate: a homogeneous sheet with a Young's modulus of 1 MPa, about that of soft wool felt, and "
                  "1.2 mm.",
        .look = {.structure = Structure::Fibres, .columns = 2500.0F, .rows = 2500.0F,
                 .warp = {0.22F, 0.37F, 0.28F}, .weft = {0.23F, 0.36F, 0.28F}, .relief = 0.60F, .roughness = 0.95F,
                 .shine = 0.1F, .sheen = 0.40F, .unevenness = 0.30F, .translucency = 0.1F}},
    Preset{
        .name = "leather", .title = "Leather", .density = 0.6,
        .material = withBending(sheetOf(5e6, 0.9e-3, 0.4), 40e-6),
        .thickness = 0.9e-3, .friction = {.selfStatic = 0.6, .selfKinetic = 0.5, .skin = 0.6},
        .source = "Estimate: stretch and shear of a sheet with a Young's modulus of 5 MPa, about that of soft garment "
                  "leather at small strain, and 0.9 mm. Bending: from the usual drape coefficient, 47 to 70 %. The "
                  "layers of leather differ, so it bends more easily than such a sheet.",
        .drape = DrapeRange{.lower = 47.0, .upper = 70.0, .source = oftenQuoted},
        .look = {.structure = Structure::Grain, .columns = 750.0F, .rows = 750.0F,
                 .warp = {0.43F, 0.25F, 0.15F}, .weft = {0.58F, 0.44F, 0.33F}, .relief = 0.45F, .roughness = 0.36F,
                 .shine = 1.3F, .sheen = 0.03F, .unevenness = 0.20F, .translucency = 0.0F}},
    Preset{
        .name = "rubber", .title = "Rubber sheet", .density = 0.38,
        .material = sheetOf(1.2e6, 0.4e-3, 0.5, rubberDamping),
        .thickness = 0.4e-3, .friction = {.selfStatic = 1.0, .selfKinetic = 0.8, .skin = 0.61},
        .source = "Estimate: a homogeneous incompressible sheet with a Young's modulus of 1.2 MPa, about that of soft "
                  "natural rubber, and 0.4 mm.",
        .look = {.structure = Structure::Smooth, .columns = 1000.0F, .rows = 1000.0F,
                 .warp = {0.17F, 0.17F, 0.18F}, .weft = {0.20F, 0.20F, 0.21F}, .relief = 0.0F, .roughness = 0.30F,
                 .shine = 1.2F, .sheen = 0.04F, .unevenness = 0.02F, .translucency = 0.0F}},
};
// clang-format on

}  // namespace

std::span<const Preset> presetTable() {
  return presets;
}

double skinFrictionRatio(const Friction& friction) {
  return friction.skin / cottonOnSkin;
}

const Preset* findPreset(std::string_view name) {
  const auto found =
      std::find_if(presets.begin(), presets.end(), [&](const Preset& preset) { return preset.name == name; });
  return found == presets.end() ? nullptr : &*found;
}

}  // namespace drape::fabrics

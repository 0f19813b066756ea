#pragma once

#include "report/hardcases/watched_cloth.hpp"

namespace drape::report::hardcases {

/// The settings of the cases of contact: exact self-collision, 0.15 kg/m^2, damped springs in air at rest.
[[nodiscard]] settings::Settings contactSettings(const CaseTrial& trial, const std::vector<std::string>& changes = {});

/// A cloth of that mesh, without pins.
[[nodiscard]] CaseCloth clothOf(const settings::Settings& settings, sim::ClothMesh mesh);

/// A level sheet, centred on the origin. @param resolution vertices along its shorter side
[[nodiscard]] sim::ClothMesh sheetMesh(int resolution, double width, double depth);

/// The mesh, rotated about its origin (axis times angle [rad]) and translated.
[[nodiscard]] sim::ClothMesh placed(sim::ClothMesh mesh, const Vec3& position, const Vec3& rotation = Vec3::Zero());

/// A watched cloth that collides. The exact intersection test counts the intersecting pairs of triangles, of the cloth
/// with itself and with bodies, at the start and after every step: none is allowed. Its start is jittered if the trial
/// asks for that.
class ContactCloth {
 public:
  /// For bodies at rest: the energy counts.
  ContactCloth(CaseTrial& trial, const CaseCloth& cloth);
  ContactCloth(CaseTrial& trial, const std::shared_ptr<const scene::Scene>& scene);
  /// For moving bodies, whose work is unknown. @param speedLimit that no vertex may exceed [m/s]
  ContactCloth(CaseTrial& trial, const CaseCloth& cloth, double speedLimit);

  /// @param work allowed external work of this step [J], evaluated after it; may be empty
  void step(const std::function<double()>& work = {});
  /// Takes the whole steps in that simulated time [s].
  void run(double seconds);

  /// Whether intersecting pairs are only shown, because a vice is closed: a position without them need not exist.
  void allowPairs(bool allowed) { allowed_ = allowed; }

  /// Runs, and expects that the fastest vertex is slow from then on.
  void expectRest(double seconds);

  [[nodiscard]] WatchedCloth& watched() { return watched_; }

 private:
  ContactCloth(CaseTrial& trial, const std::shared_ptr<const scene::Scene>& scene, EnergyRule rule, double speedLimit);

  void watch();

  CaseTrial& trial_;
  WatchedCloth watched_;
  double speedLimit_;
  bool allowed_ = false;
};

}  // namespace drape::report::hardcases

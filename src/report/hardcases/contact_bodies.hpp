#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/model/cloth_model.hpp"

#include <memory>
#include <string>
#include <vector>

/// Bodies and cloth meshes of the cases of contact.
namespace drape::report::hardcases {

/// A body at rest. @param rotation axis times angle [rad]
[[nodiscard]] sim::contact::Body bodyAt(const std::string& name, sim::contact::BodyShape shape, const Vec3& position,
                                        const Vec3& rotation = Vec3::Zero());

/// A body that moves along keyframes.
[[nodiscard]] sim::contact::Body movingBody(const std::string& name, sim::contact::BodyShape shape,
                                            std::vector<sim::contact::Keyframe> keyframes);

/// A point of a profile that turns about the y axis.
struct ProfilePoint {
  double radius = 0.0;  ///< distance from the axis [m]
  double height = 0.0;  ///< [m]
};

/// The surface that a profile sweeps around the y axis. Its front is to the left of the profile's direction, seen with
/// the radius to the right and the height upwards. Points on the axis become one vertex. @param closed whether the last
/// point is connected with the first
[[nodiscard]] sim::ClothMesh revolved(const std::vector<ProfilePoint>& profile, int sectors, bool closed);

/// A torus around the y axis. @param ring radius of its centre line [m] @param tube radius of its tube [m]
[[nodiscard]] std::shared_ptr<const sim::contact::MeshShape> torusShape(double ring, double tube);

/// A spike on the plane y = 0 that points up.
[[nodiscard]] std::shared_ptr<const sim::contact::MeshShape> spikeShape(double radius, double height);

/// A blade on the plane y = 0 with its sharp edge up, along x.
[[nodiscard]] std::shared_ptr<const sim::contact::MeshShape> bladeShape(double length, double height, double width);

/// A sphere that holds cloth inside. It lacks one triangle, because a closed mesh would push cloth out. Its radius
/// follows `radii` [m] at equal intervals.
[[nodiscard]] std::shared_ptr<const sim::contact::MeshShape> hollowSphereShape(const std::vector<double>& radii,
                                                                               double frameTime);

/// Adds a mesh as separate pieces.
void append(sim::ClothMesh& mesh, const sim::ClothMesh& other);

}  // namespace drape::report::hardcases

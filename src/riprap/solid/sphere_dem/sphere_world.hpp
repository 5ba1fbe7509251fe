// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/body/multisphere.hpp"
#include "riprap/solid/sphere_dem/advance.hpp"

namespace riprap::solid::sphere_dem {

/// Motion that a body starts with.
struct Start {
    Pose pose{};
    Vec3 velocity{};  ///< [m/s]
    Vec3 spin{};      ///< world axes [rad/s]
};

/// A scene of spheres with its State and Scratch, for programs that drive the method by themselves: add materials and
/// bodies, call `build`, then `step`.
class SphereWorld {
 public:
    MaterialId add_material(const contact::ContactMaterial& material);
    /// Sphere of moment 2/5 m r^2.
    BodyId add_sphere(MaterialId material, double radius, double mass, const Start& start);
    /// Disc in a planar scene, moment m r^2/2 about z.
    BodyId add_disc(MaterialId material, double radius, double mass, const Start& start);
    /// Body of spheres; volume integrals of the true shape where `shape` has them, else those of its spheres.
    BodyId add_multisphere(MaterialId material, const body::Multisphere& shape, double density, const Start& start);
    /// Body that does not move, of one polyhedron or half-space.
    BodyId add_wall(MaterialId material, ShapeId shape, const Pose& pose = {});
    /// Half-space with the outward normal `normal` through `point`.
    BodyId add_plane(MaterialId material, const Vec3& normal, const Vec3& point);
    /// Fixed surface of triangles.
    BodyId add_surface(MaterialId material, const std::vector<Vec3>& points, const std::vector<std::int32_t>& corners);
    /// Closes the scene.
    void build();

    SphereModel model() const { return {bodies, shapes, spheres, triangles, table, settings}; }
    /// Longest stable step now [s].
    double step_limit() const;
    SphereReport step(double dt, const body::LoadView& external = {});
    /// Total energy of the last report [J]: kinetic, potential, elastic, and everything that has left.
    double energy_account() const;

    body::BodySet bodies;
    body::BodyState state;
    geometry::ShapeSet shapes;
    SphereSet spheres;
    TriangleSet triangles;
    std::vector<contact::ContactMaterial> materials;
    contact::ContactMixing mixing;
    contact::ContactTable table;
    SphereSettings settings;
    Vec3 gravity{};
    SphereState contacts;
    SphereScratch scratch;
    SphereReport report;  ///< of the last step
    double time{0};       ///< [s]

 private:
    BodyId add_body(MaterialId material, double mass, const Vec3& moments, const Quat& axes, const Start& start);

    double previous_dt_{0};
    double other_losses_{0};
};

}  // namespace riprap::solid::sphere_dem

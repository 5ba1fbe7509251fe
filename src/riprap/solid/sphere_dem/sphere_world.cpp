// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sphere_world.hpp"

#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/solid/sphere_dem/time_step.hpp"

namespace riprap::solid::sphere_dem {

MaterialId SphereWorld::add_material(const contact::ContactMaterial& material) {
    materials.push_back(material);
    return MaterialId{static_cast<std::int32_t>(materials.size()) - 1};
}

BodyId SphereWorld::add_body(MaterialId material, double mass, const Vec3& moments, const Quat& axes,
                             const Start& start) {
    body::NewBody body;
    body.name = "body";
    body.name_index = bodies.size();
    body.material = material;
    body.pose = start.pose;
    body.velocity = start.velocity;
    const BodyId id = body::add_body(bodies, state, shapes, body);
    bodies.mass[at(id.value)] = mass;
    bodies.principal_moments[at(id.value)] = moments;
    bodies.principal_axes[at(id.value)] = axes;
    state.angular_momentum[at(id.value)] = angular_momentum_of(bodies, id, start.pose.orientation, start.spin);
    return id;
}

BodyId SphereWorld::add_sphere(MaterialId material, double radius, double mass, const Start& start) {
    const double moment = 0.4 * mass * radius * radius;
    const BodyId id = add_body(material, mass, {moment, moment, moment}, {}, start);
    spheres.add(id, radius);
    return id;
}

BodyId SphereWorld::add_disc(MaterialId material, double radius, double mass, const Start& start) {
    bodies.is_planar = true;
    const double moment = 0.5 * mass * radius * radius;
    const BodyId id = add_body(material, mass, {moment, moment, moment}, {}, start);
    spheres.add(id, radius);
    return id;
}

BodyId SphereWorld::add_multisphere(MaterialId material, const body::Multisphere& shape, double density,
                                    const Start& start) {
    const geometry::MassProperties whole = shape.shape.volume > 0 ? shape.shape : body::union_of_spheres(shape.spheres);
    const SymmetricEigen eigen = symmetric_eigen(density * geometry::inertia_from_second_moment(whole.second_moment));
    Start moved = start;
    moved.pose.position = to_world(start.pose, whole.centroid);
    const BodyId id = add_body(material, density * whole.volume, eigen.values, from_matrix(eigen.axes), moved);
    for (const body::ShapeSphere& sphere : shape.spheres) {
        spheres.add(id, sphere.radius, sphere.centre - whole.centroid, sphere.face_normal);
    }
    return id;
}

BodyId SphereWorld::add_wall(MaterialId material, ShapeId shape, const Pose& pose) {
    body::NewBody body;
    body.name = "wall";
    body.name_index = bodies.size();
    body.material = material;
    body.drive = body::Drive::fixed;
    body.pose = pose;
    body.parts.push_back({{}, shape, {}});
    return body::add_body(bodies, state, shapes, body);
}

BodyId SphereWorld::add_plane(MaterialId material, const Vec3& normal, const Vec3& point) {
    return add_wall(material, shapes.add_half_space(normal, dot(normal, point)));
}

BodyId SphereWorld::add_surface(MaterialId material, const std::vector<Vec3>& points,
                                const std::vector<std::int32_t>& corners) {
    const BodyId id = add_body(material, 0, {}, {}, {});
    bodies.drive[at(id.value)] = body::Drive::fixed;
    triangles.add(id, points, corners);
    return id;
}

void SphereWorld::build() {
    spheres.finish(bodies.size());
    table = contact::ContactTable(materials, settings.normal, mixing, settings.allows_pull);
}

double SphereWorld::step_limit() const { return sphere_dem::step_limit(model(), state, norm(gravity)).limit; }

SphereReport SphereWorld::step(double dt, const body::LoadView& external) {
    report =
        advance(model(), gravity, external, {time, dt, previous_dt_ > 0 ? previous_dt_ : dt}, state, contacts, scratch);
    time += dt;
    previous_dt_ = dt;
    other_losses_ += report.kick.damping_loss - report.kick.external_work - report.kick.work_driven;
    return report;
}

double SphereWorld::energy_account() const {
    return report.kick.kinetic + report.kick.potential + report.contacts.elastic + contacts.friction_loss +
           contacts.damping_loss + report.dashpots.before - report.dashpots.all + contacts.rolling_loss + other_losses_;
}

}  // namespace riprap::solid::sphere_dem

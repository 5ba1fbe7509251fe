// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "riprap/contact/pipeline.hpp"
#include "riprap/contact/stability.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::contact {

namespace {

struct Load {
    Vec3 force{}, torque{};
};
Load operator+(const Load& a, const Load& b) { return {a.force + b.force, a.torque + b.torque}; }

/// Load of one contact on the body of part `part`, whose centre of mass is `center`.
Load load_on(const ContactRow& row, std::int32_t part, const Vec3& center) {
    const Vec3 arm = row.point - center;
    const Load on_a{row.force, cross(arm, row.force) + row.moment};
    return row.parts.a == part ? on_a : Load{-on_a.force, -on_a.torque};
}

}  // namespace

/// visit(row, part) for every contact of a body, `part` being the one of its parts that the contact is on.
template <class Visit>
void ContactPipeline::visit_contacts_of(std::size_t body, const body::BodySet& bodies, const Visit& visit) const {
    for (std::int32_t part = bodies.part_begin[body]; part < bodies.part_begin[body + 1]; ++part) {
        for (const std::int32_t pair : cache_.pairs_of(part)) {
            for (std::int32_t contact = contact_begin_[at(pair)]; contact < contact_begin_[at(pair) + 1]; ++contact) {
                visit(*rows_[at(contact)], part);
            }
        }
    }
}

void ContactPipeline::gather_loads(const ContactScene& scene, const body::BodyState& state, body::Loads& loads) const {
    const body::BodySet& bodies = scene.bodies;
    loads.force.resize(at(bodies.size()));
    loads.torque.resize(at(bodies.size()));
    parallel::for_each_uneven(bodies.size(), 256, [&](std::int64_t body) {
        Load sum;
        visit_contacts_of(at(body), bodies, [&](const ContactRow& row, std::int32_t part) {
            sum = sum + load_on(row, part, state.position[at(body)]);
        });
        loads.force[at(body)] = sum.force;
        loads.torque[at(body)] = sum.torque;
    });
}

double ContactPipeline::dashpot_loss(const ContactScene& scene, const body::BodyState& state,
                                     const body::BodyKinematics& kinematics, double dt) const {
    struct Motion {
        Vec3 velocity, spin;
    };
    const auto motion_at = [&](std::int32_t part, const Vec3& point) {
        const std::size_t body = at(scene.bodies.parts[at(part)].body.value);
        const Vec3 spin = kinematics.inverse_mass[body] > 0
                              ? kinematics.inverse_inertia[body] * state.angular_momentum[body]
                              : kinematics.angular_velocity[body];
        return Motion{state.velocity[body] + cross(spin, point - state.position[body]), spin};
    };
    const auto loss_of = [&](std::int64_t i) {
        const ContactRow& row = *rows_[at(i)];
        if (row.dashpot == Vec3T<float>{} && row.dashpot_couple == Vec3T<float>{}) {
            return 0.0;
        }
        const Motion a = motion_at(row.parts.a, row.point), b = motion_at(row.parts.b, row.point);
        const double power_after =
            dot(a.velocity - b.velocity, widen(row.dashpot)) + dot(a.spin - b.spin, widen(row.dashpot_couple));
        return -0.5 * (row.dashpot_power + power_after) * dt;
    };
    return parallel::sum_exactly(static_cast<std::int64_t>(rows_.size()), loss_of);
}

double ContactPipeline::stable_step(const ContactScene& scene) const {
    constexpr std::int64_t block = 256;  // a minimum does not depend on it
    return parallel::reduce(
        scene.bodies.size(), std::numeric_limits<double>::infinity(),
        [&](std::int64_t body) {
            double omega_squared = 0, damping = 0;
            visit_contacts_of(at(body), scene.bodies, [&](const ContactRow& row, std::int32_t part) {
                omega_squared += row.parts.a == part ? row.omega_squared_a : row.omega_squared_b;
                damping += row.parts.a == part ? row.damping_a : row.damping_b;
            });
            return contact::stable_step(omega_squared, damping);
        },
        [](double a, double b) { return std::min(a, b); }, block);
}

}  // namespace riprap::contact

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "riprap/contact/pipeline.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

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

void ContactPipeline::gather_loads(const ContactScene& scene, const body::BodyState& state, BodyLoads& loads) const {
    const body::BodySet& bodies = scene.bodies;
    loads.force.resize(at(bodies.size()));
    loads.torque.resize(at(bodies.size()));
    parallel::for_each_uneven(bodies.size(), 256, [&](std::int64_t index) {
        const auto body = static_cast<std::int32_t>(index);
        Load sum;
        for (std::int32_t part = bodies.part_begin[at(body)]; part < bodies.part_begin[at(body) + 1]; ++part) {
            for (const std::int32_t pair : cache_.pairs_of(part)) {
                const std::int32_t contact = contact_of_pair_[at(pair)];
                if (contact >= 0) {
                    sum = sum + load_on(rows_[at(contact)], part, state.position[at(body)]);
                }
            }
        }
        loads.force[at(body)] = sum.force;
        loads.torque[at(body)] = sum.torque;
    });
}

double ContactPipeline::dashpot_loss(const ContactScene& scene, const body::BodyState& state,
                                     const body::BodyKinematics& kinematics, const ContactHistory& history,
                                     double dt) const {
    const auto velocity_at = [&](std::int32_t part, const Vec3& point) {
        const std::size_t body = at(scene.bodies.parts[at(part)].body.value);
        const Vec3 spin = kinematics.inverse_mass[body] > 0
                              ? kinematics.inverse_inertia[body] * state.angular_momentum[body]
                              : kinematics.angular_velocity[body];
        return state.velocity[body] + cross(spin, point - state.position[body]);
    };
    return parallel::reduce(
        static_cast<std::int64_t>(rows_.size()), 0.0,
        [&](std::int64_t i) {
            const ContactRow& row = rows_[at(i)];
            if (row.dashpot == 0) {
                return 0.0;
            }
            const Vec3 relative = velocity_at(row.parts.a, row.point) - velocity_at(row.parts.b, row.point);
            return 0.5 * (row.closing_speed + dot(relative, history.normal[at(i)])) * row.dashpot * dt;
        },
        [](double a, double b) { return a + b; });
}

double ContactPipeline::gershgorin_bound(const ContactScene& scene) const {
    const body::BodySet& bodies = scene.bodies;
    return parallel::reduce(
        bodies.size(), 0.0,
        [&](std::int64_t body) {
            double sum = 0;
            for (std::int32_t part = bodies.part_begin[at(body)]; part < bodies.part_begin[at(body) + 1]; ++part) {
                for (const std::int32_t pair : cache_.pairs_of(part)) {
                    const std::int32_t contact = contact_of_pair_[at(pair)];
                    if (contact >= 0) {
                        const ContactRow& row = rows_[at(contact)];
                        sum += row.parts.a == part ? row.gershgorin_a : row.gershgorin_b;
                    }
                }
            }
            return sum;
        },
        [](double a, double b) { return std::max(a, b); });
}

}  // namespace riprap::contact

// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/body_set.hpp"

#include <algorithm>

#include "riprap/body/locks.hpp"
#include "riprap/core/error.hpp"

namespace riprap::body {

namespace {

/// Mass and second moment of one part, both per unit density, in the frame the parts are given in.
struct PartIntegrals {
    double volume;
    Vec3 center;
    Mat3 second_moment;  ///< about `center`
};

PartIntegrals integrals_of(const geometry::ShapeSet& shapes, const Part& part) {
    const Mat3 turn = to_matrix(part.local.orientation);
    return {shapes.volume(part.shape), part.local.position, turn * shapes.second_moment(part.shape) * transpose(turn)};
}

/// Moments that agree to round-off are made equal, so that symmetric tops are recognised as such.
Vec3 snap_equal(Vec3 moments) {
    const double tolerance = 1e-12 * std::max({moments.x, moments.y, moments.z});
    if (std::abs(moments.y - moments.x) <= tolerance) {
        moments.y = moments.x;
    }
    if (std::abs(moments.z - moments.x) <= tolerance) {
        moments.z = moments.x;
    } else if (std::abs(moments.z - moments.y) <= tolerance) {
        moments.z = moments.y;
    }
    return moments;
}

}  // namespace

std::string BodySet::name(BodyId body) const {
    const auto i = static_cast<std::size_t>(body.value);
    const std::string& base = names[static_cast<std::size_t>(name_id[i])];
    return name_index[i] < 0 ? base : base + '[' + std::to_string(name_index[i]) + ']';
}

Vec3 angular_velocity(const BodySet& bodies, const BodyState& state, BodyId body) {
    const auto i = static_cast<std::size_t>(body.value);
    const Vec3& moments = bodies.principal_moments[i];
    if (moments.x <= 0) {
        return {};
    }
    const Quat frame = state.orientation[i] * bodies.principal_axes[i];
    if (locks_of(bodies, i).any_rotation()) {
        return inverse_inertia_of(bodies, i, state.orientation[i]) * state.angular_momentum[i];
    }
    const Vec3 local = rotate_back(frame, state.angular_momentum[i]);
    return rotate(frame, {local.x / moments.x, local.y / moments.y, local.z / moments.z});
}

Vec3 angular_momentum_of(const BodySet& bodies, BodyId body, const Quat& orientation, const Vec3& angular_velocity) {
    const auto i = static_cast<std::size_t>(body.value);
    const Vec3& moments = bodies.principal_moments[i];
    const Quat frame = orientation * bodies.principal_axes[i];
    const Vec3 local = rotate_back(frame, angular_velocity);
    const Vec3 momentum = rotate(frame, {local.x * moments.x, local.y * moments.y, local.z * moments.z});
    return locks_of(bodies, i).free_rotation(momentum);
}

bool is_free(const BodySet& bodies, BodyId body, double time) {
    const auto i = static_cast<std::size_t>(body.value);
    return bodies.drive[i] == Drive::free || time >= bodies.release_time[i];
}

DrivenState driven_state(const BodySet& bodies, BodyId body, double time) {
    const DrivenBody& entry =
        bodies.driven_bodies[static_cast<std::size_t>(bodies.driven[static_cast<std::size_t>(body.value)])];
    return evaluate(bodies.motions[static_cast<std::size_t>(entry.motion)], entry.start, time);
}

std::int64_t look_count(const BodySet& bodies, BodyId body, double end) {
    const DrivenBody& entry =
        bodies.driven_bodies[static_cast<std::size_t>(bodies.driven[static_cast<std::size_t>(body.value)])];
    const double period = shortest_period(bodies.motions[static_cast<std::size_t>(entry.motion)]);
    return static_cast<std::int64_t>(std::clamp(64 * end / period, 1999.0, 2e5));
}

void drive(BodySet& bodies, BodyId body, std::int32_t motion, const Pose& start) {
    RIPRAP_ASSERT(bodies.driven[static_cast<std::size_t>(body.value)] == -1, "a body is driven by one motion");
    bodies.driven[static_cast<std::size_t>(body.value)] = static_cast<std::int32_t>(bodies.driven_bodies.size());
    bodies.driven_bodies.push_back({motion, start});
}

void shrink_to_fit(BodySet& bodies, BodyState& state) {
    const auto shrink = [](auto&... arrays) { (arrays.shrink_to_fit(), ...); };
    shrink(bodies.name_id, bodies.name_index, bodies.names, bodies.material, bodies.drive, bodies.mass,
           bodies.principal_moments, bodies.principal_axes, bodies.driven, bodies.locks, bodies.release_time,
           bodies.part_begin, bodies.parts, bodies.driven_bodies, bodies.motions);
    BodyState::visit_fields(state, [](std::string_view, auto& field) { field.shrink_to_fit(); });
}

BodyId add_body(BodySet& bodies, BodyState& state, const geometry::ShapeSet& shapes, const NewBody& body) {
    const BodyId id{bodies.size()};

    double volume = 0;
    Vec3 first_moment{};
    for (const Part& part : body.parts) {
        const PartIntegrals integrals = integrals_of(shapes, part);
        volume += integrals.volume;
        first_moment += integrals.volume * integrals.center;
    }
    const bool is_single = body.parts.size() == 1 && body.parts[0].local == Pose{};
    const Vec3 center = is_single || volume <= 0 ? Vec3{} : first_moment / volume;
    Mat3 second_moment{};
    for (const Part& part : body.parts) {
        const PartIntegrals integrals = integrals_of(shapes, part);
        const Vec3 arm = integrals.center - center;
        second_moment = second_moment + integrals.second_moment + integrals.volume * outer(arm, arm);
    }
    const SymmetricEigen eigen = symmetric_eigen(body.density * geometry::inertia_from_second_moment(second_moment));

    const auto name = std::find(bodies.names.rbegin(), bodies.names.rend(), body.name);
    if (name == bodies.names.rend()) {
        bodies.name_id.push_back(static_cast<std::int32_t>(bodies.names.size()));
        bodies.names.push_back(body.name);
    } else {
        bodies.name_id.push_back(static_cast<std::int32_t>(bodies.names.rend() - name) - 1);
    }
    bodies.name_index.push_back(body.name_index);
    bodies.material.push_back(body.material);
    bodies.drive.push_back(body.drive);
    bodies.mass.push_back(body.density * volume);
    bodies.principal_moments.push_back(volume > 0 ? snap_equal(eigen.values) : Vec3{});
    bodies.principal_axes.push_back(from_matrix(eigen.axes));
    bodies.driven.push_back(-1);
    if (!bodies.locks.empty()) {
        bodies.locks.push_back(0);
    }
    bodies.release_time.push_back(body.release_time);
    if (bodies.part_begin.empty()) {
        bodies.part_begin.push_back(0);
    }
    for (Part part : body.parts) {
        part.body = id;
        part.local.position -= center;
        bodies.parts.push_back(part);
    }
    bodies.part_begin.push_back(bodies.part_count());

    const Pose pose{to_world(body.pose, center), normalized(body.pose.orientation)};
    if (body.motion >= 0) {
        drive(bodies, id, body.motion, pose);
    }
    state.position.push_back(pose.position);
    state.orientation.push_back(pose.orientation);
    state.velocity.push_back(body.velocity);
    state.angular_momentum.push_back(angular_momentum_of(bodies, id, pose.orientation, body.angular_velocity));
    return id;
}

}  // namespace riprap::body

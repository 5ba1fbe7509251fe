// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/swept_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::run {

namespace {

/// A body at both ends of a step.
struct Way {
    Pose from, to;
    double travel;  ///< of its farthest point, at most [m]
    double reach;   ///< [m]

    Pose at_share(double s) const {
        const Quat &p = from.orientation, &q = to.orientation;
        const double side = p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z < 0 ? -s : s, r = 1 - s;
        return {r * from.position + s * to.position, normalized(Quat{r * p.w + side * q.w, r * p.x + side * q.x,
                                                                     r * p.y + side * q.y, r * p.z + side * q.z})};
    }
};

Way way_of(const sim::Model& model, const sim::State& state, std::int32_t b, double dt) {
    const body::BodySet& bodies = model.bodies;
    const BodyId id{b};
    const Pose from{state.bodies.position[at(b)], state.bodies.orientation[at(b)]};
    Way way{from, from, 0, solid::reach_of(bodies, model.shapes, b)};
    if (is_free(bodies, id, state.time)) {
        const Vec3 turn = dt * angular_velocity(bodies, state.bodies, id);
        way.to = {from.position + dt * state.bodies.velocity[at(b)],
                  normalized(from_rotation_vector(turn) * from.orientation)};
        way.travel = norm(way.to.position - from.position) + way.reach * norm(turn);
    } else if (bodies.drive[at(b)] == body::Drive::driven) {
        way.to = driven_state(bodies, id, state.time + dt).pose;
        way.to.position += state.bodies.drive_offset.empty() ? Vec3{} : state.bodies.drive_offset[at(b)];
        const Quat turn = conjugate(from.orientation) * way.to.orientation;
        way.travel = norm(way.to.position - from.position) +
                     way.reach * 2 * std::atan2(norm(Vec3{turn.x, turn.y, turn.z}), std::abs(turn.w));
    }
    return way;
}

contact::Frame frame_of(const Pose& body, const body::Part& part) {
    return {to_world(body, part.local.position), to_matrix(body.orientation * part.local.orientation)};
}

/// Do two parts come deeper in each other on their ways than half the smaller radius?
bool do_meet(const sim::Model& model, const Way& a, const body::Part& part_a, const Way& b, const body::Part& part_b) {
    const geometry::ConvexView shape_a = model.shapes.view(part_a.shape), shape_b = model.shapes.view(part_b.shape);
    const double radius = std::min(shape_a.inscribed_radius, shape_b.inscribed_radius);
    if (!(a.travel + b.travel > radius) || !std::isfinite(radius)) {
        return false;
    }
    constexpr double most_looks = 1000;
    const double looks = std::min(most_looks, std::ceil((a.travel + b.travel) / (0.5 * radius)));
    for (double k = 0; k <= looks; ++k) {
        contact::SeparatingCache cache;
        contact::NormalContact found{};
        if (contact::find_contact(shape_a, frame_of(a.at_share(k / looks), part_a), 1, shape_b,
                                  frame_of(b.at_share(k / looks), part_b), 1, {}, cache, found) &&
            found.depth > 0.5 * radius) {
            return true;
        }
    }
    return false;
}

bool are_far(const Way& a, const Way& b) {
    return std::isfinite(a.reach + b.reach) && a.reach > 0 && b.reach > 0 &&
           norm(a.from.position - b.from.position) > a.reach + b.reach + a.travel + b.travel;
}

bool do_meet(const sim::Model& model, const Way& a, std::int32_t body_a, const Way& b, std::int32_t body_b) {
    const std::vector<std::int32_t>& begin = model.bodies.part_begin;
    for (std::int32_t p = begin[at(body_a)]; p < begin[at(body_a) + 1]; ++p) {
        for (std::int32_t q = begin[at(body_b)]; q < begin[at(body_b) + 1]; ++q) {
            if (do_meet(model, a, model.bodies.parts[at(p)], b, model.bodies.parts[at(q)])) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

std::optional<Sweep> find_sweep(const sim::Model& model, const sim::State& state, double dt) {
    const std::int32_t count = model.bodies.size();
    const double thinnest = solid::smallest_radius(model.bodies, model.shapes);
    std::vector<Way> ways;
    for (std::int32_t b = 0; b < count; ++b) {
        ways.push_back(way_of(model, state, b, dt));
    }
    for (std::int32_t a = 0; a < count; ++a) {
        // One of two that approach each other by more than the thinnest radius goes half of that.
        if (!(ways[at(a)].travel > 0.5 * thinnest)) {
            continue;
        }
        for (std::int32_t b = 0; b < count; ++b) {
            const bool is_free_pair =
                is_free(model.bodies, BodyId{a}, state.time) || is_free(model.bodies, BodyId{b}, state.time);
            if (a != b && is_free_pair && !are_far(ways[at(a)], ways[at(b)]) &&
                do_meet(model, ways[at(a)], a, ways[at(b)], b)) {
                return Sweep{BodyId{a}, BodyId{b}, ways[at(a)].travel};
            }
        }
    }
    return std::nullopt;
}

}  // namespace riprap::run

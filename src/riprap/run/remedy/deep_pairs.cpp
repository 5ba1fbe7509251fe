// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/remedy/deep_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "riprap/core/index.hpp"
#include "riprap/scene/warnings/initial_overlaps.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::run {

namespace {

Pose pose_of(const sim::State& state, BodyId body) {
    return {state.bodies.position[at(body.value)], state.bodies.orientation[at(body.value)]};
}

/// Tells whether a point lies in a part where it is now.
bool is_inside(const sim::Model& model, const sim::State& state, const body::Part& part, const Vec3& point) {
    const geometry::ConvexView shape = model.shapes.view(part.shape);
    const Vec3 local = to_body(part.local, to_body(pose_of(state, part.body), point));
    for (int f = 0; f < shape.face_count; ++f) {
        if (dot(shape.normal(f), local) > shape.offset[f]) {
            return false;
        }
    }
    return true;
}

/// Velocity of the body of a part at a point in the world [m/s].
Vec3 velocity_at(const sim::Model& model, const sim::State& state, std::int32_t part, const Vec3& point) {
    const BodyId body = model.bodies.parts[at(part)].body;
    const auto b = at(body.value);
    return state.bodies.velocity[b] +
           cross(angular_velocity(model.bodies, state.bodies, body), point - state.bodies.position[b]);
}

/// Tells whether another deep contact pushes a body against `push`, within 60 degrees.
bool is_held(const sim::Model& model, std::span<const DeepPairs::Meeting> meetings, BodyId body, const Vec3& push) {
    return std::any_of(meetings.begin(), meetings.end(), [&](const DeepPairs::Meeting& other) {
        const double along = dot(other.push, push);
        return (model.bodies.parts[at(other.parts.a)].body == body && -along < -0.5) ||
               (model.bodies.parts[at(other.parts.b)].body == body && along < -0.5);
    });
}

/// One side of a gap, as a body in it feels it.
struct Side {
    BodyId body, wall;
    Vec3 met, push;  ///< from the wall to the body: when they met, and now [-]
};

/// The side of a gap that a pair is for its body, where the other one cannot yield.
std::optional<Side> side_of(const sim::Model& model, const DeepPairs::Meeting& now, const Vec3& met) {
    const BodyId a = model.bodies.parts[at(now.parts.a)].body, b = model.bodies.parts[at(now.parts.b)].body;
    const auto is_free = [&model](BodyId body) { return model.bodies.drive[at(body.value)] == body::Drive::free; };
    if (is_free(a) == is_free(b)) {
        return std::nullopt;
    }
    return is_free(b) ? Side{b, a, met, now.push} : Side{a, b, -met, -now.push};
}

/// Tells whether two sides of a gap that held a body back when it came no longer do, or push it on: while deep in both
/// it has come to where they are nearest to each other.
bool has_passed(const Side& one, const Side& other) {
    // Sums of the two pushes of size 1: one at the mouth of a gap of 0.97 of the width of a disc, one a disc between
    // walls that close by 3 degrees.
    constexpr double held = 0.2, let_go = 0.05;
    if (one.body != other.body || !(dot(one.push, other.push) < -0.5)) {
        return false;
    }
    const Vec3 before = one.met + other.met, now = one.push + other.push;
    return norm(before) > held && dot(before, now) < let_go * norm(before);
}

}  // namespace

std::string DeepPairs::look(const sim::Model& model, const sim::State& state, std::span<const Meeting> meetings) {
    const DeepPairs before = std::exchange(*this, {});
    std::string problem;
    std::vector<Side> sides;  // of pairs that were deep before
    for (const Meeting& now : meetings) {
        const body::Part &part_a = model.bodies.parts[at(now.parts.a)], &part_b = model.bodies.parts[at(now.parts.b)];
        const Pose a = pose_of(state, part_a.body), b = pose_of(state, part_b.body);
        pair_.push_back(pair_key(now.parts));
        const auto old = std::lower_bound(before.pair_.begin(), before.pair_.end(), pair_.back());
        if (old == before.pair_.end() || *old != pair_.back()) {
            point_a_.push_back(to_body(a, now.point));
            point_b_.push_back(to_body(b, now.point));
            normal_a_.push_back(rotate_back(a.orientation, now.normal));
            normal_b_.push_back(rotate_back(b.orientation, now.normal));
            continue;
        }
        const auto k = static_cast<std::size_t>(old - before.pair_.begin());
        point_a_.push_back(before.point_a_[k]);
        point_b_.push_back(before.point_b_[k]);
        normal_a_.push_back(before.normal_a_[k]);
        normal_b_.push_back(before.normal_b_[k]);
        const Vec3 on_a = to_world(a, point_a_.back()), on_b = to_world(b, point_b_.back()), way = on_a - on_b;
        const double gone = std::min(dot(way, rotate(a.orientation, normal_a_.back())),
                                     dot(way, rotate(b.orientation, normal_b_.back())));
        const double radius = now.depth / now.share;
        if (problem.empty() && gone > solid::most_overlap * radius && is_inside(model, state, part_a, on_b) &&
            is_inside(model, state, part_b, on_a) &&
            (is_held(model, meetings, part_a.body, -now.push) || is_held(model, meetings, part_b.body, now.push))) {
            problem = fmt::format(
                "{} and {} have gone {:.3g} m into each other against the push with which they met, {:.3g} of an "
                "inscribed radius, at ({:.6g}, {:.6g}, {:.6g}) m, t = {:.6g} s: their contact cannot carry what they "
                "bring; allowed: {:.3g}",
                model.bodies.name(part_a.body), model.bodies.name(part_b.body), gone, gone / radius, now.point.x,
                now.point.y, now.point.z, state.time, solid::most_overlap);
        }
        const auto side = side_of(model, now, rotate(a.orientation, normal_a_.back()));
        if (!side) {
            continue;
        }
        const auto other = std::ranges::find_if(sides, [&](const Side& one) { return has_passed(one, *side); });
        if (problem.empty() && other != sides.end()) {
            problem = fmt::format(
                "{} is squeezed through between {} and {}, {:.3g} m deep in them, {:.3g} of an inscribed radius, at "
                "({:.6g}, {:.6g}, {:.6g}) m, t = {:.6g} s: their contact cannot carry what they bring; a body passes "
                "no gap narrower than itself",
                model.bodies.name(side->body), model.bodies.name(other->wall), model.bodies.name(side->wall), now.depth,
                now.share, now.point.x, now.point.y, now.point.z, state.time);
        }
        sides.push_back(*side);
    }
    return problem;
}

bool DeepPairs::fits(const sim::Model& model) const {
    const std::size_t count = pair_.size();
    const auto parts = static_cast<std::uint64_t>(model.bodies.part_count());
    return point_a_.size() == count && point_b_.size() == count && normal_a_.size() == count &&
           normal_b_.size() == count &&
           std::adjacent_find(pair_.begin(), pair_.end(), std::greater_equal<>()) == pair_.end() &&
           std::all_of(pair_.begin(), pair_.end(),
                       [parts](std::uint64_t pair) { return pair >> 32 < parts && (pair & 0xFFFFFFFFU) < parts; });
}

std::vector<DeepPairs::Meeting> deep_meetings(const sim::Model& model, const sim::State& state,
                                              std::span<const contact::ShownContact> rows, double dt) {
    const contact::ContactHistory& contacts = state.contacts;
    std::vector<DeepPairs::Meeting> meetings;
    for (std::size_t first = 0, last = 0; first < std::min(rows.size(), contacts.size()); first = last) {
        const std::uint64_t pair = contacts.pair[first];
        DeepPairs::Meeting meeting{
            {static_cast<std::int32_t>(pair >> 32), static_cast<std::int32_t>(pair & 0xFFFFFFFFU)}, {}, {}, {}, 0, 0};
        for (; last < std::min(rows.size(), contacts.size()) && contacts.pair[last] == pair; ++last) {
            meeting.point += rows[last].point;
            if (rows[last].potential > meeting.share) {
                meeting.share = rows[last].potential;
                meeting.depth = rows[last].overlap;
                meeting.push = contacts.normal[last];
            }
        }
        meeting.point = meeting.point / static_cast<double>(last - first);
        if (meeting.share > deep_overlap) {
            const Vec3 way = dt * (velocity_at(model, state, meeting.parts.b, meeting.point) -
                                   velocity_at(model, state, meeting.parts.a, meeting.point));
            meeting.normal = norm(way) > meeting.depth ? -way / norm(way) : meeting.push;
            meetings.push_back(meeting);
        }
    }
    return meetings;
}

std::vector<DeepPairs::Meeting> deep_meetings(const sim::Model& model, const sim::State& state) {
    std::vector<DeepPairs::Meeting> meetings;
    for (const scene::PartOverlap& overlap : scene::find_part_overlaps(model, state, deep_overlap)) {
        if (norm_squared(overlap.normal) > 0) {
            meetings.push_back(
                {overlap.parts, overlap.point, overlap.normal, overlap.normal, overlap.depth, overlap.share});
        }
    }
    return meetings;
}

}  // namespace riprap::run

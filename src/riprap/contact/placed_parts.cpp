// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/placed_parts.hpp"

#include <atomic>

#include "riprap/body/may_move.hpp"
#include "riprap/contact/broadphase/giants.hpp"
#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {

namespace {

void describe_parts(const geometry::ShapeSet& shapes, const body::BodySet& bodies,
                    std::span<const std::uint8_t> left_out, PlacedParts& placed) {
    const std::size_t count = bodies.parts.size();
    placed.frames.resize(count);
    placed.centers.resize(count);
    placed.radii.resize(count);
    placed.body.resize(count);
    placed.is_mobile.resize(count);
    for (std::size_t p = 0; p < count; ++p) {
        const body::Part& part = bodies.parts[p];
        const auto body = at(part.body.value);
        placed.radii[p] = shapes.view(part.shape).circumradius;
        placed.body[p] = part.body.value;
        placed.is_mobile[p] = may_move(bodies, body) && (left_out.empty() || left_out[body] == 0) ? 1 : 0;
    }
    placed.restless.clear();
    placed.resting.clear();
    static std::atomic<std::uint64_t> scenes{0};
    placed.scene = ++scenes;
    placed.median_radius = median_radius(placed.radii);
    placed.giants.clear();
    for (const std::int32_t part : choose_giants(placed.radii)) {
        placed.giants.push_back({part, shapes.view(bodies.parts[at(part)].shape), {}});
    }
}

Pose pose_of(const body::BodyState& state, std::int32_t body) {
    return {state.position[at(body)], state.orientation[at(body)]};
}

void place_part(const body::BodySet& bodies, const body::BodyState& state, std::int32_t index, PlacedParts& placed) {
    const body::Part& part = bodies.parts[at(index)];
    const Pose body_pose = pose_of(state, part.body.value);
    Frame& frame = placed.frames[at(index)];
    frame = to_frame({to_world(body_pose, part.local.position), body_pose.orientation * part.local.orientation});
    placed.centers[at(index)] = frame.origin;
}

void append_parts(const body::BodySet& bodies, std::int32_t body, std::vector<std::int32_t>& parts) {
    for (std::int32_t p = bodies.part_begin[at(body)]; p < bodies.part_begin[at(body) + 1]; ++p) {
        parts.push_back(p);
    }
}

/// Places all parts of a new scene, and says which of its bodies rest.
void place_all(const body::BodySet& bodies, const body::BodyState& state, PlacedParts& placed) {
    parallel::for_each(bodies.part_count(),
                       [&](std::int64_t part) { place_part(bodies, state, static_cast<std::int32_t>(part), placed); });
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        const std::int32_t first = bodies.part_begin[at(b)];
        if (first < bodies.part_begin[at(b) + 1] && placed.is_mobile[at(first)] == 0) {
            placed.resting.push_back({b, pose_of(state, b)});
        } else {
            append_parts(bodies, b, placed.restless);
        }
    }
}

/// Places the parts of all bodies but those that rest still.
void place_restless(const body::BodySet& bodies, const body::BodyState& state, PlacedParts& placed) {
    std::erase_if(placed.resting, [&](const PlacedParts::Resting& resting) {
        const bool has_moved = resting.pose != pose_of(state, resting.body);
        if (has_moved) {
            append_parts(bodies, resting.body, placed.restless);
        }
        return has_moved;
    });
    parallel::for_each(static_cast<std::int64_t>(placed.restless.size()),
                       [&](std::int64_t k) { place_part(bodies, state, placed.restless[at(k)], placed); });
}

}  // namespace

void place_parts(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                 PlacedParts& placed, std::span<const std::uint8_t> left_out) {
    if (placed.frames.size() != bodies.parts.size()) {
        describe_parts(shapes, bodies, left_out, placed);
        place_all(bodies, state, placed);
    } else {
        place_restless(bodies, state, placed);
    }
    for (Giant& giant : placed.giants) {
        giant.frame = placed.frames[at(giant.part)];
    }
}

std::size_t PlacedParts::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return of(frames) + of(centers) + of(radii) + of(body) + of(is_mobile) + of(giants) + of(restless) + of(resting);
}

}  // namespace riprap::contact

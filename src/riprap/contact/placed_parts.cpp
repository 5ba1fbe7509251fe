// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/placed_parts.hpp"

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
    placed.median_radius = median_radius(placed.radii);
    placed.giants.clear();
    for (const std::int32_t part : choose_giants(placed.radii)) {
        placed.giants.push_back({part, shapes.view(bodies.parts[at(part)].shape), {}});
    }
}

}  // namespace

void place_parts(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                 PlacedParts& placed, std::span<const std::uint8_t> left_out) {
    if (placed.frames.size() != bodies.parts.size()) {
        describe_parts(shapes, bodies, left_out, placed);
    }
    parallel::for_each(static_cast<std::int64_t>(bodies.parts.size()), [&](std::int64_t index) {
        const body::Part& part = bodies.parts[at(index)];
        const auto body = at(part.body.value);
        const Pose body_pose{state.position[body], state.orientation[body]};
        Frame& frame = placed.frames[at(index)];
        frame = to_frame({to_world(body_pose, part.local.position), body_pose.orientation * part.local.orientation});
        placed.centers[at(index)] = frame.origin;
    });
    for (Giant& giant : placed.giants) {
        giant.frame = placed.frames[at(giant.part)];
    }
}

std::size_t PlacedParts::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return of(frames) + of(centers) + of(radii) + of(body) + of(is_mobile) + of(giants);
}

}  // namespace riprap::contact

// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/round_touch.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

namespace {

Vec2 center_of(const State& state, std::int32_t block) { return {state.x[at(block)], state.y[at(block)]}; }

Vec2 direction(const Vec2& v, const Vec2& otherwise) {
    const double length = norm(v);
    return length > 0 ? (1 / length) * v : otherwise;
}

/// Way from the centre of a disc to its point that lies farthest along n: r F F^T n/|F^T n| with F = R U [m].
Vec2 farthest_along(const Model& model, const State& state, std::int32_t block, const Vec2& n) {
    const Vec2 fx = offset_of(state, block, {1, 0}), fy = offset_of(state, block, {0, 1});  // columns of F
    const Vec2 back{dot(fx, n), dot(fy, n)};
    return (model.round_radius[at(block)] / norm(back)) * (back.x * fx + back.y * fy);
}

RoundTouch touch_disc(const Model& model, const State& state, std::int32_t a, std::int32_t b, const Vec2& ahead) {
    const Vec2 apart = center_of(state, a) - center_of(state, b), up{0, 1};
    const Vec2 n = direction(apart, up);
    RoundTouch touch;
    touch.gap = norm(apart) + dot(n, farthest_along(model, state, a, -n)) - dot(n, farthest_along(model, state, b, n));
    touch.normal = direction(apart + ahead, n);
    touch.on_disc = center_of(state, a) + farthest_along(model, state, a, -touch.normal);
    touch.other = center_of(state, b) + farthest_along(model, state, b, touch.normal);
    return touch;
}

}  // namespace

RoundTouch touch_round(const Model& model, const State& state, const std::vector<Vec2>& corners, std::int32_t disc,
                       std::int32_t edge, const Vec2& ahead) {
    const std::int32_t a = model.corner_block[at(disc)];
    if (is_round(model, edge)) {
        return touch_disc(model, state, a, model.corner_block[at(edge)], ahead);
    }
    const Vec2 center = center_of(state, a), end = corners[at(model.corner_next[at(edge)])];
    const Vec2 line = corners[at(edge)] - end, outward = direction({-line.y, line.x}, {});
    RoundTouch touch;
    touch.foot = dot(line, center - end) / dot(line, line);
    if (touch.foot >= 0 && touch.foot < 1) {
        touch.normal = outward;
        touch.on_disc = center + farthest_along(model, state, a, -outward);
        touch.gap = dot(outward, touch.on_disc - end);
        touch.other = touch.on_disc - touch.gap * outward;
        return touch;
    }
    touch.other = touch.foot < 0 ? end : corners[at(edge)];
    const Vec2 from = center - touch.other, n = direction(from, outward);
    touch.gap = norm(from) + dot(n, farthest_along(model, state, a, -n));
    touch.normal = direction(from + ahead, n);
    touch.on_disc = center + farthest_along(model, state, a, -touch.normal);
    return touch;
}

}  // namespace riprap::solid::planar_dda

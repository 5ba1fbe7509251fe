// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/seams.hpp"

#include <cmath>

namespace riprap::solid::planar_dda {

Seams::Seams(const Scene& scene, const ContactSearch& search)
    : scene_(&scene),
      search_(&search),
      begin_(at(scene.model.block_count() + 1), 0),
      neighbour_(2 * search.pairs.size()),
      give_(at(scene.model.block_count()), 0) {
    find_give();
    for (const auto& [a, b] : search.pairs) {
        ++begin_[at(a + 1)];
        ++begin_[at(b + 1)];
    }
    for (std::size_t b = 1; b < begin_.size(); ++b) {
        begin_[b] += begin_[b - 1];
    }
    std::vector<std::int32_t> filled(begin_.begin(), begin_.end() - 1);
    for (const auto& [a, b] : search.pairs) {
        neighbour_[at(filled[at(a)]++)] = b;
        neighbour_[at(filled[at(b)]++)] = a;
    }
}

/// Finds by how much the springs of its closed contacts give at every block that they carry.
void Seams::find_give() {
    const State& state = scene_->state;
    for (std::size_t k = 0; k < state.contact_corner.size(); ++k) {
        const std::int32_t a = scene_->model.corner_block[at(state.contact_corner[k])];
        const std::int32_t b = scene_->model.corner_block[at(state.contact_edge[k])];
        const double overlap =
            state.contact_force[k] / (state.contact_share[k] * scene_->model.joint(a, b).normal_stiffness);
        for (const std::int32_t block : {a, b}) {
            if (scene_->model.is_fixed[at(block)] == 0) {
                give_[at(block)] = std::max(give_[at(block)], overlap);
            }
        }
    }
}

/// Tells whether a block comes so near to a corner that it may carry the block of the corner: over a joint as wide as
/// half of the longer face there, as that block tips into a wider one.
bool Seams::is_near(std::int32_t corner, std::int32_t block) const {
    const ContactSearch::Box& box = search_->boxes[at(block)];
    const Vec2 p = scene_->place(corner);
    const double longest =
        std::max(norm(scene_->place(scene_->next(corner)) - p), norm(scene_->place(scene_->before(corner)) - p));
    const double reach = std::max(scene_->reach, 0.5 * longest);
    return p.x >= box.left - reach && p.x <= box.right + reach && p.y >= box.low - reach && p.y <= box.high + reach;
}

Vec2 Seams::outward(std::int32_t edge) const {
    const Vec2 line = scene_->place(edge) - scene_->place(scene_->next(edge));
    return (1 / norm(line)) * Vec2{-line.y, line.x};
}

/// Neither edge at the corner leans into the edge's material.
bool Seams::may_stand(std::int32_t corner, std::int32_t edge) const {
    const double lean = -std::sin(scene_->settings.angle_tolerance);
    const Vec2 n = outward(edge);
    for (const std::int32_t end : {scene_->next(corner), scene_->before(corner)}) {
        const Vec2 side = scene_->place(end) - scene_->place(corner);
        if (dot(n, side) < lean * norm(side)) {
            return false;
        }
    }
    return true;
}

Seams::Bridge Seams::bridge_over(std::int32_t stander, std::int32_t face, bool is_at_end) const {
    const std::int32_t end = is_at_end ? scene_->next(face) : face;
    const Vec2 n = outward(face);
    for (const std::int32_t edge : {stander, scene_->before(stander)}) {
        const bool is_along = dot(outward(edge), n) < -std::cos(scene_->settings.angle_tolerance);
        const GapAndFoot g = gap_and_foot(*scene_, end, edge);
        if (is_along && g.foot > 0 && g.foot < 1 && g.gap <= scene_->reach) {
            return {true, scene_->is_closed(end, edge), std::max(0.0, -g.gap)};
        }
    }
    return {};
}

/// What a corner lies on carries it, rather than the end of a face farther back that its block bridges; of several ends
/// the nearest.
bool Seams::Seam::carries_rather_than(const Seam& other) const {
    if (!other.is_there || hangs != other.hangs) {
        return !other.is_there || !hangs;
    }
    return hangs ? past < other.past : is_closed && !other.is_closed;
}

void Seams::look_at(std::int32_t third, std::int32_t stander, std::int32_t other, Seam& seam) const {
    const Model& model = scene_->model;
    const double breadth =
        std::min(model.width[at(model.corner_block[at(stander)])], model.width[at(model.corner_block[at(other)])]);
    const double joint = joint_share * breadth, least = step_share * breadth;
    for (std::int32_t f = model.corner_begin[at(third)]; f < model.corner_begin[at(third + 1)]; ++f) {
        const GapAndFoot s = gap_and_foot(*scene_, stander, f), o = gap_and_foot(*scene_, other, f);
        const double slack = joint / s.length;
        // Of the end of the face that `other` is nearer to: how far both are beyond it.
        const bool is_at_end = o.foot < 0.5;
        const double past = o.length * (is_at_end ? -o.foot : o.foot - 1);
        const bool hangs = s.foot < -slack || s.foot > 1 + slack;
        if (s.gap > scene_->reach || s.gap < -scene_->depth(stander, f) || past < -joint || !may_stand(stander, f)) {
            continue;
        }
        const Bridge under = hangs ? bridge_over(stander, f, is_at_end)
                                   : Bridge{true, scene_->is_closed(stander, f), std::max(0.0, -s.gap)};
        // Neither height is known better than the springs give on which the blocks lie.
        const double give = std::max({under.overlap, give_[at(third)], give_[at(model.corner_block[at(other)])]});
        const double step = std::max(least, std::min(2 * give, soft_step_share * breadth));
        // A corner that hangs over a joint sinks by what the springs of both supports give, at most twice the overlap
        // at the end of the face; one that is lower has left its support.
        const bool has_dipped = hangs && -s.gap > std::max(least, 2 * under.overlap);
        if (o.gap > step || !under.is_there || has_dipped) {
            continue;
        }
        const Vec2 n = outward(f);
        const Vec2 towards = (is_at_end ? 1 : -1) / o.length * (scene_->place(f) - scene_->place(scene_->next(f)));
        const std::int32_t edges[2]{other, scene_->before(other)};
        const bool is_second = dot(outward(edges[1]), n - towards) > dot(outward(edges[0]), n - towards);
        const Seam found{true,
                         under.is_closed,
                         hangs,
                         n,
                         edges[is_second ? 1 : 0],
                         s.length * (is_at_end ? -s.foot : s.foot - 1),
                         o.gap,
                         step};
        if (dot(outward(found.top), n) >= 0.5 && found.carries_rather_than(seam)) {
            seam = found;
        }
    }
}

Seams::Seam Seams::find(std::int32_t stander, std::int32_t other) const {
    const Model& model = scene_->model;
    const std::int32_t a = model.corner_block[at(stander)], b = model.corner_block[at(other)];
    Seam seam;
    for (const std::int32_t block : {a, b}) {
        for (std::int32_t k = begin_[at(block)]; k < begin_[at(block + 1)]; ++k) {
            const std::int32_t third = neighbour_[at(k)];
            const bool moves = model.is_fixed[at(third)] == 0 || model.is_fixed[at(a)] == 0;
            const bool has_faces = model.round_radius[at(third)] == 0;
            if (third != a && third != b && moves && has_faces && is_near(stander, third)) {
                look_at(third, stander, other, seam);
            }
        }
    }
    return seam;
}

/// Tells whether the first entrance is the one along the face of a seam.
bool Seams::leads_along(const Seam& seam, std::int32_t stander, const Key& first, const Key& second) const {
    if (first.second == seam.top || second.second == seam.top) {
        return first.second == seam.top;
    }
    const std::int32_t block = scene_->model.corner_block[at(stander)];
    const auto towards_stander = [&](const Key& key) {
        return scene_->model.corner_block[at(key.second)] == block ? -dot(outward(key.second), seam.normal)
                                                                   : dot(outward(key.second), seam.normal);
    };
    return towards_stander(first) >= towards_stander(second);
}

Seams::Answer Seams::open_entrance(std::int32_t v, std::int32_t w, const Key& first, const Key& second) const {
    using Kind = Answer::Kind;
    const Seam of_v = find(v, w), of_w = find(w, v);
    if (!of_v.is_there && !of_w.is_there) {
        return {};
    }
    const bool by_v = of_v.is_there && leads_along(of_v, v, first, second);
    const bool by_w = of_w.is_there && leads_along(of_w, w, first, second);
    if (!of_v.is_there || !of_w.is_there || by_v == by_w) {
        const bool hangs = (of_v.is_there && of_v.hangs) || (of_w.is_there && of_w.hangs);
        return {hangs ? Kind::weak : Kind::clear, of_v.is_there ? by_v : by_w};
    }
    // Both stand on something that the other continues. What has not come to the end of its face yet passes by.
    const double tolerance = std::max(of_v.tolerance, of_w.tolerance);
    const double ahead = std::max(of_v.past, of_w.step) - std::max(of_v.step, of_w.past);
    if (std::abs(ahead) > tolerance) {
        return {Kind::clear, ahead < 0 ? by_v : by_w};
    }
    const Model& model = scene_->model;
    const auto velocity = [&](std::int32_t corner) {
        return velocity_of(scene_->state, model.corner_block[at(corner)], model.corner[at(corner)]);
    };
    const Vec2 relative = velocity(v) - velocity(w);
    const double across_v = std::abs(dot(relative, of_v.normal)), across_w = std::abs(dot(relative, of_w.normal));
    if (across_v < 0.5 * across_w || across_w < 0.5 * across_v) {
        return {Kind::weak, across_v < across_w ? by_v : by_w};
    }
    return {};
}

}  // namespace riprap::solid::planar_dda

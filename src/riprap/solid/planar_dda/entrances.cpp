// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/entrances.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

namespace {

/// Two lines that are nearly one: who stands on whom. Both, where both do.
Entrances standing_entrances(const Scene& scene, const Key& first, const Key& second) {
    const GapAndFoot g1 = gap_and_foot(scene, first.first, first.second);
    const GapAndFoot g2 = gap_and_foot(scene, second.first, second.second);
    if (is_foot_on_edge(g1) && is_foot_on_edge(g2)) {
        return {2, {first, second}};
    }
    return {1, {beyond_ends(g1) < beyond_ends(g2) ? first : second}};
}

/// Gaps that differ by less than this share of the narrower block's width are one [-].
constexpr double equal_share = 1e-6;

/// The two ways in at two corners where the one is as good as the other. So it is where aligned tips meet: either way
/// alone would throw to its side what is symmetric. Both of one corner where that can be, else they make a couple.
Entrances equal_entrances(const Scene& scene, std::int32_t v, std::int32_t w, const Key& first, const Key& second) {
    const Model& model = scene.model;
    const double tolerance =
        equal_share * std::min(model.width[at(model.corner_block[at(v)])], model.width[at(model.corner_block[at(w)])]);
    const auto gap = [&scene](const Key& key) { return gap_and_foot(scene, key.first, key.second).gap; };
    const double largest = std::max(gap(first), gap(second));
    const auto are_equal = [&](const Key& one, const Key& other) {
        return std::abs(gap(one) - largest) < tolerance && std::abs(gap(other) - largest) < tolerance;
    };
    if (!are_equal(first, second)) {
        return {};
    }
    for (const auto& [one, other] :
         {std::pair{Key{v, w}, Key{v, scene.before(w)}}, {Key{w, v}, Key{w, scene.before(v)}}}) {
        if (are_equal(one, other)) {
            return {2, {one, other}};
        }
    }
    return {2, {first, second}};
}

/// Two lines at an angle: what a third block hides is none; a closed contact stays the entrance until it opens or is
/// left; else the larger gap decides, and both are entrances where they are equal.
Entrances cornered_entrance(const Scene& scene, const Seams& seams, std::int32_t v, std::int32_t w, const Key& first,
                            const Key& second) {
    const Seams::Answer seam = seams.open_entrance(v, w, first, second);
    if (seam.kind == Seams::Answer::Kind::clear) {
        return {1, {seam.is_first ? first : second}, true};
    }
    const GapAndFoot g1 = gap_and_foot(scene, first.first, first.second);
    const GapAndFoot g2 = gap_and_foot(scene, second.first, second.second);
    const bool stays1 = scene.is_closed(first.first, first.second) && is_foot_on_edge(g1);
    const bool stays2 = scene.is_closed(second.first, second.second) && is_foot_on_edge(g2);
    if (const Entrances both = equal_entrances(scene, v, w, first, second); both.count == 2) {
        const bool stay1 = scene.is_closed(both.key[0].first, both.key[0].second);
        const bool stay2 = scene.is_closed(both.key[1].first, both.key[1].second);
        if (stay1 == stay2 && (stay1 || (!stays1 && !stays2))) {
            return both;
        }
    }
    if (stays1 != stays2) {
        return {1, {stays1 ? first : second}};
    }
    if (seam.kind == Seams::Answer::Kind::weak) {
        return {1, {seam.is_first ? first : second}, true};
    }
    return {1, {g1.gap >= g2.gap ? first : second}};
}

}  // namespace

Entrances find_entrances(const Scene& scene, const Seams& seams, std::int32_t v, std::int32_t w) {
    const Vec2 p1 = scene.place(scene.next(w)) - scene.place(w), p2 = scene.place(scene.before(w)) - scene.place(w);
    const Vec2 q1 = scene.place(v) - scene.place(scene.next(v)), q2 = scene.place(v) - scene.place(scene.before(v));
    const auto angle = [](const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), dot(a, b)); };
    const double cone_w = angle(p1, p2), cone_v = angle(q1, q2), turn = angle(p1, q1);
    double begin = 0, end = 0, total = 1e9;
    for (const double shifted : {turn, turn - 2 * std::numbers::pi, turn + 2 * std::numbers::pi}) {
        const double from = std::min(0.0, shifted), to = std::max(cone_w, shifted + cone_v);
        if (to - from < total) {
            total = to - from;
            begin = from;
            end = to;
        }
    }
    if (total > std::numbers::pi + 2 * scene.settings.angle_tolerance) {
        return {};
    }
    const Key first = begin == 0 ? Key{v, w} : Key{w, v};
    const Key second = end == cone_w ? Key{v, scene.before(w)} : Key{w, scene.before(v)};
    return total > std::numbers::pi - 2 * scene.settings.angle_tolerance
               ? standing_entrances(scene, first, second)
               : cornered_entrance(scene, seams, v, w, first, second);
}

}  // namespace riprap::solid::planar_dda

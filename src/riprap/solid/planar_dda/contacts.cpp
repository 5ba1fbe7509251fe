// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/entrances.hpp"
#include "riprap/solid/planar_dda/round_touch.hpp"

namespace riprap::solid::planar_dda {

namespace {

/// Corner against edge where no other corner is near.
void find_at_edge(const Scene& scene, std::int32_t corner, std::int32_t edge, ContactSearch& search) {
    const GapAndFoot g = gap_and_foot(scene, corner, edge);
    const bool is_closed = scene.is_closed(corner, edge);
    if (g.gap > scene.reach || (g.gap < -scene.depth(corner, edge) && !is_closed) || g.foot < -foot_slack ||
        g.foot > 1 + foot_slack) {
        return;
    }
    const Vec2 line = scene.place(edge) - scene.place(scene.next(edge));
    const Vec2 outward{-line.y / g.length, line.x / g.length};
    const Vec2 to_next = scene.place(scene.next(corner)) - scene.place(corner);
    const Vec2 to_before = scene.place(scene.before(corner)) - scene.place(corner);
    const double lean = -std::sin(scene.settings.angle_tolerance);
    if (dot(outward, to_next) >= lean * norm(to_next) && dot(outward, to_before) >= lean * norm(to_before)) {
        search.wanted.push_back(key_of(corner, edge));
    }
}

void find_at_corners(const Scene& scene, const Seams& seams, std::int32_t v, std::int32_t w, ContactSearch& search) {
    const Entrances entrances = find_entrances(scene, seams, v, w);
    if (entrances.count == 0) {
        return;
    }
    const auto is_entrance = [&entrances](const Key& key) {
        return key == entrances.key[0] || (entrances.count == 2 && key == entrances.key[1]);
    };
    for (int k = 0; k < entrances.count; ++k) {
        const auto& [corner, edge] = entrances.key[k];
        const GapAndFoot g = gap_and_foot(scene, corner, edge);
        const bool is_closed = scene.is_closed(corner, edge);
        if (entrances.is_at_seam && is_closed && !is_foot_on_edge(g)) {
            continue;  // it has left this face for the next one
        }
        if (g.gap >= -scene.depth(corner, edge) || is_closed) {
            search.wanted.push_back(key_of(corner, edge));
        }
    }
    if (entrances.count == 2) {
        const std::uint64_t one = key_of(entrances.key[0].first, entrances.key[0].second);
        const std::uint64_t other = key_of(entrances.key[1].first, entrances.key[1].second);
        search.twins.emplace_back(one, other);
        search.twins.emplace_back(other, one);
    }
    for (const Key& other : {Key{v, w}, Key{v, scene.before(w)}, Key{w, v}, Key{w, scene.before(v)}}) {
        if (!is_entrance(other)) {
            search.vetoed.push_back(key_of(other.first, other.second));
        }
    }
}

/// Half the length along which the edge lies against an edge of the corner's block that ends at the corner [m].
double half_overlap(const Scene& scene, const Contact& contact) {
    const Vec2 end = scene.place(scene.next(contact.edge));
    const Vec2 along = (1 / contact.edge_length) * (scene.place(contact.edge) - end);
    for (const std::int32_t other : {scene.next(contact.corner), scene.before(contact.corner)}) {
        const Vec2 line = scene.place(other) - scene.place(contact.corner);
        if (std::abs(cross(along, line)) <= std::sin(scene.settings.angle_tolerance) * norm(line)) {
            const double s0 = dot(along, scene.place(contact.corner) - end), s1 = s0 + dot(along, line);
            return 0.5 *
                   std::max(0.0, std::min(std::max(s0, s1), contact.edge_length) - std::max(0.0, std::min(s0, s1)));
        }
    }
    return 0;
}

/// Takes over what the state knows of this contact, or of the one with the roles of two near corners changed.
void remember(const Scene& scene, Contact& contact, const CornerAndEdge& where) {
    const std::int32_t v = contact.corner, e = contact.edge;
    std::int64_t old = scene.remembered(v, e);
    contact.lock = contact.foot;
    bool has_swapped = false;
    for (const std::int32_t w : {e, scene.next(e)}) {
        for (const std::int32_t other : {v, scene.before(v)}) {
            if (old < 0 && norm(scene.place(w) - scene.place(v)) < scene.reach) {
                old = scene.remembered(w, other);
                if (old >= 0 && contact.share < 1 && scene.state.contact_share[at(old)] < 1) {
                    old = -1;  // the other half's own; this half was open
                }
                has_swapped = old >= 0;
            }
        }
    }
    if (old < 0) {
        return;
    }
    contact.mode = static_cast<Mode>(scene.state.contact_mode[at(old)]);
    contact.is_bonded = scene.state.contact_is_bonded[at(old)] != 0;
    contact.multiplier = contact.share / scene.state.contact_share[at(old)] * scene.state.contact_multiplier[at(old)];
    contact.plastic_slip = scene.state.contact_plastic_slip[at(old)];
    if (contact.mode == Mode::open) {
        return;
    }
    contact.lock = scene.state.contact_lock[at(old)];
    if (has_swapped) {  // the same slip, seen from the other edge
        const CornerAndEdge before = scene.pair(scene.state.contact_corner[at(old)], scene.state.contact_edge[at(old)]);
        contact.lock = foot_of(where) - slip_of(before, contact.lock).value / contact.edge_length;
    }
}

Contact make_contact(const Scene& scene, std::int32_t corner, std::int32_t edge, double share) {
    const CornerAndEdge where = scene.pair(corner, edge);
    const Model& model = scene.model;
    Contact contact;
    contact.corner = corner;
    contact.edge = edge;
    contact.a = model.corner_block[at(corner)];
    contact.b = model.corner_block[at(edge)];
    contact.joint = model.joint(contact.a, contact.b);
    contact.share = share;
    contact.joint.normal_stiffness *= share;
    contact.joint.shear_stiffness *= share;
    contact.edge_length = norm(where.end - where.begin);
    contact.foot = foot_of(where);
    contact.place = where.corner;
    contact.gap = gap_of(where);
    remember(scene, contact, where);
    contact.slip = slip_of(where, contact.lock);
    if (contact.joint.has_bond()) {
        const double smaller = std::min(model.area[at(contact.a)], model.area[at(contact.b)]);
        contact.bond_slip = scene.settings.bond_share * std::sqrt(smaller);
        contact.bond_length = share * half_overlap(scene, contact);
    }
    return contact;
}

/// A circle lies outside of its polygon of 64 sides by less than this share of its radius.
constexpr double outside_of_polygon = 1e-3;

ContactSearch::Box box_of(const Model& model, const std::vector<Vec2>& corners, std::int32_t block) {
    ContactSearch::Box box{1e300, -1e300, 1e300, -1e300};
    for (std::int32_t k = model.corner_begin[at(block)]; k < model.corner_begin[at(block + 1)]; ++k) {
        const Vec2& p = corners[at(k)];
        box = {std::min(box.left, p.x), std::max(box.right, p.x), std::min(box.low, p.y), std::max(box.high, p.y)};
    }
    const double bulge = outside_of_polygon * model.round_radius[at(block)];
    return {box.left - bulge, box.right + bulge, box.low - bulge, box.high + bulge};
}

/// Corners of block i against edges and corners of block j.
void find_of_pair(const Scene& scene, const Seams& seams, std::int32_t i, std::int32_t j, ContactSearch& search) {
    const Model& model = scene.model;
    const ContactSearch::Box& box = search.boxes[at(j)];
    for (std::int32_t v = model.corner_begin[at(i)]; v < model.corner_begin[at(i + 1)]; ++v) {
        const Vec2 p = scene.place(v);
        if (!model.is_convex[at(v)] || p.x < box.left - scene.reach || p.x > box.right + scene.reach ||
            p.y < box.low - scene.reach || p.y > box.high + scene.reach) {
            continue;
        }
        for (std::int32_t e = model.corner_begin[at(j)]; e < model.corner_begin[at(j + 1)]; ++e) {
            find_at_edge(scene, v, e, search);
            const Vec2 d = p - scene.place(e);
            if (i < j && model.is_convex[at(e)] && dot(d, d) < 2.25 * scene.reach * scene.reach) {
                find_at_corners(scene, seams, v, e, search);
            }
        }
    }
}

}  // namespace

void place_corners(const Model& model, const State& state, std::vector<Vec2>& corners) {
    corners.resize(model.corner.size());
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        const Vec2 center{state.x[at(b)], state.y[at(b)]};
        const Vec2 fx = offset_of(state, b, {1, 0}), fy = offset_of(state, b, {0, 1});
        for (std::int32_t k = model.corner_begin[at(b)]; k < model.corner_begin[at(b + 1)]; ++k) {
            corners[at(k)] = center + model.corner[at(k)].x * fx + model.corner[at(k)].y * fy;
        }
    }
}

void find_pairs(const Model& model, const std::vector<Vec2>& corners, double reach, ContactSearch& search) {
    const std::int32_t n = model.block_count();
    search.boxes.resize(at(n));
    search.order.resize(at(n));
    for (std::int32_t b = 0; b < n; ++b) {
        search.boxes[at(b)] = box_of(model, corners, b);
        search.order[at(b)] = b;
    }
    const auto& boxes = search.boxes;
    std::sort(search.order.begin(), search.order.end(), [&boxes](std::int32_t a, std::int32_t b) {
        return boxes[at(a)].left < boxes[at(b)].left || (boxes[at(a)].left == boxes[at(b)].left && a < b);
    });
    search.pairs.clear();
    for (std::size_t i = 0; i < search.order.size(); ++i) {
        const std::int32_t a = search.order[i];
        for (std::size_t j = i + 1; j < search.order.size(); ++j) {
            const std::int32_t b = search.order[j];
            if (boxes[at(b)].left > boxes[at(a)].right + reach) {
                break;
            }
            if (boxes[at(b)].low <= boxes[at(a)].high + reach && boxes[at(a)].low <= boxes[at(b)].high + reach &&
                !(model.is_fixed[at(a)] && model.is_fixed[at(b)])) {
                search.pairs.emplace_back(std::min(a, b), std::max(a, b));
            }
        }
    }
    std::sort(search.pairs.begin(), search.pairs.end());
}

void find_contacts(const Model& model, const State& state, const Settings& settings, const std::vector<Vec2>& corners,
                   ContactSearch& search, std::vector<Contact>& contacts, double dt) {
    const Scene scene{model, state, settings, corners, 2.5 * settings.displacement_limit, dt};
    find_pairs(model, corners, scene.reach, search);
    search.wanted.clear();
    search.vetoed.clear();
    search.twins.clear();
    const Seams seams(scene, search);
    for (const auto& [i, j] : search.pairs) {
        if (model.round_radius[at(i)] == 0 && model.round_radius[at(j)] == 0) {
            find_of_pair(scene, seams, i, j, search);
            find_of_pair(scene, seams, j, i, search);
        }
    }
    find_round(scene, search);
    std::sort(search.wanted.begin(), search.wanted.end());
    search.wanted.erase(std::unique(search.wanted.begin(), search.wanted.end()), search.wanted.end());
    std::sort(search.vetoed.begin(), search.vetoed.end());
    std::erase_if(search.wanted, [&search](std::uint64_t key) {
        return std::binary_search(search.vetoed.begin(), search.vetoed.end(), key);
    });
    std::sort(search.twins.begin(), search.twins.end());
    contacts.clear();
    for (const std::uint64_t key : search.wanted) {
        const auto corner = static_cast<std::int32_t>(key >> 32), edge = static_cast<std::int32_t>(key & 0xffffffffU);
        if (is_round(model, corner)) {
            contacts.push_back(make_round_contact(scene, search, corner, edge));
            continue;
        }
        const auto twin = std::lower_bound(search.twins.begin(), search.twins.end(), std::pair{key, std::uint64_t{0}});
        const bool is_shared = twin != search.twins.end() && twin->first == key &&
                               std::binary_search(search.wanted.begin(), search.wanted.end(), twin->second);
        contacts.push_back(make_contact(scene, corner, edge, is_shared ? 0.5 : 1.0));
    }
}

}  // namespace riprap::solid::planar_dda

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/contact_scene.hpp"
#include "riprap/solid/planar_dda/round_touch.hpp"
#include "riprap/solid/planar_dda/seams.hpp"

namespace riprap::solid::planar_dda {

namespace {

/// Half of the way of the centre of a disc in this step against a point of another block, as the velocities tell [m].
Vec2 half_way(const Scene& scene, std::int32_t disc, std::int32_t edge, const Vec2& point) {
    const std::int32_t a = scene.model.corner_block[at(disc)], b = scene.model.corner_block[at(edge)];
    const Unknowns of_a = rates_of(scene.state, a), of_b = rates_of(scene.state, b);
    const Vec2 r = is_round(scene.model, edge) ? Vec2{} : point - scene.center(b);
    return 0.5 * scene.dt * (Vec2{of_a[0], of_a[1]} - displacement_at(r, of_b));
}

RoundTouch touch_of(const Scene& scene, std::int32_t disc, std::int32_t edge) {
    return touch_round(scene.model, scene.state, scene.corners, disc, edge);
}

/// Looks at the outline of a block from the centre of a disc.
class Outline {
 public:
    Outline(const Scene& scene, std::int32_t disc, std::int32_t block)
        : scene_(&scene),
          center_(scene.center(scene.model.corner_block[at(disc)])),
          begin_(scene.model.corner_begin[at(block)]),
          end_(scene.model.corner_begin[at(block + 1)]) {}

    /// Calls visit(edge) for each nearest place: on an edge, or at the convex corner where it begins.
    template <class Visit>
    void for_each_nearest(const Visit& visit) const {
        if (is_inside()) {
            if (const std::int32_t edge = nearest_edge(); edge >= 0) {
                visit(edge);
            }
            return;
        }
        for (std::int32_t e = begin_; e < end_; ++e) {
            const double foot = foot_on(e);
            if (foot >= 0 && foot < 1 ? height_over(e) > 0 && sees(place_at(e, foot), e, e)
                                      : foot >= 1 && foot_on(scene_->before(e)) < 0 && scene_->model.is_convex[at(e)] &&
                                            sees(scene_->place(e), e, scene_->before(e))) {
                visit(e);
            }
        }
    }

 private:
    Vec2 line_of(std::int32_t e) const { return scene_->place(e) - scene_->place(scene_->next(e)); }
    Vec2 place_at(std::int32_t e, double foot) const { return scene_->place(scene_->next(e)) + foot * line_of(e); }
    double foot_on(std::int32_t e) const {
        const Vec2 line = line_of(e);
        return dot(line, center_ - scene_->place(scene_->next(e))) / dot(line, line);
    }
    double height_over(std::int32_t e) const {
        const Vec2 line = line_of(e);
        return cross(line, center_ - scene_->place(scene_->next(e))) / norm(line);
    }
    bool is_inside() const {
        bool inside = false;
        for (std::int32_t e = begin_; e < end_; ++e) {
            const Vec2 p = scene_->place(e), q = scene_->place(scene_->next(e));
            if ((p.y > center_.y) != (q.y > center_.y) &&
                center_.x < p.x + (center_.y - p.y) / (q.y - p.y) * (q.x - p.x)) {
                inside = !inside;
            }
        }
        return inside;
    }
    /// The edge through which a disc whose centre has come inside is pushed out.
    std::int32_t nearest_edge() const {
        std::int32_t nearest = -1;
        double highest = -1e300;
        for (std::int32_t e = begin_; e < end_; ++e) {
            const double foot = foot_on(e);
            if (foot >= 0 && foot < 1 && height_over(e) <= 0 && height_over(e) > highest) {
                highest = height_over(e);
                nearest = e;
            }
        }
        return nearest;
    }
    /// Nothing of the outline but the two edges named lies between the centre and a point of it.
    bool sees(const Vec2& point, std::int32_t edge, std::int32_t other) const {
        for (std::int32_t e = begin_; e < end_; ++e) {
            const Vec2 p = scene_->place(e), q = scene_->place(scene_->next(e));
            if (e != edge && e != other && cross(q - p, center_ - p) * cross(q - p, point - p) < 0 &&
                cross(point - center_, p - center_) * cross(point - center_, q - center_) < 0) {
                return false;
            }
        }
        return true;
    }

    const Scene* scene_;
    Vec2 center_;
    std::int32_t begin_, end_;
};

/// A corner of another block continues the face that the disc touches, or lies below it.
bool is_hidden_by(const Scene& scene, std::int32_t disc, std::int32_t corner, std::int32_t face, double overlap) {
    const Model& model = scene.model;
    const double breadth =
        std::min(model.width[at(model.corner_block[at(disc)])], model.width[at(model.corner_block[at(corner)])]);
    const GapAndFoot g = gap_and_foot(scene, corner, face);
    return g.gap <= overlap && beyond_ends(g) <= joint_share * breadth;
}

/// Drops the corners that faces hide, of the contacts of one disc.
void drop_hidden(const Scene& scene, std::vector<std::uint64_t>& of_disc) {
    struct Face {
        std::int32_t edge;
        double overlap;
    };
    std::vector<Face> faces;
    const auto disc_of = [](std::uint64_t key) { return static_cast<std::int32_t>(key >> 32); };
    const auto edge_of = [](std::uint64_t key) { return static_cast<std::int32_t>(key & 0xffffffffU); };
    const auto is_corner = [&](const RoundTouch& touch) { return touch.foot < 0 || touch.foot >= 1; };
    for (const std::uint64_t key : of_disc) {
        const RoundTouch touch = touch_of(scene, disc_of(key), edge_of(key));
        if (!is_round(scene.model, edge_of(key)) && !is_corner(touch)) {
            faces.push_back({edge_of(key), std::max(0.0, -touch.gap)});
        }
    }
    std::erase_if(of_disc, [&](std::uint64_t key) {
        const std::int32_t edge = edge_of(key), block = scene.model.corner_block[at(edge)];
        return !is_round(scene.model, edge) && is_corner(touch_of(scene, disc_of(key), edge)) &&
               std::any_of(faces.begin(), faces.end(), [&](const Face& face) {
                   return scene.model.corner_block[at(face.edge)] != block &&
                          is_hidden_by(scene, disc_of(key), edge, face.edge, face.overlap);
               });
    });
}

/// The contact of the state that the disc has left for this one, -1 where there is none: of those that are not found
/// any more, each goes to the nearest new one with the same normal.
std::int64_t left_for(const Scene& scene, const ContactSearch& search, std::int32_t disc, std::int32_t edge) {
    const State& state = scene.state;
    const auto range_of = [&](const auto& list) {
        return std::pair{std::lower_bound(list.begin(), list.end(), disc) - list.begin(),
                         std::upper_bound(list.begin(), list.end(), disc) - list.begin()};
    };
    const auto [old_begin, old_end] = range_of(state.contact_corner);
    const auto new_begin = std::lower_bound(search.wanted.begin(), search.wanted.end(), key_of(disc, 0));
    const auto new_end = std::lower_bound(search.wanted.begin(), search.wanted.end(), key_of(disc + 1, 0));
    for (auto old = old_begin; old < old_end; ++old) {
        const std::int32_t left = state.contact_edge[at(old)];
        if (std::binary_search(new_begin, new_end, key_of(disc, left))) {
            continue;
        }
        const RoundTouch before = touch_of(scene, disc, left);
        double least = scene.reach;
        std::int32_t nearest = -1;
        for (auto key = new_begin; key < new_end; ++key) {
            const auto candidate = static_cast<std::int32_t>(*key & 0xffffffffU);
            const RoundTouch now = touch_of(scene, disc, candidate);
            if (scene.remembered(disc, candidate) < 0 && norm(before.other - now.other) < least &&
                dot(before.normal, now.normal) > std::cos(scene.settings.angle_tolerance)) {
                least = norm(before.other - now.other);
                nearest = candidate;
            }
        }
        if (nearest == edge) {
            return old;
        }
    }
    return -1;
}

}  // namespace

void find_round(const Scene& scene, ContactSearch& search) {
    std::vector<std::uint64_t> found;
    const Model& model = scene.model;
    const auto look = [&](std::int32_t a, std::int32_t b) {
        const std::int32_t disc = model.corner_begin[at(a)], other = model.corner_begin[at(b)];
        const auto visit = [&](std::int32_t edge) {
            if (touch_of(scene, disc, edge).gap <= scene.reach) {
                found.push_back(key_of(disc, edge));
            }
        };
        if (is_round(model, other)) {
            visit(other);
        } else {
            Outline(scene, disc, b).for_each_nearest(visit);
        }
    };
    for (const auto& [i, j] : search.pairs) {
        if (model.round_radius[at(i)] > 0) {
            look(i, j);
        } else if (model.round_radius[at(j)] > 0) {
            look(j, i);
        }
    }
    std::sort(found.begin(), found.end());
    for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
        while (end < found.size() && (found[end] >> 32) == (found[begin] >> 32)) {
            ++end;
        }
        std::vector<std::uint64_t> of_disc(found.begin() + static_cast<std::ptrdiff_t>(begin),
                                           found.begin() + static_cast<std::ptrdiff_t>(end));
        drop_hidden(scene, of_disc);
        search.wanted.insert(search.wanted.end(), of_disc.begin(), of_disc.end());
    }
}

Contact make_round_contact(const Scene& scene, const ContactSearch& search, std::int32_t disc, std::int32_t edge) {
    const Model& model = scene.model;
    const Vec2 ahead = half_way(scene, disc, edge, touch_of(scene, disc, edge).other);
    const RoundTouch touch = touch_round(model, scene.state, scene.corners, disc, edge, ahead);
    Contact contact;
    contact.is_round = true;
    contact.corner = disc;
    contact.edge = edge;
    contact.a = model.corner_block[at(disc)];
    contact.b = model.corner_block[at(edge)];
    contact.joint = model.joint(contact.a, contact.b);
    contact.place = touch.other;
    const Vec2 n = touch.normal, along{n.y, -n.x};
    const Vec2 of_a = scene.center(contact.a), of_b = scene.center(contact.b);
    contact.gap = {touch.gap, force_at(touch.on_disc - of_a, n), force_at(touch.other - of_b, -n)};
    std::int64_t old = scene.remembered(disc, edge);
    if (old < 0) {
        old = left_for(scene, search, disc, edge);
    }
    if (old >= 0) {
        contact.mode = static_cast<Mode>(scene.state.contact_mode[at(old)]);
        contact.multiplier = scene.state.contact_multiplier[at(old)];
        contact.lock = scene.state.contact_lock[at(old)];
    }
    // both at one point, so that the pair of forces has no moment
    contact.slip = {contact.lock, force_at(touch.other - of_a, along), force_at(touch.other - of_b, -along)};
    return contact;
}

}  // namespace riprap::solid::planar_dda

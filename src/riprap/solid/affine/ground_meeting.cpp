// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/ground_meeting.hpp"

#include <array>
#include <cmath>

#include "riprap/contact/narrowphase/common_plane_contacts.hpp"

namespace riprap::solid::affine {

namespace {

std::int32_t ground_part(std::uint64_t feature) { return static_cast<std::int32_t>(feature & 0xffffffffU); }

/// Distance from the nearest corner within which others count as touching, as for two blocks [m].
double touching(const LocalBlock& block, double gap, double reach) {
    const double widest = 0.1 * block.size;
    return std::max(std::min(2 * std::abs(gap) + 1e-4 * block.size, widest), std::min(reach, widest));
}

}  // namespace

void GroundMeeting::find(const BlockContactHistory& history, std::size_t begin, std::size_t end,
                         std::vector<BlockContact>& found) {
    first_ = found.size();
    found_ = &found;
    add_corners();
    add_points(history, begin, end);
    add_edges();
    if (scene_.needs_areas) {
        share_areas();
    }
    const auto own = std::span(found).subspan(first_);
    std::sort(own.begin(), own.end(),
              [](const BlockContact& p, const BlockContact& q) { return p.feature < q.feature; });
    take_over(history, begin, end, own);
}

GroundMeeting::Floor GroundMeeting::floor_of(std::int32_t triangle) const {
    const Vec3& n = features_.normal(triangle);
    Floor floor{n, dot(n, mesh_.corner(triangle, 0)), 0, false};
    const double lowest = block_.lowest_along(n) - floor.offset;
    // A block whose middle is below the plane is on the other side of it.
    floor.is_met = lowest <= reach_ && floor.gap(block_.centre) > 0;
    floor.highest = std::min(reach_, lowest + touching(block_, lowest, reach_));
    return floor;
}

Box GroundMeeting::box_of(std::int32_t triangle) const {
    Box box{mesh_.corner(triangle, 0), mesh_.corner(triangle, 0)};
    box.add(mesh_.corner(triangle, 1));
    box.add(mesh_.corner(triangle, 2));
    return box;
}

void GroundMeeting::add(GroundKind kind, std::size_t of_block, std::int32_t of_ground, const Vec3& normal,
                        const Vec3& on_ground, const Vec3& on_block) {
    const auto world = [this](const Vec3& x) { return scene_.position + scene_.turn * x; };
    const Vec3 n = scene_.turn * normal, g = world(on_ground), b = world(on_block);
    const bool first = scene_.is_ground_first;
    BlockContact contact{scene_.pair.a, scene_.pair.b, ground_feature(kind, of_block, of_ground), 0, first ? n : -n,
                         first ? g : b, first ? b : g, dot(normal, on_block - on_ground),         0, -1};
    found_->push_back(contact);
}

/// Gives corners the area that they would have on the plane across their mean normal.
void GroundMeeting::share_areas() {
    Vec3 normal{};
    const auto own = std::span(*found_).subspan(first_);
    for (const BlockContact& c : own) {
        normal += kind_of(c.feature) == GroundKind::corner ? c.normal : Vec3{};
    }
    if (!(norm_squared(normal) > 0)) {
        return;
    }
    normal = normalized((scene_.is_ground_first ? 1.0 : -1.0) * transpose_times(scene_.turn, normal));
    const double lowest = block_.lowest_along(normal);
    const contact::PlacedHull plane{nullptr, {}, {&normal, 1}, block_.centre, lowest};
    contact::PlaneContacts points;
    find_plane_contacts(plane, block_.hull(), {normal, 0, {}, false}, touching(block_, 0, reach_), points);
    for (BlockContact& c : own) {
        const Vec3& x = block_.vertices[at(static_cast<std::int32_t>(c.feature >> 32 & 0xfffffffU))];
        for (int k = 0; kind_of(c.feature) == GroundKind::corner && k < points.count; ++k) {
            c.area = points.contacts[at(k)].on_b == x ? points.contacts[at(k)].area : c.area;
        }
    }
}

/// Tells whether the surface goes on from one triangle, or edge, to the other: they share a point.
bool GroundMeeting::are_neighbours(GroundKind kind, std::int32_t x, std::int32_t y) const {
    const auto points = [&](std::int32_t i) {
        const auto ends = [&](std::int32_t e) {
            return std::array{features_.edge(e).from, features_.edge(e).to, features_.edge(e).to};
        };
        return kind == GroundKind::corner ? mesh_.corners[at(i)] : ends(i);
    };
    const auto a = points(x), b = points(y);
    return std::any_of(a.begin(), a.end(), [&](std::int32_t p) { return std::find(b.begin(), b.end(), p) != b.end(); });
}

/// Finds the rows of the history. A contact point that has come to the next triangle or edge keeps its spring.
void GroundMeeting::take_over(const BlockContactHistory& history, std::size_t begin, std::size_t end,
                              std::span<BlockContact> own) const {
    std::vector<std::uint8_t> is_taken(end - begin, 0);
    for (BlockContact& c : own) {
        for (std::size_t row = begin; row < end; ++row) {
            if (history.feature[row] == c.feature) {
                c.old = static_cast<std::int64_t>(row);
                is_taken[row - begin] = 1;
            }
        }
    }
    for (BlockContact& c : own) {
        const GroundKind kind = kind_of(c.feature);
        for (std::size_t row = begin; row < end && c.old < 0 && kind != GroundKind::point; ++row) {
            const std::uint64_t before = history.feature[row];
            if (is_taken[row - begin] == 0 && before >> 32 == c.feature >> 32 &&
                are_neighbours(kind, ground_part(before), ground_part(c.feature))) {
                c.old = static_cast<std::int64_t>(row);
                is_taken[row - begin] = 1;
            }
        }
    }
}

}  // namespace riprap::solid::affine

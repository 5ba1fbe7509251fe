// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/contacts.hpp"

// What one search for contacts looks at.

namespace riprap::solid::planar_dda {

inline std::uint64_t key_of(std::int32_t corner, std::int32_t edge) {
    return (static_cast<std::uint64_t>(corner) << 32) | static_cast<std::uint32_t>(edge);
}

/// Input of one search.
struct Scene {
    const Model& model;
    const State& state;
    const Settings& settings;
    const std::vector<Vec2>& corners;
    double reach;
    double dt;  ///< of the step, 0 = of none [s]

    Vec2 place(std::int32_t corner) const { return corners[at(corner)]; }
    std::int32_t next(std::int32_t corner) const { return model.corner_next[at(corner)]; }
    std::int32_t before(std::int32_t corner) const { return model.corner_before[at(corner)]; }
    Vec2 center(std::int32_t block) const { return {state.x[at(block)], state.y[at(block)]}; }
    CornerAndEdge pair(std::int32_t corner, std::int32_t edge) const {
        return {place(corner), place(edge), place(next(edge)), center(model.corner_block[at(corner)]),
                center(model.corner_block[at(edge)])};
    }
    /// Index into the contacts of the state, or -1.
    std::int64_t remembered(std::int32_t corner, std::int32_t edge) const {
        const auto count = static_cast<std::int64_t>(state.contact_corner.size());
        std::int64_t low = 0, high = count;
        const std::uint64_t wanted = key_of(corner, edge);
        while (low < high) {
            const std::int64_t middle = (low + high) / 2;
            if (key_of(state.contact_corner[at(middle)], state.contact_edge[at(middle)]) < wanted) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        const bool is_there =
            low < count && state.contact_corner[at(low)] == corner && state.contact_edge[at(low)] == edge;
        return is_there ? low : -1;
    }
    /// An open contact is not looked for deeper than this: behind it lies the other side of a block [m].
    double depth(std::int32_t corner, std::int32_t edge) const {
        const double narrow =
            std::min(model.width[at(model.corner_block[at(corner)])], model.width[at(model.corner_block[at(edge)])]);
        return std::min(reach, 0.5 * narrow);
    }
    bool is_closed(std::int32_t corner, std::int32_t edge) const {
        const std::int64_t old = remembered(corner, edge);
        return old >= 0 && state.contact_mode[at(old)] != static_cast<std::uint8_t>(Mode::open);
    }
};

struct GapAndFoot {
    double gap, foot, length;
};
inline GapAndFoot gap_and_foot(const Scene& scene, std::int32_t corner, std::int32_t edge) {
    const Vec2 end = scene.place(scene.next(edge)), line = scene.place(edge) - end, to = scene.place(corner) - end;
    const double length = norm(line);
    return {cross(line, to) / length, dot(line, to) / (length * length), length};
}

/// Distance of the foot beyond the ends of the edge [m].
inline double beyond_ends(const GapAndFoot& g) { return g.length * std::max({0.0, -g.foot, g.foot - 1}); }

/// A foot may lie outside of its edge by this share of its length.
constexpr double foot_slack = 1e-3;

inline bool is_foot_on_edge(const GapAndFoot& g) { return g.foot >= -foot_slack && g.foot <= 1 + foot_slack; }

/// A corner and an edge.
using Key = std::pair<std::int32_t, std::int32_t>;

}  // namespace riprap::solid::planar_dda

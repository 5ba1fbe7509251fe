// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/narrow_gaps.hpp"
#include "riprap/solid/dem_settings.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "riprap/contact/broadphase/multilevel_grid.hpp"
#include "riprap/contact/placed_parts.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::scene {

using contact::Frame;
using geometry::ConvexView;

namespace {

/// Spacings between faces: below, water in the gap is that of a joint; above, particles find room.
constexpr double closed = 0.25, wide = 2, slack = 1e-6;

/// A part in the world.
struct Placed {
    ConvexView shape;
    const Frame& frame;
};

/// The widest distance between a face of `a` and all of `b` in front of it, and that face's normal in the world.
struct Separation {
    double distance;
    Vec3 normal;
};

Separation before_faces(const Placed& a, const Placed& b) {
    Separation widest{-std::numeric_limits<double>::infinity(), {}};
    for (int j = 0; j < a.shape.face_count && b.shape.vertex_count > 0; ++j) {
        if (a.shape.is_internal[j] != 0) {
            continue;
        }
        const Vec3 normal = a.frame.axes * a.shape.normal(j);
        double nearest = std::numeric_limits<double>::infinity();
        for (int v = 0; v < b.shape.vertex_count; ++v) {
            const Vec3 x = b.frame.origin + b.frame.axes * b.shape.vertex(v);
            nearest = std::min(nearest, dot(normal, x - a.frame.origin) - a.shape.offset[j]);
        }
        if (nearest > widest.distance) {
            widest = {nearest, normal};
        }
    }
    return widest;
}

bool has_face_against(const Placed& part, const Vec3& normal) {
    constexpr double looking = -0.9;  // cosine, as for water on two sides of a thin body
    for (int j = 0; j < part.shape.face_count; ++j) {
        if (part.shape.is_internal[j] == 0 && dot(part.frame.axes * part.shape.normal(j), normal) < looking) {
            return true;
        }
    }
    return false;
}

/// Width of the gap between opposite faces; nothing where there is none.
std::optional<double> gap_between(const Placed& a, const Placed& b) {
    const Separation of_a = before_faces(a, b), of_b = before_faces(b, a);
    const bool is_a = of_a.distance >= of_b.distance;
    const Separation& widest = is_a ? of_a : of_b;
    return has_face_against(is_a ? b : a, widest.normal) ? std::optional(widest.distance) : std::nullopt;
}

}  // namespace

NarrowGaps find_narrow_gaps(const sim::Model& model, const sim::State& state) {
    contact::PlacedParts placed;
    contact::place_parts(model.shapes, model.bodies, state.bodies, placed);
    std::vector<contact::PartPair> pairs;
    const double spacing = model.particles()->settings().spacing;
    contact::MultilevelGrid().find_pairs(placed.bounds(), placed.giants, wide * spacing,
                                         solid::DemSettings{}.grid_factor, pairs);
    const auto part = [&](std::int32_t p) {
        return Placed{model.shapes.view(model.bodies.parts[at(p)].shape), placed.frames[at(p)]};
    };
    const auto is_wet = [&](std::int32_t p) { return model.particles()->is_dry[at(placed.body[at(p)])] == 0; };
    std::vector<double> width(pairs.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(pairs.size()), 64, [&](std::int64_t i) {
        const contact::PartPair pair = pairs[at(i)];
        const bool counts = is_wet(pair.a) && is_wet(pair.b);
        width[at(i)] = counts ? gap_between(part(pair.a), part(pair.b)).value_or(0) / spacing : 0;
    });
    NarrowGaps gaps;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (width[i] < closed + slack || width[i] > wide - slack) {
            continue;
        }
        if (gaps.pairs == 0) {
            gaps = {0, width[i], width[i], BodyId{placed.body[at(pairs[i].a)]}, BodyId{placed.body[at(pairs[i].b)]}};
        }
        ++gaps.pairs;
        gaps.narrowest = std::min(gaps.narrowest, width[i]);
        gaps.widest = std::max(gaps.widest, width[i]);
    }
    return gaps;
}

}  // namespace riprap::scene

// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/narrow_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "riprap/contact/broadphase/multilevel_grid.hpp"
#include "riprap/contact/placed_parts.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/sim/column_group.hpp"
#include "riprap/solid/dem_settings.hpp"

namespace riprap::scene {

using contact::Frame;
using geometry::ConvexView;

namespace {

/// Spacings between faces: below, water in the gap is that of a joint; above, particles find room.
constexpr double closed = 0.25, wide = 2, slack = 1e-6;
constexpr double none = std::numeric_limits<double>::infinity();

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

/// Pairs of parts that are near each other, and the widths of their gaps [spacings]; infinite where faces are not
/// opposite or a body is dry.
struct Gaps {
    contact::PlacedParts placed;
    std::vector<contact::PartPair> pairs;
    std::vector<double> width;
};

/// @param meets  per body: pairs of two that do not are left out; empty: as the model says
Gaps find_gaps(const sim::Model& model, const sim::State& state, std::span<const std::uint8_t> meets) {
    Gaps gaps;
    contact::PlacedParts& placed = gaps.placed;
    contact::place_parts(model.shapes, model.bodies, state.bodies, placed);
    std::vector<contact::PartPair>& pairs = gaps.pairs;
    const double spacing = model.particles()->settings().spacing;
    contact::PartBounds bounds = placed.bounds();
    bounds.is_mobile = meets.empty() ? bounds.is_mobile : meets;
    bounds.scene = meets.empty() ? bounds.scene : 0;
    contact::MultilevelGrid().find_pairs(bounds, placed.giants, wide * spacing, solid::DemSettings{}.grid_factor,
                                         pairs);
    const auto part = [&](std::int32_t p) {
        return Placed{model.shapes.view(model.bodies.parts[at(p)].shape), placed.frames[at(p)]};
    };
    const auto is_wet = [&](std::int32_t p) { return model.particles()->is_dry[at(placed.body[at(p)])] == 0; };
    std::vector<double>& width = gaps.width;
    width.resize(pairs.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(pairs.size()), 64, [&](std::int64_t i) {
        const contact::PartPair pair = pairs[at(i)];
        const bool counts = is_wet(pair.a) && is_wet(pair.b);
        width[at(i)] = counts ? gap_between(part(pair.a), part(pair.b)).value_or(none) / spacing : none;
    });
    return gaps;
}

/// True for a quantity of a body that water in its joints belongs to.
bool is_load_of_water(const sim::QuantityInfo& info) {
    return info.name == "fluid_force" || info.name == "fluid_pressure_force" || info.name == "fluid_torque";
}

/// True for a body that no force moves, now or later.
bool is_held(const body::BodySet& bodies, std::int32_t body) {
    return bodies.drive[at(body)] != body::Drive::free &&
           bodies.release_time[at(body)] == std::numeric_limits<double>::infinity();
}

/// Bodies whose loads by water are recorded or judged, and that no force moves; one value per body.
std::vector<std::uint8_t> asked_and_held(const sim::Model& model) {
    std::vector<std::uint8_t> is_asked(at(model.bodies.size()), 0);
    const auto ask = [&](BodyId body) { is_asked[at(body.value)] = is_held(model.bodies, body.value) ? 1 : 0; };
    for (const sim::Probe& probe : model.output.probes) {
        const sim::QuantityInfo* info = sim::find_quantity(probe.quantity, probe.body.is_valid());
        if (probe.body.is_valid() && info != nullptr && is_load_of_water(*info)) {
            ask(probe.body);
        }
    }
    for (const sim::Expect& expect : model.expects) {
        const auto found = sim::find_columns(model, expect.quantity);
        for (const sim::Column& column : found ? found->columns : std::vector<sim::Column>{}) {
            if (column.body.is_valid() && column.quantity != nullptr && is_load_of_water(*column.quantity)) {
                ask(column.body);
            }
        }
    }
    return is_asked;
}

}  // namespace

std::vector<HeldJoint> find_held_joints(const sim::Model& model, const sim::State& state) {
    std::vector<HeldJoint> joints;
    if (model.particles() == nullptr) {
        return joints;
    }
    const std::vector<std::uint8_t> is_asked = asked_and_held(model);
    if (std::find(is_asked.begin(), is_asked.end(), 1) == is_asked.end()) {
        return joints;
    }
    const Gaps found = find_gaps(model, state, is_asked);
    for (std::size_t i = 0; i < found.pairs.size(); ++i) {
        const std::int32_t a = found.placed.body[at(found.pairs[i].a)], b = found.placed.body[at(found.pairs[i].b)];
        const bool is_joint = std::abs(found.width[i]) <= closed + slack;
        for (const auto& [own, other] : {std::pair{a, b}, std::pair{b, a}}) {
            const auto is_known = [own = own](const HeldJoint& joint) { return joint.body.value == own; };
            if (is_joint && is_asked[at(own)] != 0 && is_held(model.bodies, other) &&
                std::ranges::none_of(joints, is_known)) {
                joints.push_back({BodyId{own}, BodyId{other}});
            }
        }
    }
    return joints;
}

NarrowGaps find_narrow_gaps(const sim::Model& model, const sim::State& state) {
    const auto [placed, pairs, width] = find_gaps(model, state, {});
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

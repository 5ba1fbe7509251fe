// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/initial_overlaps.hpp"
#include "riprap/solid/dem_settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "riprap/contact/broadphase/multilevel_grid.hpp"
#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/contact/placed_parts.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::scene {

using contact::Frame;
using geometry::ConvexView;

namespace {

/// Returns the depth of a point inside a part, below the nearest face that carries a field; negative outside [m].
double depth_of_point(const ConvexView& shape, const Frame& frame, const Vec3& point) {
    const Vec3 local = transpose_times(frame.axes, point - frame.origin);
    double inside = std::numeric_limits<double>::infinity(), below = inside;
    for (int j = 0; j < shape.face_count; ++j) {
        const double h = shape.offset[j] - dot(shape.normal(j), local);
        inside = std::min(inside, h);
        below = shape.is_internal[j] != 0 ? below : std::min(below, h);
    }
    return inside < 0 ? inside : below;
}

/// Returns the least depth of a point below the faces of a part that carry a field; negative above one [m].
double depth_below_faces(const ConvexView& shape, const Frame& frame, const Vec3& point) {
    const Vec3 local = transpose_times(frame.axes, point - frame.origin);
    double below = std::numeric_limits<double>::infinity();
    for (int j = 0; j < shape.face_count; ++j) {
        below = shape.is_internal[j] != 0 ? below : std::min(below, shape.offset[j] - dot(shape.normal(j), local));
    }
    return below;
}

/// Deepest vertex of a part below the plane of a half-space [m].
double depth_below_plane(const ConvexView& shape, const Frame& frame, const ConvexView& plane,
                         const Frame& plane_frame) {
    double depth = 0;
    for (int v = 0; v < shape.vertex_count; ++v) {
        depth = std::max(depth, depth_of_point(plane, plane_frame, frame.origin + frame.axes * shape.vertex(v)));
    }
    return depth;
}

/// Fills depth, point and normal of a pair.
void measure(const ConvexView& a, const Frame& frame_a, const ConvexView& b, const Frame& frame_b,
             PartOverlap& overlap) {
    contact::SeparatingCache cache;
    contact::NormalContact found{};
    contact::DistancePotentialOptions options;
    options.with_energy = false;
    const bool have_faces = a.face_count > 0 && b.face_count > 0;  // ground has none
    if (have_faces && contact::find_contact(a, frame_a, 1, b, frame_b, 1, options, cache, found)) {
        const double force = norm(found.force);
        overlap.depth = found.depth;
        overlap.point = found.point;
        overlap.normal = force > 0 ? -found.force / force : Vec3{};
    }
    if (a.vertex_count == 0 || b.vertex_count == 0) {
        overlap.depth =
            a.vertex_count == 0 ? depth_below_plane(b, frame_b, a, frame_a) : depth_below_plane(a, frame_a, b, frame_b);
        return;
    }
    // The origin of a shape is its centre of mass.
    overlap.depth = std::max(
        {overlap.depth, depth_of_point(b, frame_b, frame_a.origin), depth_of_point(a, frame_a, frame_b.origin)});
}

/// Radius about the centre of mass that holds all of a shape [m].
double radius_of(const ConvexView& shape, bool is_planar) {
    double reach = 0;
    for (int v = 0; v < shape.vertex_count; ++v) {
        const Vec3 x = shape.vertex(v);
        reach = std::max(reach, is_planar ? std::hypot(x.x, x.y) : norm(x));
    }
    return reach;
}

/// Radius about the centre of mass that holds all of a shape, in the plane where its ends carry no field; infinity
/// where other faces carry none either: below those a point may be as deep as it likes [m].
double reach_of(const ConvexView& shape, bool is_planar) {
    for (int j = 0; j < shape.face_count; ++j) {
        if (shape.is_internal[j] != 0 && !(is_planar && std::abs(shape.normal_z[j]) > 0.5)) {
            return std::numeric_limits<double>::infinity();
        }
    }
    return shape.vertex_count > 0 ? radius_of(shape, is_planar) : std::numeric_limits<double>::infinity();
}

/// A bound of the depth of an overlap that costs little: no point of A, within R_A of its centre, lies more than
/// R_A + h below a face of B that the centre lies h below, and none lies more than R_A + R_B - d below one, d between
/// the centres.
class DepthBound {
 public:
    explicit DepthBound(const sim::Model& model) : is_planar_(model.bodies.is_planar) {
        for (std::int32_t shape = 0; shape < model.shapes.size(); ++shape) {
            reach_.push_back(reach_of(model.shapes.view(ShapeId{shape}), is_planar_));
        }
    }
    /// [m]; `a` and `b` are placed shapes
    double operator()(ShapeId a, const ConvexView& shape_a, const Frame& frame_a, ShapeId b, const ConvexView& shape_b,
                      const Frame& frame_b) const {
        Vec3 between = frame_a.origin - frame_b.origin;
        between.z = is_planar_ ? 0 : between.z;
        const double reach_a = reach_[at(a.value)], reach_b = reach_[at(b.value)];
        const double balls = reach_a + reach_b - norm(between);
        return std::min(balls, shape_b.face_count < shape_a.face_count
                                   ? reach_a + depth_below_faces(shape_b, frame_b, frame_a.origin)
                                   : reach_b + depth_below_faces(shape_a, frame_a, frame_b.origin));
    }

 private:
    bool is_planar_;
    std::vector<double> reach_;
};

}  // namespace

std::vector<PartOverlap> find_part_overlaps(const sim::Model& model, const sim::State& state, double max_share) {
    contact::PlacedParts placed;
    contact::place_parts(model.shapes, model.bodies, state.bodies, placed);
    const auto view = [&model](std::int64_t part) { return model.shapes.view(model.bodies.parts[at(part)].shape); };
    // The balls around prisms one metre thick are larger than many a block: in the plane circles do.
    for (std::size_t p = 0; p < placed.radii.size() && model.bodies.is_planar; ++p) {
        const ConvexView shape = view(static_cast<std::int64_t>(p));
        placed.radii[p] = shape.vertex_count > 0 ? radius_of(shape, true) : placed.radii[p];
    }
    std::vector<contact::PartPair> pairs;
    contact::MultilevelGrid().find_pairs(placed.bounds(), placed.giants, 0, solid::DemSettings{}.grid_factor, pairs);

    const DepthBound bound(model);
    std::vector<PartOverlap> of_pair(pairs.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(pairs.size()), 64, [&](std::int64_t i) {
        const contact::PartPair pair = pairs[at(i)];
        const ConvexView a = view(pair.a), b = view(pair.b);
        const double thinner = std::min(a.inscribed_radius, b.inscribed_radius);
        // Balls that touch each other or a face are told apart without a look at all their faces.
        if (bound(model.bodies.parts[at(pair.a)].shape, a, placed.frames[at(pair.a)],
                  model.bodies.parts[at(pair.b)].shape, b, placed.frames[at(pair.b)]) < 0.999 * max_share * thinner) {
            of_pair[at(i)] = {pair, 0, 0};
            return;
        }
        of_pair[at(i)] = {pair, 0, 0};
        measure(a, placed.frames[at(pair.a)], b, placed.frames[at(pair.b)], of_pair[at(i)]);
        of_pair[at(i)].share = of_pair[at(i)].depth / thinner;
    });
    std::erase_if(of_pair, [max_share](const PartOverlap& overlap) { return !(overlap.share > max_share); });
    std::sort(of_pair.begin(), of_pair.end(),
              [](const PartOverlap& x, const PartOverlap& y) { return x.parts < y.parts; });
    return of_pair;
}

std::vector<InitialOverlap> find_initial_overlaps(const sim::Model& model, const sim::State& state, double max_share) {
    std::vector<InitialOverlap> overlaps;
    for (const PartOverlap& of_parts : find_part_overlaps(model, state, max_share)) {
        const BodyId a = model.bodies.parts[at(of_parts.parts.a)].body,
                     b = model.bodies.parts[at(of_parts.parts.b)].body;
        overlaps.push_back({a.value < b.value ? a : b, a.value < b.value ? b : a, of_parts.depth, of_parts.share});
    }
    std::stable_sort(overlaps.begin(), overlaps.end(), [](const InitialOverlap& x, const InitialOverlap& y) {
        return std::tuple(x.a.value, x.b.value, y.share) < std::tuple(y.a.value, y.b.value, x.share);
    });
    const auto is_same_pair = [](const InitialOverlap& x, const InitialOverlap& y) {
        return x.a.value == y.a.value && x.b.value == y.b.value;
    };
    overlaps.erase(std::unique(overlaps.begin(), overlaps.end(), is_same_pair), overlaps.end());
    return overlaps;
}

}  // namespace riprap::scene

// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/sample_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <type_traits>
#include <utility>

#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/samples/ground_samples.hpp"
#include "riprap/coupling/samples/seams.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/particle/sweep/lanes.hpp"
#include "riprap/geometry/polyhedra/chebyshev.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"
#include "riprap/geometry/polyhedra/face_layers.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {

using geometry::ConvexView;
using geometry::Plane;
using geometry::Polyhedron;

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

constexpr double same_count = 1e-6;  ///< of a spacing: a length that is a whole number of them but for round-off
constexpr double same_plane = 1e-9;  ///< of the domain: a face on a plane that cuts is the cut
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The box that fixed bodies are sampled in: the domain, grown by at least the reach and a spacing where it does not
/// repeat, to the next cells of the lattice that water starts on. Walls on that lattice then continue it.
struct Box {
    Vec3 low, high;
};

Box grown_domain(const SampleSettings& settings) {
    const double dp = settings.spacing, layers = std::ceil(settings.reach / dp - same_count) + 1;
    Box box{settings.domain.low, settings.domain.high};
    for (int axis = 0; axis < 3; ++axis) {
        if (settings.domain.is_periodic[at(axis)]) {
            continue;  // the images of what is inside stand outside
        }
        const bool is_flat = axis == 2 && settings.domain.dimension == 2;
        const double corner = settings.lattice_corner[axis];
        const double first = std::floor((box.low[axis] - corner) / dp + same_count) - layers;
        const double last = std::ceil((box.high[axis] - corner) / dp - same_count) + layers;
        box.low[axis] = is_flat ? -0.5 * dp : corner + first * dp;
        box.high[axis] = is_flat ? 0.5 * dp : corner + last * dp;
    }
    return box;
}

/// The planes that bound what is sampled of a body, in its frame.
std::vector<Plane> cutting_planes(const Box& box, const Pose& pose, bool is_still_body, bool is_planar) {
    std::vector<Plane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(is_still_body || (is_planar && axis == 2))) {
            continue;
        }
        for (const double side : {-1.0, 1.0}) {
            Vec3 normal{};
            normal[axis] = side;
            const double offset = side * (side < 0 ? box.low[axis] : box.high[axis]);
            planes.push_back({rotate_back(pose.orientation, normal), offset - dot(normal, pose.position)});
        }
    }
    return planes;
}

Polyhedron box_in_body(const Box& box, const Pose& pose) {
    Polyhedron result = geometry::box(box.high - box.low);
    for (Vec3& x : result.vertices) {
        x = to_body(pose, x + 0.5 * (box.low + box.high));
    }
    return result;
}

/// A convex part in the frame of its body, cut to what is to be sampled.
struct CutPart {
    Polyhedron shape;
    std::vector<geometry::LayerFace> faces;
    bool has_glue{false};  ///< some faces lie against other parts
};

bool is_cut(const Plane& face, std::span<const Plane> planes, double scale) {
    return std::any_of(planes.begin(), planes.end(), [&](const Plane& cut) {
        return dot(cut.normal, face.normal) > 1 - same_plane && std::abs(cut.offset - face.offset) < same_plane * scale;
    });
}

/// Makes a prism of a planar scene, one unit thick, as thick as the slab that it is cut to: its ends would carry layers
/// of their own where the slab is thicker.
void stretch_to_slab(Polyhedron& prism, const Box& box) {
    if (const double thickness = box.high.z - box.low.z; thickness > 1) {
        for (Vec3& x : prism.vertices) {
            x.z *= 2 * thickness;
        }
    }
}

CutPart cut_part(const geometry::ShapeSet& shapes, const body::Part& part, const Box& box, const Pose& pose,
                 std::span<const Plane> planes, bool is_planar) {
    CutPart result;
    if (shapes.is_half_space(part.shape)) {
        const ConvexView view = shapes.view(part.shape);
        const Vec3 normal = rotate(part.local.orientation, view.normal(0));
        result.shape =
            geometry::clip_convex(box_in_body(box, pose), {normal, view.offset[0] + dot(normal, part.local.position)});
    } else {
        result.shape = geometry::moved(shapes.polyhedron(part.shape), part.local);
        if (is_planar) {
            stretch_to_slab(result.shape, box);
        }
        for (const Plane& plane : planes) {
            if (!result.shape.faces.empty()) {
                result.shape = geometry::clip_convex(result.shape, plane);
            }
        }
    }
    const double scale = norm(box.high - box.low);
    for (std::size_t f = 0; f < result.shape.faces.size(); ++f) {
        const Plane plane = geometry::face_plane(result.shape.vertices, result.shape.faces[f]);
        result.faces.push_back({plane, is_cut(plane, planes, scale)});
        const bool is_internal = !result.shape.is_internal.empty() && result.shape.is_internal[f] != 0;
        result.has_glue = result.has_glue || (is_internal && !result.faces.back().is_cut);
    }
    return result;
}

/// Nearest point of the faces of a body that carry a field, in its frame.
geometry::SurfacePoint nearest_on_body(const geometry::ShapeSet& shapes, const body::BodySet& bodies, BodyId body,
                                       const Vec3& x) {
    geometry::SurfacePoint best{};
    best.distance = infinity;
    for (std::int32_t p = bodies.part_begin[at(body.value)]; p < bodies.part_begin[at(body.value) + 1]; ++p) {
        const body::Part& part = bodies.parts[at(p)];
        const ConvexView view = shapes.view(part.shape);
        const Vec3 local = to_body(part.local, x);
        for (std::int32_t j = 0; j < view.face_count; ++j) {
            if (view.is_internal[j] != 0) {
                continue;
            }
            const double distance = norm(local - geometry::nearest_on_face(view, j, local));
            if (distance < best.distance) {
                best.distance = distance;
                best.normal = rotate(part.local.orientation, view.normal(j));
            }
        }
    }
    return best;
}

double layer_estimate(const CutPart& part, const SampleSettings& settings) {
    double area = 0;
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
        if (!part.faces[f].is_cut) {
            area += norm(geometry::vector_area(part.shape.vertices, part.shape.faces[f]));
        }
    }
    const double layers = settings.reach / settings.spacing + 1;
    return area / (settings.spacing * settings.spacing) * layers;
}

std::vector<geometry::LayerPoint> sample_part(const CutPart& part, const SampleSettings& settings, bool is_planar) {
    std::vector<Plane> planes;
    std::vector<std::uint8_t> flags;
    planes.reserve(part.faces.size());
    flags.reserve(part.faces.size());
    for (const geometry::LayerFace& face : part.faces) {
        planes.push_back(face.plane);
        flags.push_back(face.is_cut ? 1 : 0);
    }
    if (std::find(flags.begin(), flags.end(), 0) == flags.end()) {
        return {};  // nothing of its surface is within the domain
    }
    Vec3 middle{};
    for (const Vec3& x : part.shape.vertices) {
        middle += x / static_cast<double>(part.shape.vertices.size());
    }
    const double extent = 2 * geometry::length_scale(part.shape.vertices);
    geometry::InscribedSphere sphere = geometry::largest_inscribed_sphere(planes, flags, middle, extent);
    sphere.centre.z = is_planar ? 0 : sphere.centre.z;
    return geometry::layers_under_faces(part.faces, sphere.radius, sphere.centre, extent,
                                        {settings.spacing, settings.reach, is_planar});
}

void append(const geometry::ShapeSet& shapes, const body::BodySet& bodies, BodyId body, const CutPart& cut,
            const SampleSettings& settings, SampleSet& samples) {
    for (const geometry::LayerPoint& point : sample_part(cut, settings, bodies.is_planar)) {
        Vec3 normal = cut.faces[at(point.face)].plane.normal;
        double depth = point.depth;
        if (cut.has_glue) {
            const geometry::SurfacePoint nearest = nearest_on_body(shapes, bodies, body, point.position);
            if (nearest.distance >= settings.reach) {
                continue;
            }
            normal = nearest.normal;
            depth = nearest.distance;
        }
        samples.body.push_back(body);
        samples.anchor.push_back(point.position);
        samples.normal.push_back(normal);
        samples.depth.push_back(depth);
        samples.volume.push_back(bodies.is_planar ? point.volume / settings.spacing : point.volume);
        samples.is_slippery.push_back(settings.is_slippery.empty() ? 0 : settings.is_slippery[at(body.value)]);
        samples.is_in_vertex.push_back(0);  // share_seams finds them
    }
}

[[noreturn]] void refuse(const std::string& body, double estimate, std::int64_t limit) {
    Diagnostic problem;
    problem.message = fmt::format("the surfaces up to '{}' need about {:.3g} boundary particles", body, estimate);
    problem.allowed = fmt::format(
        "at most {}: use a larger spacing, a smaller domain, or wet = false for bodies that meet no water", limit);
    throw CaseError(std::move(problem));
}

/// Puts the samples of every body in order of place: sums over neighbours are fast where neighbours lie together. They
/// take four that follow each other at once, from the first sample of all on. Fours of the curve of a body are such
/// fours: where it begins between two, the end of its curve comes first.
void sort_by_place(const SampleSettings& settings, SampleSet& samples) {
    std::vector<std::uint32_t> order;
    for (std::size_t begin = 0, end = 0; begin < samples.body.size(); begin = end) {
        while (end < samples.body.size() && samples.body[end] == samples.body[begin]) {
            ++end;
        }
        std::vector<Vec3> points;
        points.reserve(end - begin);
        for (std::size_t i = begin; i < end; ++i) {
            points.push_back(samples.anchor[i]);
        }
        std::vector<std::uint32_t> curve = fluid::order_by_place(points, settings.domain, settings.spacing);
        constexpr std::size_t four = fluid::cluster_size;
        const std::size_t first = std::min(curve.size(), (four - begin % four) % four);
        std::rotate(curve.begin(), curve.end() - static_cast<std::ptrdiff_t>(first), curve.end());
        for (const std::uint32_t i : curve) {
            order.push_back(static_cast<std::uint32_t>(begin) + i);
        }
    }
    samples.for_each_column([&order](auto& column) {
        std::remove_reference_t<decltype(column)> sorted;
        sorted.reserve(order.size());
        for (const std::uint32_t i : order) {
            sorted.push_back(column[i]);
        }
        column = std::move(sorted);
    });
}

}  // namespace

SampleSet sample_shapes(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
                        const SampleSettings& settings) {
    const Box box = grown_domain(settings);
    const std::vector<body::Ground> grounds = body::find_grounds(bodies, shapes);
    SampleSet samples;
    double estimate = 0;
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (!settings.is_dry.empty() && settings.is_dry[at(b)] != 0) {
            continue;
        }
        const BodyId body{b};
        const Pose pose{initial.position[at(b)], initial.orientation[at(b)]};
        const auto ground = std::ranges::find(grounds, body, &body::Ground::body);
        if (ground != grounds.end()) {
            sample_ground(*ground, pose, {box.low, box.high}, bodies.is_planar, settings, samples);
            continue;
        }
        for (std::int32_t p = bodies.part_begin[at(b)]; p < bodies.part_begin[at(b) + 1]; ++p) {
            const body::Part& part = bodies.parts[at(p)];
            const bool is_bounded = is_still(bodies, body) || shapes.is_half_space(part.shape);
            const CutPart cut = cut_part(shapes, part, box, pose,
                                         cutting_planes(box, pose, is_bounded, bodies.is_planar), bodies.is_planar);
            if (cut.shape.faces.empty()) {
                continue;
            }
            estimate += layer_estimate(cut, settings);
            if (estimate > static_cast<double>(settings.limit)) {
                refuse(bodies.name(body), estimate, settings.limit);
            }
            append(shapes, bodies, body, cut, settings, samples);
        }
    }
    share_seams(shapes, bodies, initial, settings, grounds, samples);
    sort_by_place(settings, samples);
    samples.pack();
    return samples;
}

}  // namespace riprap::coupling

// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/convex_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "riprap/core/index.hpp"

namespace riprap::solid::sphere_dem {

namespace {

constexpr double most_of_edge = 2000;  ///< samples: the edges of a floor a kilometre wide are no place of stones [-]

/// A piece of a line, x = origin + t along, begin <= t <= end.
struct Segment {
    Vec3 origin, along;  ///< [m], unit vector [-]
    double begin{-std::numeric_limits<double>::infinity()}, end{std::numeric_limits<double>::infinity()};  ///< [m]

    bool is_empty() const { return !(begin <= end); }
    Vec3 at(double t) const { return origin + t * along; }
};

/// Is the face one that others meet? The ends of a planar prism are not.
bool is_met(const geometry::ConvexView& shape, std::int32_t face, bool is_planar) {
    return !is_planar || std::abs(shape.normal(face).z) < 0.5;
}

/// Cuts a line to what lies deeper than `depth` below all faces but two, within a millionth of that depth.
void cut(const geometry::ConvexView& shape, double depth, std::int32_t first, std::int32_t second, bool is_planar,
         Segment& line) {
    const double forgiven = 1e-6 * depth;
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        if (f == first || f == second || !is_met(shape, f, is_planar)) {
            continue;
        }
        const double rate = dot(shape.normal(f), line.along);
        const double left = shape.offset[f] - depth - dot(shape.normal(f), line.origin);
        if (std::abs(rate) < 1e-12) {
            line.end = left < -forgiven ? -std::numeric_limits<double>::infinity() : line.end;
        } else if (rate > 0) {
            line.end = std::min(line.end, left / rate);
        } else {
            line.begin = std::max(line.begin, left / rate);
        }
    }
    if (line.begin > line.end && line.begin - line.end < forgiven) {
        line.begin = line.end = 0.5 * (line.begin + line.end);
    }
}

/// The line at one depth below two faces, where it is as deep below all others; empty where it is nowhere.
Segment line_below(const geometry::ConvexView& shape, std::int32_t j, std::int32_t k, double depth, bool is_planar) {
    const Vec3 nj = shape.normal(j), nk = shape.normal(k);
    const double c = dot(nj, nk), oj = shape.offset[j] - depth, ok = shape.offset[k] - depth;
    const double square = 1 - c * c;
    Segment line;
    if (square < 1e-12) {
        line.end = -line.end;
        return line;
    }
    line.origin = ((oj - c * ok) / square) * nj + ((ok - c * oj) / square) * nk;
    line.along = normalized(cross(nj, nk));
    if (is_planar) {
        line.begin = line.end = 0;
    }
    cut(shape, depth, j, k, is_planar, line);
    return line;
}

/// Pairs of faces that share an edge.
std::vector<std::pair<std::int32_t, std::int32_t>> neighbours(const geometry::ConvexView& shape, bool is_planar) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> first_face;
    std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        const std::int32_t begin = shape.face_start[f], end = shape.face_start[f + 1];
        for (std::int32_t k = begin; k < end && is_met(shape, f, is_planar); ++k) {
            const std::int32_t a = shape.face_vertex[k], b = shape.face_vertex[k + 1 < end ? k + 1 : begin];
            const auto [found, is_new] = first_face.emplace(std::minmax(a, b), f);
            if (!is_new) {
                pairs.emplace_back(found->second, f);
            }
        }
    }
    return pairs;
}

/// Calls take(t, length) with equal steps of a segment, `spacing` at most, both ends with them, and the length of the
/// segment that is nearest to t.
template <class Take>
void step_along(double begin, double end, double spacing, const Take& take) {
    const auto count = static_cast<std::int64_t>(std::ceil((end - begin) / spacing - 1e-9));
    if (count <= 0) {
        take(0.5 * (begin + end), end - begin);
        return;
    }
    const double step = (end - begin) / static_cast<double>(count);
    for (std::int64_t i = 0; i <= count; ++i) {
        take(begin + step * static_cast<double>(i), i == 0 || i == count ? 0.5 * step : step);
    }
}

/// Leaves of places that are the same but for round-off the first.
void leave_out_copies(std::vector<SurfaceSample>& samples, double within) {
    std::ranges::stable_sort(samples, {}, [](const SurfaceSample& s) { return s.sphere.centre.x; });
    std::vector<SurfaceSample> kept;
    for (const SurfaceSample& sample : samples) {
        const Vec3& centre = sample.sphere.centre;
        bool is_copy = false;
        for (std::size_t i = kept.size(); i > 0 && !is_copy && kept[i - 1].sphere.centre.x > centre.x - within; --i) {
            is_copy = norm(kept[i - 1].sphere.centre - centre) < within;
        }
        if (!is_copy) {
            kept.push_back(sample);
        }
    }
    samples = std::move(kept);
}

/// The part of a face, moved inwards by `depth`, that is as deep below all other faces; a convex polygon.
std::vector<Vec3> face_below(const geometry::ConvexView& shape, std::int32_t face, double depth) {
    std::vector<Vec3> polygon;
    for (std::int32_t k = shape.face_start[face]; k < shape.face_start[face + 1]; ++k) {
        polygon.push_back(shape.vertex(shape.face_vertex[k]) - depth * shape.normal(face));
    }
    for (std::int32_t f = 0; f < shape.face_count && !polygon.empty(); ++f) {
        if (f == face) {
            continue;
        }
        std::vector<Vec3> cut_off;
        const auto left = [&](const Vec3& x) { return shape.offset[f] - depth - dot(shape.normal(f), x); };
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double of_a = left(a), of_b = left(b);
            if (of_a >= 0) {
                cut_off.push_back(a);
            }
            if ((of_a >= 0) != (of_b >= 0)) {
                cut_off.push_back(a + (of_a / (of_a - of_b)) * (b - a));
            }
        }
        polygon = std::move(cut_off);
    }
    return polygon;
}

/// Spheres of one face in space: rows across its polygon along its first edge. Only those inside of it meet parts.
void fill_face(const geometry::ConvexView& shape, std::int32_t face, double radius, bool meets_triangles,
               std::vector<SurfaceSample>& samples) {
    const std::vector<Vec3> polygon = face_below(shape, face, radius);
    if (polygon.empty()) {
        return;
    }
    const Vec3 normal = shape.normal(face), origin = polygon.front();
    const std::int32_t first = shape.face_start[face];
    const Vec3 u = normalized(shape.vertex(shape.face_vertex[first + 1]) - shape.vertex(shape.face_vertex[first]));
    const Vec3 v = cross(normal, u);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& x : polygon) {
        low = std::min(low, dot(x - origin, v));
        high = std::max(high, dot(x - origin, v));
    }
    const double inside = 1e-9 * (high - low);
    step_along(low + inside, high - inside, 2 * radius, [&](double row, double height) {
        double begin = std::numeric_limits<double>::infinity(), end = -begin;
        const auto reach = [&](double along) {
            begin = std::min(begin, along);
            end = std::max(end, along);
        };
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3 a = polygon[i] - origin, b = polygon[(i + 1) % polygon.size()] - origin;
            const double va = dot(a, v) - row, vb = dot(b, v) - row;
            if (va == vb) {
                continue;  // along the row, whose ends the edges beside it reach
            }
            if (std::min(va, vb) <= 0 && std::max(va, vb) >= 0) {
                reach(dot(a, u) - va / (vb - va) * dot(b - a, u));
            }
        }
        if (begin <= end) {
            step_along(begin, end, 2 * radius, [&](double along, double width) {
                const bool is_inner = begin < along && along < end && low + inside < row && row < high - inside;
                if (is_inner || meets_triangles) {
                    samples.push_back(
                        {{origin + along * u + row * v, radius, is_inner ? normal : Vec3{}}, radius, width * height});
                }
            });
        }
    });
}

/// Ends of a side of a planar section, in the order of its faces.
struct Side {
    Vec3 begin, end;
};

Side side_of(const geometry::ConvexView& shape, std::int32_t face) {
    const Vec3 normal = shape.normal(face), along{-normal.y, normal.x, 0};
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::int32_t k = shape.face_start[face]; k < shape.face_start[face + 1]; ++k) {
        low = std::min(low, dot(shape.vertex(shape.face_vertex[k]), along));
        high = std::max(high, dot(shape.vertex(shape.face_vertex[k]), along));
    }
    const Vec3 base = shape.offset[face] * normal;
    return {base + low * along, base + high * along};
}

/// Length of the equal parts of a side, two radii at most [m].
double part_of(const Side& side, double radius) {
    const double length = norm(side.end - side.begin);
    return length / std::max(1.0, std::ceil(length / (2 * radius) - 1e-9));
}

/// Discs of one side of a planar section.
void fill_side(const geometry::ConvexView& shape, std::int32_t face, double radius, bool meets_triangles,
               std::vector<SurfaceSample>& samples) {
    const Vec3 normal = shape.normal(face);
    const Side side = side_of(shape, face);
    const double part = part_of(side, radius), length = norm(side.end - side.begin);
    const Vec3 along = (side.end - side.begin) / length;
    Segment line{side.begin - radius * normal, along};
    cut(shape, radius, face, face, true, line);
    if (line.is_empty()) {
        return;
    }
    const double forgiven = 1e-6 * radius;
    const auto count = static_cast<std::int64_t>(std::llround(length / part));
    for (std::int64_t i = 1; i < count; ++i) {
        const double t = part * static_cast<double>(i);
        if (line.begin - forgiven <= t && t <= line.end + forgiven) {
            samples.push_back({{line.at(t), radius, normal}, radius, part});
        }
    }
    for (const double t : {line.begin, line.end}) {
        if (meets_triangles) {
            samples.push_back({{line.at(t), radius, {}}, radius, 0.5 * part});
        }
    }
}

}  // namespace

std::vector<SurfaceSample> edge_samples(const geometry::ConvexView& shape, double radius, double law_radius,
                                        bool is_planar) {
    std::vector<SurfaceSample> samples;
    for (const auto& [j, k] : neighbours(shape, is_planar)) {
        const Segment line = line_below(shape, j, k, radius, is_planar);
        if (line.is_empty()) {
            continue;
        }
        if (is_planar) {  // a corner of the section is an edge of the prism
            const double parts = part_of(side_of(shape, j), law_radius) + part_of(side_of(shape, k), law_radius);
            samples.push_back({{{line.origin.x, line.origin.y, 0}, radius, {}}, law_radius, 0.25 * parts});
            continue;
        }
        const double spacing = std::max(2 * law_radius, (line.end - line.begin) / most_of_edge);
        step_along(line.begin, line.end, spacing, [&](double t, double length) {
            samples.push_back({{line.at(t), radius, {}}, law_radius, length * law_radius});
        });
    }
    leave_out_copies(samples, 0.1 * radius);
    return samples;
}

std::vector<SurfaceSample> face_samples(const geometry::ConvexView& shape, double radius, bool is_planar,
                                        bool meets_triangles) {
    std::vector<SurfaceSample> samples;
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        if (!is_planar) {
            fill_face(shape, f, radius, meets_triangles, samples);
        } else if (is_met(shape, f, true)) {
            fill_side(shape, f, radius, meets_triangles, samples);
        }
    }
    leave_out_copies(samples, 0.1 * radius);
    return samples;
}

double sample_estimate(const geometry::ConvexView& shape, double radius) {
    double perimeter = 0, area = 0;
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        const std::int32_t begin = shape.face_start[f], end = shape.face_start[f + 1];
        for (std::int32_t k = begin; k < end; ++k) {
            const Vec3 a = shape.vertex(shape.face_vertex[k]);
            const Vec3 b = shape.vertex(shape.face_vertex[k + 1 < end ? k + 1 : begin]);
            perimeter += 0.5 * norm(b - a);
            area += 0.5 * dot(cross(a, b), shape.normal(f));
        }
    }
    return perimeter / (2 * radius) + area / (4 * radius * radius);
}

}  // namespace riprap::solid::sphere_dem

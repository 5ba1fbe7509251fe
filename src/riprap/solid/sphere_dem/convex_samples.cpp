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

/// Calls take(t) with equal steps of a segment, `spacing` at most, both ends with them.
template <class Take>
void step_along(double begin, double end, double spacing, const Take& take) {
    const auto count = static_cast<std::int64_t>(std::ceil((end - begin) / spacing - 1e-9));
    for (std::int64_t i = 0; i <= count; ++i) {
        take(count > 0 ? begin + (end - begin) * static_cast<double>(i) / static_cast<double>(count)
                       : 0.5 * (begin + end));
    }
}

/// Leaves of places that are the same but for round-off the first.
void leave_out_copies(std::vector<body::ShapeSphere>& samples, double within) {
    std::ranges::stable_sort(samples, {}, [](const body::ShapeSphere& s) { return s.centre.x; });
    std::vector<body::ShapeSphere> kept;
    for (const body::ShapeSphere& sample : samples) {
        bool is_copy = false;
        for (std::size_t i = kept.size(); i > 0 && !is_copy && kept[i - 1].centre.x > sample.centre.x - within; --i) {
            is_copy = norm(kept[i - 1].centre - sample.centre) < within;
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

/// Spheres of one face in space: rows across its polygon along its first edge.
void fill_face(const geometry::ConvexView& shape, std::int32_t face, double radius,
               std::vector<body::ShapeSphere>& samples) {
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
    step_along(low + inside, high - inside, 2 * radius, [&](double row) {
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
            step_along(begin, end, 2 * radius, [&](double along) {
                const bool is_inner = begin < along && along < end && low + inside < row && row < high - inside;
                samples.push_back({origin + along * u + row * v, radius, is_inner ? normal : Vec3{}});
            });
        }
    });
}

}  // namespace

std::vector<body::ShapeSphere> edge_samples(const geometry::ConvexView& shape, double radius, double spacing,
                                            bool is_planar) {
    std::vector<body::ShapeSphere> samples;
    if (is_planar) {  // a corner of the section is an edge of the prism
        for (const auto& [j, k] : neighbours(shape, true)) {
            if (const Segment line = line_below(shape, j, k, radius, true); !line.is_empty()) {
                samples.push_back({{line.origin.x, line.origin.y, 0}, radius, {}});
            }
        }
        return samples;
    }
    for (const auto& [j, k] : neighbours(shape, false)) {
        if (const Segment line = line_below(shape, j, k, radius, false); !line.is_empty()) {
            step_along(line.begin, line.end, std::max(spacing, (line.end - line.begin) / most_of_edge), [&](double t) {
                samples.push_back({line.at(t), radius, {}});
            });
        }
    }
    leave_out_copies(samples, 0.1 * radius);
    return samples;
}

std::vector<body::ShapeSphere> face_samples(const geometry::ConvexView& shape, double radius, bool is_planar) {
    std::vector<body::ShapeSphere> samples;
    for (std::int32_t f = 0; f < shape.face_count; ++f) {
        if (!is_planar) {
            fill_face(shape, f, radius, samples);
            continue;
        }
        if (!is_met(shape, f, true)) {
            continue;
        }
        const Vec3 normal = shape.normal(f);
        Segment line{(shape.offset[f] - radius) * normal, {-normal.y, normal.x, 0}};
        cut(shape, radius, f, f, true, line);
        if (!line.is_empty()) {
            step_along(line.begin, line.end, 2 * radius, [&](double t) {
                samples.push_back({line.at(t), radius, normal});
            });
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

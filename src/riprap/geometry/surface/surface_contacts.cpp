// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/surface/surface_mesh.hpp"

namespace riprap::geometry {

namespace {

/// A part with its planes and box.
struct PlacedPart {
    std::size_t number;
    Vec3 low, high;
    std::vector<Plane> planes;
};

std::vector<PlacedPart> place(const std::vector<ConvexPart>& parts) {
    std::vector<PlacedPart> placed;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Polyhedron& p = parts[i].part.polyhedron;
        PlacedPart entry{i, p.vertices.front(), p.vertices.front(), {}};
        for (const Vec3& x : p.vertices) {
            entry.low = min(entry.low, x);
            entry.high = max(entry.high, x);
        }
        for (const auto& face : p.faces) {
            entry.planes.push_back(face_plane(p.vertices, face));
        }
        placed.push_back(std::move(entry));
    }
    std::sort(placed.begin(), placed.end(), [](const PlacedPart& a, const PlacedPart& b) {
        return a.low.x != b.low.x ? a.low.x < b.low.x : a.number < b.number;
    });
    return placed;
}

bool boxes_touch(const PlacedPart& a, const PlacedPart& b, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.low[axis] > b.high[axis] + tolerance || b.low[axis] > a.high[axis] + tolerance) {
            return false;
        }
    }
    return true;
}

std::string name_of(const std::vector<ConvexPart>& parts, std::size_t i) {
    return fmt::format("part {}{}", i + 1, parts[i].part.name.empty() ? "" : " " + parts[i].part.name);
}

/// Clips a flat polygon to a half-space.
std::vector<Vec3> clip_polygon(const std::vector<Vec3>& polygon, const Plane& plane) {
    std::vector<Vec3> inside;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double height_a = dot(plane.normal, a) - plane.offset, height_b = dot(plane.normal, b) - plane.offset;
        if (height_a <= 0.0) {
            inside.push_back(a);
        }
        if ((height_a < 0.0 && height_b > 0.0) || (height_a > 0.0 && height_b < 0.0)) {
            inside.push_back(a + (height_a / (height_a - height_b)) * (b - a));
        }
    }
    return inside;
}

class ContactCheck {
 public:
    ContactCheck(std::vector<ConvexPart>& parts, const SurfaceMesh& mesh, ProblemList& problems)
        : parts_(parts), mesh_(mesh), problems_(problems), placed_(place(parts)) {}

    void check(bool is_one_body) {
        constexpr std::size_t most_pairs = 2'000'000;
        std::size_t pairs = 0;
        if (is_one_body) {
            flag_shared_faces();
        }
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            for (std::size_t j = i + 1; j < placed_.size() && placed_[j].low.x <= placed_[i].high.x + band(); ++j) {
                if (!boxes_touch(placed_[i], placed_[j], band())) {
                    continue;
                }
                if (++pairs > most_pairs || problems_.count() >= ProblemList::cap) {
                    problems_.add(mesh_.source->file, "too many parts with overlapping boxes", "parts side by side");
                    return;
                }
                if (!report_overlap(placed_[i], placed_[j]) && is_one_body) {
                    report_partly_shared(placed_[i], placed_[j]);
                }
            }
        }
    }

 private:
    /// Parts whose common volume is thinner than this touch but do not overlap [m]; see slack() in surface_convexity.
    double band() const { return 4.0 * mesh_.tolerance; }

    const Polyhedron& shape(const PlacedPart& part) const { return parts_[part.number].part.polyhedron; }

    /// Two parts share a whole face if it runs through the same welded points.
    void flag_shared_faces() {
        std::map<std::vector<std::int32_t>, std::pair<std::size_t, std::size_t>> first_with;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            Polyhedron& polyhedron = parts_[i].part.polyhedron;
            polyhedron.is_internal.assign(polyhedron.faces.size(), 0);
            for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
                std::vector<std::int32_t> points;
                for (const std::int32_t v : polyhedron.faces[f]) {
                    points.push_back(parts_[i].point[static_cast<std::size_t>(v)]);
                }
                std::sort(points.begin(), points.end());
                const auto [entry, is_new] = first_with.try_emplace(std::move(points), i, f);
                if (!is_new) {
                    const auto [other, other_face] = entry->second;
                    polyhedron.is_internal[f] = 1;
                    parts_[other].part.polyhedron.is_internal[other_face] = 1;
                }
            }
        }
    }

    bool report_overlap(const PlacedPart& a, const PlacedPart& b) {
        Polyhedron common = shape(a);
        for (const Plane& plane : b.planes) {
            common = clip_convex(common, {plane.normal, plane.offset - band()});
        }
        if (common.faces.empty()) {
            return false;
        }
        const MassProperties mass = mass_properties(common);
        problems_.add(mesh_.source->file,
                      fmt::format("{} and {} overlap by {:.3g} m^3 around {}", name_of(parts_, a.number),
                                  name_of(parts_, b.number), mass.volume, coordinates(mass.centroid)),
                      "parts that touch at most");
        return true;
    }

    void report_partly_shared(const PlacedPart& a, const PlacedPart& b) {
        for (std::size_t f = 0; f < a.planes.size(); ++f) {
            for (std::size_t g = 0; g < b.planes.size(); ++g) {
                if (shape(a).is_internal[f] != 0 && shape(b).is_internal[g] != 0) {
                    continue;
                }
                const std::vector<Vec3> common = common_polygon(a, f, b, g);
                if (common.size() >= 3) {
                    Vec3 centre{};
                    for (const Vec3& x : common) {
                        centre += x / static_cast<double>(common.size());
                    }
                    problems_.add(mesh_.source->file,
                                  fmt::format("{} and {} share a part of a face around {}", name_of(parts_, a.number),
                                              name_of(parts_, b.number), coordinates(centre)),
                                  "parts of one body that meet in whole faces; cut the larger face along the smaller");
                    return;
                }
            }
        }
    }

    std::vector<Vec3> common_polygon(const PlacedPart& a, std::size_t f, const PlacedPart& b, std::size_t g) const {
        const Plane &plane_a = a.planes[f], &plane_b = b.planes[g];
        constexpr double opposite = -0.999;
        std::vector<Vec3> polygon;
        if (dot(plane_a.normal, plane_b.normal) > opposite) {
            return polygon;
        }
        for (const std::int32_t v : shape(a).faces[f]) {
            polygon.push_back(shape(a).vertices[static_cast<std::size_t>(v)]);
        }
        polygon = clip_polygon(polygon, {plane_b.normal, plane_b.offset + band()});
        polygon = clip_polygon(polygon, {-plane_b.normal, -plane_b.offset + band()});
        const auto& loop = shape(b).faces[g];
        for (std::size_t k = 0; k < loop.size() && polygon.size() >= 3; ++k) {
            const Vec3& from = shape(b).vertices[static_cast<std::size_t>(loop[k])];
            const Vec3& to = shape(b).vertices[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
            const Vec3 outwards = normalized(cross(to - from, plane_b.normal));
            polygon = clip_polygon(polygon, {outwards, dot(outwards, from) - band()});
        }
        return polygon;
    }

    std::vector<ConvexPart>& parts_;
    const SurfaceMesh& mesh_;
    ProblemList& problems_;
    std::vector<PlacedPart> placed_;
};

}  // namespace

void check_part_contacts(std::vector<ConvexPart>& parts, const SurfaceMesh& mesh, const SurfaceAuditOptions& options,
                         ProblemList& problems) {
    ContactCheck(parts, mesh, problems).check(options.is_one_body);
}

}  // namespace riprap::geometry

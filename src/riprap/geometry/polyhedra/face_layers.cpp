// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/face_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "riprap/geometry/polyhedra/plane_cells.hpp"

namespace riprap::geometry {

namespace {

// Lengths below are shares of the spacing.
constexpr double same_place = 0.45;   ///< points nearer than this are one: corners of small faces, edges of two faces
constexpr double room_inside = 0.7;   ///< a lattice point inside a face keeps this distance from others
constexpr double count_shift = 1e-6;  ///< moves the step of rounding off the half-integers that people write
constexpr double shy = 1 - 1e-9;      ///< the middle of a part is reached from its side, never passed
constexpr double flat = 1e-12;        ///< sine of the angle below which two planes are parallel

std::int64_t interval_count(double length, double spacing) {
    return static_cast<std::int64_t>(std::floor(length / spacing + 0.5 + count_shift));
}

/// The points of one layer, found again by place.
class LayerSites {
 public:
    explicit LayerSites(double spacing) : size_(room_inside * spacing) {}

    /// The nearest point within `radius` (at most room_inside dp), the earlier of two; -1 = none.
    std::int32_t find(const Vec3& x, double radius) const {
        std::int32_t best = -1;
        double least = radius * radius;
        const Cell c = cell_of(x);
        for (std::int64_t k = -1; k <= 1; ++k) {
            for (std::int64_t j = -1; j <= 1; ++j) {
                for (std::int64_t i = -1; i <= 1; ++i) {
                    const auto found = first_.find(key({c.x + i, c.y + j, c.z + k}));
                    for (std::int32_t s = found == first_.end() ? -1 : found->second; s >= 0; s = next_[index(s)]) {
                        const double squared = norm_squared(points[index(s)].position - x);
                        if (squared < least || (squared == least && s < best)) {
                            least = squared;
                            best = s;
                        }
                    }
                }
            }
        }
        return best;
    }
    std::int32_t add(const LayerPoint& point) {
        const auto site = static_cast<std::int32_t>(points.size());
        points.push_back(point);
        const auto [entry, is_new] = first_.try_emplace(key(cell_of(point.position)), site);
        next_.push_back(is_new ? -1 : entry->second);
        entry->second = site;
        return site;
    }
    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

    std::vector<LayerPoint> points;

 private:
    struct Cell {
        std::int64_t x, y, z;
    };
    Cell cell_of(const Vec3& x) const {
        const auto of = [this](double c) { return static_cast<std::int64_t>(std::floor(c / size_)); };
        return {of(x.x), of(x.y), of(x.z)};
    }
    static std::uint64_t key(const Cell& c) {
        constexpr std::uint64_t mask = (1ULL << 21U) - 1;
        return (static_cast<std::uint64_t>(c.x) & mask) << 42U | (static_cast<std::uint64_t>(c.y) & mask) << 21U |
               (static_cast<std::uint64_t>(c.z) & mask);
    }
    double size_;
    std::unordered_map<std::uint64_t, std::int32_t> first_;  // looked up, never walked through
    std::vector<std::int32_t> next_;
};

/// One face with coordinates u, v on it. A plane i meets the parallel plane at depth d in a_i u + b_i v = c_i + s_i d.
class FaceSections {
 public:
    FaceSections(std::span<const LayerFace> faces, std::size_t face, const Vec3& centre, double extent)
        : normal_(faces[face].plane.normal), reach_(2 * extent) {
        const Vec3 axis = std::abs(normal_.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        e1_ = normalized(cross(axis, normal_));
        e2_ = cross(normal_, e1_);
        origin_ = centre + (faces[face].plane.offset - dot(normal_, centre)) * normal_;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            if (i != face) {
                const Plane& plane = faces[i].plane;
                const double along = dot(plane.normal, normal_);
                lines_.push_back({dot(plane.normal, e1_), dot(plane.normal, e2_),
                                  plane.offset - dot(plane.normal, origin_), along - (faces[i].is_cut ? 0 : 1),
                                  faces[i].is_cut});
            }
        }
    }

    /// The section at depth d of the piece that is nearest to this face, kept `inset` away from cuts.
    PlanePolygon section(double depth, double inset) const {
        PlanePolygon polygon = square(reach_);
        cut_to_section(polygon, depth, inset);
        return polygon;
    }
    void cut_to_section(PlanePolygon& polygon, double depth, double inset) const {
        PlanePolygon buffer;
        for (const Line& line : lines_) {
            const double c = line.c + line.slope * depth - (line.is_cut ? inset : 0);
            if (std::abs(line.a) + std::abs(line.b) > flat) {
                clip(polygon, {line.a, line.b, c}, buffer);
            } else if (c < 0) {
                polygon.clear();
            }
        }
    }
    Vec3 place(const PlanePoint& p, double depth) const { return origin_ + p.u * e1_ + p.v * e2_ - depth * normal_; }
    PlanePoint project(const Vec3& x) const { return {dot(x - origin_, e1_), dot(x - origin_, e2_)}; }
    double reach() const { return reach_; }
    double depth_of(const Vec3& x) const { return dot(origin_ - x, normal_); }

 private:
    struct Line {
        double a, b, c, slope;
        bool is_cut;
    };
    Vec3 normal_, e1_, e2_, origin_;
    double reach_;
    std::vector<Line> lines_;
};

double length(const PlanePoint& a, const PlanePoint& b) { return std::hypot(b.u - a.u, b.v - a.v); }

/// Lattice points inside a polygon, along its longest edge, its extents divided evenly.
std::vector<PlanePoint> lattice_in(const PlanePolygon& polygon, double spacing) {
    std::size_t longest = 0;
    double most = 0;
    const auto next = [&](std::size_t i) { return i + 1 < polygon.size() ? i + 1 : 0; };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double l = length(polygon[i], polygon[next(i)]);
        if (l > (1 + 1e-9) * most) {  // equal edges differ by round-off
            most = l;
            longest = i;
        }
    }
    if (most == 0) {
        return {};
    }
    const PlanePoint o = polygon[longest], q = polygon[next(longest)];
    const double cosine = (q.u - o.u) / most, sine = (q.v - o.v) / most;
    PlanePoint low{0, 0}, high{0, 0};
    for (const PlanePoint& p : polygon) {
        const PlanePoint turned{cosine * (p.u - o.u) + sine * (p.v - o.v), cosine * (p.v - o.v) - sine * (p.u - o.u)};
        low = {std::min(low.u, turned.u), std::min(low.v, turned.v)};
        high = {std::max(high.u, turned.u), std::max(high.v, turned.v)};
    }
    const auto is_inside = [&](const PlanePoint& p) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const PlanePoint a = polygon[i], b = polygon[next(i)];
            if ((b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u) < 0) {
                return false;
            }
        }
        return true;
    };
    const std::int64_t nu = interval_count(high.u - low.u, spacing), nv = interval_count(high.v - low.v, spacing);
    std::vector<PlanePoint> points;
    for (std::int64_t j = 1; j < nv; ++j) {
        for (std::int64_t i = 1; i < nu; ++i) {
            const double s = low.u + (high.u - low.u) * static_cast<double>(i) / static_cast<double>(nu);
            const double t = low.v + (high.v - low.v) * static_cast<double>(j) / static_cast<double>(nv);
            const PlanePoint p{o.u + cosine * s - sine * t, o.v + sine * s + cosine * t};
            if (is_inside(p)) {
                points.push_back(p);
            }
        }
    }
    return points;
}

/// One layer of all faces: places its points, then shares its volume out.
class Layer {
 public:
    Layer(const std::vector<FaceSections>& sections, const std::vector<std::int32_t>& faces, double depth,
          const LayerSettings& settings)
        : sections_(sections),
          faces_(faces),
          depth_(depth),
          settings_(settings),
          sites_(settings.spacing),
          owners_(sections.size()) {
        for (const FaceSections& face : sections) {
            const double inset = 0.5 * shy * settings.spacing;
            PlanePolygon polygon = face.section(depth, inset);
            polygons_.push_back(polygon.empty() ? face.section(depth, 0) : std::move(polygon));
        }
        place_corners();
        place_along_edges();
        place_inside();
    }

    /// Between the depths `top` and `bottom`.
    void share_volume(double top, double bottom) {
        for (std::size_t f = 0; f < sections_.size(); ++f) {
            std::vector<std::int32_t>& owners = owners_[f];
            std::sort(owners.begin(), owners.end());
            owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
            if (owners.empty()) {
                give_to_nearest(f, top, bottom);
                continue;
            }
            std::vector<PlanePoint> at;
            at.reserve(owners.size());
            for (const std::int32_t owner : owners) {
                at.push_back(sections_[f].project(sites_.points[LayerSites::index(owner)].position));
            }
            const std::array<PlanePolygon, 3> levels{sections_[f].section(top, 0),
                                                     sections_[f].section(0.5 * (top + bottom), 0),
                                                     sections_[f].section(bottom, 0)};
            const PlaneBox box = bounds(levels);
            if (!(box.low.u < box.high.u && box.low.v < box.high.v)) {
                continue;
            }
            const auto cells = voronoi_cells(at, box, settings_.spacing);
            for (std::size_t i = 0; i < owners.size(); ++i) {
                give(LayerSites::index(owners[i]), sections_[f], cells[i], top, bottom);
            }
        }
    }
    /// Moves every point to the middle of what it stands for.
    void move_to_middles() {
        moments_.resize(sites_.points.size());
        for (std::size_t i = 0; i < sites_.points.size(); ++i) {
            LayerPoint& point = sites_.points[i];
            Vec3 way = point.volume > 0 ? moments_[i] / point.volume : Vec3{};
            way.z = settings_.is_slab ? 0 : way.z;
            if (norm(way) > count_shift * settings_.spacing) {  // a lattice stays what it is
                point.position += way;
                point.depth = depth_of(point.position);
            }
        }
    }
    const std::vector<LayerPoint>& points() const { return sites_.points; }

 private:
    /// Adds what a face has of a cell between two depths to the volume of a point, and to its first moment.
    void give(std::size_t site, const FaceSections& face, const PlanePolygon& cell, double top, double bottom) {
        moments_.resize(sites_.points.size());
        LayerPoint& point = sites_.points[site];
        const double middle = 0.5 * (top + bottom);
        for (const auto& [depth, weight] : {std::pair{top, 1.0}, std::pair{middle, 4.0}, std::pair{bottom, 1.0}}) {
            PlanePolygon cut = cell;
            face.cut_to_section(cut, depth, 0);
            const double share = weight * (bottom - top) / 6 * area(cut);
            if (share > 0) {
                point.volume += share;
                moments_[site] += share * (face.place(centroid(cut), depth) - point.position);
            }
        }
    }
    /// Depth below the nearest face [m].
    double depth_of(const Vec3& x) const {
        double depth = sections_.front().depth_of(x);
        for (const FaceSections& face : sections_) {
            depth = std::min(depth, face.depth_of(x));
        }
        return depth;
    }
    /// A face that ends above the points of this layer.
    void give_to_nearest(std::size_t f, double top, double bottom) {
        const PlanePolygon polygon = sections_[f].section(top, 0);
        if (polygon.empty() || sites_.points.empty()) {
            return;
        }
        const Vec3 corner = sections_[f].place(polygon[0], depth_);
        const auto nearest = std::min_element(
            sites_.points.begin(), sites_.points.end(), [&corner](const LayerPoint& a, const LayerPoint& b) {
                return norm_squared(a.position - corner) < norm_squared(b.position - corner);
            });
        const auto site = static_cast<std::size_t>(nearest - sites_.points.begin());
        give(site, sections_[f], square(sections_[f].reach()), top, bottom);
    }
    void place(std::size_t f, const PlanePoint& p, double keep_away) {
        Vec3 x = sections_[f].place(p, depth_);
        x.z = settings_.is_slab ? 0 : x.z;
        std::int32_t site = sites_.find(x, keep_away * settings_.spacing);
        if (site < 0) {
            site = sites_.add({x, depth_, 0, faces_[f]});
        }
        owners_[f].push_back(site);
    }
    void place_corners() {
        for (std::size_t f = 0; f < sections_.size(); ++f) {
            for (const PlanePoint& p : polygons_[f]) {
                place(f, p, same_place);
            }
        }
    }
    void place_along_edges() {
        for (std::size_t f = 0; f < sections_.size(); ++f) {
            const PlanePolygon& polygon = polygons_[f];
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const PlanePoint a = polygon[i], b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
                const std::int64_t n = interval_count(length(a, b), settings_.spacing);
                for (std::int64_t k = 1; k < n; ++k) {
                    const double t = static_cast<double>(k) / static_cast<double>(n);
                    place(f, {a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)}, same_place);
                }
            }
        }
    }
    void place_inside() {
        for (std::size_t f = 0; f < sections_.size(); ++f) {
            for (const PlanePoint& p : lattice_in(polygons_[f], settings_.spacing)) {
                place(f, p, room_inside);
            }
        }
    }

    const std::vector<FaceSections>& sections_;
    const std::vector<std::int32_t>& faces_;
    double depth_;
    const LayerSettings& settings_;
    LayerSites sites_;
    std::vector<PlanePolygon> polygons_;
    std::vector<std::vector<std::int32_t>> owners_;
    std::vector<Vec3> moments_;  ///< of what points stand for, about them [m^4]
};

}  // namespace

std::vector<LayerPoint> layers_under_faces(std::span<const LayerFace> faces, double inscribed_radius,
                                           const Vec3& centre, double extent, const LayerSettings& settings) {
    std::vector<FaceSections> sections;
    std::vector<std::int32_t> face_of;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (!faces[f].is_cut) {
            sections.emplace_back(faces, f, centre, extent);
            face_of.push_back(static_cast<std::int32_t>(f));
        }
    }
    // Layer k is wanted while (k + 1/2) dp < reach; without the shift round-off would decide when reach fits.
    const auto wanted = static_cast<std::int64_t>(std::ceil(settings.reach / settings.spacing - 0.5 - count_shift));
    const bool is_thin = inscribed_radius < static_cast<double>(wanted) * settings.spacing;
    const std::int64_t across = std::max<std::int64_t>(1, interval_count(2 * inscribed_radius, settings.spacing));
    const double thickness = is_thin ? 2 * inscribed_radius / static_cast<double>(across) : settings.spacing;
    const std::int64_t count = is_thin ? std::min((across + 1) / 2, wanted) : wanted;

    std::vector<LayerPoint> points;
    for (std::int64_t k = 0; k < count; ++k) {
        const double top = static_cast<double>(k) * thickness;
        const double depth = std::min(top + 0.5 * thickness, shy * inscribed_radius);
        Layer layer(sections, face_of, depth, settings);
        layer.share_volume(top, std::min(top + thickness, inscribed_radius));
        if (!is_thin || across > 1) {  // a plate of one layer keeps its ends, with which it stands on other bodies
            layer.move_to_middles();
        }
        points.insert(points.end(), layer.points().begin(), layer.points().end());
    }
    return points;
}

}  // namespace riprap::geometry

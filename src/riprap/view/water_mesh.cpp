// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/water_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "riprap/core/error.hpp"

namespace riprap::view {

namespace {

constexpr double most_nodes = 1e8;
constexpr double level = 0.5;
constexpr int support = 2;  // of the kernel, in spacings

/// Values on a lattice of unit cells, in units of the spacing.
class Lattice {
 public:
    Lattice(std::span<const Vec3> particles, std::span<const float> speed, double spacing, bool is_planar)
        : spacing_(spacing), is_planar_(is_planar) {
        Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
        for (const Vec3& x : particles) {
            low = min(low, x);
            high = max(high, x);
        }
        const double margin = (support + 1) * spacing;
        origin_ = low - Vec3{margin, margin, is_planar ? 0 : margin};
        double nodes = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double cells =
                axis == 2 && is_planar ? 0 : std::ceil((high[axis] + margin - origin_[axis]) / spacing);
            nodes *= cells + 1;
            count_[static_cast<std::size_t>(axis)] = nodes <= most_nodes ? static_cast<std::int64_t>(cells) + 1 : 0;
        }
        if (!(nodes <= most_nodes)) {
            throw FileError(
                fmt::format("the surface of this water would need {:.3g} nodes, more than {:.0e}", nodes, most_nodes));
        }
        share_.resize(static_cast<std::size_t>(nodes));
        speed_.resize(share_.size());
        for (std::size_t i = 0; i < particles.size(); ++i) {
            add((particles[i] - origin_) / spacing, i < speed.size() ? speed[i] : 0.0F);
        }
    }

    std::int64_t count(int axis) const { return count_[static_cast<std::size_t>(axis)]; }
    std::int64_t node(std::int64_t i, std::int64_t j, std::int64_t k) const {
        return (k * count_[1] + j) * count_[0] + i;
    }
    double share(std::int64_t node) const { return static_cast<double>(share_[static_cast<std::size_t>(node)]); }
    double speed(std::int64_t node) const {
        const auto n = static_cast<std::size_t>(node);
        return share_[n] > 0 ? static_cast<double>(speed_[n] / share_[n]) : 0;
    }
    Vec3 place(std::int64_t node) const {
        const std::int64_t i = node % count_[0], j = node / count_[0] % count_[1], k = node / (count_[0] * count_[1]);
        return origin_ + spacing_ * Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
    }

 private:
    void add(const Vec3& x, float speed) {
        // Scaled to an integral of one over the support, in space and in the plane.
        constexpr double radius = support;
        const double scale = is_planar_ ? 4 / (std::numbers::pi * radius * radius)
                                        : 315 / (64 * std::numbers::pi * radius * radius * radius);
        const auto first = [&](int axis) {
            return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(x[axis] - radius)));
        };
        const auto last = [&](int axis) {
            return std::min(count(axis) - 1, static_cast<std::int64_t>(std::floor(x[axis] + radius)));
        };
        const std::int64_t top = is_planar_ ? 0 : last(2);
        for (std::int64_t k = is_planar_ ? 0 : first(2); k <= top; ++k) {
            for (std::int64_t j = first(1); j <= last(1); ++j) {
                for (std::int64_t i = first(0); i <= last(0); ++i) {
                    const double dx = static_cast<double>(i) - x.x, dy = static_cast<double>(j) - x.y;
                    const double dz = is_planar_ ? 0 : static_cast<double>(k) - x.z;
                    const double q = 1 - (dx * dx + dy * dy + dz * dz) / (radius * radius);
                    if (q > 0) {
                        const auto n = static_cast<std::size_t>(node(i, j, k));
                        const auto w = static_cast<float>(scale * q * q * q);
                        share_[n] += w;
                        speed_[n] += w * speed;
                    }
                }
            }
        }
    }

    double spacing_;
    bool is_planar_;
    Vec3 origin_{};
    std::array<std::int64_t, 3> count_{};
    std::vector<float> share_, speed_;
};

/// Collects triangles; a point of the lattice or of an edge is made once.
class Mesher {
 public:
    explicit Mesher(const Lattice& lattice) : lattice_(lattice) {}

    /// The part of the surface in a tetrahedron.
    void cut(const std::array<std::int64_t, 4>& corners) {
        std::array<std::int64_t, 4> wet{}, dry{};
        std::size_t wet_count = 0, dry_count = 0;
        for (const std::int64_t corner : corners) {
            (is_wet(corner) ? wet[wet_count++] : dry[dry_count++]) = corner;
        }
        if (wet_count == 1 || wet_count == 3) {
            const std::int64_t lone = wet_count == 1 ? wet[0] : dry[0];
            const auto& others = wet_count == 1 ? dry : wet;
            add({between(lone, others[0]), between(lone, others[1]), between(lone, others[2])}, wet[0], dry[0]);
        } else if (wet_count == 2) {
            const std::int32_t a = between(wet[0], dry[0]), b = between(wet[0], dry[1]), c = between(wet[1], dry[1]),
                               d = between(wet[1], dry[0]);
            add({a, b, c}, wet[0], dry[0]);
            add({a, c, d}, wet[1], dry[0]);
        }
    }

    /// The wet part of a triangle of the plane, seen from +z.
    void fill(const std::array<std::int64_t, 3>& corners) {
        std::vector<std::int32_t> polygon;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t a = corners[k], b = corners[(k + 1) % 3];
            if (is_wet(a)) {
                polygon.push_back(between(a, a));
            }
            if (is_wet(a) != is_wet(b)) {
                polygon.push_back(is_wet(a) ? between(a, b) : between(b, a));
            }
        }
        for (std::size_t k = 2; k < polygon.size(); ++k) {
            mesh_.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
        }
    }

    WaterMesh finish() {
        mesh_.normals.assign(mesh_.points.size(), Vec3{});
        for (const auto& t : mesh_.triangles) {
            const Vec3& a = point(t[0]);
            const Vec3 normal = cross(point(t[1]) - a, point(t[2]) - a);  // twice the area long
            for (const std::int32_t i : t) {
                mesh_.normals[static_cast<std::size_t>(i)] += normal;
            }
        }
        for (Vec3& normal : mesh_.normals) {
            normal = norm(normal) > 0 ? normal / norm(normal) : Vec3{0, 0, 1};
        }
        return std::move(mesh_);
    }

 private:
    bool is_wet(std::int64_t node) const { return lattice_.share(node) > level; }
    const Vec3& point(std::int32_t i) const { return mesh_.points[static_cast<std::size_t>(i)]; }

    /// The point of the surface between a wet and a dry node, or the node itself.
    std::int32_t between(std::int64_t a, std::int64_t b) {
        const std::int64_t low = std::min(a, b), high = std::max(a, b);
        const auto [found, is_new] =
            known_.try_emplace(Edge{low, high}, static_cast<std::int32_t>(mesh_.points.size()));
        if (is_new) {
            const double fa = lattice_.share(low), fb = lattice_.share(high);
            const double part = low == high ? 0 : std::clamp((level - fa) / (fb - fa), 1e-3, 1 - 1e-3);
            mesh_.points.push_back((1 - part) * lattice_.place(low) + part * lattice_.place(high));
            mesh_.speed.push_back(static_cast<float>((1 - part) * lattice_.speed(low) + part * lattice_.speed(high)));
        }
        return found->second;
    }

    /// Turns the triangle so that its front looks from the wet corner to the dry one.
    void add(std::array<std::int32_t, 3> t, std::int64_t wet, std::int64_t dry) {
        const Vec3 normal = cross(point(t[1]) - point(t[0]), point(t[2]) - point(t[0]));
        if (dot(normal, lattice_.place(dry) - lattice_.place(wet)) < 0) {
            std::swap(t[1], t[2]);
        }
        mesh_.triangles.push_back(t);
    }

    struct Edge {
        std::int64_t low, high;
        bool operator==(const Edge& other) const { return low == other.low && high == other.high; }
    };
    struct EdgeHash {
        std::size_t operator()(const Edge& edge) const {
            return std::hash<std::int64_t>()(edge.low * 31 + (edge.high - edge.low) * 1000003);
        }
    };
    const Lattice& lattice_;
    WaterMesh mesh_;
    std::unordered_map<Edge, std::int32_t, EdgeHash> known_;
};

/// A cell is cut into six tetrahedra around the diagonal from corner 0 to 7; neighbours agree on their common face.
constexpr std::array<std::array<int, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

void mesh_space(const Lattice& lattice, Mesher& mesher) {
    for (std::int64_t k = 0; k + 1 < lattice.count(2); ++k) {
        for (std::int64_t j = 0; j + 1 < lattice.count(1); ++j) {
            for (std::int64_t i = 0; i + 1 < lattice.count(0); ++i) {
                std::array<std::int64_t, 8> corner{};
                int wet = 0;
                for (std::size_t c = 0; c < 8; ++c) {
                    corner[c] =
                        lattice.node(i + static_cast<std::int64_t>(c & 1U), j + static_cast<std::int64_t>(c >> 1U & 1U),
                                     k + static_cast<std::int64_t>(c >> 2U));
                    wet += lattice.share(corner[c]) > level ? 1 : 0;
                }
                for (std::size_t t = 0; wet > 0 && wet < 8 && t < tetrahedra.size(); ++t) {
                    const auto at = [&](std::size_t n) { return corner[static_cast<std::size_t>(tetrahedra[t][n])]; };
                    mesher.cut({at(0), at(1), at(2), at(3)});
                }
            }
        }
    }
}

void mesh_plane(const Lattice& lattice, Mesher& mesher) {
    for (std::int64_t j = 0; j + 1 < lattice.count(1); ++j) {
        for (std::int64_t i = 0; i + 1 < lattice.count(0); ++i) {
            const std::int64_t a = lattice.node(i, j, 0), b = lattice.node(i + 1, j, 0),
                               c = lattice.node(i + 1, j + 1, 0), d = lattice.node(i, j + 1, 0);
            mesher.fill({a, b, c});
            mesher.fill({a, c, d});
        }
    }
}

}  // namespace

WaterMesh mesh_water(std::span<const Vec3> particles, std::span<const float> speed, double spacing, bool is_planar) {
    if (particles.empty()) {
        return {};
    }
    const Lattice lattice(particles, speed, spacing, is_planar);
    Mesher mesher(lattice);
    if (is_planar) {
        mesh_plane(lattice, mesher);
    } else {
        mesh_space(lattice, mesher);
    }
    return mesher.finish();
}

}  // namespace riprap::view

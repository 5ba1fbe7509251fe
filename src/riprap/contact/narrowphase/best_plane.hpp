// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "riprap/contact/narrowphase/common_plane.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/wide.hpp"

namespace riprap::contact {

/// Edges and links shorter or more parallel than this share of the lengths involved give no direction.
inline constexpr double least_sine = 1e-6;

/// Number of the edge between two corners.
inline std::int32_t edge_between(const HullTopology& hull, std::int32_t v, std::int32_t w) {
    for (std::size_t e = 0; e < hull.edges.size(); ++e) {
        const HullEdge& edge = hull.edges[e];
        if ((edge.from == v && edge.to == w) || (edge.from == w && edge.to == v)) {
            return static_cast<std::int32_t>(e);
        }
    }
    return -1;
}

/// The best plane around the nearest corners of both bodies. Gaps of eight candidates are calculated at once; a later
/// one must win by more than round-off.
class BestPlane {
 public:
    BestPlane(const PlacedHull& a, const PlacedHull& b, std::int32_t va, std::int32_t vb, double margin)
        : a_(&a),
          b_(&b),
          va_(va),
          vb_(vb),
          link_(b.centre - a.centre),
          unclear_(least_sine * norm(link_)),
          margin_(margin) {}

    /// Takes a feature; one of `edges` as the corners at the far ends of the two edges.
    void offer(const Vec3& normal, const PlaneFeature& feature) {
        x_[count_] = normal.x;
        y_[count_] = normal.y;
        z_[count_] = normal.z;
        feature_[count_] = feature;
        if (++count_ == width) {
            compare();
        }
    }
    /// Offers the one of +-direction that points from A to B, both where that cannot be told.
    void offer_axis(const Vec3& direction, const PlaneFeature& feature) {
        const Vec3 n = direction / norm(direction);
        const double along = dot(n, link_);
        if (along > -unclear_) {
            offer(n, feature);
        }
        if (along < unclear_) {
            offer(-n, feature);
        }
    }
    const CommonPlane& plane() {
        compare();
        if (plane_.feature.kind == PlaneKind::edges && !has_edges_) {
            plane_.feature.a = edge_between(*a_->topology, va_, plane_.feature.a);
            plane_.feature.b = edge_between(*b_->topology, vb_, plane_.feature.b);
            has_edges_ = true;
        }
        return plane_;
    }

 private:
    static constexpr std::size_t width = 8;
    using Lanes = Wide<double, width>;

    void compare() {
        const Lanes x = Lanes::load(x_), y = Lanes::load(y_), z = Lanes::load(z_);
        const auto along = [&](const Vec3& p) { return x * Lanes(p.x) + y * Lanes(p.y) + z * Lanes(p.z); };
        Lanes most_a = along(a_->vertices[0]), least_b = along(b_->vertices[0]);
        for (const Vec3& p : a_->vertices) {
            most_a = max(most_a, along(p));
        }
        for (const Vec3& p : b_->vertices) {
            least_b = min(least_b, along(p));
        }
        double gap[width];
        (least_b - most_a).store(gap);
        for (std::size_t i = 0; i < count_; ++i) {
            if (is_empty_ || gap[i] > plane_.gap + margin_) {
                plane_ = {{x_[i], y_[i], z_[i]}, gap[i], feature_[i], false};
                is_empty_ = false;
                has_edges_ = false;
            }
        }
        count_ = 0;
    }

    const PlacedHull *a_, *b_;
    std::int32_t va_, vb_;
    Vec3 link_;  ///< of the centres
    double unclear_, margin_;
    alignas(64) double x_[width]{}, y_[width]{}, z_[width]{};
    PlaneFeature feature_[width];
    std::size_t count_{0};
    CommonPlane plane_{};
    bool is_empty_{true}, has_edges_{false};
};

}  // namespace riprap::contact

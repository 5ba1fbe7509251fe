// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <vector>

#include "riprap/contact/narrowphase/distance_potential.hpp"

// Plain and slow: every face of every cell of the overlap is found by clipping a large square with all planes. It
// serves as the first narrowphase and as an independent check of the fast one.

namespace riprap::contact {
namespace {
struct Plane {
    Vec3 n;  // inside: n.x <= d
    double d;
};
using Polygon = std::vector<Vec3>;
Polygon polygon_on(const std::vector<Plane>& planes, std::size_t i, double size) {
    const Vec3 n = normalized(planes[i].n);
    const Vec3 c = (planes[i].d / norm(planes[i].n)) * n;
    const Vec3 u = normalized(cross(n, std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})), v = cross(n, u);
    Polygon p{c - size * u - size * v, c + size * u - size * v, c + size * u + size * v, c - size * u + size * v};
    for (std::size_t k = 0; k < planes.size() && !p.empty(); ++k) {
        if (k == i)
            continue;
        Polygon q;
        for (std::size_t a = 0; a < p.size(); ++a) {
            const Vec3 x = p[a], y = p[(a + 1) % p.size()];
            const double hx = planes[k].d - dot(planes[k].n, x), hy = planes[k].d - dot(planes[k].n, y);
            if (hx >= 0)
                q.push_back(x);
            if ((hx > 0 && hy < 0) || (hx < 0 && hy > 0))
                q.push_back(x + (hx / (hx - hy)) * (y - x));
        }
        p = q;
    }
    return p;
}
std::vector<Plane> planes_of(const geometry::ConvexView& s, const Frame& f, const Vec3& o) {
    std::vector<Plane> out;
    for (int j = 0; j < s.face_count; ++j) {
        const Vec3 n = f.axes * s.normal(j);
        out.push_back({n, s.offset[j] + dot(n, f.origin - o)});
    }
    return out;
}
struct Sum {
    Vec3 force{}, moment{}, first{}, area{};
    double zero{0}, energy{0}, depth{0}, potential{0};
};
// field of b, boundary of a
void one_side(const std::vector<Plane>& a, const std::vector<Plane>& b, const geometry::ConvexView& vb, double k,
              double size, double sign, Sum& sum) {
    for (std::size_t j = 0; j < b.size(); ++j) {
        if (vb.is_internal[j])
            continue;
        const double w = 1 / vb.inscribed_radius;
        std::vector<Plane> all = a;
        for (std::size_t l = 0; l < b.size(); ++l) {
            if (l == j) {
                all.push_back(b[j]);
                continue;
            }
            if (vb.is_internal[l]) {
                all.push_back(b[l]);
                continue;
            }
            all.push_back({b[l].n - b[j].n, b[l].d - b[j].d});
        }
        const Vec3 apex = b[j].d * b[j].n;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (norm(all[i].n) < 1e-12)
                continue;
            const Polygon p = polygon_on(all, i, size);
            if (p.size() < 3)
                continue;
            const bool on_a = i < a.size();
            const Vec3 n = normalized(all[i].n);
            for (std::size_t t = 2; t < p.size(); ++t) {
                const Vec3 x[3] = {p[0], p[t - 1], p[t]};
                const double area = 0.5 * dot(cross(x[1] - x[0], x[2] - x[0]), n);
                double phi[3], total = 0;
                Vec3 mix{};
                for (int m = 0; m < 3; ++m) {
                    phi[m] = w * (b[j].d - dot(b[j].n, x[m]));
                    total += phi[m];
                    mix += phi[m] * x[m];
                    if (on_a) {
                        sum.potential = std::max(sum.potential, phi[m]);
                        sum.depth = std::max(sum.depth, phi[m] / w);
                    }
                }
                const double integral = k * area * total / 3;
                sum.energy += 0.25 * integral * dot(x[0] - apex, n);
                if (on_a) {
                    const Vec3 X = (k * area / 12) * (total * (x[0] + x[1] + x[2]) + mix);
                    sum.force -= sign * integral * n;
                    sum.moment -= sign * cross(X, n);
                    sum.first += X;
                    sum.zero += integral;
                    if (sign > 0)
                        sum.area += area * n;
                }
            }
        }
    }
}
}  // namespace

bool find_contact(const geometry::ConvexView& a, const Frame& frame_a, double stiffness_a,
                  const geometry::ConvexView& b, const Frame& frame_b, double stiffness_b,
                  const DistancePotentialOptions&, SeparatingCache&, NormalContact& contact) {
    if (norm(frame_a.origin - frame_b.origin) > a.circumradius + b.circumradius)
        return false;
    const Vec3 o = 0.5 * (frame_a.origin + frame_b.origin);
    const auto pa = planes_of(a, frame_a, o), pb = planes_of(b, frame_b, o);
    const double size = 4 * (a.circumradius + b.circumradius);
    Sum sum;
    one_side(pa, pb, b, stiffness_b, size, 1, sum);
    one_side(pb, pa, a, stiffness_a, size, -1, sum);
    if (sum.zero <= 0 || norm(sum.force) == 0)
        return false;
    const Vec3 n = normalized(sum.force);
    const Vec3 center = sum.first / sum.zero;
    const Vec3 p0 = cross(sum.force, sum.moment) / norm_squared(sum.force);
    const Vec3 p = p0 + dot(center - p0, n) * n;
    contact.force = sum.force;
    contact.moment = sum.moment - cross(p, sum.force);
    contact.point = p + o;
    contact.area = norm(sum.area);
    contact.stiffness = contact.area * (stiffness_a / a.inscribed_radius + stiffness_b / b.inscribed_radius);
    contact.energy = sum.energy;
    contact.depth = sum.depth;
    contact.potential = sum.potential;
    contact.spin_moment = 0;
    return true;
}
}  // namespace riprap::contact

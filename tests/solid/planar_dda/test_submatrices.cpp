// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"
#include "solid/planar_dda/blocks.hpp"

namespace riprap::solid::planar_dda {
namespace {

/// First derivative of `energy` at D = 0 by central differences of a quadratic: exact but for round-off.
Unknowns slope(const std::function<double(const Unknowns&)>& energy, double h) {
    Unknowns g;
    for (std::size_t i = 0; i < 6; ++i) {
        Unknowns plus{}, minus{};
        plus[i] = h;
        minus[i] = -h;
        g[i] = (energy(plus) - energy(minus)) / (2 * h);
    }
    return g;
}

Block6 curvature(const std::function<double(const Unknowns&)>& energy, double h) {
    Block6 K;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            double sum = 0;
            for (const double si : {-1.0, 1.0}) {
                for (const double sj : {-1.0, 1.0}) {
                    Unknowns d{};
                    d[i] += si * h;
                    d[j] += sj * h;
                    sum += si * sj * energy(d);
                }
            }
            K[6 * i + j] = sum / (4 * h * h);
        }
    }
    return K;
}

void expect_near(const Block6& ours, const Block6& expected, double tolerance) {
    for (std::size_t k = 0; k < 36; ++k) {
        EXPECT_NEAR(ours[k], expected[k], tolerance) << "entry " << k / 6 << ", " << k % 6;
    }
}
void expect_near(const Unknowns& ours, const Unknowns& expected, double tolerance) {
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(ours[k], expected[k], tolerance) << "entry " << k;
    }
}

/// An L of area 3, concave, away from the origin.
const std::vector<Vec2> ell{{10, 5}, {12, 5}, {12, 6}, {11, 6}, {11, 7}, {10, 7}};

/// Integral over the L of f by midpoints of cells of side `h`, which is exact for quadratic f after the h^2/24 term.
double integrate_over_ell(const std::function<double(const Vec2&)>& f, double h) {
    double sum = 0;
    const int n = static_cast<int>(std::lround(1 / h));
    for (const Vec2 corner : {Vec2{10, 5}, Vec2{11, 5}, Vec2{10, 6}}) {
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                sum += f({corner.x + (i + 0.5) * h, corner.y + (j + 0.5) * h}) * h * h;
            }
        }
    }
    return sum;
}

TEST(PlanarDdaSubmatrices, MassIsTheIntegralOfTheDisplacementFunctions) {
    Blocks blocks;
    blocks.add(ell);
    const Vec2 center{blocks.state.x[0], blocks.state.y[0]};
    const double density = 2500;
    const auto kinetic = [&](const Unknowns& v) {
        const auto square = [&](const Vec2& p) {
            const Vec2 u = displacement_at(p - center, v);
            return 0.5 * density * dot(u, u);
        };
        const double coarse = integrate_over_ell(square, 0.5), fine = integrate_over_ell(square, 0.25);
        return fine + (fine - coarse) / 3;  // quadratic: Richardson is exact
    };
    expect_near(mass_block(blocks.model.mass[0], spread_of(blocks.model, blocks.state, 0)), curvature(kinetic, 1),
                1e-8);
}

TEST(PlanarDdaSubmatrices, MassFollowsAStretchedAndTurnedBlock) {
    Blocks blocks;
    blocks.add(ell);
    State& state = blocks.state;
    state.angle[0] = 0.7;
    state.stretch_xx[0] = 1.1;
    state.stretch_yy[0] = 0.9;
    state.stretch_xy[0] = 0.05;
    std::vector<Vec2> corners;
    place_corners(blocks.model, state, corners);
    const geometry::PolygonMoments moments = geometry::moments_of(corners);
    const Spread spread = spread_of(blocks.model, state, 0);
    EXPECT_NEAR(spread.xx, moments.xx / moments.area, 1e-13);
    EXPECT_NEAR(spread.yy, moments.yy / moments.area, 1e-13);
    EXPECT_NEAR(spread.xy, moments.xy / moments.area, 1e-13);
    EXPECT_NEAR(volume_of(blocks.model, state, 0), moments.area, 1e-13);
    EXPECT_NEAR(moments.centroid.x, state.x[0], 1e-13);
}

TEST(PlanarDdaSubmatrices, StrainAndStressEnergyGiveStiffnessAndForce) {
    for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
        const Elasticity e = elasticity_of({8e3, 0.3}, plane);
        const Stress before{30, -20, 7};
        const double volume = 2.5;
        const auto energy = [&](const Unknowns& d) {
            const Stress s = stress_of(e, d);
            return volume * (0.5 * (s.x * d[3] + s.y * d[4] + s.xy * d[5]) + before.x * d[3] + before.y * d[4] +
                             before.xy * d[5]);
        };
        expect_near(elastic_block(e, volume), curvature(energy, 1), 1e-9);
        Unknowns force = slope(energy, 1);
        for (double& f : force) {
            f = -f;
        }
        expect_near(stress_force(before, volume), force, 1e-9);
        // the energy of a stress is the one stored on the way to it
        const Unknowns d{0, 0, 0, 0.01, -0.02, 0.03};
        const Stress s = stress_of(e, d);
        EXPECT_NEAR(energy_density(e, s), 0.5 * (s.x * d[3] + s.y * d[4] + s.xy * d[5]), 1e-12 * 8e3);
    }
}

TEST(PlanarDdaSubmatrices, PlaneStressAndStrainGiveTheTextbookModuli) {
    const double E = 2e5, nu = 0.3;
    const auto pulled = [&](PlaneState plane) {  // stiffness along x with free sides
        const Elasticity e = elasticity_of({E, nu}, plane);
        return e.direct - e.cross * e.cross / e.direct;
    };
    EXPECT_NEAR(pulled(PlaneState::stress), E, 1e-9 * E);
    EXPECT_NEAR(pulled(PlaneState::strain), E / (1 - nu * nu), 1e-9 * E);
}

TEST(PlanarDdaSubmatrices, MaterialIsIsotropic) {
    for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
        const Elasticity e = elasticity_of({2e5, 0.3}, plane);
        // a pure shear is a stretch and a squeeze at 45 degrees: gamma = 2 eps stores the same energy
        const double eps = 1e-3;
        const Stress sheared = stress_of(e, {0, 0, 0, 0, 0, 2 * eps}),
                     stretched = stress_of(e, {0, 0, 0, eps, -eps, 0});
        EXPECT_NEAR(energy_density(e, sheared), energy_density(e, stretched), 1e-12);
        EXPECT_NEAR(sheared.xy, stretched.x, 1e-9);
    }
}

TEST(PlanarDdaSubmatrices, AFixedPointPullsWithTheGradientOfItsEnergy) {
    const Vec2 r{0.3, -0.8}, gap{0.02, 0.05};
    const double p = 7;
    const auto energy = [&](const Unknowns& d) {
        const Vec2 rest = gap - displacement_at(r, d);
        return 0.5 * p * dot(rest, rest);
    };
    expect_near(fixed_point_block(r, p), curvature(energy, 1), 1e-12);
    Unknowns force = force_at(r, p * gap);
    const Unknowns gradient = slope(energy, 1);
    add(force, 1, gradient);
    expect_near(force, Unknowns{}, 1e-12);
}

/// A corner near an edge; the blocks turn and strain about their centroids.
struct Pair {
    CornerAndEdge w{{1.02, 0.9}, {2, 1}, {0.1, 1.3}, {1.2, 0.2}, {0.9, 1.9}};

    CornerAndEdge moved(const Unknowns& da, const Unknowns& db) const {
        CornerAndEdge m = w;
        m.corner += displacement_at(w.corner - w.corner_center, da);
        m.begin += displacement_at(w.begin - w.edge_center, db);
        m.end += displacement_at(w.end - w.edge_center, db);
        return m;
    }
    /// Twice the area over the length of the start: what DDA calls the gap.
    double frozen_gap(const Unknowns& da, const Unknowns& db) const {
        const CornerAndEdge m = moved(da, db);
        return cross(m.end - m.corner, m.begin - m.corner) / norm(w.begin - w.end);
    }
    double frozen_slip(const Unknowns& da, const Unknowns& db, double lock) const {
        const CornerAndEdge m = moved(da, db);
        const Vec2 point = (1 - lock) * m.end + lock * m.begin;
        return dot(m.corner - point, m.begin - m.end) / norm(w.begin - w.end);
    }
};

TEST(PlanarDdaSubmatrices, GapAndSlipHaveTheDerivativesOfTheirGeometry) {
    const Pair pair;
    const double lock = 0.3, h = 1e-6;
    const Linear gap = gap_of(pair.w), slip = slip_of(pair.w, lock);
    EXPECT_NEAR(gap.value, pair.frozen_gap({}, {}), 1e-15);
    EXPECT_NEAR(slip.value, pair.frozen_slip({}, {}, lock), 1e-15);
    const Unknowns zero{};
    expect_near(gap.a, slope([&](const Unknowns& d) { return pair.frozen_gap(d, zero); }, h), 1e-9);
    expect_near(gap.b, slope([&](const Unknowns& d) { return pair.frozen_gap(zero, d); }, h), 1e-9);
    expect_near(slip.a, slope([&](const Unknowns& d) { return pair.frozen_slip(d, zero, lock); }, h), 1e-9);
    expect_near(slip.b, slope([&](const Unknowns& d) { return pair.frozen_slip(zero, d, lock); }, h), 1e-9);
}

TEST(PlanarDdaSubmatrices, ContactForcesHaveNeitherResultantNorMoment) {
    const Pair pair;
    for (const Linear& length : {gap_of(pair.w), slip_of(pair.w, 0.3)}) {
        EXPECT_NEAR(length.a[0] + length.b[0], 0, 1e-15);
        EXPECT_NEAR(length.a[1] + length.b[1], 0, 1e-15);
        const auto moment = [](const Vec2& center, const Unknowns& f) {
            return f[2] + center.x * f[1] - center.y * f[0];
        };
        EXPECT_NEAR(moment(pair.w.corner_center, length.a) + moment(pair.w.edge_center, length.b), 0, 1e-14);
    }
}

TEST(PlanarDdaSubmatrices, ABoltPullsAlongItsLine) {
    const Vec2 first{0, 0}, second{3, 4}, first_center{-1, 0.5}, second_center{3.5, 5};
    const Linear length = length_of(first, first_center, second, second_center);
    EXPECT_DOUBLE_EQ(length.value, 5);
    const auto exact = [&](const Unknowns& da, const Unknowns& db) {
        return norm(second + displacement_at(second - second_center, db) - first -
                    displacement_at(first - first_center, da));
    };
    const Unknowns zero{};
    expect_near(length.a, slope([&](const Unknowns& d) { return exact(d, zero); }, 1e-6), 1e-9);
    expect_near(length.b, slope([&](const Unknowns& d) { return exact(zero, d); }, 1e-6), 1e-9);
}

TEST(PlanarDdaSubmatrices, ALoadWorksByItsForceTorqueAndPull) {
    const Vec2 r{0.4, -1.1}, f{3, 5};
    const Unknowns d{0.1, -0.2, 0.3, 0.05, -0.07, 0.02};
    EXPECT_NEAR(dot(force_at(r, f), d), dot(f, displacement_at(r, d)), 1e-15);
}

TEST(PlanarDdaSubmatrices, PressureSplitToTheCornersOfAnEdgeIsPressureAtItsPlaces) {
    // The share of a corner is that of the distance to the other one [Ding2021, eq. 3.27].
    const Vec2 first{0.4, -1.1}, second{-0.8, 0.7}, normal{-0.6, 0.8};
    Unknowns at_corners{}, at_nodes{};
    for (int i = 0; i < 7; ++i) {
        const double share = (i + 0.5) / 7;
        const Vec2 force = (1000.0 + 300 * i * i) * normal;
        const Unknowns node = force_at(first + share * (second - first), force);
        const Unknowns one = force_at(first, (1 - share) * force), other = force_at(second, share * force);
        for (std::size_t k = 0; k < 6; ++k) {
            at_nodes[k] += node[k];
            at_corners[k] += one[k] + other[k];
        }
    }
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(at_corners[k], at_nodes[k], 1e-13 * std::abs(at_nodes[1])) << k;
    }
}

}  // namespace
}  // namespace riprap::solid::planar_dda

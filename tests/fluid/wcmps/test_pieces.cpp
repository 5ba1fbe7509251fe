// SPDX-License-Identifier: Apache-2.0
// Pieces that scenes of moving particles rest on, each beside its exact answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "riprap/fluid/mps_operators/collision.hpp"
#include "riprap/fluid/mps_operators/mps_weight.hpp"
#include "riprap/fluid/wcmps/wcmps.hpp"

namespace riprap {
namespace {

constexpr fluid::MpsWeightLaw published = fluid::MpsWeightLaw::reciprocal;

/// A lattice of spacing 1 m and its constants, by summing over it apart from the program.
struct Lattice {
    int dimension;
    double support;  ///< r_e/l_0 [-]
    double number_density, lambda;
    int neighbours;
};
constexpr std::array lattices{Lattice{2, 2.1, 6.539697, 1.388351, 12}, Lattice{2, 3.1, 18.976417, 2.448472, 28},
                              Lattice{3, 2.1, 14.418575, 1.701738, 32}, Lattice{3, 3.1, 54.321209, 3.243422, 122}};

/// Calls visit(d, W) for every neighbour of the particle at the origin of a lattice of spacing 1 m.
template <class Visit>
void for_neighbours(const Lattice& lattice, const Visit& visit) {
    const fluid::MpsWeight weight(lattice.support, 1.0, published);
    const int reach = static_cast<int>(lattice.support), depth = lattice.dimension == 3 ? reach : 0;
    for (int k = -depth; k <= depth; ++k) {
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) {
                const Vec3 d{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                if (const double w = weight.value(norm_squared(d)); w > 0) {
                    visit(d, w);
                }
            }
        }
    }
}

/// Constants of four lattices [Mellado2021, 5.2]; gradient of g.x and Laplacian of x.x by eqs. 5.8 and 5.11.
TEST(MpsLattice, HasTheConstantsOfASumAndTakesLinearAndSquareFieldsExactly) {
    double density = 0, lambda = 0, count = 0, slope = 0, curvature = 0;
    for (const Lattice& expected : lattices) {
        const fluid::MpsLattice ours = fluid::mps_lattice(published, expected.support, 1.0, expected.dimension);
        density = std::max(density, std::abs(ours.number_density / expected.number_density - 1));
        lambda = std::max(lambda, std::abs(ours.lambda / expected.lambda - 1));
        count = std::max(count, std::abs(ours.neighbours - expected.neighbours));
        const Vec3 given{0.3, -0.7, expected.dimension == 3 ? 0.2 : 0};
        Vec3 gradient{};
        double laplacian = 0;
        for_neighbours(expected, [&](const Vec3& d, double w) {
            gradient += (ours.first_order() * dot(given, d) * w / norm_squared(d)) * d;
            laplacian += ours.second_order() * norm_squared(d) * w;
        });
        slope = std::max(slope, norm(gradient - given) / norm(given));
        curvature = std::max(curvature, std::abs(laplacian / (2 * expected.dimension) - 1));
    }
    EXPECT_LE(density, 1e-6);
    EXPECT_LE(lambda, 1e-6);
    EXPECT_LE(count, 1e-6);
    EXPECT_LE(slope, 1e-12);
    EXPECT_LE(curvature, 1e-12);
}

fluid::WcmpsSettings settings_of(int dimension) {
    fluid::WcmpsSettings settings;
    settings.spacing = 0.02;
    settings.sound_speed = 20;
    settings.weight_law = published;
    settings.wall_pressure = fluid::MpsWallPressure::mirrored;
    settings.particle_mass = settings.rest_density * std::pow(settings.spacing, dimension);
    settings.domain = {{0, 0, 0}, {0.2, 0.2, 0.2}, {true, true, dimension == 3}, dimension};
    return settings;
}

/// A disordered periodic cloud, summed in double: what a step changes of its momentum.
double momentum_gap(int dimension) {
    fluid::WcmpsSettings settings = settings_of(dimension);
    settings.is_plain = true;
    std::mt19937_64 bits(5);
    const auto shake = [&] { return 0.25 * (static_cast<double>(bits() >> 11) * 0x1p-52 - 1); };
    fluid::ParticleState state;
    for (int k = 0; k < (dimension == 3 ? 10 : 1); ++k) {
        for (int j = 0; j < 10; ++j) {
            for (int i = 0; i < 10; ++i) {
                const Vec3 x{i + 0.5 + shake(), j + 0.5 + shake(), dimension == 3 ? k + 0.5 + shake() : 0};
                const double pressure = 1000 * shake();
                state.add(settings.spacing * x, {}, settings.rest_density * fluid::concentration_of(settings, pressure),
                          static_cast<std::int32_t>(state.size()));
            }
        }
    }
    fluid::BoundaryParticles none;
    fluid::Wcmps scheme(settings);
    fluid::ParticleReport report;
    const TimeSpan span{0, scheme.limit(state).limit};
    scheme.update_density(state, none, {}, span.dt, report);
    scheme.begin_forces(state, none, span, {}, report);
    scheme.load_walls(state, none, {});
    scheme.kick(state, none, {}, span, {}, report);
    Vec3 sum{};
    double moved = 0;
    for (const Vec3& v : state.velocity) {
        sum += v;
        moved += norm(v);
    }
    return norm(sum) / moved;
}

TEST(WcmpsPieces, ForcesOnADisorderedCloudMakeNoMomentum) {
    EXPECT_LE(momentum_gap(2), 1e-12);
    EXPECT_LE(momentum_gap(3), 1e-12);
}

TEST(WcmpsPieces, TheEquationOfStateAndItsInverseAgree) {
    const fluid::WcmpsSettings settings = settings_of(2);
    for (double x = 0.98; x < 1.05; x += 0.001) {
        EXPECT_NEAR(fluid::concentration_of(settings, fluid::pressure_of(settings, x)) / x, 1, 1e-12);
    }
}

// A pair alone, as two particles of the surface meet: on its way at 1.5 m/s, ratio 0.5.
TEST(WcmpsPieces, ACollidingPairKeepsItsMomentumAndPartsByItsRatio) {
    const fluid::WcmpsSettings settings = settings_of(2);
    const fluid::MpsCollision pair{0.9 * 0.9, 1e-8};
    const double share = 0.5 * (1 + settings.collision_ratio);
    const double a[4] = {1, 0.3, 0, share}, b[4] = {-0.5, 0.1, 0, share}, d[3] = {-0.8, 0, 0};
    double change_a[3]{}, change_b[3]{};
    pair.exchange<2>(a, b, d, 0.64, 0.8, change_a, change_b);
    EXPECT_NEAR((change_a[0] + change_b[0]) / change_b[0], 0, 1e-12);
    EXPECT_NEAR(((b[0] + change_b[0]) - (a[0] + change_a[0])) / 1.5, settings.collision_ratio, 1e-6);
}

}  // namespace
}  // namespace riprap

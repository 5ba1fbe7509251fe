// SPDX-License-Identifier: Apache-2.0
// What dashpots take is what the bodies lose, at every step: linear springs, whose energy leapfrog keeps to round-off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/multisphere.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"

namespace riprap::solid::sphere_dem {
namespace {

constexpr double radius = 0.01, mass = 0.01;  // [m], [kg]

SphereWorld world_of(double restitution, double friction = 0) {
    SphereWorld world;
    world.settings.normal = contact::NormalLaw::linear;
    world.add_material({.restitution = restitution,
                        .static_friction = friction,
                        .kinetic_friction = friction,
                        .normal_stiffness = 1e4,
                        .shear_ratio = 0.8});
    return world;
}

struct Books {
    double miss{0};   ///< of the energy at the first kick, while the same spheres touch: largest sum of steps [-]
    double taken{0};  ///< by dashpots, over the same energy [-]
    int touching{0};  ///< steps of which the sum is made
};

/// Steps at a tenth of what is stable, so that an impact takes some hundred steps. A contact that begins or ends within
/// a step does so with an overlap that no kick has seen: only steps between two kicks with the same contacts count.
Books books_of(SphereWorld& world, int steps) {
    const double dt = 0.1 * world.step_limit();
    world.step(dt);
    const double scale = world.report.kick.kinetic;
    Books books;
    double sum = 0;
    for (int step = 0; step < steps; ++step) {
        const auto spheres = world.contacts.contacts.pair, walls = world.contacts.walls.pair;
        const double before = world.energy_account();
        world.step(dt);
        if (world.report.contact_count > 0 && world.contacts.contacts.pair == spheres &&
            world.contacts.walls.pair == walls) {
            sum += (world.energy_account() - before) / scale;
            books.miss = std::max(books.miss, std::abs(sum));
            ++books.touching;
        }
    }
    books.taken = world.contacts.damping_loss / scale;
    return books;
}

// With a velocity halfway that is foreseen from the dashpot alone, spring and weight left out, this missed more.
TEST(Dashpots, TakeFromABouncingBallWhatItLosesAtEveryStep) {
    for (const double restitution : {0.2, 0.5, 0.9}) {
        SphereWorld world = world_of(restitution);
        world.add_plane(MaterialId{0}, {0, 0, 1}, {});
        world.add_sphere(MaterialId{0}, radius, mass, {{{0, 0, 1.01 * radius}, {}}, {0, 0, -1}, {}});
        world.gravity = {0, 0, -9.81};
        world.build();
        const Books books = books_of(world, 4000);
        EXPECT_GT(books.touching, 100);
        EXPECT_LT(books.miss, 1e-9) << restitution;
        EXPECT_GT(books.taken, 0.9 * (1 - restitution * restitution)) << restitution;
    }
}

TEST(Dashpots, TakeFromARowOfBallsWhatItLosesAtEveryStep) {
    SphereWorld world = world_of(0.4);
    for (int k = 0; k < 4; ++k) {
        world.add_sphere(MaterialId{0}, radius, (1 + k) * mass,
                         {{{2.001 * radius * k, 0, 0}, {}},
                          {k == 0   ? 2.0
                           : k == 3 ? -1.0
                                    : 0.0,
                           0, 0},
                          {}});
    }
    world.build();
    const Books books = books_of(world, 4000);
    EXPECT_GT(books.touching, 100);
    EXPECT_LT(books.miss, 1e-9);
    EXPECT_GT(books.taken, 0.2);
}

// Several contacts of one pair of bodies, which share the dashpots of one.
TEST(Dashpots, TakeFromABodyThatLandsOnThreeOfItsSpheresWhatItLosesAtEveryStep) {
    SphereWorld world = world_of(0.3);
    world.add_plane(MaterialId{0}, {0, 0, 1}, {});
    body::Multisphere tripod;
    for (int k = 0; k < 3; ++k) {
        const double angle = 2 * M_PI * k / 3;
        tripod.spheres.push_back({{2 * radius * std::cos(angle), 2 * radius * std::sin(angle), 0}, radius});
    }
    world.add_multisphere(MaterialId{0}, tripod, 2000, {{{0, 0, 1.01 * radius}, {}}, {0, 0, -0.5}, {}});
    world.gravity = {0, 0, -9.81};
    world.build();
    const Books books = books_of(world, 4000);
    EXPECT_GT(books.touching, 100);
    EXPECT_LT(books.miss, 1e-9);
    EXPECT_GT(books.taken, 0.5);
}

// A disc that spins and hits a wall aslant: the arm of the rub changes with the overlap, to second order.
TEST(Dashpots, TakeFromASpinningDiscThatSticksWhatItLoses) {
    SphereWorld world = world_of(0.5, 50);
    world.add_plane(MaterialId{0}, {0, 1, 0}, {});
    world.bodies.is_planar = true;
    world.add_disc(MaterialId{0}, radius, mass, {{{0, 1.001 * radius, 0}, {}}, {0.3, -0.5, 0}, {0, 0, 20}});
    world.build();
    const Books books = books_of(world, 4000);
    EXPECT_GT(books.touching, 100);
    EXPECT_LT(books.miss, 2e-4);
    EXPECT_GT(books.taken, 0.3);
}

}  // namespace
}  // namespace riprap::solid::sphere_dem

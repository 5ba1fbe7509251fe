// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/spheres_scene.hpp"

#include <cmath>
#include <random>

#include "riprap/core/error.hpp"

namespace riprap::bench {

namespace {

using solid::sphere_dem::SphereWorld;

constexpr double diameter = 0.01, density = 2500;
constexpr int columns = 22, layers = 21;

double lattice_spacing() { return diameter * std::cbrt(M_PI / 6 / 0.34); }

/// Walls about `tiles_x` by `tiles_y` beds, material and gravity; spheres come after.
MaterialId add_box(SphereWorld& world, int tiles_x, int tiles_y) {
    const MaterialId glass =
        world.add_material({.youngs_modulus = 5e6, .poisson_ratio = 0.3, .restitution = 0.3, .static_friction = 0.5});
    const double side = columns * lattice_spacing();
    world.add_plane(glass, {0, 0, 1}, {});
    world.add_plane(glass, {1, 0, 0}, {});
    world.add_plane(glass, {-1, 0, 0}, {side * tiles_x, 0, 0});
    world.add_plane(glass, {0, 1, 0}, {});
    world.add_plane(glass, {0, -1, 0}, {0, side * tiles_y, 0});
    world.gravity = {0, 0, -9.81};
    return glass;
}

void add_sphere(SphereWorld& world, MaterialId material, const Vec3& place) {
    world.add_sphere(material, 0.5 * diameter, density * M_PI / 6 * std::pow(diameter, 3), {{place, {}}, {}, {}});
}

/// One bed, poured and settled; made once and kept.
const std::vector<Vec3>& settled_places() {
    static const std::vector<Vec3> places = [] {
        SphereWorld world;
        const MaterialId glass = add_box(world, 1, 1);
        const double spacing = lattice_spacing();
        std::mt19937_64 bits(11);
        const auto jitter = [&] { return 0.07 * diameter * (static_cast<double>(bits() >> 11) * 0x1p-52 - 1); };
        for (int k = 0; k < layers; ++k) {
            for (int j = 0; j < columns; ++j) {
                for (int i = 0; i < columns; ++i) {
                    const Vec3 at_rest{(i + 0.5) * spacing, (j + 0.5) * spacing, (k + 0.5) * spacing};
                    add_sphere(world, glass, at_rest + Vec3{jitter(), jitter(), jitter()});
                }
            }
        }
        world.settings.mass_damping = 4;
        world.build();
        const auto run_to = [&](double end) {
            while (world.time < end) {
                const auto report = world.step(sphere_bed_dt);
                if (!report.problem.empty()) {
                    throw InternalError("the bed of spheres: " + report.problem);
                }
            }
        };
        run_to(0.45);
        world.settings.mass_damping = 0;
        run_to(0.55);
        return std::vector<Vec3>(world.state.position.begin() + 5, world.state.position.end());
    }();
    return places;
}

}  // namespace

SphereWorld sphere_bed(int tiles_x, int tiles_y) {
    SphereWorld world;
    const MaterialId glass = add_box(world, tiles_x, tiles_y);
    const double side = columns * lattice_spacing();
    for (int j = 0; j < tiles_y; ++j) {
        for (int i = 0; i < tiles_x; ++i) {
            for (const Vec3& place : settled_places()) {
                add_sphere(world, glass, place + Vec3{i * side, j * side, 0});
            }
        }
    }
    world.build();
    return world;
}

}  // namespace riprap::bench

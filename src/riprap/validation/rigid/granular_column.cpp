// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/geometry/random_bits.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "riprap/validation/rigid/cases.hpp"

namespace riprap::validation::rigid {

namespace {

using solid::sphere_dem::SphereWorld;

constexpr double gravity = 9.81, diameter = 0.005, radius = 0.5 * diameter;
constexpr double mass = 2500 * M_PI / 6 * diameter * diameter * diameter;  ///< [kg]
constexpr double solid_fraction = 0.58;                                    ///< of a loose bed, to choose its size by

/// One column: a cylinder about z, or a block of `width` in a channel along x.
struct Column {
    bool is_round;
    double aspect;    ///< a, height over radius or over length
    double base;      ///< r_0 or x_0 [m]
    double width{0};  ///< of the channel [m]
    double height() const { return aspect * base; }
};

/// The base that `count` grains make a column of.
Column column_of(bool is_round, double aspect, int count) {
    const double volume = count * M_PI / 6 * diameter * diameter * diameter / solid_fraction;
    if (is_round) {
        return {true, aspect, std::cbrt(volume / (M_PI * aspect))};
    }
    const double width = 10 * diameter;
    return {false, aspect, std::sqrt(volume / (aspect * width)), width};
}

struct Materials {
    MaterialId grain, smooth;
};

/// Sand-like grains, and a wall without friction.
Materials add_materials(SphereWorld& world) {
    world.settings.rolling = contact::RollingLaw::spring;
    world.gravity = {0, 0, -gravity};
    contact::ContactMaterial grain{.youngs_modulus = 3e6, .restitution = 0.5, .static_friction = 0.5};
    grain.rolling_friction = 0.1;
    contact::ContactMaterial smooth{.youngs_modulus = 3e6, .restitution = 0.5, .static_friction = 0};
    world.mixing.friction = material::Mixing::minimum;
    world.mixing.restitution = material::Mixing::minimum;
    return {world.add_material(grain), world.add_material(smooth)};
}

/// Walls of a box between `low` and `high` in x and y, those along y without friction where it is a channel.
void add_box(SphereWorld& world, const Materials& materials, const Vec3& low, const Vec3& high) {
    world.add_plane(materials.grain, {0, 0, 1}, {});
    world.add_plane(materials.smooth, {1, 0, 0}, low);
    world.add_plane(materials.smooth, {-1, 0, 0}, high);
    world.add_plane(materials.smooth, {0, 1, 0}, low);
    world.add_plane(materials.smooth, {0, -1, 0}, high);
}

double uniform(std::uint64_t& number) { return geometry::unit_interval(geometry::mix_bits(11, number++)) - 0.5; }

/// Places of grains that fell into a box and came to rest, more than the column needs.
std::vector<Vec3> settled_bed(const Column& column) {
    SphereWorld world;
    const Materials materials = add_materials(world);
    const Vec3 low = column.is_round ? Vec3{-column.base, -column.base, 0} : Vec3{0, 0, 0};
    const Vec3 high = column.is_round ? Vec3{column.base, column.base, 0} : Vec3{column.base, column.width, 0};
    add_box(world, materials, low, high);
    const auto walls = static_cast<std::size_t>(world.bodies.size());
    const double pitch = 1.1 * diameter, lattice_fraction = M_PI / 6 / std::pow(1.1, 3);
    const double top = 1.15 * column.height() * solid_fraction / lattice_fraction;
    std::uint64_t number = 1;
    const auto columns = [&](double length) { return std::max(1, static_cast<int>(length / pitch)); };
    const int nx = columns(high.x - low.x), ny = columns(high.y - low.y);
    for (double z = pitch; z < top; z += pitch) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const Vec3 cell{low.x + (i + 0.5) * (high.x - low.x) / nx, low.y + (j + 0.5) * (high.y - low.y) / ny,
                                z};
                const Vec3 shift = 0.08 * diameter * Vec3{uniform(number), uniform(number), uniform(number)};
                world.add_sphere(materials.grain, radius, mass, {{cell + shift, {}}, {}, {}});
            }
        }
    }
    world.build();
    world.settings.mass_damping = 0.5 / std::sqrt(diameter / gravity);
    const double end = 4 * std::sqrt(2 * top / gravity);
    const double dt = world.step_limit();
    while (world.time < end) {
        world.step(dt);
    }
    return {world.state.position.begin() + static_cast<std::ptrdiff_t>(walls), world.state.position.end()};
}

/// Distance from the axis, or from the back wall of the channel [m].
double distance(const Column& column, const Vec3& x) { return column.is_round ? std::hypot(x.x, x.y) : x.x; }

/// Edge of the deposit: the first ring or strip, a diameter wide, of which grains cover less than half [m].
double edge_of(const Column& column, const std::vector<Vec3>& places) {
    std::vector<double> covered;
    for (const Vec3& x : places) {
        const auto bin = static_cast<std::size_t>(std::max(0.0, distance(column, x) / diameter));
        covered.resize(std::max(covered.size(), bin + 1));
        covered[bin] += M_PI / 4 * diameter * diameter;
    }
    for (std::size_t bin = 0; bin < covered.size(); ++bin) {
        const auto b = static_cast<double>(bin);
        const double area = column.is_round ? M_PI * (2 * b + 1) * diameter * diameter : column.width * diameter;
        if (covered[bin] < 0.5 * area) {
            return b * diameter;
        }
    }
    return static_cast<double>(covered.size()) * diameter;
}

struct Collapse {
    std::size_t grains;
    double run_out;         ///< (r - r_0)/r_0 [-]
    double moving;          ///< share of the first potential energy that is kinetic at the end [-]
    std::vector<Vec3> end;  ///< places [m]
};

/// Carves the column out of a settled bed, takes its walls away and waits until it lies.
Collapse collapse(const Column& column) {
    std::vector<Vec3> bed = settled_bed(column);
    std::erase_if(bed, [&](const Vec3& x) {
        return x.z > column.height() - radius || (column.is_round && distance(column, x) > column.base - radius);
    });
    SphereWorld world;
    const Materials materials = add_materials(world);
    world.add_plane(materials.grain, {0, 0, 1}, {});
    if (!column.is_round) {
        world.add_plane(materials.smooth, {1, 0, 0}, {});
        world.add_plane(materials.smooth, {0, 1, 0}, {});
        world.add_plane(materials.smooth, {0, -1, 0}, {0, column.width, 0});
    }
    const auto walls = world.bodies.size();
    for (const Vec3& x : bed) {
        world.add_sphere(materials.grain, radius, mass, {{x, {}}, {}, {}});
    }
    world.build();
    const double start = edge_of(column, bed), dt = world.step_limit();
    const double end = 4 * std::sqrt(2 * column.height() / gravity) + 0.2;
    while (world.time < end) {
        world.step(dt);
    }
    double kinetic = 0;
    for (const Vec3& v : world.state.velocity) {
        kinetic += 0.5 * mass * norm_squared(v);
    }
    const double potential = static_cast<double>(bed.size()) * mass * gravity * 0.5 * column.height();
    std::vector<Vec3> places(world.state.position.begin() + static_cast<std::ptrdiff_t>(walls),
                             world.state.position.end());
    return {bed.size(), edge_of(column, places) / start - 1, kinetic / potential, std::move(places)};
}

/// Run-out measured by Lube et al. (2004: round; 2005: channel).
double measured(bool is_round, double a) {
    if (is_round) {
        return a < 1.7 ? 1.24 * a : 1.6 * std::sqrt(a);
    }
    return a < 2.3 ? 1.2 * a : 1.9 * std::cbrt(a * a);
}

}  // namespace

void granular_column(const CaseSetting& setting, CaseReport& report) {
    const int count = setting.is_full ? 20000 : 5000;
    for (const bool is_round : {true, false}) {
        Plot plot;
        plot.title = is_round ? "Collapse of a round column of grains" : "Collapse of a column of grains in a channel";
        plot.x = {"height over base a [-]", true};
        plot.y = {"run-out over base [-]", true};
        Curve theory{"Lube et al.", {}, {}, CurveStyle::line, 0}, ours{"ours", {}, {}, CurveStyle::markers, 0};
        for (const double a : {0.5, 1.0, 2.0, 4.0}) {
            const Column column = column_of(is_round, a, count);
            const Collapse found = collapse(column);
            const double reference = measured(is_round, a);
            report.judge({fmt::format("{}, a = {}: run-out over base", is_round ? "round" : "channel", a),
                          "-",
                          reference,
                          {},
                          fmt::format("{} grains; kinetic energy at the end {:.1e} of the potential energy",
                                      found.grains, found.moving)},
                         found.run_out, 0.85 * reference, 1.15 * reference);
            theory.x.push_back(a);
            theory.y.push_back(reference);
            ours.x.push_back(a);
            ours.y.push_back(found.run_out);
        }
        plot.curves = {theory, ours};
        write_plot(setting, is_round ? "granular_column_round" : "granular_column_channel", plot);
    }
}

}  // namespace riprap::validation::rigid

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>

#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "riprap/validation/mellado/cases.hpp"

namespace riprap::validation::mellado {

namespace {

using solid::sphere_dem::SphereWorld;

constexpr double width = 0.26, diameter = 0.01, length = 0.099, density = 2700;

/// 33 cylinders in six rows 6-5-6-5-6-5 in the corner of a tank [Mellado2021, 4.6.2], every one moved by up to 5 um.
struct Stack {
    bool is_ring{false};  ///< rings of 59 spheres of 0.5 mm for smooth discs
    contact::SphereNormals normals{contact::SphereNormals::centres};
    unsigned seed{1};
};

SphereWorld make_stack(const Stack& stack) {
    SphereWorld world;
    const double restitution = 0.74;  // contact ratio 0.1
    const MaterialId pvc = world.add_material(
        {.youngs_modulus = 3e9, .poisson_ratio = 0.3, .restitution = restitution, .static_friction = 0.45});
    const MaterialId aluminium = world.add_material(
        {.youngs_modulus = 69e9, .poisson_ratio = 0.3, .restitution = restitution, .static_friction = 0.45});
    world.bodies.is_planar = true;
    world.add_plane(pvc, {0, 1, 0}, {});
    world.add_plane(pvc, {1, 0, 0}, {});
    world.add_plane(pvc, {-1, 0, 0}, {width, 0, 0});
    std::mt19937_64 bits(stack.seed);
    const auto jitter = [&] { return 5e-6 * (static_cast<double>(bits() >> 11) * 0x1p-52 - 1); };
    const double mass = density * M_PI * 0.25 * diameter * diameter * length;
    const body::Multisphere ring = body::ring(0.5 * diameter, 0.00025, 59, length).value();
    for (int row = 0; row < 6; ++row) {
        const int count = row % 2 == 0 ? 6 : 5;
        for (int k = 0; k < count; ++k) {
            const double x = 0.005 + 0.01 * k + (row % 2 == 0 ? 0 : 0.005), y = 0.005 + 0.00866025 * row;
            const Vec3 place{x + jitter(), y + jitter(), 0};
            if (stack.is_ring) {
                world.add_multisphere(aluminium, ring, density, {{place, {}}, {}, {}});
            } else {
                world.add_disc(aluminium, 0.5 * diameter, mass, {{place, {}}, {}, {}});
            }
        }
    }
    world.gravity = {0, -9.81, 0};
    world.settings.normals = stack.normals;
    world.build();
    return world;
}

constexpr std::array times{0.1, 0.3, 0.5};

/// Mean centre of the cylinders over the width of the tank at `times`: x, then y.
using Means = std::array<std::array<double, 2>, 3>;

Means collapse(const Stack& stack, const CaseSetting& setting, Curve* picture) {
    SphereWorld world = make_stack(stack);
    const double dt = 2e-6;
    Means means{};
    for (std::size_t k = 0; k < times.size(); ++k) {
        while (world.time < times[k] - 0.5 * dt) {
            const auto report = world.step(dt);
            if (!report.problem.empty()) {
                throw std::runtime_error(report.problem);
            }
            if (setting.after_step && static_cast<std::int64_t>(world.time / dt) % 1000 == 0) {
                setting.after_step(world.time, times.back());
            }
        }
        Vec3 sum{};
        for (std::size_t b = 3; b < 36; ++b) {
            sum += world.state.position[b];
        }
        means[k] = {sum.x / 33 / width, sum.y / 33 / width};
    }
    for (std::size_t b = 3; picture != nullptr && b < 36; ++b) {
        picture->x.push_back(world.state.position[b].x);
        picture->y.push_back(world.state.position[b].y);
    }
    return means;
}

/// Means over several jittered runs, beside the experiment [ZhangKuwabara2009].
void judge_runs(const std::string& name, Stack stack, unsigned runs, const CaseSetting& setting, CaseReport& report) {
    constexpr std::array measured{std::array{0.1350, 0.0920}, std::array{0.2128, 0.0585}, std::array{0.3077, 0.0403}};
    Means mean{}, low{}, high{};
    for (unsigned seed = 1; seed <= runs; ++seed) {
        stack.seed = seed;
        const Means one = collapse(stack, setting, nullptr);
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                mean[k][axis] += one[k][axis] / runs;
                low[k][axis] = seed == 1 ? one[k][axis] : std::min(low[k][axis], one[k][axis]);
                high[k][axis] = seed == 1 ? one[k][axis] : std::max(high[k][axis], one[k][axis]);
            }
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::string what =
                fmt::format("{}, {} at {} s over the width", name, axis == 0 ? "x" : "y", times[k]);
            const std::string note =
                fmt::format("mean of {} jittered runs, {:.4f} to {:.4f}", runs, low[k][axis], high[k][axis]);
            const double must = axis == 0 ? 0.035 : 0.012, beyond = axis == 0 ? 0.015 : 0.006;
            const double value = mean[k][axis], m = measured[k][axis];
            report.judge({what, "-", m, {}, note}, value, m - must, m + must);
            report.judge({what + ", beyond the source", "-", m, {}, note}, value, m - beyond, m + beyond);
        }
    }
}

}  // namespace

void cylinders(const CaseSetting& setting, CaseReport& report) {
    judge_runs("smooth discs", {}, setting.is_full ? 10 : 5, setting, report);
    judge_runs("rings, normals of their round side", {true, contact::SphereNormals::faces, 1}, 5, setting, report);
    // Rings that touch along their centres interlock as gears: spheres of 0.5 mm lie 0.506 mm apart.
    judge_runs("rings that interlock", {true, contact::SphereNormals::centres, 1}, 5, setting, report);
    Plot plot;
    plot.title = "33 cylinders after 0.5 s";
    plot.x.label = "x [m]";
    plot.y.label = "y [m]";
    plot.has_equal_scales = true;
    Curve centres{"centres", {}, {}, CurveStyle::points, -1};
    collapse({}, setting, &centres);
    plot.curves.push_back(centres);
    write_plot(setting, "cylinders", plot);
}

}  // namespace riprap::validation::mellado

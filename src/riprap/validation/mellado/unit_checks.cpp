// SPDX-License-Identifier: Apache-2.0
// The pieces that every other case of the suite rests on, each beside its exact answer.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "riprap/fluid/particle/mps_weight.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"
#include "riprap/fluid/wcmps/wcmps_step.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "riprap/validation/mellado/mean_surface.hpp"
#include "riprap/validation/mellado/unit_checks.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mellado {

namespace {

using solid::sphere_dem::SphereWorld;
using water::WaterTrial;

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
void judge_lattices(CaseReport& report) {
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
    const std::string note = "worst of the plane and space, supports 2.1 and 3.1";
    report.judge_below({"lattice: relative error of n_0", "-", {}, 0.0, note}, density, 1e-6);
    report.judge_below({"lattice: relative error of lambda", "-", {}, 0.0, note}, lambda, 1e-6);
    report.judge_below({"lattice: error of the count of neighbours", "-", {}, 0.0, note}, count, 1e-6);
    report.judge_below({"lattice: relative error of the gradient of a linear field", "-", {}, 0.0, note}, slope, 1e-12);
    report.judge_below({"lattice: relative error of the Laplacian of x.x", "-", {}, 0.0, note}, curvature, 1e-12);
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
    fluid::WcmpsScratch scratch;
    fluid::FluidReport report;
    const double dt = fluid::choose_fluid_time_step(settings, state).limit;
    fluid::update_density(settings, state, none, {}, dt, scratch, report);
    fluid::accelerate(settings, state, none, {}, dt, 0, scratch, report);
    Vec3 sum{};
    double moved = 0;
    for (const Vec3& v : state.velocity) {
        sum += v;
        moved += norm(v);
    }
    return norm(sum) / moved;
}

void judge_fluid_pieces(CaseReport& report) {
    for (const int dimension : {2, 3}) {
        report.judge_below({fmt::format("cloud in {} dimensions: momentum a step makes, over that it moves", dimension),
                            "-",
                            {},
                            0.0,
                            "forces of eq. 5.15 on a disordered cloud"},
                           momentum_gap(dimension), 1e-12);
    }
    const fluid::WcmpsSettings settings = settings_of(2);
    double worst = 0;
    for (double x = 0.98; x < 1.05; x += 0.001) {
        worst = std::max(worst, std::abs(fluid::concentration_of(settings, fluid::pressure_of(settings, x)) / x - 1));
    }
    report.judge_below({"equation of state and its inverse: relative error of n", "-", {}, 0.0, {}}, worst, 1e-12);

    // A pair alone, as two particles of the surface meet: on its way at 1.5 m/s, ratio 0.5.
    const fluid::wcmps::MpsCollision pair{0.9 * 0.9, 1e-8};
    const double share = 0.5 * (1 + settings.collision_ratio);
    const double a[4] = {1, 0.3, 0, share}, b[4] = {-0.5, 0.1, 0, share}, d[3] = {-0.8, 0, 0};
    double change_a[3]{}, change_b[3]{};
    pair.exchange<2>(a, b, d, 0.64, 0.8, change_a, change_b);
    report.judge_below({"colliding pair: change of its momentum over what is handed on", "-", {}, 0.0, {}},
                       (change_a[0] + change_b[0]) / change_b[0], 1e-12);
    report.judge({"colliding pair: speed of parting over that of approach", "-", {}, settings.collision_ratio, {}},
                 ((b[0] + change_b[0]) - (a[0] + change_a[0])) / 1.5, Absolute{1e-6});
}

/// A column of water 0.5 m deep and wide, twenty spacings deep, for 5 s.
void judge_column(const CaseSetting& setting, CaseReport& report) {
    constexpr double depth = 0.5, width = 0.5, end = 5, gravity = 9.81;
    CaseSetting scene = setting;
    scene.folder = setting.folder.parent_path().parent_path() / "water" / "still_tank";
    WaterTrial trial(scene, std::vector<std::string>{"fluid.method=\"wcmps\"", "fluid.weight=\"reciprocal\"",
                                                     "fluid.wall_pressure=\"mirrored\"", "fluid.spacing=0.025", "end=5",
                                                     "fluid.region.0.box.high=[0.5,0.5]",
                                                     "body.right.shape.half_space.offset=-0.5"});
    trial.record("surface", [](const WaterTrial& now) {
        return now.now() < end - 0.5 ? std::nan("") : mean_surface(now, {}, {width, 0.8, 0});
    });
    trial.run();
    report.judge({"still column: pressure on the bottom over rho g H, last 3 s", "-", {}, 1.0, {}},
                 -trial.mean("bottom.fluid_force.y", 2, end) / (1000 * gravity * depth * width), Relative{0.02});
    report.judge({"still column: kinetic energy of the fifth second over that of the fourth",
                  "-",
                  {},
                  {},
                  "at most 1: motion does not grow"},
                 trial.mean("fluid.kinetic", 4, end) / trial.mean("fluid.kinetic", 3, 4), 0, 1);
    report.judge({"still column: level at the end over that of its volume", "-", {}, 1.0, {}},
                 last_surface(trial, "surface", 0.5) / depth, Relative{0.005});
}

/// Two spheres that meet head on at 2 m/s: speed of parting over that of approach, time of contact, deepest overlap.
struct HeadOn {
    double restitution{0}, duration{0}, overlap{0};
};

constexpr double modulus = 1e8, poisson_ratio = 0.3, radius = 0.01, mass = 0.01, half_speed = 1;

HeadOn head_on(double restitution) {
    SphereWorld world;
    const MaterialId grain =
        world.add_material({.youngs_modulus = modulus, .poisson_ratio = poisson_ratio, .restitution = restitution});
    world.add_sphere(grain, radius, mass, {{{0, 0, 0}, {}}, {half_speed, 0, 0}, {}});
    world.add_sphere(grain, radius, mass, {{{2 * radius + 1e-7, 0, 0}, {}}, {-half_speed, 0, 0}, {}});
    world.settings.steps_per_contact = 400;
    world.build();
    const double dt = world.step_limit();
    HeadOn result;
    for (int step = 0; step < 100'000 && (result.duration == 0 || world.report.contact_count > 0); ++step) {
        world.step(dt);
        result.duration += world.report.contact_count > 0 ? dt : 0;
        result.overlap = std::max(result.overlap, 2 * radius - norm(world.state.position[1] - world.state.position[0]));
    }
    result.restitution = (world.state.velocity[1].x - world.state.velocity[0].x) / (2 * half_speed);
    return result;
}

void judge_spheres(CaseReport& report) {
    for (const double e : {0.3, 0.5, 0.7, 0.95}) {
        report.judge({fmt::format("two spheres, restitution {}", e), "-", {}, e, {}}, head_on(e).restitution,
                     Relative{0.005});
    }
    const HeadOn elastic = head_on(1);
    const double effective = modulus / (2 * (1 - poisson_ratio * poisson_ratio));
    report.judge({"two elastic spheres: time of contact over 2.87 (m*^2/(R* Y*^2 v))^(1/5)", "-", {}, 1.0, {}},
                 elastic.duration /
                     (2.87 * std::pow(std::pow(0.5 * mass / effective, 2) / (0.5 * radius * 2 * half_speed), 0.2)),
                 Relative{0.03});
    report.judge(
        {"two elastic spheres: deepest overlap over (15 m* v^2/(16 Y* sqrt(R*)))^(2/5)", "-", {}, 1.0, {}},
        elastic.overlap /
            std::pow(15 * 0.5 * mass * std::pow(2 * half_speed, 2) / (16 * effective * std::sqrt(0.5 * radius)), 0.4),
        Relative{0.005});
}

/// A box of unequal edges that tumbles freely, and a spin about z in the plane and in space.
void judge_rotation(CaseReport& report) {
    SphereWorld world;
    const MaterialId grain = world.add_material({.youngs_modulus = 1e8});
    world.add_multisphere(grain, body::box_shell({0.4, 0.2, 0.1}, 0.05).value(), 1000,
                          {{{0, 0, 0}, {}}, {}, {0.3, 6, 0.2}});
    world.build();
    const auto energy = [&] {
        return 0.5 * dot(world.state.angular_momentum[0], angular_velocity(world.bodies, world.state, BodyId{0}));
    };
    const double size = norm(world.state.angular_momentum[0]), start = energy();
    double drift = 0, growth = 0, stretch = 0;
    for (int step = 0; step < 10'000; ++step) {
        world.step(1e-3);
        drift = std::max(drift, std::abs(norm(world.state.angular_momentum[0]) / size - 1));
        growth = std::max(growth, std::abs(energy() / start - 1));
        const Quat& q = world.state.orientation[0];
        stretch = std::max(stretch, std::abs(std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z) - 1));
    }
    const std::string note =
        "largest in 10 000 steps of 1 ms; it turns once a second about its middle axis and tumbles";
    report.judge_below({"free box: relative change of angular momentum", "-", {}, 0.0, note}, drift, 1e-10);
    report.judge_below({"free box: relative change of energy", "-", {}, 0.0, note}, growth, 1e-6);
    report.judge_below({"free box: change of the length of its quaternion", "-", {}, 0.0, note}, stretch, 1e-12);
    const auto turned = [](bool is_planar) {
        SphereWorld one;
        const MaterialId material = one.add_material({.youngs_modulus = 1e8});
        one.bodies.is_planar = is_planar;
        const solid::sphere_dem::Start spin{{}, {}, {0, 0, 1.7}};
        if (is_planar) {
            one.add_disc(material, 0.1, 1, spin);
        } else {
            one.add_sphere(material, 0.1, 1, spin);
        }
        one.build();
        for (int step = 0; step < 1000; ++step) {
            one.step(1e-3);
        }
        const Quat& q = one.state.orientation[0];
        return 2 * std::atan2(q.z, q.w);
    };
    report.judge({"angle of a spin about z after a second, in the plane", "rad", {}, 1.7, {}}, turned(true),
                 Absolute{1e-10});
    report.judge({"the same in space", "rad", {}, 1.7, {}}, turned(false), Absolute{1e-10});
}

}  // namespace

void unit_checks(const CaseSetting& setting, CaseReport& report) {
    judge_lattices(report);
    judge_fluid_pieces(report);
    judge_column(setting, report);
    judge_spheres(report);
    judge_rotation(report);
}

}  // namespace riprap::validation::mellado

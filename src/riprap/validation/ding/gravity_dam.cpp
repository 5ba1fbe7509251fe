// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/geometry/shapes.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/validation/block_trial.hpp"
#include "riprap/validation/ding/cases_3d.hpp"

namespace riprap::validation::ding {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180, water = 1000;
constexpr double dip = 16.1 * degree, friction_angle = 30 * degree;
constexpr double wide = 2.5, along = 3.0, mean_height = 5.0;

/// Stiffness of the contacts: that of faces does not depend on the number of their corners when it is per area, but
/// edges and corners, on which a block falls, have no area and would pass through.
enum class Springs { per_area, per_point };

/// The part of the dam above its crack: two columns of 1.25 m on a plane that dips downstream (+x), mean height 5 m,
/// level crest; below it the body of the dam with its downstream face of 0.8 : 1, and a floor 10 m below the crack. The
/// crack begins upstream at (0, 0).
struct Dam {
    ImplicitTrial trial;
    std::int32_t upstream{0}, downstream{0};
    double crest{0};
    Vec3 start_downstream{};
    std::vector<Vec3> force, torque;
    std::vector<Mat3> pull;

    explicit Dam(double cohesion, double dt, Springs springs = Springs::per_area) {
        const double drop = wide * std::tan(dip);
        crest = mean_height - 0.5 * drop;
        for (int material = 0; material < 2; ++material) {
            add_material(trial.system, {2500, 5e10, 0.2},
                         {2e9, 2e9, springs == Springs::per_area, std::tan(friction_angle), cohesion});
        }
        // The joint between the columns has no strength, and no friction.
        auto& joint = trial.system.surfaces[0];
        joint.friction = joint.cohesion = 0;
        // Material 1 is the body of the dam and the floor.
        add_prism({{0, -10}, {wide + 0.8 * (10 - drop), -10}, {wide, -drop}, {0, 0}}, 1, true);
        add_block(trial.system, trial.state.blocks,
                  {.shape = add_half_space(trial.system, {0, 0, 1}, -10), .material = 1});
        const double middle = -0.5 * drop;
        upstream = add_prism({{0, 0}, {0.5 * wide, middle}, {0.5 * wide, crest}, {0, crest}}, 0, false);
        downstream = add_prism({{0.5 * wide, middle}, {wide, -drop}, {wide, crest}, {0.5 * wide, crest}}, 0, false);
        trial.dt = dt;
        trial.settings.max_displacement = 0.1;
        trial.system.gravity = {0, 0, -gravity};
        trial.state.contacts.bonded = bonded_pairs(trial.system, trial.state.blocks);
        trial.settle(200, 1e-12);
        start_downstream = trial.position(downstream);
        force.resize(at(trial.system.size()));
        torque.resize(force.size());
        pull.resize(force.size());
        trial.external = {force, torque, pull};
    }

    std::int32_t add_prism(const std::vector<geometry::Point2>& corners, std::int32_t material, bool is_fixed) {
        // Corners in the x-z plane; the prism runs along y.
        const auto made = geometry::extruded_polygon(corners, 0, along);
        if (!made) {
            throw std::runtime_error(made.problems().front().message);
        }
        geometry::Polyhedron shape = made.value();
        for (Vec3& x : shape.vertices) {
            x = {x.x, -x.z, x.y};  // a rotation about x by 90 degrees
        }
        return add_polyhedron(trial.system, trial.state.blocks, shape, {.material = material, .is_fixed = is_fixed});
    }

    /// Water pressure on the upstream face up to `level` above the upstream end of the crack: force, and its dipole
    /// about the centroid, exact for a linear pressure. The face keeps its place. Once the upstream block has passed
    /// half of the crack the water runs out behind it and pushes no more.
    void set_level(double level) {
        const double h = trial.position(upstream).x > 0.75 * wide ? 0 : std::min(level, crest);
        const double top =
            h > 0 ? water * gravity * (level - h) : 0;  // pressure at the crest, if the water stands above it
        const double push = (0.5 * water * gravity * h * h + top * h) * along;
        const double first = (water * gravity * h * h * h / 6 + 0.5 * top * h * h) * along;  // integral of p z
        const auto b = at(upstream);
        const Vec3 f{push, 0, 0};
        // Point of action on the face x = 0.
        const Vec3 point{0, -0.5 * along, push > 0 ? first / push : 0};
        const Vec3 arm = point - trial.position(upstream);
        force[b] = f;
        torque[b] = cross(arm, f);
        pull[b] = solid::affine::symmetric_part(outer(f, arm));
    }
    double slid() const { return norm(trial.position(downstream) - start_downstream); }

    /// Raises the water by 0.5 m a second to `level`, then holds it there; returns the time at which the downstream
    /// block has moved by `mark`, or infinity. Adds the displacement of that block to a curve.
    double run(double level, double end, double mark, Curve* curve = nullptr) {
        double onset = INFINITY;
        while (trial.time < end - 1e-9) {
            set_level(std::min(level, 0.5 * trial.time));
            trial.step();
            onset = std::isinf(onset) && slid() > mark ? trial.time : onset;
            if (curve != nullptr) {
                curve->x.push_back(trial.time);
                curve->y.push_back(slid());
            }
        }
        return onset;
    }
};

/// Level at which the body begins to slide without cohesion: H = W tan(phi - dip).
double critical_level() {
    const double weight = 2500 * gravity * wide * mean_height;
    return std::sqrt(2 * weight * std::tan(friction_angle - dip) / (water * gravity));
}

/// Acceleration down the crack at a level.
double acceleration(double level, double cohesion) {
    const double weight = 2500 * gravity * wide * mean_height, push = 0.5 * water * gravity * level * level;
    const double strength =
        (weight * std::cos(dip) - push * std::sin(dip)) * std::tan(friction_angle) + cohesion * wide / std::cos(dip);
    return (push * std::cos(dip) + weight * std::sin(dip) - strength) / (weight / gravity);
}

/// Holds the water at a level from the start; returns the distance slid in the last second before `end`.
double creep_at(double level, double end) {
    Dam dam(0, 0.01);
    dam.run(level, end - 1, INFINITY);
    const double before = dam.slid();
    dam.run(level, end, INFINITY);
    return dam.slid() - before;
}

}  // namespace

void gravity_dam(const CaseSetting& setting, CaseReport& report) {
    {
        Dam dam(0, 0.01);
        dam.set_level(4);
        const double h = 4, push = 0.5 * water * gravity * h * h * along;
        report.judge({"water 4 m: thrust", "N", {}, push, {}}, dam.force[at(dam.upstream)].x, Relative{1e-10});
        const Vec3 centre = dam.trial.position(dam.upstream);
        const double moment = dam.torque[at(dam.upstream)].y + centre.z * push;
        report.judge({"moment of the thrust about the crack", "N m", {}, push * h / 3, {}}, moment, Relative{1e-10});
    }
    const double critical = critical_level();
    report.judge_below({"1 % below the critical level: way in the last second", "m", {}, 0, {}},
                       creep_at(0.99 * critical, 11), 1e-6);
    report.judge({"1 % above the critical level it slides: way in the last second",
                  "m",
                  "fails at 4 m",
                  {},
                  fmt::format("critical level {:.3f} m", critical)},
                 creep_at(1.01 * critical, 11), 1e-3, 10);
    {
        Dam dam(0, 0.01);
        dam.run(4, 8, INFINITY);
        const double v0 = norm(dam.trial.velocity(dam.downstream));
        dam.run(4, 9, INFINITY);
        report.judge({"water kept at 4 m: acceleration over a second", "m/s^2", {}, acceleration(4, 0), {}},
                     norm(dam.trial.velocity(dam.downstream)) - v0, Relative{0.02});
    }
    // Displacement at 10 s, when the blocks are still on the crack.
    const double end = 10;
    std::vector<double> ways, onsets;
    const auto plot_of = [](const char* title) {
        Plot plot;
        plot.title = title;
        plot.x.label = "time [s]";
        plot.y.label = "displacement of block 1 [m]";
        return plot;
    };
    Plot levels = plot_of("The cracked top of a dam in space, three levels of water");
    for (const double level : {3.5, 4.0, 5.0}) {
        Dam dam(0, 0.01);
        levels.curves.push_back({fmt::format("{} m", level), {}, {}, CurveStyle::line, -1});
        onsets.push_back(dam.run(level, end, 0.01, &levels.curves.back()));
        ways.push_back(dam.slid());
    }
    report.judge_below({"water 3.5 m: displacement of block 1", "m", "stands", 0, {}}, ways[0], 1e-3);
    report.judge({"5 m moves block 1 farther than 4 m: ratio", "-", "larger", {}, {}}, ways[2] / ways[1], 1, INFINITY);
    report.judge({"5 m moves it earlier than 4 m: time saved", "s", "earlier", {}, {}}, onsets[1] - onsets[2], 0,
                 INFINITY);
    std::vector<double> cohesive;
    Plot cohesions = plot_of("The same at 4.2 m, by cohesion");
    for (const double cohesion : {0.0, 1e3, 2e3, 0.3e6, 3e6}) {
        Dam dam(cohesion, 0.01);
        cohesions.curves.push_back({fmt::format("{:.0f} kPa", 1e-3 * cohesion), {}, {}, CurveStyle::line, -1});
        dam.run(4.2, end, INFINITY, &cohesions.curves.back());
        cohesive.push_back(dam.slid());
        report.state(
            {fmt::format("4.2 m, cohesion {:.0f} kPa: displacement after {} s", 1e-3 * cohesion, end), "m", {}},
            cohesive.back());
    }
    bool is_monotone = true;
    for (std::size_t i = 1; i < cohesive.size(); ++i) {
        // Two bonds that hold differ by the elastic motion of their springs alone.
        is_monotone = is_monotone && (cohesive[i] < cohesive[i - 1] || cohesive[i] < 1e-3);
    }
    report.judge({"cohesion 0, 1, 2 kPa, 0.3, 3 MPa: displacement falls", "-", "3 MPa: -16.7 %", 1, {}},
                 is_monotone ? 1 : 0, 1, 1);
    report.judge_below({"0.3 MPa: displacement", "m", {}, 0, {}}, cohesive[3], 1e-3);
    write_plot(setting, "gravity_dam_levels", levels);
    write_plot(setting, "gravity_dam_cohesions", cohesions);
    if (setting.is_full) {
        Dam dam(0, 0.01, Springs::per_point);
        double peak = 0, last = 0;
        while (dam.trial.time < 40) {
            dam.set_level(std::min(4.0, 0.5 * dam.trial.time));
            dam.trial.step();
            peak = std::max(peak, dam.trial.report.sums.kinetic);
            last = dam.trial.report.sums.kinetic;
        }
        report.judge_below({"sliding, falling, rest: kinetic energy at the end over its peak", "-",
                            "at rest after 15 s", 0, "the water is let go once half of the crack is passed"},
                           last / peak, 1e-3);
    }
}

}  // namespace riprap::validation::ding

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/geometry/shapes.hpp"
#include "riprap/validation/block_trial.hpp"
#include "riprap/validation/dda/cases_3d.hpp"

namespace riprap::validation::dda {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180;

/// x east, y north, z up; dip directions count from north to east.
struct JointPlane {
    double dip, direction, friction_angle;  ///< [deg]
    /// Unit normal into the wedge above the plane.
    Vec3 normal() const {
        const double d = dip * degree, a = direction * degree;
        return {std::sin(d) * std::sin(a), std::sin(d) * std::cos(a), std::cos(d)};
    }
};

struct RockWedge {
    JointPlane a, b;
    double safety;  ///< factor by equilibrium on both planes
    Vec3 line() const {
        const Vec3 along = normalized(cross(a.normal(), b.normal()));
        return along.z > 0 ? -along : along;
    }
};

/// Tetrahedron above both planes, cut by a level top and by a steep face through the daylighting line.
geometry::Polyhedron wedge_shape(const RockWedge& rock) {
    const Vec3 na = rock.a.normal(), nb = rock.b.normal(), line = rock.line(), up{0, 0, 1};
    const Vec3 face = normalized(normalized(Vec3{line.x, line.y, 0}) + 0.3 * up);
    const auto meet = [](const Vec3& n1, const Vec3& n2, const Vec3& n3, double d3) {
        return (d3 * cross(n1, n2)) / dot(n1, cross(n2, n3));  // n1 . x = n2 . x = 0, n3 . x = d3
    };
    return geometry::tetrahedron({}, meet(na, nb, up, 1), meet(na, face, up, 1), meet(nb, face, up, 1)).value();
}

struct FirstMotion {
    double distance;  ///< in 1 s [m]
    Vec3 direction;
};

template <class Trial>
FirstMotion release(const RockWedge& rock, double strength_factor, double dt, const auto& settle) {
    Trial trial;
    const double stiffness = 1e8;
    add_material(trial.system, {2600, 1e10, 0.25}, {stiffness, stiffness, true});
    add_material(trial.system, {2600, 1e10, 0.25}, {stiffness, stiffness, true});
    add_material(trial.system, {2600, 1e10, 0.25}, {stiffness, stiffness, true});
    auto& table = trial.system.surfaces;
    table[0 * 3 + 1].friction = table[1 * 3 + 0].friction = std::tan(rock.a.friction_angle * degree) * strength_factor;
    table[0 * 3 + 2].friction = table[2 * 3 + 0].friction = std::tan(rock.b.friction_angle * degree) * strength_factor;
    add_block(trial.system, trial.state.blocks,
              {.shape = add_half_space(trial.system, rock.a.normal(), 0), .material = 1});
    add_block(trial.system, trial.state.blocks,
              {.shape = add_half_space(trial.system, rock.b.normal(), 0), .material = 2});
    const std::int32_t wedge = add_polyhedron(trial.system, trial.state.blocks, wedge_shape(rock), {});
    trial.system.gravity = {0, 0, -gravity};
    trial.dt = dt;
    settle(trial);
    const Vec3 start = trial.position(wedge);
    const double from = trial.time;
    trial.run_until(from + 1);
    const Vec3 moved = trial.position(wedge) - start;
    return {norm(moved), norm(moved) > 0 ? normalized(moved) : Vec3{}};
}

template <class Trial>
void judge_wedges(const std::string& engine, double dt, const auto& settle, CaseReport& report) {
    const std::array<RockWedge, 3> wedges{{{{40, 165, 35}, {70, 285, 20}, 1.3041},
                                           {{45, 105, 20}, {70, 235, 30}, 1.1066},
                                           {{50, 130, 30}, {50, 230, 30}, 0.9308}}};
    for (std::size_t i = 0; i < wedges.size(); ++i) {
        const RockWedge& rock = wedges[i];
        const std::string name = fmt::format("{}, wedge {}: ", engine, i + 1);
        const FirstMotion holds = release<Trial>(rock, 1 / (0.98 * rock.safety), dt, settle);
        report.judge_below({name + "way in 1 s with the strength over 0.98 F", "m", "holds", 0, {}}, holds.distance,
                           1e-3);
        const FirstMotion slides = release<Trial>(rock, 1 / (1.02 * rock.safety), dt, settle);
        report.judge({name + "way in 1 s with the strength over 1.02 F", "m", "slides", {}, {}}, slides.distance, 0.01,
                     5);
        report.judge_below({name + "its direction off the line of intersection", "deg", {}, 0, {}},
                           std::acos(std::min(1.0, dot(slides.direction, rock.line()))) / degree, 1);
    }
}

}  // namespace

void rock_wedges_3d(const CaseSetting&, CaseReport& report) {
    judge_wedges<ImplicitTrial>(
        "implicit", 0.01, [](ImplicitTrial& trial) { trial.settle(300, 1e-12); }, report);
    judge_wedges<ExplicitTrial>(
        "explicit", 1e-4,
        [](ExplicitTrial& trial) {
            trial.settings.mass_damping = 50;
            trial.run_until(0.5);
            trial.settings.mass_damping = 0;
        },
        report);
}

}  // namespace riprap::validation::dda

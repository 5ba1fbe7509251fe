// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180;

/// x east, y north, z up; dip directions count from north to east.
struct JointPlane {
    double dip, direction, friction_angle;  ///< [deg]
    /// Unit normal that points up, into the wedge above the plane.
    Vec3 normal() const {
        const double d = dip * degree, a = direction * degree;
        return {std::sin(d) * std::sin(a), std::sin(d) * std::cos(a), std::cos(d)};
    }
};

struct RockWedge {
    JointPlane a, b;
    double plunge, trend, safety;  ///< expected [deg], [deg], [-]
};

/// Tetrahedron above both planes: cut by a level top at z = 1 m and by a steep face that daylights the line of
/// intersection; that line passes through the origin on the face.
geometry::Outcome<geometry::Polyhedron> wedge_shape(const RockWedge& rock, const Vec3& line) {
    const Vec3 na = rock.a.normal(), nb = rock.b.normal();
    const Vec3 up{0, 0, 1};
    const Vec3 out = normalized(Vec3{line.x, line.y, 0});
    const Vec3 face = normalized(out + 0.3 * up);  // dips steeper than the line: x . face <= 0 inside
    const auto meet = [](const Vec3& n1, double d1, const Vec3& n2, double d2, const Vec3& n3, double d3) {
        return (d1 * cross(n2, n3) + d2 * cross(n3, n1) + d3 * cross(n1, n2)) / dot(n1, cross(n2, n3));
    };
    return geometry::tetrahedron({}, meet(na, 0, nb, 0, up, 1), meet(na, 0, face, 0, up, 1),
                                 meet(nb, 0, face, 0, up, 1));
}

struct FirstMotion {
    double distance;  ///< moved in 1 s [m]
    Vec3 direction;
};

FirstMotion release(const RockWedge& rock, double strength_factor) {
    const Vec3 na = rock.a.normal(), nb = rock.b.normal();
    Vec3 line = normalized(cross(na, nb));
    line = line.z > 0 ? -line : line;
    SceneBuilder scene;
    scene.add_material({.name = "rock", .density = 2600, .normal_stiffness = 1e9});
    for (const JointPlane* plane : {&rock.a, &rock.b}) {
        scene.add_material(
            {.name = plane == &rock.a ? "plane_a" : "plane_b", .density = 2600, .normal_stiffness = 1e9});
    }
    auto& pairs = scene.model.materials.pairs;
    pairs[0 * 3 + 1].friction = pairs[1 * 3 + 0].friction = std::tan(rock.a.friction_angle * degree) * strength_factor;
    pairs[0 * 3 + 2].friction = pairs[2 * 3 + 0].friction = std::tan(rock.b.friction_angle * degree) * strength_factor;
    for (int i = 0; i < 2; ++i) {
        BodySpec plane;
        plane.name = i == 0 ? "plane_a" : "plane_b";
        plane.material = MaterialId{i + 1};
        plane.shape = scene.add_half_space(i == 0 ? na : nb, 0);
        plane.drive = body::Drive::fixed;
        scene.add_body(plane);
    }
    BodySpec wedge;
    wedge.name = "wedge";
    wedge.shape = scene.add_shape(wedge_shape(rock, line));
    const BodyId body = scene.add_body(wedge);
    scene.model.gravity.value = {0, 0, -gravity};
    Trial trial(std::move(scene));
    trial.follow_energy(false);
    settle(trial, 4000);
    const Vec3 start = trial.position(body);
    trial.run_until(trial.time() + 1);
    const Vec3 moved = trial.position(body) - start;
    return {norm(moved), normalized(moved)};
}

}  // namespace

void rock_wedges(const CaseSetting&, CaseReport& report) {
    const std::array<RockWedge, 3> wedges{{{{40, 165, 35}, {70, 285, 20}, 31.568, 207.923, 1.3041},
                                           {{45, 105, 20}, {70, 235, 30}, 31.197, 157.732, 1.1066},
                                           {{50, 130, 30}, {50, 230, 30}, 37.454, 180, 0.9308}}};
    for (const RockWedge& rock : wedges) {
        const std::string name = fmt::format("planes {:02.0f}/{:03.0f} and {:02.0f}/{:03.0f}, F = {}", rock.a.dip,
                                             rock.a.direction, rock.b.dip, rock.b.direction, rock.safety);
        const FirstMotion holds = release(rock, 1 / (0.98 * rock.safety));
        report.judge_below({name + ": motion in 1 s with tan(phi)/(0.98 F)", "m", {}, {}, {}}, holds.distance, 1e-5);
        const FirstMotion slides = release(rock, 1 / (1.02 * rock.safety));
        // 2 % less than needed: a = 0.02/1.02 g sin(plunge).
        const double exact = 0.5 * gravity * std::sin(rock.plunge * degree) * (1 - 1 / 1.02);
        report.judge({name + ": motion in 1 s with tan(phi)/(1.02 F)", "m", {}, exact, {}}, slides.distance,
                     Relative{0.05});
        const double plunge = -std::asin(slides.direction.z) / degree;
        double trend = std::atan2(slides.direction.x, slides.direction.y) / degree;
        trend = trend < 0 ? trend + 360 : trend;
        report.judge({name + ": plunge of the motion", "deg", {}, rock.plunge, {}}, plunge, Absolute{1});
        report.judge({name + ": trend of the motion", "deg", {}, rock.trend, {}}, trend, Absolute{1});
    }
}

}  // namespace riprap::validation::rigid

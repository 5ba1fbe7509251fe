// SPDX-License-Identifier: Apache-2.0
// Sides of the domain that a case speaks of one by one.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/coupling/grid_fluid/carried_water.hpp"
#include "riprap/coupling/grid_fluid/grid_parts.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::Inflow;
using fluid::grid::Side;
using fluid::grid::SideKind;
using Kind = SideRule::Kind;

Side side_by(const GridFluidSettings& settings, const SideRule& rule) {
    Side side;
    switch (rule.kind) {
        case Kind::slip:
            break;
        case Kind::no_slip:
            side.kind = SideKind::no_slip;
            break;
        case Kind::wall_function:
            side.kind = SideKind::wall_function;
            break;
        case Kind::endless:
            side.kind = SideKind::open;
            side.is_from_rest = false;
            side.open_fraction = 1;
            break;
        case Kind::flow:
            side.kind = SideKind::inflow;
            side.inflow = [mesh = settings.grid.mesh, flow = *settings.scene.flow, nu = settings.kinematic_viscosity,
                           s = rule.side](const Vec3& x, double t) {
                const int a = s / 2;
                std::array<int, 3> face{mesh.cell_at(0, x.x), mesh.cell_at(1, x.y), mesh.cell_at(2, x.z)};
                face[at(a)] = s % 2 == 1 ? mesh.box.cells[at(a)] : 0;
                Vec3 u = velocity_of(flow, x, t, nu);
                u[a] = mean_across(mesh, flow, nu, a, face, t);
                return Inflow{u, 1};
            };
            break;
    }
    side.velocity = rule.velocity;
    return side;
}

/// Says what a rule asks for that its side has not; empty where nothing is wrong.
std::string problem_of(const GridFluidSettings& settings, const SideRule& rule) {
    if (rule.kind == Kind::flow && !settings.scene.flow) {
        return "a side with the velocity of a flow in a case without one";
    }
    if (norm(rule.velocity) > 0 && rule.kind != Kind::no_slip && rule.kind != Kind::wall_function) {
        return "a velocity of a side that nothing sticks to";
    }
    if (rule.velocity[rule.side / 2] != 0) {
        return "a wall that moves across itself";
    }
    return "";
}

}  // namespace

std::vector<KeyProblem> add_sides(GridFluidSettings& settings) {
    std::vector<KeyProblem> problems;
    std::vector<int> told;
    for (std::size_t r = 0; r < settings.scene.sides.size(); ++r) {
        const SideRule& rule = settings.scene.sides[r];
        const std::string_view key = entry_key("side", r);
        if (std::string problem = problem_of(settings, rule); !problem.empty()) {
            problems.push_back({key, problem,
                                "a velocity along a wall of kind \"no_slip\" or \"wall_function\"; kind = \"flow\" "
                                "with fluid.flow"});
        } else if (std::find(told.begin(), told.end(), rule.side) != told.end()) {
            problems.push_back({key, "a second rule for the same side", "one [[fluid.side]] for each side"});
        } else {
            told.push_back(rule.side);
            settings.grid.side[at(rule.side)] = side_by(settings, rule);
        }
    }
    if (settings.is_carried && !settings.scene.flow) {
        problems.push_back({"carried", "water that no flow carries", "fluid.flow, or carried = false"});
    }
    const auto& is_dry = settings.scene.is_dry;
    if (settings.is_carried && std::find(is_dry.begin(), is_dry.end(), 0) != is_dry.end()) {
        problems.push_back({"carried", "bodies in water that goes its way whatever it meets",
                            "bodies that are not in the water, or carried = false"});
    }
    return problems;
}

}  // namespace riprap::coupling

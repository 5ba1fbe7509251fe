// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/scene_bridge.hpp"

#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/plane.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"

namespace riprap::solid::planar_dda {

void drive_blocks(const SolidScene& scene, const TimeSpan& span, const body::BodyState& bodies, const State& state,
                  Model& model, std::vector<Unknowns>& driven) {
    driven.assign(at(model.block_count()), Unknowns{});
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        const auto i = at(b);
        const BodyId id{b};
        model.is_fixed[i] = is_free(scene.bodies, id, span.time) ? 0 : 1;
        if (model.is_fixed[i] == 0 || scene.bodies.drive[i] != body::Drive::driven) {
            continue;
        }
        const Pose there = driven_state(scene.bodies, id, span.end()).pose;
        const Vec3 corrected = bodies.drive_offset.empty() ? Vec3{} : bodies.drive_offset[i];
        const double angle = angle_of(there.orientation);
        const Vec2 place =
            Vec2{there.position.x + corrected.x, there.position.y + corrected.y} + turned(angle, model.offset[i]);
        driven[i] = {place.x - state.x[i], place.y - state.y[i],
                     std::remainder(angle - state.angle[i], 2 * std::numbers::pi)};
    }
}

void read_loads(const body::LoadView& loads, std::vector<Unknowns>& sums) {
    sums.resize(loads.force.size());
    for (std::size_t b = 0; b < sums.size(); ++b) {
        const Sym3 pull = loads.pull.empty() ? Sym3{} : loads.pull[b];
        sums[b] = {loads.force[b].x, loads.force[b].y, loads.torque[b].z, pull.xx, pull.yy, pull.xy};
    }
}

void write_bodies(const Model& model, const State& state, body::BodyState& bodies) {
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        const auto i = at(b);
        const Vec2 origin = place_of(state, b, -1.0 * model.offset[i]);
        const Unknowns rates = rates_of(state, b);
        const Vec2 velocity = velocity_of(state, b, -1.0 * model.offset[i]);
        bodies.position[i] = {origin.x, origin.y, bodies.position[i].z};
        bodies.velocity[i] = {velocity.x, velocity.y, 0};
        bodies.orientation[i] = turn_of(state.angle[i]);
        bodies.stretch[i] = {state.stretch_xx[i], state.stretch_yy[i], 1, state.stretch_xy[i], 0, 0};
        const Block6 mass = mass_block(model.mass[i], spread_of(model, state, b));
        bodies.stretch_rate[i] = {rates[3], rates[4], 0, 0.5 * rates[5], 0, 0};
        bodies.angular_momentum[i] = {0, 0, multiply(mass, rates)[2]};
    }
}

}  // namespace riprap::solid::planar_dda

// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/joint_loads.hpp"

#include <algorithm>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/coupling/solid_slopes.hpp"
#include "riprap/sim/water_step.hpp"

namespace riprap::sim {

namespace {

/// f(i) for the samples of the first layer of loose bodies.
template <class F>
void for_each_face_sample(const Model& model, std::span<const std::uint8_t> is_loose, const F& f) {
    if (!model.fluid->has_joint_pressure) {
        return;
    }
    const coupling::SampleSet& samples = model.fluid->samples;
    for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
        if (is_loose[at(samples.body[i].value)] != 0 && samples.depth[i] < model.fluid->sph.spacing) {
            f(i);
        }
    }
}

/// Slopes of the samples that are near now.
void find_slopes(const Model& model, WaterScratch& scratch) {
    const FluidModel& water = *model.fluid;
    JointScratch& joints = scratch.joints;
    if (joints.slopes.size() != at(water.samples.size())) {
        const fluid::WendlandC2 kernel(water.sph.smoothing_length(), water.sph.domain.dimension);
        joints.slopes = coupling::solid_slopes(water.samples, scratch.motion, scratch.is_still, kernel,
                                               water.sph.support_radius(), water.sph.domain);
    }
    if (joints.near_slopes.size() != scratch.near_numbers.size()) {
        joints.near_slopes.clear();
        for (const std::int32_t number : scratch.near_numbers) {
            joints.near_slopes.push_back(joints.slopes[at(number)]);
        }
    }
}

}  // namespace

std::size_t JointScratch::bytes() const {
    return pressure.bytes() + water.bytes() + bytes_of(slopes, near_slopes, sample_force, force, torque);
}

void add_joint_loads(const Model& model, WaterScratch& scratch, const Vec3& gravity) {
    const FluidModel& water = *model.fluid;
    JointScratch& joints = scratch.joints;
    joints.sample_force.clear();
    const bool is_any_loose = std::find(scratch.is_loose.begin(), scratch.is_loose.end(), 1) != scratch.is_loose.end();
    if (!water.has_joint_pressure || !is_any_loose) {
        return;
    }
    find_slopes(model, scratch);
    describe_water_at_walls(gravity, scratch.sph, joints.water);
    joints.pressure.find(scratch.near, joints.near_slopes, {scratch.is_still, scratch.is_loose}, scratch.motion,
                         scratch.walls, joints.water, water.sph, gravity, joints.sample_force);
    if (joints.sample_force.empty()) {
        return;
    }
    gather(scratch.near, scratch.motion, scratch.walls.position, joints.sample_force, joints.force, joints.torque);
    for (std::size_t b = 0; b < joints.force.size(); ++b) {
        scratch.held_loads.pressure_force[b] += joints.force[b];
        scratch.held_loads.pressure_torque[b] += joints.torque[b];
    }
}

double joint_power(const WaterScratch& scratch) {
    double power = 0;
    for (std::size_t b = 0; !scratch.joints.sample_force.empty() && b < scratch.joints.force.size(); ++b) {
        power += dot(scratch.joints.force[b], scratch.motion.velocity[b]) +
                 dot(scratch.joints.torque[b], scratch.motion.angular_velocity[b]);
    }
    return power;
}

void add_places_of_joints(const Model& model, std::span<const std::uint8_t> is_loose,
                          const coupling::BodyMotion& motion, std::vector<Vec3>& places) {
    const coupling::SampleSet& samples = model.fluid->samples;
    for_each_face_sample(model, is_loose, [&](std::size_t i) {
        const Pose& pose = motion.pose[at(samples.body[i].value)];
        places.push_back(pose.position + rotate(pose.orientation, samples.anchor[i]));
    });
}

double speed_of_joints(const Model& model, std::span<const std::uint8_t> is_loose, const coupling::BodyMotion& motion) {
    double fastest = 0;
    const coupling::SampleSet& samples = model.fluid->samples;
    for_each_face_sample(model, is_loose, [&](std::size_t i) {
        const auto b = at(samples.body[i].value);
        fastest =
            std::max(fastest, norm(motion.velocity[b]) + norm(motion.angular_velocity[b]) * norm(samples.anchor[i]));
    });
    return fastest;
}

}  // namespace riprap::sim

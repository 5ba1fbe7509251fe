// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/joint_loads.hpp"

#include <algorithm>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/coupling/solid_slopes.hpp"
#include "riprap/sim/water_scratch.hpp"

namespace riprap::sim {

namespace {

/// Samples whose body forces may move and that lie under a face.
bool is_face_of_loose(const Model& model, std::span<const std::uint8_t> is_loose, std::size_t sample) {
    const coupling::SampleSet& samples = model.fluid->samples;
    return is_loose[at(samples.body[sample].value)] != 0 && samples.depth[sample] < model.fluid->sph.spacing;
}

/// Slopes of all samples, once.
void find_slopes(const Model& model, WaterScratch& scratch) {
    const FluidModel& water = *model.fluid;
    if (scratch.joints.slopes.size() != at(water.samples.size())) {
        const fluid::WendlandC2 kernel(water.sph.smoothing_length(), water.sph.domain.dimension);
        scratch.joints.slopes = coupling::solid_slopes(water.samples, scratch.motion, scratch.is_still, kernel,
                                                       water.sph.support_radius(), water.sph.domain);
    }
}

}  // namespace

std::size_t JointScratch::bytes() const {
    return pressure.bytes() + water.bytes() + loads.bytes() + bytes_of(slopes, sample_force, radius);
}

bool has_joints(const Model& model, std::span<const std::uint8_t> is_loose) {
    return model.fluid->has_joint_pressure && model.fluid->wall == WallTreatment::boundary_particles &&
           std::find(is_loose.begin(), is_loose.end(), 1) != is_loose.end();
}

double reach_of_joints(const Model& model, std::span<const std::uint8_t> is_loose) {
    if (!has_joints(model, is_loose)) {
        return 0;
    }
    bool has_driven = false;
    for (std::size_t b = 0; b < is_loose.size(); ++b) {
        has_driven = has_driven || (model.bodies.drive[b] == body::Drive::driven && is_loose[b] == 0);
    }
    return (has_driven ? 2 : 1) * coupling::JointKernel::reach(model.fluid->sph);
}

void add_joint_loads(const Model& model, WaterScratch& scratch, const Vec3& gravity) {
    const FluidModel& water = *model.fluid;
    JointScratch& joints = scratch.joints;
    joints.sample_force.clear();
    if (!has_joints(model, scratch.is_loose)) {
        return;
    }
    find_slopes(model, scratch);
    describe_water_at_walls(gravity, scratch.sph, joints.water);
    const coupling::SampleView near = samples_near_water(model, scratch);
    joints.pressure.find(near, joints.slopes, {scratch.is_still, scratch.is_loose}, scratch.motion, scratch.walls,
                         joints.water, water.sph, gravity, joints.sample_force);
    if (joints.sample_force.empty()) {
        return;
    }
    gather(near, scratch.motion, scratch.walls.position, joints.sample_force, joints.loads);
    for (std::size_t b = 0; b < joints.loads.force.size(); ++b) {
        scratch.held_loads.pressure.force[b] += joints.loads.force[b];
        scratch.held_loads.pressure.torque[b] += joints.loads.torque[b];
    }
}

double joint_power(const WaterScratch& scratch) {
    double power = 0;
    for (std::size_t b = 0; !scratch.joints.sample_force.empty() && b < scratch.joints.loads.force.size(); ++b) {
        power += dot(scratch.joints.loads.force[b], scratch.motion.velocity[b]) +
                 dot(scratch.joints.loads.torque[b], scratch.motion.angular_velocity[b]);
    }
    return power;
}

void add_places_of_joints(const Model& model, std::span<const std::uint8_t> is_loose,
                          const body::Motion& motion, std::vector<Vec3>& places) {
    if (!has_joints(model, is_loose)) {
        return;
    }
    const coupling::SampleSet& samples = model.fluid->samples;
    for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
        if (is_face_of_loose(model, is_loose, i)) {
            const Pose& pose = motion.pose[at(samples.body[i].value)];
            places.push_back(pose.position + rotate(pose.orientation, samples.anchor[i]));
        }
    }
}

double speed_of_joints(const Model& model, std::span<const std::uint8_t> is_loose, const body::BodyState& bodies,
                       JointScratch& joints) {
    if (!has_joints(model, is_loose)) {
        return 0;
    }
    const coupling::SampleSet& samples = model.fluid->samples;
    if (joints.radius.size() != is_loose.size()) {
        joints.radius.assign(is_loose.size(), 0);
        for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
            double& radius = joints.radius[at(samples.body[i].value)];
            radius = std::max(radius, norm(samples.anchor[i]));
        }
    }
    double fastest = 0;
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (is_loose[at(b)] != 0) {
            const double spin = norm(angular_velocity(model.bodies, bodies, BodyId{b}));
            fastest = std::max(fastest, norm(bodies.velocity[at(b)]) + spin * joints.radius[at(b)]);
        }
    }
    return fastest;
}

}  // namespace riprap::sim

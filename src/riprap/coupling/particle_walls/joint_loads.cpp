// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/joint_loads.hpp"

#include <algorithm>
#include <variant>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/coupling/joints/joint_kernel.hpp"
#include "riprap/coupling/joints/joint_pairs.hpp"
#include "riprap/coupling/joints/solid_slopes.hpp"
#include "riprap/coupling/particle_walls/particle_scratch.hpp"

namespace riprap::coupling {

namespace {

/// Samples of chosen bodies that lie under a face.
bool is_face_of(const ParticleFluid& water, std::span<const std::uint8_t> chosen, std::size_t sample) {
    const SampleSet& samples = water.samples;
    return chosen[at(samples.body[sample].value)] != 0 && samples.depth[sample] < water.settings().spacing;
}

/// Tells whether sums over pairs are in double.
bool has_plain_sums(const ParticleFluid& water) {
    return std::visit([](const auto& scheme) { return scheme.is_plain; }, water.scheme);
}

/// Slopes of all samples, once.
void find_slopes(const ParticleFluid& water, ParticleScratch& scratch) {
    if (scratch.joints.slopes.size() != at(water.samples.size())) {
        const fluid::WendlandC2 kernel(water.settings().smoothing_length(), water.settings().domain.dimension);
        scratch.joints.slopes = solid_slopes(water.samples, scratch.motion, scratch.bodies.is_still, kernel,
                                             water.settings().support_radius(), water.settings().domain);
    }
}

}  // namespace

std::size_t JointScratch::bytes() const {
    return pressure.bytes() + water.bytes() + loads.bytes() + bytes_of(slopes, sample_force, radius);
}

bool has_joints(const ParticleFluid& water, std::span<const std::uint8_t> is_loose) {
    return water.has_joint_pressure && water.wall == WallTreatment::boundary_particles &&
           std::find(is_loose.begin(), is_loose.end(), 1) != is_loose.end();
}

double reach_of_joints(const ParticleFluid& water, const body::BodySet& bodies,
                       std::span<const std::uint8_t> is_loose) {
    if (!has_joints(water, is_loose)) {
        return 0;
    }
    bool has_driven = false;
    for (std::size_t b = 0; b < is_loose.size(); ++b) {
        has_driven = has_driven || (bodies.drive[b] == body::Drive::driven && is_loose[b] == 0);
    }
    return (has_driven ? 2 : 1) * JointKernelLimits(water.settings()).reach;
}

void add_joint_loads(const ParticleFluid& water, ParticleScratch& scratch, const Vec3& gravity) {
    JointScratch& joints = scratch.joints;
    joints.sample_force.clear();
    if (!has_joints(water, scratch.bodies.is_loose)) {
        return;
    }
    find_slopes(water, scratch);
    scratch.scheme->describe_walls(gravity, joints.water);
    const SampleView near = SampleView(water.samples, scratch.near_numbers);
    joints.pressure.find(near, joints.slopes, {scratch.bodies.is_still, scratch.bodies.is_loose}, scratch.motion,
                         scratch.walls, joints.water, water.settings(), gravity, has_plain_sums(water),
                         joints.sample_force);
    if (joints.sample_force.empty()) {
        return;
    }
    gather(near, scratch.motion, scratch.walls.position, joints.sample_force, joints.loads);
    scratch.held_loads.pressure += joints.loads;
}

double joint_power(const ParticleScratch& scratch) {
    double power = 0;
    for (std::size_t b = 0; !scratch.joints.sample_force.empty() && b < scratch.joints.loads.force.size(); ++b) {
        power += dot(scratch.joints.loads.force[b], scratch.motion.velocity[b]) +
                 dot(scratch.joints.loads.torque[b], scratch.motion.angular_velocity[b]);
    }
    return power;
}

void add_places_of_joints(const ParticleFluid& water, std::span<const std::uint8_t> chosen, const body::Motion& motion,
                          std::vector<Vec3>& places) {
    const SampleSet& samples = water.samples;
    for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
        if (is_face_of(water, chosen, i)) {
            const Pose& pose = motion.pose[at(samples.body[i].value)];
            places.push_back(pose.position + rotate(pose.orientation, samples.anchor[i]));
        }
    }
}

double speed_of_joints(const ParticleFluid& water, std::span<const std::uint8_t> is_loose, const body::BodySet& bodies,
                       const body::BodyState& state, JointScratch& joints) {
    if (!has_joints(water, is_loose)) {
        return 0;
    }
    const SampleSet& samples = water.samples;
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
            const double spin = norm(angular_velocity(bodies, state, BodyId{b}));
            fastest = std::max(fastest, norm(state.velocity[at(b)]) + spin * joints.radius[at(b)]);
        }
    }
    return fastest;
}

}  // namespace riprap::coupling

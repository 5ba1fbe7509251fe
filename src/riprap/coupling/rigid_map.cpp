// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/rigid_map.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

void place_samples(const SampleView& samples, const body::Motion& motion, fluid::BoundaryParticles& particles,
                   std::span<const std::uint8_t> is_still) {
    const auto count = at(samples.size());
    const bool is_placed = particles.position.size() == count && !is_still.empty();
    if (!is_placed) {
        particles.position.resize(count);
        particles.velocity.resize(count);
        particles.acceleration.resize(count);
        particles.given_pressure.clear();
        particles.volume.resize(count);
        particles.is_slippery.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            particles.volume[i] = samples.volume(i);
            particles.is_slippery[i] = samples.is_slippery(i);
        }
    }
    parallel::for_each(samples.size(), [&](std::int64_t index) {
        const auto i = at(index);
        const auto body = at(samples.body(i).value);
        if (is_placed && is_still[body] != 0) {
            return;
        }
        const Vec3 r = arm_of(motion, body, samples.anchor(i));
        const Vec3& omega = motion.angular_velocity[body];
        const Vec3 swing = cross(omega, r);
        particles.position[i] = motion.pose[body].position + r;
        particles.velocity[i] = motion.velocity[body] + swing;
        if (motion.deforms()) {
            particles.velocity[i] += motion.stretch_rate[body] * r;
        }
        particles.acceleration[i] =
            motion.acceleration[body] + cross(motion.angular_acceleration[body], r) + cross(omega, swing);
    });
}

void gather(const SampleView& samples, const body::Motion& motion, std::span<const Vec3> place,
            std::span<const Vec3> sample_force, body::Loads& loads) {
    const std::size_t bodies = motion.pose.size();
    loads.clear(bodies, motion.deforms());
    // Samples are grouped by body, so each body has one range of them and its sum one order.
    const auto begin_of = [&samples](std::size_t body) {
        return samples.begin_of(BodyId{static_cast<std::int32_t>(body)});
    };
    parallel::for_each_uneven(static_cast<std::int64_t>(bodies), 8, [&](std::int64_t index) {
        const auto body = at(index);
        const std::size_t end = begin_of(body + 1);
        for (std::size_t i = begin_of(body); i < end; ++i) {
            const Vec3 arm = place[i] - motion.pose[body].position;
            loads.force[body] += sample_force[i];
            loads.torque[body] += cross(arm, sample_force[i]);
            if (motion.deforms()) {
                loads.pull[body] += symmetric_product(sample_force[i], arm);
            }
        }
    });
}

void gather_loads(const SampleView& samples, const body::Motion& motion, const fluid::BoundaryParticles& particles,
                  FluidLoads& loads) {
    gather(samples, motion, particles.position, particles.pressure_force, loads.pressure);
    gather(samples, motion, particles.position, particles.viscous_force, loads.viscous);
}

}  // namespace riprap::coupling

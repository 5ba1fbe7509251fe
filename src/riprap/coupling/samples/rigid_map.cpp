// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/rigid_map.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/columns.hpp"

namespace riprap::coupling {

namespace {

/// Place of the foot of a sample on its face, relative to the centre of mass of its body [m].
Vec3 foot_of(const SampleView& samples, const body::Motion& motion, std::size_t body, std::size_t i) {
    return arm_of(motion, body, samples.anchor(i) + samples.depth(i) * samples.normal(i));
}

/// Velocity of a body at an arm [m/s].
Vec3 velocity_at(const body::Motion& motion, std::size_t body, const Vec3& arm) {
    const Vec3 v = motion.velocity[body] + cross(motion.angular_velocity[body], arm);
    return motion.deforms() ? v + motion.stretch_rate[body] * arm : v;
}

}  // namespace

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
        particles.foot_velocity.resize(may_stick(particles) ? count : 0);
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
        particles.velocity[i] = velocity_at(motion, body, r);
        if (!particles.foot_velocity.empty()) {
            particles.foot_velocity[i] = velocity_at(motion, body, foot_of(samples, motion, body, i));
        }
        particles.acceleration[i] =
            motion.acceleration[body] + cross(motion.angular_acceleration[body], r) + cross(omega, swing);
    });
}

namespace {

/// Samples of one body that are summed in one go.
constexpr std::int64_t piece = 4096;

/// Force, torque and pull of some samples.
struct LoadSum {
    Vec3 force{}, torque{};
    Sym3 pull{};
};

}  // namespace

void gather(const SampleView& samples, const body::Motion& motion, std::span<const Vec3> place,
            std::span<const Vec3> sample_force, body::Loads& loads) {
    const auto bodies = static_cast<std::int64_t>(motion.pose.size());
    loads.clear(motion.pose.size(), motion.deforms());
    const auto add = [&](std::size_t body, std::size_t i, LoadSum& sum) {
        const Vec3 arm = place[i] - motion.pose[body].position;
        sum.force += sample_force[i];
        sum.torque += cross(arm, sample_force[i]);
        if (motion.deforms()) {
            sum.pull += symmetric_product(sample_force[i], arm);
        }
    };
    const auto put = [&](std::size_t body, const LoadSum& sum) {
        loads.force[body] = sum.force;
        loads.torque[body] = sum.torque;
        if (motion.deforms()) {
            loads.pull[body] = sum.pull;
        }
    };
    // Samples are grouped by body, so each body has one range of them and its sum one order.
    const auto begin_of = [&samples](std::int64_t body) {
        return samples.begin_of(BodyId{static_cast<std::int32_t>(body)});
    };
    std::vector<std::uint8_t> is_large(at(bodies));
    parallel::for_ranges(bodies, 16, [&](std::int64_t first, std::int64_t end) {
        std::size_t i = begin_of(first);
        for (std::int64_t body = first; body < end; ++body) {
            const std::size_t begin = i, last = begin + at(piece);
            LoadSum sum;
            for (; i < at(samples.size()) && i < last && samples.body(i).value == body; ++i) {
                add(at(body), i, sum);
            }
            is_large[at(body)] = i < at(samples.size()) && samples.body(i).value == body ? 1 : 0;
            i = is_large[at(body)] != 0 ? begin_of(body + 1) : i;
            put(at(body), sum);
        }
    });
    const auto join = [](LoadSum a, const LoadSum& b) {
        a.force += b.force;
        a.torque += b.torque;
        a.pull += b.pull;
        return a;
    };
    for (std::int64_t body = 0; body < bodies; ++body) {
        if (is_large[at(body)] != 0) {
            const std::size_t begin = begin_of(body), count = begin_of(body + 1) - begin;
            const auto one = [&](std::int64_t k) {
                LoadSum sum;
                add(at(body), begin + at(k), sum);
                return sum;
            };
            put(at(body), parallel::reduce(static_cast<std::int64_t>(count), LoadSum{}, one, join, piece));
        }
    }
}

void gather_loads(const SampleView& samples, const body::Motion& motion, const fluid::BoundaryParticles& particles,
                  FluidLoads& loads) {
    gather(samples, motion, particles.position, particles.pressure_force, loads.pressure);
    std::vector<Vec3> feet(particles.foot_velocity.empty() ? 0 : at(samples.size()));
    parallel::for_each(static_cast<std::int64_t>(feet.size()), [&](std::int64_t index) {
        const auto i = at(index), body = at(samples.body(i).value);
        feet[i] = motion.pose[body].position + foot_of(samples, motion, body, i);
    });
    gather(samples, motion, feet.empty() ? particles.position : feet, particles.viscous_force, loads.viscous);
}

}  // namespace riprap::coupling

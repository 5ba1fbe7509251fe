// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/rigid_map.hpp"

#include <cstdint>
#include <vector>

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

/// Samples of one body that are summed in one go: those with numbers from a multiple of this to the next, however many
/// of them are near water.
constexpr std::size_t piece = 4096;

/// Force, torque and pull of some samples.
struct LoadSum {
    Vec3 force{}, torque{};
    Sym3 pull{};

    LoadSum& operator+=(const LoadSum& b) {
        force += b.force;
        torque += b.torque;
        pull += b.pull;
        return *this;
    }
};

/// Sums the loads of samples of one body after another.
struct Gatherer {
    const SampleView& samples;
    const body::Motion& motion;
    std::span<const Vec3> place, sample_force;

    LoadSum of(std::size_t body, std::size_t begin, std::size_t end) const {
        LoadSum sum;
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3 arm = place[i] - motion.pose[body].position;
            sum.force += sample_force[i];
            sum.torque += cross(arm, sample_force[i]);
            if (motion.deforms()) {
                sum.pull += symmetric_product(sample_force[i], arm);
            }
        }
        return sum;
    }
    /// The first entry from `begin` up to `end` whose number is that of piece `k` or a later one.
    std::size_t begin_of_piece(std::size_t k, std::size_t begin, std::size_t end) const {
        while (begin < end) {
            const std::size_t middle = begin + (end - begin) / 2;
            if (samples.number(middle) < k * piece) {
                begin = middle + 1;
            } else {
                end = middle;
            }
        }
        return begin;
    }
    /// All of a body, whose entries are [begin, end): pieces in the order of their numbers.
    LoadSum all_of(std::size_t body, std::size_t begin, std::size_t end) const {
        if (begin == end) {
            return {};
        }
        const std::size_t first = samples.number(begin) / piece, last = samples.number(end - 1) / piece;
        std::vector<LoadSum> pieces(last - first + 1);
        parallel::for_each_uneven(static_cast<std::int64_t>(pieces.size()), 1, [&](std::int64_t k) {
            const std::size_t from = begin_of_piece(first + at(k), begin, end);
            pieces[at(k)] = of(body, from, begin_of_piece(first + at(k) + 1, from, end));
        });
        LoadSum sum;
        for (const LoadSum& one : pieces) {
            sum += one;
        }
        return sum;
    }
};

}  // namespace

void gather(const SampleView& samples, const body::Motion& motion, std::span<const Vec3> place,
            std::span<const Vec3> sample_force, body::Loads& loads) {
    const auto bodies = static_cast<std::int64_t>(motion.pose.size());
    loads.clear(motion.pose.size(), motion.deforms());
    const Gatherer gatherer{samples, motion, place, sample_force};
    const auto put = [&](std::size_t body, const LoadSum& sum) {
        loads.force[body] = sum.force;
        loads.torque[body] = sum.torque;
        if (motion.deforms()) {
            loads.pull[body] = sum.pull;
        }
    };
    // Samples are grouped by body, so each body has one range of them. Bodies of one piece are summed side by side,
    // those of several one after the other, piece by piece.
    std::vector<std::size_t> begin_of(at(bodies) + 1, at(samples.size()));
    std::vector<std::uint8_t> is_large(at(bodies));
    parallel::for_ranges(bodies, 16, [&](std::int64_t first, std::int64_t end) {
        std::size_t i = samples.begin_of(BodyId{static_cast<std::int32_t>(first)});
        for (std::int64_t body = first; body < end; ++body) {
            const std::size_t begin = begin_of[at(body)] = i;
            const std::size_t past = i < at(samples.size()) ? (samples.number(i) / piece + 1) * piece : 0;
            while (i < at(samples.size()) && samples.number(i) < past && samples.body(i).value == body) {
                ++i;
            }
            put(at(body), gatherer.of(at(body), begin, i));
            if (i < at(samples.size()) && samples.body(i).value == body) {
                is_large[at(body)] = 1;
                i = samples.begin_of(BodyId{static_cast<std::int32_t>(body + 1)});
            }
        }
    });
    for (std::int64_t body = 0; body < bodies; ++body) {
        if (is_large[at(body)] != 0) {
            put(at(body), gatherer.all_of(at(body), begin_of[at(body)], begin_of[at(body) + 1]));
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

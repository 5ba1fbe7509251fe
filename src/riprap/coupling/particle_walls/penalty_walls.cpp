// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/penalty_walls.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "riprap/core/index.hpp"
#include "riprap/coupling/particle_walls/near_parts.hpp"
#include "riprap/coupling/particle_walls/passage.hpp"
#include "riprap/coupling/particle_walls/touch.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"

namespace riprap::coupling {

namespace {

/// Particles whose pushes are kept together, and summed before blocks are: one of the blocks of their order.
constexpr std::int64_t block_size = parallel::reduce_block;
static_assert(block_size % fluid::SparseVectors::block_size == 0);

/// Sums the pushes of a block of particles per body, in the order of the particles.
void sum_by_body(const body::Motion& motion, const std::vector<PenaltyWalls::Push>& pushes,
                 std::vector<PenaltyWalls::Reaction>& reactions) {
    reactions.clear();
    for (const PenaltyWalls::Push& push : pushes) {
        auto of = std::ranges::lower_bound(reactions, push.body, {}, &PenaltyWalls::Reaction::body);
        if (of == reactions.end() || of->body != push.body) {
            of = reactions.insert(of, {push.body, {}, {}, {}});
        }
        const Vec3 arm = push.place - motion.pose[at(push.body)].position;
        of->force -= push.force;
        of->torque -= cross(arm, push.force);
        if (motion.deforms()) {
            of->pull += -1.0 * symmetric_product(push.force, arm);
        }
    }
}

/// Places all parts; those of dry bodies, and of a ground, which is met as one surface, reach nowhere.
void place_parts(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::Motion& motion,
                 std::span<const std::uint8_t> is_dry, std::span<const body::Ground> grounds, double reach,
                 std::vector<PlacedPart>& parts) {
    parts.resize(bodies.parts.size());
    parallel::for_each(static_cast<std::int64_t>(parts.size()), [&](std::int64_t p) {
        const body::Part& part = bodies.parts[at(p)];
        const auto b = at(part.body.value);
        const bool is_ground = std::ranges::find(grounds, part.body, &body::Ground::body) != grounds.end();
        const geometry::ConvexView view = shapes.view(part.shape);
        const bool is_wet = !is_ground && (is_dry.empty() || is_dry[b] == 0);
        parts[at(p)] = {
            view,
            {to_world(motion.pose[b], part.local.position), motion.pose[b].orientation * part.local.orientation},
            part.body.value,
            is_wet ? view.circumradius + reach : -1};
    });
}

/// Between opposite faces neither pushes beyond the middle.
void meet_in_the_middle(std::vector<Touch>& touches) {
    constexpr double looking = -0.5;
    for (Touch& one : touches) {
        for (const Touch& other : touches) {
            if (dot(one.normal, other.normal) < looking) {
                one.reach = std::min(one.reach, 0.5 * (one.distance + other.distance));
            }
        }
    }
}

/// Settings from the reach over the spacing and the stiffness over rho_0 c_0^2 dp^(dim-2).
PenaltySettings scaled_settings(const fluid::ParticleSettings& settings, double reach, double strength) {
    constexpr double damping_ratio = 0.5;
    const double stiffness = strength * settings.rest_density * settings.sound_speed * settings.sound_speed *
                             std::pow(settings.spacing, settings.domain.dimension - 2);
    return {reach * settings.spacing, stiffness, 2 * damping_ratio * std::sqrt(stiffness * settings.particle_mass),
            settings.spacing, settings.domain};
}

}  // namespace

PenaltySettings penalty_settings(const fluid::ParticleSettings& settings, double dt) {
    PenaltySettings penalty = scaled_settings(settings, 0.5, 0.1);
    penalty.dt = dt;
    return penalty;
}

PenaltySettings guard_settings(const fluid::ParticleSettings& settings, double dt) {
    PenaltySettings guard = scaled_settings(settings, 0.2, 0.5);
    guard.fastest_return = 0.05 * settings.sound_speed;
    guard.hardest = settings.particle_mass / dt;
    guard.dt = dt;
    return guard;
}

void PenaltyWalls::push(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::Motion& motion,
                        std::span<const std::uint8_t> is_dry, const PenaltySettings& settings,
                        std::span<const double> share, const fluid::ParticleState& particles,
                        fluid::SparseVectors& force, FluidLoads& loads) {
    const double within = 2 * settings.reach;  // where a face on the other side may limit the push
    find_grounds(shapes, bodies);
    std::vector<PlacedPart> parts;
    place_parts(shapes, bodies, motion, is_dry, grounds_, within, parts);
    NearParts near_parts;
    near_parts.find(parts, particles.position, settings.domain, within);
    force.reset(at(particles.size()));
    blocks_.resize(at((particles.size() + block_size - 1) / block_size));
    reactions_.resize(blocks_.size());
    passed_.assign(blocks_.size(), {});
    const fluid::PeriodicImages images(settings.domain);
    const PassageScene scene{bodies, motion, parts, is_dry, images, settings.spacing, settings.dt};
    parallel::for_ranges(particles.size(), block_size, [&](std::int64_t begin, std::int64_t end) {
        std::vector<Push>& pushes = blocks_[at(begin / block_size)];
        pushes.clear();
        std::vector<Touch> touches;
        PartsAround around(scene, std::span(particles.position).subspan(at(begin), at(end - begin)));
        for (std::int64_t i = begin; i < end; ++i) {
            const std::span<const std::int32_t> near = near_parts.of_block(i / NearParts::block_size);
            if (near.empty() && grounds_.empty()) {
                i = (i / NearParts::block_size + 1) * NearParts::block_size - 1;
                continue;
            }
            touches.clear();
            for (const std::int32_t part : near) {
                if (const auto touch = deepest_touch(parts[at(part)], particles.position[at(i)], within, images)) {
                    touches.push_back(*touch);
                }
            }
            for (const body::Ground& ground : grounds_) {
                if (!is_dry.empty() && is_dry[at(ground.body.value)] != 0) {
                    continue;
                }
                if (const auto touch = touch_ground(ground, motion.pose[at(ground.body.value)],
                                                    particles.position[at(i)], within, images)) {
                    touches.push_back(*touch);
                }
            }
            if (touches.empty()) {
                continue;
            }
            passed_[at(begin / block_size)].add(
                passage_of(scene, particles.position[at(i)], particles.velocity[at(i)], touches, around));
            meet_in_the_middle(touches);
            for (const Touch& touch : touches) {
                const double overlap = touch.reach - touch.distance;
                if (overlap <= 0) {
                    continue;
                }
                const double closing =
                    dot(particles.velocity[at(i)] - velocity_at(motion, touch.body, touch.place), touch.normal);
                const double factor = share.empty() ? 1 : share[at(touch.body)];
                const double most = settings.hardest * std::max(0.0, settings.fastest_return - closing);
                const double size =
                    std::min(most, settings.stiffness * overlap - settings.damping * std::min(0.0, closing));
                const Vec3 push = factor * size * touch.normal;
                force.add(at(i), push);
                pushes.push_back({touch.body, push, touch.place});
            }
        }
        sum_by_body(motion, pushes, reactions_[at(begin / block_size)]);
    });
    passages_ = {};
    for (const WallPassages& passed : passed_) {
        passages_.add(passed);
    }
    gather(bodies, motion, particles.blocks(), loads);
}

void PenaltyWalls::find_grounds(const geometry::ShapeSet& shapes, const body::BodySet& bodies) {
    if (parts_ != bodies.parts.size()) {
        grounds_ = body::find_grounds(bodies, shapes);
        parts_ = bodies.parts.size();
    }
}

/// Per body in the order of the blocks of particles.
void PenaltyWalls::gather(const body::BodySet& bodies, const body::Motion& motion, const parallel::Blocks& blocks,
                          FluidLoads& loads) const {
    const auto count = at(bodies.size());
    loads.pressure.clear(count, motion.deforms());
    loads.viscous.clear(count, motion.deforms());
    for (std::size_t k = 0; k < reactions_.size(); ++k) {
        if (!blocks[static_cast<std::int64_t>(k)].own) {
            continue;
        }
        for (const Reaction& reaction : reactions_[k]) {
            const auto b = at(reaction.body);
            loads.pressure.force[b] += reaction.force;
            loads.pressure.torque[b] += reaction.torque;
            if (motion.deforms()) {
                loads.pressure.pull[b] += reaction.pull;
            }
        }
    }
}

}  // namespace riprap::coupling

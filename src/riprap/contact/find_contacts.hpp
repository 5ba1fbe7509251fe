// SPDX-License-Identifier: Apache-2.0
#pragma once

// The body of ContactPipeline::find_contacts, for the source file of a physics and for tests.

#include "riprap/contact/pipeline.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {

template <ContactPhysics Physics>
double ContactPipeline::find_contacts(const Physics& physics, const ContactScene& scene, const body::BodyState& state,
                                      const body::BodyKinematics& kinematics, double sliding_time,
                                      ContactHistory& history) {
    map_history(history);
    is_carried_.assign(history.size(), 0);
    evaluate(physics, scene, state, kinematics, sliding_time, history);
    const double lost = lost_energy(history);
    collect(history);
    return lost;
}

template <ContactPhysics Physics>
void ContactPipeline::evaluate(const Physics& physics, const ContactScene& scene, const body::BodyState& state,
                               const body::BodyKinematics& kinematics, double sliding_time,
                               const ContactHistory& history) {
    // Up to `few` candidates one thread works through sooner than it wakes another.
    constexpr std::int64_t few = 256, share = 64;
    rows_.clear();  // they point into what is written now
    grain_ = pair_count() <= few ? few : share;
    found_.resize(at((pair_count() + grain_ - 1) / grain_));
    const auto side = [&](std::int32_t part) {
        const std::int32_t body = placed_.body[at(part)];
        return PairSide{.part = part,
                        .body = body,
                        .shape = scene.shapes.view(scene.bodies.parts[at(part)].shape),
                        .frame = placed_.frames[at(part)],
                        .material = scene.materials[scene.bodies.material[at(body)]],
                        .center = state.position[at(body)],
                        .velocity = state.velocity[at(body)],
                        .spin = kinematics.angular_velocity[at(body)],
                        .inverse_mass = kinematics.inverse_mass[at(body)],
                        .inverse_inertia = kinematics.inverse_inertia[at(body)]};
    };
    parallel::for_ranges(pair_count(), grain_, [&](std::int64_t begin, std::int64_t end) {
        std::vector<FoundContact>& chunk = found_[at(begin / grain_)];
        chunk.clear();
        FoundContacts found(history, chunk);
        for (std::int64_t p = begin; p < end; ++p) {
            const PartPair parts = cache_.pairs()[at(p)];
            if (!scene.left_out.empty() && (scene.left_out[at(placed_.body[at(parts.a)])] != 0 ||
                                            scene.left_out[at(placed_.body[at(parts.b)])] != 0)) {
                continue;
            }
            const PairSide a = side(parts.a), b = side(parts.b);
            const auto& surfaces =
                scene.materials.pair(scene.bodies.material[at(a.body)], scene.bodies.material[at(b.body)]);
            found.begin_pair(static_cast<std::int32_t>(p), parts, contact_begin_[at(p)]);
            physics.meet({a, b, surfaces, sliding_time}, separating_[at(p)], found);
            found.end_pair();
        }
        for (const FoundContact& contact : chunk) {
            if (contact.is_old()) {
                is_carried_[at(contact.old_contact)] = 1;
            }
        }
    });
}

}  // namespace riprap::contact

// SPDX-License-Identifier: Apache-2.0
#pragma once

// The body of ContactPipeline::find_contacts, for the source file of a physics and for tests.

#include <algorithm>

#include "riprap/contact/pipeline.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {

template <PairPhysics Physics>
double ContactPipeline::find_contacts(const Physics& physics, const ContactScene& scene, const body::BodyState& state,
                                      const body::BodyKinematics& kinematics, double sliding_time,
                                      ContactHistory& history) {
    map_history(history);
    is_carried_.assign(history.size(), 0);
    std::size_t contact_count = 0;
    for (std::int64_t begin = 0; begin < pair_count();) {
        const Wave wave = next_wave(begin);
        wave_.resize(std::max(wave_.size(), at(wave.chunk_count())));
        run_wave(wave, physics, scene, state, kinematics, sliding_time, history);
        contact_count = append_wave(wave, contact_count);
        begin = wave.end;
    }
    contact_begin_.back() = static_cast<std::int32_t>(contact_count);
    rows_.resize(contact_count);
    next_.resize(contact_count);
    const double lost = lost_energy(history);
    std::swap(history, next_);
    return lost;
}

template <PairPhysics Physics>
void ContactPipeline::run_wave(const Wave& wave, const Physics& physics, const ContactScene& scene,
                               const body::BodyState& state, const body::BodyKinematics& kinematics,
                               double sliding_time, const ContactHistory& history) {
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
    parallel::for_ranges(wave.end - wave.begin, wave.grain, [&](std::int64_t first, std::int64_t last) {
        std::vector<FoundContact>& chunk = wave_[at(first / wave.grain)];
        chunk.clear();
        FoundContacts found(history, chunk);
        for (std::int64_t p = wave.begin + first; p < wave.begin + last; ++p) {
            const PartPair parts = cache_.pairs()[at(p)];
            const PairSide a = side(parts.a), b = side(parts.b);
            const auto& surfaces =
                scene.materials.pair(scene.bodies.material[at(a.body)], scene.bodies.material[at(b.body)]);
            found.begin_pair(static_cast<std::int32_t>(p), parts, contact_begin_[at(p)]);
            physics.find_contacts({a, b, surfaces, sliding_time}, separating_[at(p)], found);
            found.end_pair();
        }
    });
}

}  // namespace riprap::contact

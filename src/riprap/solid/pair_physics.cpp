// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/pair_physics.hpp"

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"

namespace riprap::solid {

std::vector<BodyKind> kinds_by_lists(const SolidScene& scene) {
    std::vector<BodyKind> kinds(at(scene.bodies.size()), BodyKind::faces);
    for (const body::GivenSpheres& given : scene.spheres) {
        kinds[at(given.body.value)] = BodyKind::spheres;
    }
    return kinds;
}

std::vector<UnansweredBody> unanswered_bodies(const body::BodySet& bodies, std::span<const BodyKind> kinds,
                                              std::span<const PairOfKinds> pairs) {
    constexpr std::size_t count = kind_names.size();
    std::array<std::int32_t, count> first{};
    std::array<bool, count> can_move{};
    first.fill(-1);
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        const auto kind = static_cast<std::size_t>(kinds[at(b)]);
        first[kind] = first[kind] < 0 ? b : first[kind];
        can_move[kind] = can_move[kind] || may_move(bodies, at(b));
    }
    std::vector<UnansweredBody> found;
    for (std::size_t kind = 0; kind < count; ++kind) {
        UnansweredBody body{BodyId{first[kind]}, static_cast<BodyKind>(kind), {}};
        for (std::size_t other = 0; other <= kind && first[kind] >= 0; ++other) {
            const bool may_meet = first[other] >= 0 && (can_move[kind] || can_move[other]);
            if (may_meet && !answers(pairs, body.kind, static_cast<BodyKind>(other))) {
                body.others.push_back(static_cast<BodyKind>(other));
            }
        }
        if (!body.others.empty()) {
            found.push_back(std::move(body));
        }
    }
    return found;
}

}  // namespace riprap::solid

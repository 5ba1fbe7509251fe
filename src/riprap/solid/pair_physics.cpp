// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/pair_physics.hpp"

#include <algorithm>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/material/property_keys.hpp"

namespace riprap::solid {

std::vector<BodyKind> kinds_by_lists(const SolidScene& scene) {
    std::vector<BodyKind> kinds(at(scene.bodies.size()), BodyKind::faces);
    for (const body::GivenSpheres& given : scene.spheres) {
        kinds[at(given.body.value)] = BodyKind::spheres;
    }
    return kinds;
}

std::vector<material::PropertyUse> joined(std::span<const PhysicsReads> physics) {
    std::vector<material::PropertyUse> uses;
    for (const PhysicsReads& one : physics) {
        for (const material::PropertyUse& use : one.uses) {
            add_use(uses, use);
        }
    }
    return uses;
}

namespace {

/// Kinds of bodies that are in a scene, and those of which one can move.
struct KindsThere {
    std::array<bool, kind_names.size()> is_there{}, can_move{};

    KindsThere(const SolidScene& scene, std::span<const BodyKind> kinds) {
        for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
            const auto kind = static_cast<std::size_t>(kinds[at(b)]);
            is_there[kind] = true;
            can_move[kind] = can_move[kind] || may_move(scene.bodies, at(b));
        }
    }
    bool meet(const PairOfKinds& kinds) const {
        const auto a = static_cast<std::size_t>(kinds.a), b = static_cast<std::size_t>(kinds.b);
        return is_there[a] && is_there[b] && (can_move[a] || can_move[b]);
    }
};

}  // namespace

std::optional<bool> is_read_in_scene(const SolidScene& scene, std::span<const BodyKind> kinds,
                                     std::span<const PhysicsReads> physics, material::Property property) {
    const KindsThere there(scene, kinds);
    std::optional<bool> is_read;
    for (const PhysicsReads& one : physics) {
        if (there.meet(one.kinds)) {
            is_read = is_read.value_or(false) || std::ranges::any_of(one.uses, [property](const auto& use) {
                          return use.property == property && use.acts;
                      });
        }
    }
    return is_read;
}

std::vector<LackingProperty> lacking_properties(const SolidScene& scene, std::span<const BodyKind> kinds,
                                                std::span<const PhysicsReads> physics) {
    constexpr std::size_t count = kind_names.size();
    const KindsThere there(scene, kinds);
    std::array<std::vector<material::PropertyUse>, count> of_kind;
    for (const PhysicsReads& one : physics) {
        const auto a = static_cast<std::size_t>(one.kinds.a), b = static_cast<std::size_t>(one.kinds.b);
        if (there.meet(one.kinds)) {
            of_kind[a].insert(of_kind[a].end(), one.uses.begin(), one.uses.end());
            of_kind[b].insert(of_kind[b].end(), one.uses.begin(), one.uses.end());
        }
    }
    std::vector<LackingProperty> found;
    std::vector<std::array<bool, count>> is_seen(at(scene.materials.size()));
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        const MaterialId material = scene.bodies.material[at(b)];
        const auto kind = static_cast<std::size_t>(kinds[at(b)]);
        if (is_seen[at(material.value)][kind]) {
            continue;
        }
        is_seen[at(material.value)][kind] = true;
        std::vector<material::PropertyUse> uses;
        for (const material::PropertyUse& use : of_kind[kind]) {
            add_use(uses, use);
        }
        for (const material::PropertyUse& use : uses) {
            if (use.is_required && !is_given(scene.materials[material], use.property)) {
                found.push_back({BodyId{b}, use.property});
            }
        }
    }
    return found;
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

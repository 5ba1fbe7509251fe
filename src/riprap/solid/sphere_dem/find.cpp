// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/find.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/lanes.hpp"
#include "riprap/solid/sphere_dem/place.hpp"

namespace riprap::solid::sphere_dem {

namespace {

constexpr std::int64_t chunk_groups = 256;  ///< groups of eight slots that one thread takes at a time

std::uint64_t key_of(const Slots& slots, std::size_t slot) {
    return static_cast<std::uint64_t>(slots.a[slot]) << 32 | static_cast<std::uint64_t>(slots.b[slot]);
}

/// Lists the slots in which a sphere is B.
void link_incoming(std::size_t sphere_count, Slots& slots) {
    slots.incoming_begin.assign(sphere_count + 1, 0);
    const auto count = at(slots.count);
    for (std::size_t s = 0; s < count; ++s) {
        ++slots.incoming_begin[at(slots.b[s]) + 1];
    }
    for (std::size_t i = 0; i < sphere_count; ++i) {
        slots.incoming_begin[i + 1] += slots.incoming_begin[i];
    }
    slots.incoming.resize(count);
    std::vector<std::uint32_t> next(slots.incoming_begin.begin(), slots.incoming_begin.end() - 1);
    for (std::size_t s = 0; s < count; ++s) {
        slots.incoming[next[at(slots.b[s])]++] = static_cast<std::uint32_t>(s);
    }
}

/// Sorts the pairs of the search into slots of spheres and candidates with walls.
void fill_slots(const SphereModel& model, SphereScratch& scratch) {
    Slots& slots = scratch.slots;
    const std::int32_t spheres = model.spheres.size();
    slots.a.clear();
    slots.b.clear();
    slots.begin.assign(at(spheres) + 1, 0);
    scratch.wall_pairs.clear();
    for (const contact::PartPair pair : scratch.pairs.pairs()) {
        if (pair.b < spheres) {
            slots.a.push_back(pair.a);
            slots.b.push_back(pair.b);
            ++slots.begin[at(pair.a) + 1];
        } else if (pair.a < spheres && scratch.placed.radius[at(pair.b)] > 0) {
            scratch.wall_pairs.push_back({pair.a, pair.b - spheres});
        }
    }
    for (std::size_t i = 0; i < at(spheres); ++i) {
        slots.begin[i + 1] += slots.begin[i];
    }
    slots.count = static_cast<std::int64_t>(slots.a.size());
    link_incoming(at(spheres), slots);
    if (slots.count > 0) {
        slots.a.resize(at(8 * slots.group_count()), slots.a.back());
        slots.b.resize(at(8 * slots.group_count()), slots.b.back());
    }
    slots.touching.assign(at(slots.group_count()), 0);
    slots.load.assign(at(slots.count) + 1, {});  // gather_loads reads two numbers beyond the last
}

/// One bit per slot of a group whose spheres overlap.
std::uint32_t touching_bits(const Placed& placed, const Slots& slots, std::int64_t group) {
    RowIndex a, b;
    std::copy_n(&slots.a[at(8 * group)], 8, a.row);
    std::copy_n(&slots.b[at(8 * group)], 8, b.row);
    const FourByEight from = load_four<12>(&placed.records[0].x, a), to = load_four<12>(&placed.records[0].x, b);
    const Eight x = from.a - to.a, y = from.b - to.b, z = from.c - to.c, reach = from.d + to.d;
    const std::uint32_t bits = bits_below(x * x + y * y + z * z, reach * reach);
    const std::int64_t left = slots.count - 8 * group;
    return left >= 8 ? bits : bits & ((1U << left) - 1);
}

/// Looks at all slots. @returns true when some pair has begun or ceased to touch
bool look(SphereScratch& scratch) {
    Slots& slots = scratch.slots;
    const std::int64_t groups = slots.group_count();
    const std::int64_t chunks = (groups + chunk_groups - 1) / chunk_groups;
    scratch.chunk_count.assign(at(chunks) + 1, 0);
    std::vector<std::uint8_t> has_changed(at(chunks), 0);
    parallel::for_ranges(groups, chunk_groups, [&](std::int64_t begin, std::int64_t end) {
        std::uint32_t count = 0, changed = 0;
        for (std::int64_t g = begin; g < end; ++g) {
            const std::uint32_t bits = touching_bits(scratch.placed, slots, g);
            const std::uint32_t ended = slots.touching[at(g)] & ~bits;
            changed |= slots.touching[at(g)] ^ bits;
            for (std::uint32_t left = ended; left != 0; left &= left - 1) {
                slots.load[at(8 * g + std::countr_zero(left))] = {};
            }
            slots.touching[at(g)] = static_cast<std::uint8_t>(bits);
            count += static_cast<std::uint32_t>(std::popcount(bits));
        }
        scratch.chunk_count[at(begin / chunk_groups)] = count;
        has_changed[at(begin / chunk_groups)] = changed != 0 ? 1 : 0;
    });
    return std::ranges::any_of(has_changed, [](std::uint8_t c) { return c != 0; });
}

/// Energy that tangential springs hold [J]; that of rolling springs is small and goes with the next loss.
double spring_energy(const Springs& springs, std::size_t c) {
    const double stiffness = std::abs(springs.stiffness[c]);
    return stiffness > 0 ? norm_squared(springs.force[c]) / (2 * stiffness) : 0;
}

/// Replaces the rows of `springs` by those of the pairs that touch now. @returns energy of lost springs [J]
double carry_springs(bool has_rolling, Springs& springs, SphereScratch& scratch) {
    Slots& slots = scratch.slots;
    Springs& old = scratch.old;
    std::swap(old, springs);
    const bool had_rolling = old.rolling.size() == old.pair.size();
    const std::uint32_t count = parallel::exclusive_scan<std::uint32_t>(scratch.chunk_count, scratch.chunk_count);
    springs.pair.resize(count);
    springs.force.resize(count);
    springs.stiffness.resize(count);
    springs.rolling.assign(has_rolling ? count : 0, {});
    scratch.contact_slot.resize(count);
    scratch.is_carried.assign(old.size(), 0);
    parallel::for_ranges(slots.group_count(), chunk_groups, [&](std::int64_t begin, std::int64_t end) {
        std::size_t to = scratch.chunk_count[at(begin / chunk_groups)];
        const auto first = std::ranges::lower_bound(old.pair, key_of(slots, at(8 * begin)));
        std::size_t from = at(first - old.pair.begin());
        for (std::int64_t g = begin; g < end; ++g) {
            for (std::uint32_t left = slots.touching[at(g)]; left != 0; left &= left - 1) {
                const auto slot = at(8 * g + std::countr_zero(left));
                const std::uint64_t key = key_of(slots, slot);
                while (from < old.size() && old.pair[from] < key) {
                    ++from;
                }
                const bool is_old = from < old.size() && old.pair[from] == key;
                springs.pair[to] = key;
                springs.force[to] = is_old ? old.force[from] : Vec3{};
                springs.stiffness[to] = is_old ? old.stiffness[from] : 0;
                if (has_rolling && had_rolling && is_old) {
                    springs.rolling[to] = old.rolling[from];
                }
                if (is_old) {
                    scratch.is_carried[from] = 1;
                }
                scratch.contact_slot[to++] = static_cast<std::uint32_t>(slot);
            }
        }
    });
    return parallel::reduce(
        static_cast<std::int64_t>(old.size()), 0.0,
        [&](std::int64_t c) { return scratch.is_carried[at(c)] != 0 ? 0.0 : spring_energy(old, at(c)); },
        [](double x, double y) { return x + y; });
}

}  // namespace

double find_contacts(const SphereModel& model, SphereState& state, SphereScratch& scratch) {
    const Placed& placed = scratch.placed;
    const contact::PartBounds bounds{placed.center, placed.radius, placed.body, placed.is_mobile};
    bool is_new = scratch.pairs.update(bounds, placed.giants,
                                       {model.settings.skin * placed.median_radius, model.settings.grid_factor});
    if (is_new) {
        fill_slots(model, scratch);
    }
    is_new = look(scratch) || is_new || scratch.evaluations != state.evaluations;
    return is_new ? carry_springs(model.settings.rolling == contact::RollingLaw::spring, state.contacts, scratch) : 0;
}

}  // namespace riprap::solid::sphere_dem

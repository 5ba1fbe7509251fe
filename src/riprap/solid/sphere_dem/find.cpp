// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/find.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "riprap/core/exact_sum.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/lanes.hpp"
#include "riprap/solid/sphere_dem/load_rows.hpp"
#include "riprap/solid/sphere_dem/place.hpp"

namespace riprap::solid::sphere_dem {

namespace {

constexpr std::int64_t chunk_groups = 256;  ///< groups of eight slots that one thread takes at a time

std::uint64_t key_of(const Slots& slots, std::size_t slot) {
    return static_cast<std::uint64_t>(slots.a[slot]) << 32 | static_cast<std::uint64_t>(slots.b[slot]);
}

/// Of a sampled body, is the sphere one that meets such a wall? Triangles have no inside: the sharp samples of edges
/// could come through, so round ones meet them, which keep a radius off the edge. Parts meet the sharp ones.
bool is_for(const SphereModel& model, std::int32_t sphere, std::int32_t wall) {
    const SphereSet& spheres = model.spheres;
    const bool is_triangle = wall >= model.bodies.part_count();
    if (spheres.is_sampled[at(spheres.body[at(sphere)])] == 0 || spheres.face_normal[at(sphere)] != Vec3{}) {
        return true;
    }
    return spheres.is_sharp(sphere) != is_triangle;
}

/// Sorts the pairs of the search into slots of spheres and candidates with walls.
void fill_slots(const SphereModel& model, SphereScratch& scratch) {
    Slots& slots = scratch.slots;
    const std::int32_t spheres = model.spheres.size();
    slots.a.clear();
    slots.b.clear();
    scratch.wall_pairs.clear();
    for (const contact::PartPair pair : scratch.pairs.pairs()) {
        const std::int32_t a = scratch.placed.body[at(pair.a)], b = scratch.placed.body[at(pair.b)];
        if (pair.b < spheres) {
            if (!model.spheres.meets_surface(a, b) && !model.spheres.meets_surface(b, a)) {
                slots.a.push_back(pair.a);
                slots.b.push_back(pair.b);
            }
        } else if (pair.a < spheres && scratch.placed.radius[at(pair.b)] > 0 &&
                   (model.spheres.count_of(b) == 0 || model.spheres.touches(pair.a, b)) &&
                   is_for(model, pair.a, pair.b - spheres)) {
            scratch.wall_pairs.push_back({pair.a, pair.b - spheres});
        }
    }
    slots.count = static_cast<std::int64_t>(slots.a.size());
    place_rows(model.spheres, slots, scratch.load_rows);
    if (slots.count > 0) {
        slots.a.resize(at(8 * slots.group_count()), slots.a.back());
        slots.b.resize(at(8 * slots.group_count()), slots.b.back());
    }
    slots.touching.assign(at(slots.group_count()), 0);
    slots.found.assign(at(slots.group_count()), 0);
    slots.is_fresh = true;
}

/// One bit per slot of a group whose spheres overlap.
std::uint32_t touching_bits(const Placed& placed, const Slots& slots, std::int64_t group) {
    std::uint32_t bits = 0;
    for (std::int64_t part = 0; part < parts; ++part) {
        const std::int64_t first = part * lanes_in<Native>;
        RowsOf<Native> a, b;
        std::copy_n(&slots.a[at(8 * group + first)], lanes_in<Native>, a.row);
        std::copy_n(&slots.b[at(8 * group + first)], lanes_in<Native>, b.row);
        const FourOf<Native> from = load_four<12>(&placed.records[0].x, a), to = load_four<12>(&placed.records[0].x, b);
        const Native x = from.a - to.a, y = from.b - to.b, z = from.c - to.c, reach = from.d + to.d;
        bits |= bits_below(x * x + y * y + z * z, reach * reach) << first;
    }
    const std::int64_t left = slots.count - 8 * group;
    return left >= 8 ? bits : bits & ((1U << left) - 1);
}

/// Looks at all slots. @returns true when some pair has begun or ceased to touch
bool look(SphereScratch& scratch) {
    Slots& slots = scratch.slots;
    const std::int64_t groups = slots.group_count();
    const std::int64_t chunks = (groups + chunk_groups - 1) / chunk_groups;
    scratch.count.assign(at(chunks) + 1, 0);
    scratch.has_changed.assign(at(chunks), 0);
    parallel::for_ranges(groups, chunk_groups, [&](std::int64_t begin, std::int64_t end) {
        std::uint32_t count = 0, changed = 0;
        for (std::int64_t g = begin; g < end; ++g) {
            const std::uint32_t bits = touching_bits(scratch.placed, slots, g);
            changed |= slots.touching[at(g)] ^ bits;
            slots.found[at(g)] = static_cast<std::uint8_t>(bits);
            count += static_cast<std::uint32_t>(std::popcount(bits));
        }
        scratch.count[at(begin / chunk_groups)] = count;
        scratch.has_changed[at(begin / chunk_groups)] = changed != 0 ? 1 : 0;
    });
    return std::ranges::any_of(scratch.has_changed, [](std::uint8_t c) { return c != 0; });
}

/// Energy that tangential springs hold [J]; that of rolling springs is small and goes with the next loss.
double spring_energy(const Springs& springs, std::size_t c) {
    const double stiffness = std::abs(springs.stiffness[c]);
    return stiffness > 0 ? norm_squared(springs.force[c]) / (2 * stiffness) : 0;
}

/// Moves rows of springs from the old list to the new one.
struct Carry {
    const Springs& old;
    const std::vector<ContactEnds>& old_ends;
    Springs& springs;
    std::vector<ContactEnds>& ends;
    const Slots& slots;
    bool has_rolling, had_rolling;

    /// Copies `count` rows that follow each other.
    void rows(std::size_t from, std::size_t to, std::size_t count) const {
        const auto copy = [&](const auto& source, auto& target) {
            std::copy_n(source.data() + from, count, target.data() + to);
        };
        copy(old.pair, springs.pair);
        copy(old.force, springs.force);
        copy(old.stiffness, springs.stiffness);
        if (has_rolling && had_rolling) {
            copy(old.rolling, springs.rolling);
        }
    }
    void begin(std::size_t slot, std::size_t to) const {
        springs.pair[to] = key_of(slots, slot);
        springs.force[to] = {};
        springs.stiffness[to] = 0;
        if (has_rolling) {
            springs.rolling[to] = {};
        }
    }

    /// The groups [begin, end), which hold the same slots as before: only groups whose contacts have changed are looked
    /// at one by one.
    void same_slots(std::int64_t begin_group, std::int64_t end, std::size_t from, std::size_t to,
                    std::vector<double>& dropped) const {
        std::size_t run = 0;  // rows of unchanged groups that wait to be copied
        const auto flush = [&] {
            rows(from, to, run);
            std::copy_n(old_ends.data() + from, run, ends.data() + to);
            from += run;
            to += run;
            run = 0;
        };
        for (std::int64_t g = begin_group; g < end; ++g) {
            const std::uint32_t now = slots.found[at(g)], before = slots.touching[at(g)];
            if (now == before) {
                run += static_cast<std::size_t>(std::popcount(now));
                continue;
            }
            flush();
            for (std::uint32_t left = now | before; left != 0; left &= left - 1) {
                const std::uint32_t bit = left & (~left + 1);
                const auto slot = at(8 * g + std::countr_zero(left));
                if ((now & bit) == 0) {
                    dropped.push_back(spring_energy(old, from++));
                    continue;
                }
                if ((before & bit) != 0) {
                    rows(from++, to, 1);
                } else {
                    begin(slot, to);
                }
                ends[to++] = slots.ends[slot];
            }
        }
        flush();
    }

    /// The groups [begin, end) where slots are new or springs were put back: rows are found by their pair.
    void new_slots(std::int64_t begin_group, std::int64_t end, std::size_t to, std::vector<double>& dropped) const {
        const auto row_of = [&](std::int64_t group) {
            return at(std::ranges::lower_bound(old.pair, key_of(slots, at(8 * group))) - old.pair.begin());
        };
        std::size_t from = begin_group == 0 ? 0 : row_of(begin_group);
        const std::size_t last = end == slots.group_count() ? old.size() : row_of(end);
        for (std::int64_t g = begin_group; g < end; ++g) {
            for (std::uint32_t left = slots.found[at(g)]; left != 0; left &= left - 1) {
                const auto slot = at(8 * g + std::countr_zero(left));
                const std::uint64_t key = key_of(slots, slot);
                for (; from < last && old.pair[from] < key; ++from) {
                    dropped.push_back(spring_energy(old, from));
                }
                if (from < last && old.pair[from] == key) {
                    rows(from++, to, 1);
                } else {
                    begin(slot, to);
                }
                ends[to++] = slots.ends[slot];
            }
        }
        for (; from < last; ++from) {
            dropped.push_back(spring_energy(old, from));
        }
    }
};

/// Replaces the rows of `springs` by those of the pairs that touch now. @returns energy of lost springs [J]
double carry_springs(bool has_rolling, bool are_same_slots, Springs& springs, SphereScratch& scratch) {
    Slots& slots = scratch.slots;
    std::swap(scratch.old, springs);
    std::swap(scratch.old_ends, scratch.ends);
    std::swap(scratch.old_first_row, scratch.first_row);
    const Springs& old = scratch.old;
    scratch.first_row.resize(scratch.count.size());
    const std::uint32_t count = parallel::exclusive_scan<std::uint32_t>(scratch.count, scratch.first_row);
    springs.pair.resize(count);
    springs.force.resize(count);
    springs.stiffness.resize(count);
    const bool had_rolling = old.rolling.size() == old.size();
    springs.rolling.resize(has_rolling ? count : 0);
    if (!had_rolling) {
        std::ranges::fill(springs.rolling, Vec3{});
    }
    scratch.ends.resize(count);
    const Carry carry{old, scratch.old_ends, springs, scratch.ends, slots, has_rolling, had_rolling};
    const std::int64_t groups = slots.group_count();
    scratch.dropped.resize(at((groups + chunk_groups - 1) / chunk_groups));
    parallel::for_ranges(groups, chunk_groups, [&](std::int64_t begin, std::int64_t end) {
        const auto chunk = at(begin / chunk_groups);
        std::vector<double>& dropped = scratch.dropped[chunk];
        dropped.clear();
        if (are_same_slots) {
            carry.same_slots(begin, end, scratch.old_first_row[chunk], scratch.first_row[chunk], dropped);
        } else {
            carry.new_slots(begin, end, scratch.first_row[chunk], dropped);
        }
    });
    std::swap(slots.touching, slots.found);
    slots.is_fresh = false;
    ExactSum lost;  // so that the sum depends neither on the slots nor on who has them
    for (const std::vector<double>& dropped : scratch.dropped) {
        for (const double energy : dropped) {
            lost.add(energy);
        }
    }
    for (std::size_t c = 0; groups == 0 && c < old.size(); ++c) {
        lost.add(spring_energy(old, c));
    }
    return lost.value();
}

}  // namespace

void find_candidates(const SphereModel& model, SphereScratch& scratch) {
    const Placed& placed = scratch.placed;
    const contact::PartBounds bounds{placed.center, placed.radius, placed.body, placed.is_mobile};
    if (scratch.pairs.update(bounds, placed.giants,
                             {model.settings.skin * placed.median_radius, model.settings.grid_factor})) {
        fill_slots(model, scratch);
    }
}

double find_contacts(const SphereModel& model, SphereState& state, SphereScratch& scratch) {
    find_candidates(model, scratch);
    const bool are_same = !scratch.slots.is_fresh && scratch.evaluations == state.evaluations;
    const bool have_changed = look(scratch);
    return have_changed || !are_same
               ? carry_springs(model.settings.rolling == contact::RollingLaw::spring, are_same, state.contacts, scratch)
               : 0;
}

}  // namespace riprap::solid::sphere_dem

// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/load_rows.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/lanes.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Cuts the spheres into blocks of their numbers.
void cut_blocks(const SphereSet& spheres, LoadRows& rows) {
    rows.first_sphere.clear();
    std::int32_t block = -1;
    for (std::int32_t s = 0; s < spheres.size(); ++s) {
        if (const std::int32_t of = spheres.number_of(s) / LoadRows::block_spheres; of != block) {
            rows.first_sphere.push_back(s);
            block = of;
        }
    }
    rows.first_sphere.push_back(spheres.size());
}

/// Gives the ends of every slot their rows.
/// @param elsewhere  takes the spheres that blocks have met elsewhere, block after block: the rows behind their own
void place_ends(std::int32_t sphere_count, Slots& slots, LoadRows& rows, std::vector<std::int32_t>& elsewhere) {
    constexpr std::uint32_t none = ~0U;
    std::vector<std::uint32_t> row_of(at(sphere_count), none);  // of spheres that the block has met elsewhere
    rows.first_row.assign(1, 0);
    rows.own_row.resize(at(sphere_count));
    slots.ends.resize(at(slots.count));
    std::size_t s = 0;
    std::uint32_t next = 0;
    for (std::size_t block = 0; block + 1 < rows.first_sphere.size(); ++block) {
        const std::int32_t begin = rows.first_sphere[block], end = rows.first_sphere[block + 1];
        const std::uint32_t own = next;
        const std::size_t first = elsewhere.size();
        for (std::int32_t sphere = begin; sphere < end; ++sphere) {
            rows.own_row[at(sphere)] = next++;
        }
        for (; s < slots.ends.size() && slots.a[s] < end; ++s) {
            const std::int32_t b = slots.b[s];
            if (b >= end && row_of[at(b)] == none) {
                row_of[at(b)] = next++;
                elsewhere.push_back(b);
            }
            slots.ends[s] = {own + static_cast<std::uint32_t>(slots.a[s] - begin),
                             b < end ? own + static_cast<std::uint32_t>(b - begin) : row_of[at(b)]};
        }
        for (std::size_t k = first; k < elsewhere.size(); ++k) {
            row_of[at(elsewhere[k])] = none;
        }
        rows.first_row.push_back(next);
    }
    rows.rows.resize(next);
}

/// Lists by sphere the rows that other blocks have of it.
void list_merges(std::int32_t sphere_count, const std::vector<std::int32_t>& elsewhere, LoadRows& rows) {
    std::vector<std::uint32_t> begin(at(sphere_count) + 1, 0);
    for (const std::int32_t sphere : elsewhere) {
        ++begin[at(sphere) + 1];
    }
    for (std::size_t i = 0; i < at(sphere_count); ++i) {
        begin[i + 1] += begin[i];
    }
    rows.merge_begin.clear();
    for (const std::int32_t first : rows.first_sphere) {
        rows.merge_begin.push_back(begin[at(first)]);
    }
    rows.merges.resize(elsewhere.size());
    std::size_t k = 0;
    for (std::int64_t block = 0; block < rows.block_count(); ++block) {
        const auto own = static_cast<std::uint32_t>(rows.first_sphere[at(block + 1)] - rows.first_sphere[at(block)]);
        for (std::uint32_t row = rows.first_row[at(block)] + own; row < rows.first_row[at(block) + 1]; ++row, ++k) {
            rows.merges[begin[at(elsewhere[k])]++] = {row, rows.own_row[at(elsewhere[k])]};
        }
    }
}

}  // namespace

void place_rows(const SphereSet& spheres, Slots& slots, LoadRows& rows) {
    std::vector<std::int32_t> elsewhere;
    cut_blocks(spheres, rows);
    place_ends(spheres.size(), slots, rows, elsewhere);
    list_merges(spheres.size(), elsewhere, rows);
}

void gather_loads(const SphereModel& model, const body::BodyState& state, SphereScratch& scratch) {
    LoadRows& rows = scratch.load_rows;
    parallel::for_each_uneven(rows.block_count(), 1, [&](std::int64_t block) {
        for (std::uint32_t k = rows.merge_begin[at(block)]; k < rows.merge_begin[at(block) + 1]; ++k) {
            double* to = &rows.rows[rows.merges[k].to].force.x;
            (Eight::load(to) + Eight::load(&rows.rows[rows.merges[k].from].force.x)).store(to);
        }
    });
    const auto bodies = at(model.bodies.size());
    scratch.loads.force.resize(bodies);
    scratch.loads.torque.resize(bodies);
    parallel::for_each(model.bodies.size(), [&](std::int64_t index) {
        const auto body = at(index);
        Vec3 force{}, torque{};
        for (std::int32_t s = model.spheres.begin[body]; s < model.spheres.begin[body + 1]; ++s) {
            const LoadRow& sum = rows.rows[rows.own_row[at(s)]];
            force += sum.force;
            torque += sum.torque;
            if (!(model.spheres.local[at(s)] == Vec3{})) {
                torque += cross(scratch.placed.center[at(s)] - state.position[body], sum.force);
            }
        }
        scratch.loads.force[body] = force;
        scratch.loads.torque[body] = torque;
    });
}

}  // namespace riprap::solid::sphere_dem

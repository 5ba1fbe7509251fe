// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/load_rows.hpp"

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/lanes.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Gives the ends of every slot their rows.
/// @param elsewhere  takes the spheres that blocks have met elsewhere, block after block: the rows behind their own
void place_ends(std::int32_t sphere_count, Slots& slots, LoadRows& rows, std::vector<std::int32_t>& elsewhere) {
    constexpr std::uint32_t none = ~0U;
    std::vector<std::uint32_t> row_of(at(sphere_count), none);  // of spheres that the block has met elsewhere
    rows.first_row.assign(1, 0);
    slots.ends.resize(at(slots.count));
    std::size_t s = 0;
    std::uint32_t next = 0;
    for (std::int32_t begin = 0; begin < sphere_count; begin += LoadRows::block_spheres) {
        const std::int32_t end = std::min(begin + LoadRows::block_spheres, sphere_count);
        const std::uint32_t own = next;
        const std::size_t first = elsewhere.size();
        next += static_cast<std::uint32_t>(end - begin);
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
    for (std::int32_t first = 0; first < sphere_count; first += LoadRows::block_spheres) {
        rows.merge_begin.push_back(begin[at(first)]);
    }
    rows.merge_begin.push_back(begin.back());
    rows.merges.resize(elsewhere.size());
    std::size_t k = 0;
    for (std::int64_t block = 0; block < rows.block_count(); ++block) {
        const auto own = static_cast<std::uint32_t>(
            std::min<std::int64_t>(LoadRows::block_spheres, sphere_count - block * LoadRows::block_spheres));
        for (std::uint32_t row = rows.first_row[at(block)] + own; row < rows.first_row[at(block) + 1]; ++row, ++k) {
            rows.merges[begin[at(elsewhere[k])]++] = {row, rows.own_row(elsewhere[k])};
        }
    }
}

}  // namespace

void place_rows(std::int32_t sphere_count, Slots& slots, LoadRows& rows) {
    std::vector<std::int32_t> elsewhere;
    place_ends(sphere_count, slots, rows, elsewhere);
    list_merges(sphere_count, elsewhere, rows);
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
            const LoadRow& sum = rows.rows[rows.own_row(s)];
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

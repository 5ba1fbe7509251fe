// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/pipeline.hpp"

#include <algorithm>
#include <string_view>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {

namespace {

/// Makes a buffer at least so long, without the doubling of std::vector: its length changes little from step to step.
template <class T>
void grow_closely(std::vector<T>& buffer, std::size_t size) {
    if (size > buffer.capacity()) {
        buffer.reserve(size + size / 32);
    }
    if (size > buffer.size()) {
        buffer.resize(size);
    }
}

}  // namespace

void ContactPipeline::place_parts(const ContactScene& scene, const body::BodyState& state) {
    contact::place_parts(scene.shapes, scene.bodies, state, placed_);
    cache_settings_ = {.skin = scene.skin * placed_.median_radius, .grid_factor = scene.grid_factor};
}

bool ContactPipeline::find_pairs() {
    const bool is_new = cache_.update(placed_.bounds(), placed_.giants, cache_settings_);
    if (is_new) {
        separating_.assign(cache_.pairs().size(), {});
        contact_begin_.clear();
    }
    return is_new;
}

ContactPipeline::Wave ContactPipeline::next_wave(std::int64_t begin) const {
    constexpr std::int64_t chunk = 16, least = 32 * chunk;
    // Candidates that one thread works through sooner than it wakes another.
    constexpr std::int64_t small = 256;
    const std::int64_t eighth = (pair_count() / 8 + chunk - 1) / chunk * chunk;
    const std::int64_t end = std::min(pair_count(), begin + std::max(least, eighth));
    return {begin, end, end - begin <= small ? small : chunk};
}

bool ContactPipeline::are_rows_of(const ContactHistory& history) const {
    return rows_.size() == history.size() &&
           parallel::reduce(
               static_cast<std::int64_t>(rows_.size()), true,
               [&](std::int64_t i) { return pair_key(rows_[at(i)].parts) == history.pair[at(i)]; },
               [](bool a, bool b) { return a && b; });
}

void ContactPipeline::map_history(const ContactHistory& history) {
    const auto pairs = cache_.pairs();
    if (contact_begin_.size() == pairs.size() + 1 && are_rows_of(history)) {
        return;
    }
    contact_begin_.resize(pairs.size() + 1);
    parallel::for_each(static_cast<std::int64_t>(pairs.size()), [&](std::int64_t p) {
        const auto found = std::lower_bound(history.pair.begin(), history.pair.end(), pair_key(pairs[at(p)]));
        contact_begin_[at(p)] = static_cast<std::int32_t>(found - history.pair.begin());
    });
}

std::size_t ContactPipeline::append_wave(const Wave& wave, std::size_t base) {
    const std::int64_t chunk_count = wave.chunk_count();
    wave_offset_.resize(at(chunk_count));
    std::int32_t found = 0;
    for (std::int64_t chunk = 0; chunk < chunk_count; ++chunk) {
        wave_offset_[at(chunk)] = found;
        found += static_cast<std::int32_t>(wave_[at(chunk)].size());
    }
    const std::size_t end = base + at(found);
    grow_closely(rows_, end);
    ContactHistory::visit_fields(next_, [end](std::string_view, auto& field) { grow_closely(field, end); });
    parallel::for_each_uneven(chunk_count, 8, [&](std::int64_t chunk) {
        std::int64_t pair = wave.begin + chunk * wave.grain;
        const std::int64_t pair_end = std::min(wave.end, pair + wave.grain);
        std::size_t to = base + at(wave_offset_[at(chunk)]);
        const auto skip_to = [&](std::int64_t stop) {
            for (; pair < stop; ++pair) {
                contact_begin_[at(pair)] = static_cast<std::int32_t>(to);
            }
        };
        for (const FoundContact& contact : wave_[at(chunk)]) {
            skip_to(contact.pair + 1);
            rows_[to] = contact.row;
            next_.pair[to] = pair_key(contact.row.parts);
            next_.feature[to] = contact.feature;
            next_.normal[to] = contact.springs.normal;
            next_.shear_force[to] = contact.springs.shear_force;
            next_.torsion[to] = contact.springs.torsion;
            next_.shear_energy[to] = contact.springs.shear_energy;
            next_.anchor[to] = contact.springs.anchor;
            if (contact.is_old()) {
                is_carried_[at(contact.old_contact)] = 1;
            }
            ++to;
        }
        skip_to(pair_end);
    });
    return end;
}

double ContactPipeline::lost_energy(const ContactHistory& history) const {
    return parallel::reduce(
        static_cast<std::int64_t>(history.size()), 0.0,
        [&](std::int64_t i) { return is_carried_[at(i)] != 0 ? 0.0 : history.shear_energy[at(i)]; },
        [](double a, double b) { return a + b; });
}

std::size_t ContactPipeline::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    std::size_t bytes = cache_.bytes() + placed_.bytes() + of(separating_) + of(contact_begin_) + of(wave_) +
                        of(wave_offset_) + of(rows_) + of(is_carried_);
    for (const std::vector<FoundContact>& chunk : wave_) {
        bytes += of(chunk);
    }
    ContactHistory::visit_fields(next_, [&](std::string_view, const auto& field) { bytes += of(field); });
    return bytes;
}

}  // namespace riprap::contact

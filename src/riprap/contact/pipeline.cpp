// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/pipeline.hpp"

#include <algorithm>
#include <string_view>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::contact {

namespace {

/// Gives a buffer exactly this length, without the doubling of std::vector: lengths change little from step to step.
template <class T>
void resize_closely(std::vector<T>& buffer, std::size_t size) {
    if (size > buffer.capacity()) {
        buffer.reserve(size + size / 32);
    }
    buffer.resize(size);
}

}  // namespace

void ContactPipeline::place_parts(const ContactScene& scene, const body::BodyState& state) {
    contact::place_parts(scene.shapes, scene.bodies, state, placed_, scene.left_out);
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

bool ContactPipeline::are_rows_of(const ContactHistory& history) const {
    return rows_.size() == history.size() &&
           !parallel::any_of(static_cast<std::int64_t>(rows_.size()),
                             [&](std::int64_t i) { return pair_key(rows_[at(i)]->parts) != history.pair[at(i)]; });
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

void ContactPipeline::collect(ContactHistory& history) {
    const auto chunk_count = static_cast<std::int64_t>(found_.size());
    chunk_begin_.resize(found_.size());
    std::int32_t count = 0;
    for (std::size_t chunk = 0; chunk < found_.size(); ++chunk) {
        chunk_begin_[chunk] = count;
        count += static_cast<std::int32_t>(found_[chunk].size());
    }
    ContactHistory::visit_fields(history, [count](std::string_view, auto& field) { resize_closely(field, at(count)); });
    resize_closely(rows_, at(count));  // last: should memory run out, no row points nowhere
    parallel::for_each_uneven(chunk_count, 8, [&](std::int64_t chunk) {
        std::int64_t pair = chunk * grain_;
        const std::int64_t pair_end = std::min(pair_count(), pair + grain_);
        std::size_t to = at(chunk_begin_[at(chunk)]);
        const auto skip_to = [&](std::int64_t stop) {
            for (; pair < stop; ++pair) {
                contact_begin_[at(pair)] = static_cast<std::int32_t>(to);
            }
        };
        for (const FoundContact& contact : found_[at(chunk)]) {
            skip_to(contact.pair + 1);
            rows_[to] = &contact.row;
            history.pair[to] = pair_key(contact.row.parts);
            history.feature[to] = contact.feature;
            history.normal[to] = contact.springs.normal;
            history.shear_force[to] = contact.springs.shear_force;
            history.torsion[to] = contact.springs.torsion;
            history.shear_energy[to] = contact.springs.shear_energy;
            history.anchor[to] = contact.springs.anchor;
            ++to;
        }
        skip_to(pair_end);
    });
    contact_begin_.back() = count;
}

double ContactPipeline::lost_energy(const ContactHistory& history) const {
    return parallel::sum_exactly(static_cast<std::int64_t>(history.size()), [&](std::int64_t i) {
        return is_carried_[at(i)] != 0 ? 0.0 : history.shear_energy[at(i)];
    });
}

std::size_t ContactPipeline::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    std::size_t bytes = cache_.bytes() + placed_.bytes() + of(separating_) + of(contact_begin_) + of(found_) +
                        of(chunk_begin_) + of(rows_) + of(is_carried_);
    for (const std::vector<FoundContact>& chunk : found_) {
        bytes += of(chunk);
    }
    return bytes;
}

}  // namespace riprap::contact

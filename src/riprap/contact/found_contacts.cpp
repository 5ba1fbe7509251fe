// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/contact_physics.hpp"

#include <algorithm>
#include <string>

#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {
bool is_before(const FoundContact& x, const FoundContact& y) { return x.feature < y.feature; }
}  // namespace

FoundContact& FoundContacts::add(std::uint64_t feature) {
    constexpr std::size_t growth = 4;  // buffers of chunks are never freed: doubling would waste memory
    if (found_->size() == found_->capacity()) {
        found_->reserve(found_->size() + growth);
    }
    FoundContact& contact = found_->emplace_back();
    contact.pair = pair_;
    contact.old_contact = -1;
    contact.feature = feature;
    contact.row.parts = parts_;
    const std::uint64_t key = pair_key(parts_);
    for (std::size_t row = at(old_begin_); row < history_->size() && history_->pair[row] == key; ++row) {
        if (history_->feature[row] == feature) {
            contact.old_contact = static_cast<std::int32_t>(row);
            contact.springs = history_->springs(row);
            break;
        }
    }
    return contact;
}

Vec3 FoundContacts::old_normal() const {
    const std::size_t row = at(old_begin_);
    const bool has_old = row < history_->size() && history_->pair[row] == pair_key(parts_);
    return has_old ? history_->normal[row] : Vec3{};
}

void FoundContacts::begin_pair(std::int32_t pair, PartPair parts, std::int32_t old_begin) {
    pair_ = pair;
    parts_ = parts;
    old_begin_ = old_begin;
    first_ = found_->size();
}

void FoundContacts::end_pair() {
    if (found_->size() < first_ + 2) {
        return;
    }
    const auto begin = found_->begin() + static_cast<std::ptrdiff_t>(first_);
    std::sort(begin, found_->end(), is_before);
    RIPRAP_ASSERT(
        std::adjacent_find(begin, found_->end(), [](const auto& x, const auto& y) { return x.feature == y.feature; }) ==
            found_->end(),
        "a feature of pair " + std::to_string(pair_) + " was added twice");
}

}  // namespace riprap::contact

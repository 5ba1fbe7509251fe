// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/selection.hpp"

#include <atomic>

namespace riprap::parallel {

namespace {

std::atomic<std::int64_t> selected{0};

}  // namespace

void detail::note_selected(std::size_t count) {
    selected.fetch_add(static_cast<std::int64_t>(count), std::memory_order_relaxed);
}

std::int64_t entries_selected() { return selected.load(std::memory_order_relaxed); }

}  // namespace riprap::parallel

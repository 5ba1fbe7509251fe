// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/bonds.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "riprap/contact/count_pairs.hpp"
#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

namespace {

/// Edge of a cube as large as the block; infinite for ground [m].
double size_of(const BlockSystem& system, std::int32_t block) {
    const Shape& shape = system.shape_of(block);
    return shape.is_convex() ? shape.size : std::numeric_limits<double>::infinity();
}

}  // namespace

double bond_length(const BlockSystem& system, std::int32_t a, std::int32_t b) {
    const double size = std::min(size_of(system, a), size_of(system, b));
    return bond_tolerance * (std::isfinite(size) ? size : 1);
}

double largest_bond_length(const BlockSystem& system) {
    double size = 0;
    for (std::int32_t b = 0; b < system.size(); ++b) {
        const double own = size_of(system, b);
        size = std::isfinite(own) ? std::max(size, own) : size;
    }
    return bond_tolerance * (size > 0 ? size : 1);
}

std::vector<std::uint64_t> bonded_pairs(const BlockSystem& system, const BlockState& state) {
    std::vector<std::uint64_t> pairs;
    if (!system.surfaces.have_bonds()) {
        return pairs;
    }
    BlockSystem loose = system;  // what is held at the start may be released later, its bonds intact
    std::fill(loose.is_fixed.begin(), loose.is_fixed.end(), std::uint8_t{0});
    PlacedBlocks placed;
    place_blocks(loose, state, placed);
    ContactFinder finder;
    for (const BlockContact& c : finder.find(loose, state, placed, {}, largest_bond_length(system))) {
        const std::uint64_t pair = contact::pair_key({c.a, c.b});
        if (c.gap <= bond_length(system, c.a, c.b) && system.surface_of(c.a, c.b).has_bond() &&
            (pairs.empty() || pairs.back() != pair)) {
            pairs.push_back(pair);
        }
    }
    return pairs;
}

double tearing_gap(const BlockSystem& system) {
    double radius = 0, gap = 0;
    for (const Shape& shape : system.shapes) {
        radius = std::max(radius, shape.is_convex() ? shape.circumradius : 0);
    }
    for (const Surface& surface : system.surfaces.pairs) {
        const double area = surface.is_per_area ? 1 : 4 * radius * radius;
        gap = std::max(gap, surface.tension > 0 ? surface.tension * area / surface.normal_stiffness : 0);
    }
    return gap;
}

bool begins_bonded(const BlockContactHistory& history, std::int32_t a, std::int32_t b) {
    return std::binary_search(history.bonded.begin(), history.bonded.end(), contact::pair_key({a, b}));
}

void BondChanges::look_at(const BlockContact& contact, bool was_intact, bool is_closed, bool is_intact,
                          double tolerance) {
    const std::uint64_t pair = contact::pair_key({contact.a, contact.b});
    if (is_closed || contact.gap <= tolerance) {
        touching.push_back(pair);
    }
    // A point that was not there before and is open has not held anything yet.
    if (was_intact && !is_intact && (is_closed || contact.old >= 0)) {
        broken.push_back(pair);
    }
}

std::vector<std::uint64_t> bonds_left(const std::vector<std::uint64_t>& bonded, const BondChanges& changes) {
    std::vector<std::uint64_t> there, left;
    std::set_intersection(bonded.begin(), bonded.end(), changes.touching.begin(), changes.touching.end(),
                          std::back_inserter(there));
    std::set_difference(there.begin(), there.end(), changes.broken.begin(), changes.broken.end(),
                        std::back_inserter(left));
    return left;
}

std::int64_t count_touching(const BlockContactHistory& history) {
    std::vector<std::uint64_t> pairs;
    for (std::size_t row = 0; row < history.size(); ++row) {
        if (history.mode[row] != static_cast<std::uint8_t>(ContactMode::open)) {
            pairs.push_back(history.pair[row]);
        }
    }
    return contact::count_pairs(pairs);
}

bool has_intact(const BlockContactHistory& history) {
    return std::find(history.is_intact.begin(), history.is_intact.end(), 1) != history.is_intact.end();
}

bool has_come_apart(const BlockContactHistory& old, std::size_t row, const BlockContactHistory& now) {
    return old.is_intact[row] != 0 && !std::binary_search(now.pair.begin(), now.pair.end(), old.pair[row]);
}

}  // namespace riprap::solid::affine

// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/broadphase/pair_cache.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/contact/broadphase/multilevel_grid.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::contact {

namespace {

/// The displacements that decide on a rebuild. A pair has at least one mobile part, so the two that come closest
/// fastest are the two fastest mobile ones, or the fastest mobile and the fastest immobile one.
struct Displacements {
    double mobile{0}, second_mobile{0}, immobile{0};

    void add_mobile(double d) {
        second_mobile = std::max(second_mobile, std::min(mobile, d));
        mobile = std::max(mobile, d);
    }
    double largest_sum() const { return mobile + std::max(second_mobile, immobile); }
};

/// A ball around the centres of all finite parts.
struct Ball {
    Vec3 center;
    double radius;
};

Ball ball_around(const PartBounds& bounds) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    struct Box {
        Vec3 low, high;
    };
    const Box empty{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    const Box box = parallel::reduce(
        static_cast<std::int64_t>(bounds.size()), empty,
        [&](std::int64_t part) {
            const auto i = static_cast<std::size_t>(part);
            return std::isfinite(bounds.radius[i]) ? Box{bounds.center[i], bounds.center[i]} : empty;
        },
        [](const Box& a, const Box& b) {
            return Box{min(b.low, a.low), max(b.high, a.high)};
        });
    if (!(box.low.x <= box.high.x)) {
        return {};
    }
    return {0.5 * (box.low + box.high), 0.5 * norm(box.high - box.low)};
}

}  // namespace

bool PairCache::update(const PartBounds& bounds, std::span<const Giant> giants, const Settings& settings) {
    if (!needs_rebuild(bounds, giants, settings)) {
        return false;
    }
    // A grid kept for the next search, many steps later, would hold a tenth of the memory of a pile.
    MultilevelGrid().find_pairs(bounds, giants, settings.skin, settings.grid_factor, pairs_);
    link_parts_to_pairs(bounds.size());
    remember(bounds, giants, settings);
    ++rebuild_count_;
    return true;
}

bool PairCache::needs_rebuild(const PartBounds& bounds, std::span<const Giant> giants, const Settings& settings) {
    return rebuild_count_ == 0 || !is_same_scene(bounds, giants, settings) || have_parts_moved_too_far(bounds, giants);
}

bool PairCache::is_same_scene(const PartBounds& bounds, std::span<const Giant> giants, const Settings& settings) const {
    if (settings.skin != settings_.skin || settings.grid_factor != settings_.grid_factor ||
        static_cast<std::size_t>(planes_.size()) != giants.size()) {
        return false;
    }
    const bool is_known = bounds.scene != 0 && bounds.scene == scene_;
    if (!is_known && !(std::ranges::equal(bounds.radius, radius_) && std::ranges::equal(bounds.body, body_) &&
                       std::ranges::equal(bounds.is_mobile, is_mobile_))) {
        return false;
    }
    for (std::int32_t g = 0; g < planes_.size(); ++g) {
        if (planes_.part(g) != giants[static_cast<std::size_t>(g)].part) {
            return false;
        }
    }
    return true;
}

bool PairCache::have_parts_moved_too_far(const PartBounds& bounds, std::span<const Giant> giants) {
    constexpr std::int64_t block = 512;                                 // maxima do not depend on it
    const bool is_known = bounds.scene != 0 && bounds.scene == scene_;  // then the others are where they were
    const Displacements squared = parallel::reduce(
        is_known ? static_cast<std::int64_t>(bounds.restless.size()) : bounds.size(), Displacements{},
        [&](std::int64_t k) {
            const auto i = static_cast<std::size_t>(is_known ? bounds.restless[static_cast<std::size_t>(k)] : k);
            const double d = is_giant_[i] != 0 ? 0 : norm_squared(bounds.center[i] - center_[i]);
            return is_mobile_[i] != 0 ? Displacements{d, 0, 0} : Displacements{0, 0, d};
        },
        [](Displacements a, const Displacements& b) {
            a.add_mobile(b.mobile);
            a.add_mobile(b.second_mobile);
            a.immobile = std::max(a.immobile, b.immobile);
            return a;
        },
        block);
    Displacements moved{std::sqrt(squared.mobile), std::sqrt(squared.second_mobile), std::sqrt(squared.immobile)};

    planes_now_.assign(bounds, giants);
    if (!planes_now_.is_at_rest(planes_)) {
        const Ball ball = ball_around(bounds);
        for (std::int32_t g = 0; g < planes_now_.size(); ++g) {
            const double d = planes_now_.displacement_since(planes_, g, ball.center, ball.radius,
                                                            largest_guest_[static_cast<std::size_t>(g)]);
            if (is_mobile_[static_cast<std::size_t>(planes_now_.part(g))] != 0) {
                moved.add_mobile(d);
            } else {
                moved.immobile = std::max(moved.immobile, d);
            }
        }
    }
    // Round-off of positions may hide a little of a displacement; the margin is far above it and costs nothing.
    return !(moved.largest_sum() <= (1 - 1e-9) * settings_.skin);
}

void PairCache::remember(const PartBounds& bounds, std::span<const Giant> giants, const Settings& settings) {
    scene_ = bounds.scene;
    settings_ = settings;
    center_.assign(bounds.center.begin(), bounds.center.end());
    radius_.assign(bounds.radius.begin(), bounds.radius.end());
    body_.assign(bounds.body.begin(), bounds.body.end());
    is_mobile_.assign(bounds.is_mobile.begin(), bounds.is_mobile.end());
    planes_.assign(bounds, giants);
    largest_guest_.assign(giants.size(), 0);
    is_giant_.assign(radius_.size(), 0);
    for (std::size_t g = 0; g < giants.size(); ++g) {
        is_giant_[static_cast<std::size_t>(giants[g].part)] = 1;
        for (std::size_t i = 0; i < radius_.size(); ++i) {
            if (std::isfinite(radius_[i]) && may_pair(bounds, i, static_cast<std::size_t>(giants[g].part))) {
                largest_guest_[g] = std::max(largest_guest_[g], radius_[i]);
            }
        }
    }
}

void PairCache::link_parts_to_pairs(std::int32_t part_count) {
    incident_begin_.assign(static_cast<std::size_t>(part_count) + 1, 0);
    incident_.clear();  // or resize would double its memory to keep what is not wanted
    incident_.resize(2 * pairs_.size());
    for (const PartPair& pair : pairs_) {
        ++incident_begin_[static_cast<std::size_t>(pair.a)];
        ++incident_begin_[static_cast<std::size_t>(pair.b)];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& begin : incident_begin_) {
        end += begin;
        begin = end;
    }
    // Each list is filled from its end, the last pair first; what was an end becomes a beginning.
    for (std::size_t k = pairs_.size(); k-- > 0;) {
        incident_[--incident_begin_[static_cast<std::size_t>(pairs_[k].a)]] = static_cast<std::int32_t>(k);
        incident_[--incident_begin_[static_cast<std::size_t>(pairs_[k].b)]] = static_cast<std::int32_t>(k);
    }
}

std::size_t PairCache::bytes() const {
    const auto held = [](const auto&... buffers) { return (0 + ... + (buffers.capacity() * sizeof(buffers[0]))); };
    return held(pairs_, incident_begin_, incident_, center_, radius_, body_, is_mobile_, is_giant_);
}

double median_radius(std::span<const double> radius) {
    std::vector<double> finite;
    std::ranges::copy_if(radius, std::back_inserter(finite), [](double r) { return std::isfinite(r); });
    if (finite.empty()) {
        return 0;
    }
    const auto middle = finite.begin() + static_cast<std::ptrdiff_t>(finite.size() / 2);
    std::nth_element(finite.begin(), middle, finite.end());
    return *middle;
}

}  // namespace riprap::contact

// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/gauge/box_shares.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::fluid {

namespace {

/// Spacings beyond a side within which particles tell that water goes on there.
constexpr double reach = 1.5;

}  // namespace

std::size_t BoxShares::Hash::operator()(const Place& place) const {
    std::uint64_t hash = 0;
    for (const std::int64_t cell : place.cell) {
        hash = (hash ^ static_cast<std::uint64_t>(cell)) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
}

bool BoxShares::is_near(const Vec3& x) const {
    for (int a = 0; a < axes_; ++a) {
        if (x[a] < low_[a] - reach * spacing_ || x[a] > high_[a] + reach * spacing_) {
            return false;
        }
    }
    return true;
}

BoxShares::Place BoxShares::place_beside(const Vec3& x, int axis) const {
    Place place{};
    for (int a = 0; a < axes_; ++a) {
        place.cell[static_cast<std::size_t>(a)] =
            a == axis ? 0 : static_cast<std::int64_t>(std::floor((x[a] - low_[a]) / spacing_));
    }
    return place;
}

void BoxShares::note(const Vec3& x) {
    for (int a = 0; a < axes_; ++a) {
        if (x[a] < low_[a] || x[a] >= high_[a]) {
            beyond_[static_cast<std::size_t>(a)][x[a] < low_[a] ? 0 : 1].insert(place_beside(x, a));
        }
    }
}

bool BoxShares::goes_on(const Vec3& x, int axis, int side) const {
    const auto& places = beyond_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(side)];
    if (places.empty()) {
        return false;
    }
    const Place here = place_beside(x, axis);
    const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    const int wide = axes_ == 3 ? 1 : 0;
    for (int i = -1; i <= 1; ++i) {
        for (int j = -wide; j <= wide; ++j) {
            Place beside = here;
            beside.cell[static_cast<std::size_t>(first)] += i;
            beside.cell[static_cast<std::size_t>(second)] += j;
            if (places.contains(beside)) {
                return true;
            }
        }
    }
    return false;
}

double BoxShares::share(const Vec3& x) const {
    double share = 1;
    for (int a = 0; a < axes_; ++a) {
        const double below = std::clamp((low_[a] - x[a]) / spacing_ + 0.5, 0.0, 1.0);
        const double above = std::clamp((x[a] - high_[a]) / spacing_ + 0.5, 0.0, 1.0);
        double held = 1;
        if (below > 0 && (x[a] < low_[a] || goes_on(x, a, 0))) {
            held -= below;
        }
        if (above > 0 && (x[a] >= high_[a] || goes_on(x, a, 1))) {
            held -= above;
        }
        share *= std::max(0.0, held);
    }
    return share;
}

}  // namespace riprap::fluid

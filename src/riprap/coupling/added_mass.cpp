// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/added_mass.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::coupling {

namespace {

body::Acceleration operator-(const body::Acceleration& a, const body::Acceleration& b) {
    return {a.linear - b.linear, a.angular - b.angular};
}

}  // namespace

AddedMassIteration::AddedMassIteration(std::span<const double> mass, std::span<const double> inertia,
                                       std::span<const double> kappa)
    : mass_(mass), inertia_(inertia), kappa_(kappa) {}

bool AddedMassIteration::accept(std::vector<body::Acceleration>& guess, std::span<const body::Acceleration> found,
                                double scale) {
    const auto product = [this](std::size_t b, const body::Acceleration& x, const body::Acceleration& y) {
        return mass_[b] * dot(x.linear, y.linear) + inertia_[b] * dot(x.angular, y.angular);
    };
    ++passes_;
    const bool is_first = last_.empty();
    last_.resize(guess.size());
    relaxation_.resize(guess.size());
    residual_ = 0;
    std::vector<body::Acceleration> next = guess;
    for (std::size_t b = 0; b < guess.size(); ++b) {
        if (!(kappa_[b] > iterates_above)) {
            continue;
        }
        const body::Acceleration r = found[b] - guess[b];
        const double size = std::sqrt(product(b, r, r) / mass_[b]);
        residual_ = std::max(residual_, size / (scale + std::sqrt(product(b, guess[b], guess[b]) / mass_[b])));
        if (is_first) {
            relaxation_[b] = 1 / (1 + kappa_[b]);
        } else {
            const body::Acceleration change = r - last_[b];
            const double squared = product(b, change, change);
            // Without a change there is nothing to learn: the last factor stays.
            relaxation_[b] = squared > 0 ? -relaxation_[b] * product(b, last_[b], change) / squared : relaxation_[b];
            // The map contracts against itself: a factor outside (0, 1] comes from noise.
            relaxation_[b] = std::clamp(relaxation_[b], 1e-4, 1.0);
        }
        last_[b] = r;
        next[b].linear += relaxation_[b] * r.linear;
        next[b].angular += relaxation_[b] * r.angular;
    }
    if (is_settled() || passes_ >= most) {
        return true;
    }
    guess = std::move(next);
    return false;
}

}  // namespace riprap::coupling

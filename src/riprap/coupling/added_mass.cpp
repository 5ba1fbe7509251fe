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

double AddedMassIteration::product(const Accelerations& x, const Accelerations& y) const {
    double sum = 0;
    for (std::size_t b = 0; b < x.size(); ++b) {
        if (!(kappa_[b] > iterates_above)) {
            continue;
        }
        sum += mass_[b] * dot(x[b].linear, y[b].linear) + inertia_[b] * dot(x[b].angular, y[b].angular);
    }
    return sum;
}

AddedMassIteration::Accelerations AddedMassIteration::combine() const {
    // Differences from the best pass, made orthogonal one after another (Gram and Schmidt, twice over is not needed: a
    // direction that keeps little of its length says nothing new and is left out).
    Accelerations guess = guesses_[best_], residual = residuals_[best_];
    std::vector<Accelerations> steps, changes;
    const auto add = [](Accelerations& to, double factor, const Accelerations& x) {
        for (std::size_t b = 0; b < to.size(); ++b) {
            to[b].linear += factor * x[b].linear;
            to[b].angular += factor * x[b].angular;
        }
    };
    for (std::size_t k = guesses_.size(); k-- > 0;) {
        if (k == best_) {
            continue;
        }
        Accelerations step = guesses_[k], change = residuals_[k];
        add(step, -1, guesses_[best_]);
        add(change, -1, residuals_[best_]);
        const double before = product(change, change);
        for (std::size_t j = 0; j < changes.size(); ++j) {
            const double share = product(changes[j], change);
            add(change, -share, changes[j]);
            add(step, -share, steps[j]);
        }
        const double left = product(change, change);
        if (!(left > 1e-12 * before)) {
            continue;
        }
        const double scale = 1 / std::sqrt(left);
        for (Accelerations* both : {&change, &step}) {
            Accelerations unit = *both;
            add(unit, scale - 1, *both);
            *both = std::move(unit);
        }
        const double share = product(change, residual);
        add(residual, -share, change);
        add(guess, -share, step);
        changes.push_back(std::move(change));
        steps.push_back(std::move(step));
    }
    for (std::size_t b = 0; b < guess.size(); ++b) {
        guess[b].linear += 1 / (1 + kappa_[b]) * residual[b].linear;
        guess[b].angular += 1 / (1 + kappa_[b]) * residual[b].angular;
    }
    return guess;
}

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
    Accelerations residual(guess.size());
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
        last_[b] = residual[b] = r;
        next[b].linear += relaxation_[b] * r.linear;
        next[b].angular += relaxation_[b] * r.angular;
    }
    if (is_settled() || passes_ >= most) {
        return true;
    }
    guesses_.push_back(guess);
    residuals_.push_back(std::move(residual));
    if (guesses_.size() == 1 || residual_ < least_) {
        least_ = residual_;
        best_ = guesses_.size() - 1;
    }
    if (passes_ + 1 == most) {
        guess = guesses_[best_];
    } else {
        guess = passes_ < plain ? std::move(next) : combine();
    }
    return false;
}

}  // namespace riprap::coupling

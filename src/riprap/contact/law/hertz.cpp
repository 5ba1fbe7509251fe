// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/hertz.hpp"

#include <algorithm>

namespace riprap::contact {

namespace {

/// Speed that is left of 1 when the force x^(3/2) + alpha x^(1/4) x' of a dimensionless impact first vanishes.
double rebound_without_pull(double alpha) {
    // y = sqrt(x) would make the right-hand side smooth; steps of 1/2000 of the impact give 1e-7 without it.
    constexpr double dt = 3.2 / 2000;
    const auto force = [alpha](double x, double v) {
        return std::max(0.0, x * std::sqrt(std::max(0.0, x)) + alpha * std::sqrt(std::sqrt(std::max(0.0, x))) * v);
    };
    double x = 0, v = 1;
    for (int step = 0; step < 40000; ++step) {
        const double a1 = -force(x, v), v2 = v + 0.5 * dt * a1, x2 = x + 0.5 * dt * v;
        const double a2 = -force(x2, v2), v3 = v + 0.5 * dt * a2, x3 = x + 0.5 * dt * v2;
        const double a3 = -force(x3, v3), v4 = v + dt * a3, x4 = x + dt * v3;
        const double a4 = -force(x4, v4);
        x += dt / 6 * (v + 2 * v2 + 2 * v3 + v4);
        v += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        if (v < 0 && force(x, v) <= 0) {
            break;
        }
    }
    return -v;
}

}  // namespace

double effective_modulus(const Elasticity& a, const Elasticity& b) {
    return 1 / ((1 - a.poisson_ratio * a.poisson_ratio) / a.youngs_modulus +
                (1 - b.poisson_ratio * b.poisson_ratio) / b.youngs_modulus);
}

double effective_shear_modulus(const Elasticity& a, const Elasticity& b) {
    const auto compliance = [](const Elasticity& s) {
        return 2 * (2 - s.poisson_ratio) * (1 + s.poisson_ratio) / s.youngs_modulus;
    };
    return 1 / (compliance(a) + compliance(b));
}

double contact_ratio(double restitution) {
    const double log = std::log(restitution);
    return std::sqrt(10.0 / 9) * -log / std::sqrt(M_PI * M_PI + log * log);
}

double restitution_of(double contact_ratio) {
    const double beta = contact_ratio / std::sqrt(10.0 / 9);
    return beta < 1 ? std::exp(-M_PI * beta / std::sqrt(1 - beta * beta)) : 0;
}

double contact_ratio_without_pull(double restitution) {
    if (restitution >= 1) {
        return 0;
    }
    double low = 0, high = 100;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (rebound_without_pull(std::sqrt(4.5) * middle) > restitution ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double hertz_largest_overlap(double modulus, double radius, double mass, double speed) {
    return std::pow(15 * mass * speed * speed / (16 * std::sqrt(radius) * modulus), 0.4);
}

double hertz_contact_time(double modulus, double radius, double mass, double speed) {
    // 2 integral_0^1 dx/sqrt(1 - x^(5/2)) = (4/5) sqrt(pi) Gamma(2/5)/Gamma(9/10).
    return 2.9432751843247047 * hertz_largest_overlap(modulus, radius, mass, speed) / speed;
}

}  // namespace riprap::contact

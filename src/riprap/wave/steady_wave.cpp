// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/steady_wave.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "riprap/wave/linear_wave.hpp"

namespace riprap::wave {

namespace {

/// cosh(a)/cosh(b) and sinh(a)/cosh(b) for any size of a, b >= 0.
double cosh_ratio(double a, double b) { return std::exp(a - b) * (1 + std::exp(-2 * a)) / (1 + std::exp(-2 * b)); }
double sinh_ratio(double a, double b) { return std::exp(a - b) * (1 - std::exp(-2 * a)) / (1 + std::exp(-2 * b)); }

/// Lengths in depths, times in sqrt(d/g): d = g = 1. Unknowns: eta_0..eta_N, B_1..B_N, U, Q, R, k.
struct Problem {
    int order;
    double height;
    bool is_solitary;
    double period;       ///< of a regular wave
    double wave_number;  ///< of a solitary wave

    std::size_t count() const { return static_cast<std::size_t>(2 * order + 5); }

    /// Residual of all equations and, where asked for, their derivatives row by row but for those by k.
    std::vector<double> residual(const std::vector<double>& z, std::vector<double>* derivative = nullptr) const;
};

std::vector<double> Problem::residual(const std::vector<double>& z, std::vector<double>* derivative) const {
    const auto n = static_cast<std::size_t>(order);
    const std::size_t all = count();
    const double *eta = z.data(), *b = z.data() + n, u_mean = z[2 * n + 1], q = z[2 * n + 2], r = z[2 * n + 3],
                 k = z[2 * n + 4], root = std::sqrt(k);
    std::vector<double> f(all);
    if (derivative != nullptr) {
        derivative->assign(all * all, 0.0);
    }
    const auto at = [&](std::size_t row, std::size_t column) -> double& { return (*derivative)[row * all + column]; };
    double mean = 0;
    for (std::size_t m = 0; m <= n; ++m) {
        const double weight = (m == 0 || m == n ? 0.5 : 1.0) / static_cast<double>(n);
        double psi = -u_mean * eta[m], u = -u_mean, v = 0, u_up = 0, v_up = 0;
        std::vector<std::array<double, 3>> share(n + 1);  // of psi, u and v by each B_j
        for (std::size_t j = 1; j <= n; ++j) {
            const double order_j = static_cast<double>(j), jk = order_j * k;
            const double phase = static_cast<double>((j * m) % (2 * n)) * M_PI / static_cast<double>(n);
            const double c = cosh_ratio(jk * eta[m], jk), s = sinh_ratio(jk * eta[m], jk);
            share[j] = {s * std::cos(phase) / (k * root), order_j * c * std::cos(phase) / root,
                        order_j * s * std::sin(phase) / root};
            psi += b[j] * share[j][0];
            u += b[j] * share[j][1];
            v += b[j] * share[j][2];
            u_up += b[j] * order_j * jk * s * std::cos(phase) / root;
            v_up += b[j] * order_j * jk * c * std::sin(phase) / root;
        }
        f[m] = psi + q;
        f[n + 1 + m] = 0.5 * (u * u + v * v) + eta[m] - r;
        mean += weight * eta[m];
        if (derivative != nullptr) {
            at(m, m) = u;  // psi rises with height by the speed
            at(n + 1 + m, m) = u * u_up + v * v_up + 1;
            for (std::size_t j = 1; j <= n; ++j) {
                at(m, n + j) = share[j][0];
                at(n + 1 + m, n + j) = u * share[j][1] + v * share[j][2];
            }
            at(m, 2 * n + 1) = -eta[m];
            at(n + 1 + m, 2 * n + 1) = -u;
            at(m, 2 * n + 2) = 1;
            at(n + 1 + m, 2 * n + 3) = -1;
            at(2 * n + 3, m) = is_solitary ? (m == n ? 1 : 0) : weight;
        }
    }
    f[2 * n + 2] = eta[0] - eta[n] - height;
    f[2 * n + 3] = is_solitary ? eta[n] - 1 : mean - 1;
    f[2 * n + 4] = is_solitary ? k - wave_number : k * u_mean * period - 2 * M_PI;
    if (derivative != nullptr) {
        at(2 * n + 2, 0) = 1;
        at(2 * n + 2, n) = -1;
        at(2 * n + 4, 2 * n + 1) = is_solitary ? 0 : k * period;
    }
    return f;
}

/// Solves A x = b by elimination with row exchanges; A row by row, overwritten.
std::vector<double> solve_dense(std::vector<double>& a, std::vector<double> b) {
    const std::size_t n = b.size();
    for (std::size_t p = 0; p < n; ++p) {
        std::size_t best = p;
        for (std::size_t i = p + 1; i < n; ++i) {
            best = std::abs(a[i * n + p]) > std::abs(a[best * n + p]) ? i : best;
        }
        if (best != p) {
            std::swap_ranges(a.begin() + static_cast<std::ptrdiff_t>(p * n),
                             a.begin() + static_cast<std::ptrdiff_t>((p + 1) * n),
                             a.begin() + static_cast<std::ptrdiff_t>(best * n));
            std::swap(b[p], b[best]);
        }
        for (std::size_t i = p + 1; i < n; ++i) {
            const double factor = a[i * n + p] / a[p * n + p];
            if (factor != 0) {
                for (std::size_t j = p; j < n; ++j) {
                    a[i * n + j] -= factor * a[p * n + j];
                }
                b[i] -= factor * b[p];
            }
        }
    }
    for (std::size_t p = n; p-- > 0;) {
        for (std::size_t j = p + 1; j < n; ++j) {
            b[p] -= a[p * n + j] * b[j];
        }
        b[p] /= a[p * n + p];
    }
    return b;
}

double largest(const std::vector<double>& f) {
    double size = 0;
    for (const double x : f) {
        size = std::max(size, std::abs(x));
    }
    return size;
}

/// Newton's method; the derivative by k is a difference. @returns whether it converged
bool newton(const Problem& problem, std::vector<double>& z) {
    const std::size_t n = problem.count();
    std::vector<double> jacobian;
    for (int step = 0; step < 30; ++step) {
        const std::vector<double> f = problem.residual(z, &jacobian);
        if (!(largest(f) < 1e3)) {
            return false;
        }
        if (largest(f) < 1e-11) {
            return true;
        }
        std::vector<double> moved = z;
        const double d = 1e-7 * moved.back();
        moved.back() += d;
        const std::vector<double> g = problem.residual(moved);
        for (std::size_t i = 0; i < n; ++i) {
            jacobian[i * n + n - 1] = (g[i] - f[i]) / d;
        }
        const std::vector<double> change = solve_dense(jacobian, f);
        for (std::size_t i = 0; i < n; ++i) {
            z[i] -= change[i];
        }
        if (largest(change) < 1e-10) {
            return largest(problem.residual(z)) < 1e-8;
        }
    }
    return false;
}

/// Height at which a wave of this length breaks, over the depth [Fenton1990, eq. 32].
double highest_wave(double length_over_depth) {
    const double l = length_over_depth;
    return (0.141063 * l + 0.0095721 * l * l + 0.0077829 * l * l * l) /
           (1 + 0.0788340 * l + 0.0317567 * l * l + 0.0093407 * l * l * l);
}

/// First guess from a surface, in depths above the bed at k x = m pi/N, by the flow of long waves.
std::vector<double> guess_from(const std::vector<double>& eta, double k, double celerity) {
    const std::size_t n = eta.size() - 1;
    std::vector<double> z(2 * n + 5);
    std::copy(eta.begin(), eta.end(), z.begin());
    const auto coefficient = [&](std::size_t j) {  // of the mean speed over the depth, c (eta - 1)/eta
        double sum = 0;
        for (std::size_t m = 0; m <= n; ++m) {
            const double weight = m == 0 || m == n ? 0.5 : 1.0;
            sum += weight * celerity * (eta[m] - 1) / eta[m] *
                   std::cos(static_cast<double>(j * m) * M_PI / static_cast<double>(n));
        }
        return sum * (j == 0 || j == n ? 1 : 2) / static_cast<double>(n);
    };
    for (std::size_t j = 1; j <= n; ++j) {
        const double jk = static_cast<double>(j) * k;
        z[n + j] = coefficient(j) * std::sqrt(k) / static_cast<double>(j) * jk / std::tanh(jk);
    }
    z[2 * n + 1] = celerity - coefficient(0);
    z[2 * n + 2] = celerity;
    z[2 * n + 3] = 0.5 * celerity * celerity + 1;
    z[2 * n + 4] = k;
    return z;
}

/// Raises the wave to its height in steps, halved where Newton's method fails.
bool raise(Problem& problem, std::vector<double>& z, double first, double last, double step) {
    std::vector<double> before;
    double height = first, before_height = 0;
    for (int tries = 0; tries < 200; ++tries) {
        std::vector<double> attempt = z;
        if (!before.empty()) {
            for (std::size_t i = 0; i < z.size(); ++i) {  // along the last two
                attempt[i] += (z[i] - before[i]) * (height - problem.height) / (problem.height - before_height);
            }
        }
        Problem next = problem;
        next.height = height;
        if (newton(next, attempt)) {
            before = tries == 0 ? std::vector<double>{} : z;
            before_height = problem.height;
            z = attempt;
            problem.height = height;
            if (height >= last) {
                return true;
            }
        } else {
            step *= 0.5;
            if (tries == 0 || step < 1e-4) {
                return false;
            }
        }
        height = std::min(last, problem.height + step);
    }
    return false;
}

SteadyWave to_wave(const Problem& problem, const std::vector<double>& z, double height, double depth, double gravity) {
    const auto n = static_cast<std::size_t>(problem.order);
    const double speed = std::sqrt(gravity * depth);
    SteadyWave wave{height, depth, gravity, z[2 * n + 4] / depth, z[2 * n + 1] * speed, z[2 * n + 1] * speed,
                    {},     {},    0};
    for (std::size_t j = 1; j <= n; ++j) {
        wave.flow.push_back(z[n + j]);
    }
    for (std::size_t j = 0; j <= n; ++j) {
        double sum = 0;
        for (std::size_t m = 0; m <= n; ++m) {
            sum += (m == 0 || m == n ? 0.5 : 1.0) * z[m] *
                   std::cos(static_cast<double>(j * m) * M_PI / static_cast<double>(n));
        }
        wave.surface.push_back(depth * sum * (j == 0 || j == n ? 1 : 2) / static_cast<double>(n));
    }
    wave.reach = problem.is_solitary ? M_PI / wave.wave_number : std::numeric_limits<double>::infinity();
    if (problem.is_solitary) {  // the speed that leaves the water far away at rest
        double trough = -wave.mean_speed;
        for (std::size_t j = 1; j <= n; ++j) {
            trough += std::sqrt(gravity / wave.wave_number) * static_cast<double>(j) * wave.flow[j - 1] *
                      (j % 2 == 0 ? 1 : -1) / std::cosh(static_cast<double>(j) * wave.wave_number * depth);
        }
        wave.celerity = -trough;
    }
    return wave;
}

}  // namespace

double SteadyWave::length() const { return 2 * M_PI / wave_number; }

double SteadyWave::elevation(double from_crest) const {
    if (std::abs(from_crest) >= reach) {
        return 0;
    }
    double sum = -depth;
    for (std::size_t j = 0; j < surface.size(); ++j) {
        sum += surface[j] * std::cos(static_cast<double>(j) * wave_number * from_crest);
    }
    return sum;
}

WaveVelocity SteadyWave::velocity(double from_crest, double above_bed) const {
    if (std::abs(from_crest) >= reach) {
        return {0, 0};
    }
    WaveVelocity velocity{celerity - mean_speed, 0};
    const double scale = std::sqrt(gravity / wave_number);
    for (std::size_t j = 1; j <= flow.size(); ++j) {
        const double jk = static_cast<double>(j) * wave_number, size = scale * static_cast<double>(j) * flow[j - 1];
        velocity.along += size * cosh_ratio(jk * above_bed, jk * depth) * std::cos(jk * from_crest);
        velocity.up += size * sinh_ratio(jk * above_bed, jk * depth) * std::sin(jk * from_crest);
    }
    return velocity;
}

SteadyWave regular_wave(double height, double period, double depth, double gravity, int order) {
    const double unit = std::sqrt(depth / gravity);
    const LinearWave linear = linear_wave(height, period, depth, gravity);
    const double k = linear.kd(), first = std::min(height / depth, 0.02 * std::min(1.0, 2 * M_PI / k));
    Problem problem{order, first, false, period / unit, 0};
    const auto n = static_cast<std::size_t>(order);
    std::vector<double> z(problem.count());
    const double celerity = std::sqrt(std::tanh(k) / k);
    for (std::size_t m = 0; m <= n; ++m) {
        z[m] = 1 + 0.5 * first * std::cos(static_cast<double>(m) * M_PI / static_cast<double>(n));
    }
    z[n + 1] = 0.5 * first * k / std::sqrt(std::tanh(k));
    z[2 * n + 1] = celerity;
    z[2 * n + 2] = celerity;
    z[2 * n + 3] = 0.5 * celerity * celerity + 1;
    z[2 * n + 4] = k;
    // Newton's method also finds surfaces that no water has: the limit is that of breaking.
    const bool is_found = raise(problem, z, first, height / depth, 0.1 * height / depth);
    const double limit = highest_wave(2 * M_PI / z.back());
    if (!is_found || problem.height > limit) {
        throw NoSuchWave("no steady wave of height " + std::to_string(height) + " m and period " +
                         std::to_string(period) + " s in " + std::to_string(depth) + " m of water: about " +
                         std::to_string(0.95 * std::min(problem.height, limit) * depth) + " m can be made");
    }
    return to_wave(problem, z, height, depth, gravity);
}

SteadyWave solitary_wave(double height, double depth, double gravity, int order) {
    const double goal = height / depth;
    if (goal > 0.75) {
        throw NoSuchWave("a solitary wave of height " + std::to_string(height) + " m in " + std::to_string(depth) +
                         " m of water: heights up to 0.75 of the depth, " + std::to_string(0.75 * depth) +
                         " m, can be made");
    }
    const double first = std::min(goal, 0.2);
    const double decay = std::sqrt(3 * first) / 1.0;  // of exp(-decay x)
    const double k = M_PI / std::max(12.0, 11 / decay);
    Problem problem{order, first, true, 0, k};
    std::vector<double> eta;
    for (int m = 0; m <= order; ++m) {
        const double x = M_PI / k * m / order;
        eta.push_back(1 + first / std::pow(std::cosh(0.5 * decay * x), 2));
    }
    std::vector<double> z = guess_from(eta, k, std::sqrt(1 + first));
    if (!raise(problem, z, first, goal, 0.05)) {
        throw NoSuchWave("no solitary wave of height " + std::to_string(height) + " m found in " +
                         std::to_string(depth) + " m of water");
    }
    return to_wave(problem, z, height, depth, gravity);
}

}  // namespace riprap::wave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/linear/preconditioner.hpp"
#include "riprap/linear/vector_ops.hpp"

namespace riprap::linear {

enum class SolveStatus : std::uint8_t {
    converged,
    too_many_iterations,
    stagnated,              ///< round-off keeps the residual above what was asked for
    not_positive_definite,  ///< p.A p or r.M^-1 r was not positive
    not_finite,             ///< b, the first guess or a product is not finite
};

/// "converged", "not converged in the iterations allowed", ...
const char* describe(SolveStatus status);

struct PcgSettings {
    double tolerance{1e-8};        ///< of |b - A x| over |b| [-]
    double absolute_tolerance{0};  ///< of |b - A x|, where that is more [unit of b]
    int max_iterations{1000};
};

struct SolveReport {
    SolveStatus status{SolveStatus::converged};
    int iterations{0};         ///< products with A but those for residuals
    double first_residual{0};  ///< |b - A x|/|b| of the guess [-]
    double residual{0};        ///< the same of the answer, computed from it, not by recurrence [-]
    bool is_converged() const { return status == SolveStatus::converged; }
};

/// Buffers of a solve; may be dropped between solves.
struct PcgScratch {
    std::vector<double> r, z, p, q;
    std::size_t bytes() const { return bytes_of(r, z, p, q); }
};

namespace detail {

/// Iterates from x with r = b - A x and |r| = residual until the recurrence is at the target.
template <LinearOperator A, Preconditioner M>
SolveStatus iterate(const A& a, M& m, double target, int max_iterations, std::span<double> x, PcgScratch& s,
                    double& residual, int& iterations) {
    double rz = 0;
    for (bool is_first = true; residual > target; is_first = false) {
        if (iterations >= max_iterations) {
            return SolveStatus::too_many_iterations;
        }
        m.apply(s.r, s.z);
        const double rz_before = rz;
        rz = dot(s.r, s.z);
        if (!(rz > 0)) {
            return std::isfinite(rz) ? SolveStatus::not_positive_definite : SolveStatus::not_finite;
        }
        scale_and_add(s.z, is_first ? 0 : rz / rz_before, s.p);
        a.multiply(s.p, s.q);
        const double curvature = dot(s.p, s.q);
        ++iterations;
        if (!(curvature > 0)) {
            return std::isfinite(curvature) ? SolveStatus::not_positive_definite : SolveStatus::not_finite;
        }
        residual = std::sqrt(step_along(rz / curvature, s.p, s.q, x, s.r));
        if (!std::isfinite(residual)) {
            return SolveStatus::not_finite;
        }
    }
    return SolveStatus::converged;
}

}  // namespace detail

/// Solves A x = b by preconditioned conjugate gradients [HestenesStiefel1952] from the guess in x:
///
///     z = M^-1 r,   p = z + (r.z)/(r.z)_before p,   x += a p,   r -= a A p,   a = r.z/(p.A p).
///
/// Where the recurrence has reached the target, the residual is computed anew from x; where that is still above, the
/// iteration starts again from x, until it no longer halves. A guess of zeros costs no product. x is the last iterate,
/// whatever the status; where the status is not_finite it may be useless. Never throws; dots are ordered, so the bits
/// depend on neither threads nor scratch.
template <LinearOperator A, Preconditioner M>
SolveReport solve_pcg(const A& a, M& m, std::span<const double> b, std::span<double> x, const PcgSettings& settings,
                      PcgScratch& s) {
    const std::size_t n = a.size();
    for (std::vector<double>* buffer : {&s.r, &s.z, &s.p, &s.q}) {
        buffer->assign(n, 0.0);
    }
    SolveReport report;
    const double size = std::sqrt(dot(b, b));
    if (size == 0) {
        std::fill(x.begin(), x.end(), 0.0);
        return report;
    }
    const double target = std::max(settings.tolerance * size, settings.absolute_tolerance);
    const auto find_residual = [&] {
        a.multiply(x, s.q);
        return std::sqrt(subtract(b, s.q, s.r));
    };
    const bool is_zero = std::all_of(x.begin(), x.end(), [](double value) { return value == 0; });
    if (is_zero) {
        std::copy(b.begin(), b.end(), s.r.begin());
    }
    double residual = is_zero ? size : find_residual();
    report.first_residual = residual / size;
    report.status = std::isfinite(residual) ? SolveStatus::converged : SolveStatus::not_finite;
    for (double last = std::numeric_limits<double>::infinity(); report.is_converged() && residual > target;) {
        if (residual > 0.5 * last) {
            report.status = SolveStatus::stagnated;
            break;
        }
        last = residual;
        report.status = detail::iterate(a, m, target, settings.max_iterations, x, s, residual, report.iterations);
        residual = find_residual();
    }
    report.residual = residual / size;
    return report;
}

}  // namespace riprap::linear

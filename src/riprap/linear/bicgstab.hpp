// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/linear/pcg.hpp"

namespace riprap::linear {

/// Buffers of a solve; may be dropped between solves.
struct BicgstabScratch {
    std::vector<double> r, shadow, p, ahead, v, t;
    std::size_t bytes() const { return bytes_of(r, shadow, p, ahead, v, t); }
};

/// Solves A x = b, A of any sign and shape but regular, by preconditioned BiCGStab [VanDerVorst1992] from x = 0:
///
///     p = r + beta (p - w v),   v = A M^-1 p,   r -= a v,   a = (r_0.r)/(r_0.v),
///     t = A M^-1 r,             r -= w t,       w = t.r/t.t,
///
/// with x += a M^-1 p + w M^-1 r. Two products an iteration. x is the last iterate, whatever the status. Dots are
/// ordered, so the bits depend on neither threads nor scratch.
/// @param a  has size() and multiply(x, y), as LinearOperator, symmetric or not
template <class A, Preconditioner M>
SolveReport solve_bicgstab(const A& a, M& m, std::span<const double> b, std::span<double> x,
                           const PcgSettings& settings, BicgstabScratch& s) {
    const std::size_t n = a.size();
    for (std::vector<double>* buffer : {&s.p, &s.ahead, &s.v, &s.t}) {
        buffer->assign(n, 0.0);
    }
    std::fill(x.begin(), x.end(), 0.0);
    s.r.assign(b.begin(), b.end());
    s.shadow = s.r;
    SolveReport report;
    const double size = std::sqrt(dot(b, b));
    if (size == 0) {
        return report;
    }
    const double target = std::max(settings.tolerance * size, settings.absolute_tolerance);
    double rho = 1, alpha = 1, omega = 1, residual = size;
    report.first_residual = 1;
    while (residual > target) {
        if (report.iterations >= settings.max_iterations) {
            report.status = SolveStatus::too_many_iterations;
            break;
        }
        ++report.iterations;
        const double rho_before = rho;
        rho = dot(s.shadow, s.r);
        const double beta = rho / rho_before * (alpha / omega);
        parallel::for_each(static_cast<std::int64_t>(n), [&](std::int64_t index) {
            const auto i = static_cast<std::size_t>(index);
            s.p[i] = s.r[i] + beta * (s.p[i] - omega * s.v[i]);
        });
        m.apply(s.p, s.ahead);
        a.multiply(s.ahead, s.v);
        alpha = rho / dot(s.shadow, s.v);
        residual = std::sqrt(step_along(alpha, s.ahead, s.v, x, s.r));
        if (residual > target) {
            m.apply(s.r, s.ahead);
            a.multiply(s.ahead, s.t);
            omega = dot(s.t, s.r) / dot(s.t, s.t);
            residual = std::sqrt(step_along(omega, s.ahead, s.t, x, s.r));
        }
        if (!std::isfinite(residual)) {
            report.status = SolveStatus::not_finite;  // or broken down: r_0.v or t.t is zero
            break;
        }
    }
    report.residual = residual / size;
    return report;
}

}  // namespace riprap::linear

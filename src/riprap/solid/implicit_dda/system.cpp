// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/system.hpp"

#include <array>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/linear/small_cholesky.hpp"
#include "riprap/linear/vector_ops.hpp"

namespace riprap::solid::implicit_dda {

namespace {

/// One forward sweep of block SOR; returns |F - K D| before it.
double sweep(const linear::BlockCsr<12>& a, const std::vector<double>& inverse, double omega,
             const std::vector<double>& b, std::vector<double>& x) {
    double residual = 0;
    for (std::int64_t row = 0; row < a.rows(); ++row) {
        std::array<double, 12> r{};
        for (std::size_t k = 0; k < 12; ++k) {
            r[k] = b[at(row) * 12 + k];
        }
        for (std::int64_t e = a.pattern().first(row); e < a.pattern().end(row); ++e) {
            linear::add_product<12>(-1, a.block(e), &x[at(a.pattern().column_of(e)) * 12], r.data());
        }
        for (const double value : r) {
            residual += value * value;
        }
        std::array<double, 12> z{};
        linear::add_product<12>(omega, &inverse[at(row) * 144], r.data(), z.data());
        for (std::size_t k = 0; k < 12; ++k) {
            x[at(row) * 12 + k] += z[k];
        }
    }
    return std::sqrt(residual);
}

linear::SolveReport solve_sor(const SolveSettings& settings, Equations& equations) {
    const linear::BlockCsr<12>& a = equations.matrix;
    std::vector<double> inverse(at(a.rows()) * 144);
    linear::SolveReport report;
    for (std::int64_t row = 0; row < a.rows(); ++row) {
        if (!linear::invert_spd<12>(a.block(a.pattern().find(row, row)), &inverse[at(row) * 144])) {
            equations.singular_row = row;
            report.status = linear::SolveStatus::not_positive_definite;
            return report;
        }
    }
    const double size = std::sqrt(linear::dot(equations.right, equations.right));
    report.status = linear::SolveStatus::too_many_iterations;
    for (report.iterations = 0; report.iterations < settings.max_iterations; ++report.iterations) {
        report.residual =
            size > 0 ? sweep(a, inverse, settings.relaxation, equations.right, equations.solution) / size : 0;
        if (report.residual <= settings.tolerance) {
            report.status = linear::SolveStatus::converged;
            break;
        }
    }
    return report;
}

}  // namespace

linear::SolveReport solve(const SolveSettings& settings, Equations& equations) {
    equations.solution.resize(equations.right.size(), 0);
    equations.singular_row = -1;
    if (settings.solver == Solver::sor) {
        return solve_sor(settings, equations);
    }
    const linear::PcgSettings pcg{settings.tolerance, 0, settings.max_iterations};
    const bool is_cholesky = settings.solver == Solver::pcg_cholesky;
    const linear::SetUp ready = is_cholesky ? equations.cholesky.set_up(equations.matrix)
                                            : equations.jacobi.update(equations.matrix, equations.is_new);
    if (!ready.is_ready()) {
        equations.singular_row = ready.bad_row;
        linear::SolveReport report;
        report.status = linear::SolveStatus::not_positive_definite;
        return report;
    }
    if (!is_cholesky) {
        std::fill(equations.is_new.begin(), equations.is_new.end(), std::uint8_t{0});
    }
    return is_cholesky
               ? solve_pcg(equations.matrix, equations.cholesky, equations.right, equations.solution, pcg,
                           equations.pcg)
               : solve_pcg(equations.matrix, equations.jacobi, equations.right, equations.solution, pcg, equations.pcg);
}

}  // namespace riprap::solid::implicit_dda

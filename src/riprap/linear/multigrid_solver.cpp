// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/linear/multigrid.hpp"

namespace riprap::linear {

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Dot product of two rows in eight running sums, so that it fills vector registers in a fixed order.
template <class T>
double dot_row(const double* x, const T* y, int n) {
    std::array<double, 8> sum{};
    int i = 0;
    for (; i + 8 <= n; i += 8) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
            sum[lane] += x[i + static_cast<int>(lane)] * static_cast<double>(y[i + static_cast<int>(lane)]);
        }
    }
    double tail = 0;
    for (; i < n; ++i) {
        tail += x[i] * static_cast<double>(y[i]);
    }
    return ((sum[0] + sum[4]) + (sum[1] + sum[5])) + ((sum[2] + sum[6]) + (sum[3] + sum[7])) + tail;
}

/// y = A x along one row.
void apply_row(const FaceConductance& m, const double* x, double* y, std::int64_t start) {
    const int n = m.box.cells[0];
    for (int a = 0; a < m.box.axes; ++a) {
        const std::int64_t s = m.box.stride[at(a)];
        const double* c = m.face[at(a)].data() + start;
        if (a == 0) {
            for (int i = 0; i < n; ++i) {
                y[i] = c[i] * (x[i] - x[i - 1]) + c[i + 1] * (x[i] - x[i + 1]);
            }
        } else {
            for (int i = 0; i < n; ++i) {
                y[i] += c[i] * (x[i] - x[i - s]) + c[i + s] * (x[i] - x[i + s]);
            }
        }
    }
}

/// Share of ||b|| below which a residual is round-off [-].
constexpr double round_off = 1e-14;

}  // namespace

double dot_cells(const CellBox& box, const std::vector<double>& x, const std::vector<double>& y) {
    return sum_rows(box, [&](std::int64_t start, std::int64_t) {
        return dot_row(x.data() + start, y.data() + start, box.cells[0]);
    });
}

void PoissonSolver::set_operator(const FaceConductance& a) { multigrid_.build(a); }

PoissonReport PoissonSolver::solve(const FaceConductance& a, const std::vector<double>& b, std::vector<double>& p,
                                   double tolerance, int max_iterations, double enough) {
    const CellBox& box = a.box;
    const int n = box.cells[0];
    std::vector<double>&r = work_.r, &d = work_.d, &q = work_.q;
    r.resize(at(box.size));
    q.resize(at(box.size));
    d.assign(at(box.size), 0.0);  // beyond the sides too, where the operator reads it
    const double b_norm = std::sqrt(dot_cells(box, b, b));
    double rr = sum_rows(box, [&](std::int64_t s, std::int64_t) {
        apply_row(a, p.data() + s, q.data() + s, s);
        for (std::int64_t i = s; i < s + n; ++i) {
            r[at(i)] = b[at(i)] - q[at(i)];
        }
        return dot_row(r.data() + s, r.data() + s, n);
    });
    const double first = std::sqrt(rr), goal = std::max({tolerance * first, enough, round_off * b_norm});
    PoissonReport report;
    double rz_before = 0, least = rr;
    while (std::sqrt(rr) > goal && report.iterations < max_iterations) {
        double factor = 0;  // z = factor times what the cycle gives
        const std::vector<float>& z = multigrid_.apply(r, std::sqrt(rr), factor);
        const double rz = factor * sum_rows(box, [&](std::int64_t s, std::int64_t) {
                              return dot_row(r.data() + s, z.data() + s, n);
                          });
        if (!(rz > 0)) {
            break;
        }
        const double beta = report.iterations == 0 ? 0 : rz / rz_before;
        for_rows(box, [&](std::int64_t s, std::int64_t) {
            for (std::int64_t i = s; i < s + n; ++i) {
                d[at(i)] = factor * static_cast<double>(z[at(i)]) + beta * d[at(i)];
            }
        });
        const double dq = sum_rows(box, [&](std::int64_t s, std::int64_t) {
            apply_row(a, d.data() + s, q.data() + s, s);
            return dot_row(d.data() + s, q.data() + s, n);
        });
        if (!(dq > 0)) {
            break;
        }
        const double alpha = rz / dq;
        rr = sum_rows(box, [&](std::int64_t s, std::int64_t) {
            for (std::int64_t i = s; i < s + n; ++i) {
                p[at(i)] += alpha * d[at(i)];
                r[at(i)] -= alpha * q[at(i)];
            }
            return dot_row(r.data() + s, r.data() + s, n);
        });
        rz_before = rz;
        ++report.iterations;
        least = std::min(least, rr);
        // The round-off of a group of cells that no open face joins to the rest has a mean, which no pressure takes
        // away: once it is all that is left, it grows from one iteration to the next.
        constexpr double spent = 1e-7;  // of the first residual: looser solutions ended before
        if (std::sqrt(least) < spent * first && rr > 100 * least) {
            break;
        }
    }
    report.first = first;
    report.residual = first > 0 ? std::sqrt(rr) / first : 0;
    report.converged = std::sqrt(rr) <= goal;
    return report;
}

}  // namespace riprap::linear

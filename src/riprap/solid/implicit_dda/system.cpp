// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/system.hpp"

#include <array>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/linear/cholmod.hpp"
#include "riprap/linear/small_cholesky.hpp"
#include "riprap/linear/vector_ops.hpp"

namespace riprap::solid::implicit_dda {

namespace {

/// Stiffness of a contact point in its mode: k_n n n^T, besides k_s (1 - n n^T) where it is locked and F_f/|t| across
/// the slip where it slides.
Mat3 stiffness_of(const ContactTerm& c) {
    const Mat3 along = outer(c.normal, c.normal);
    if (c.trial.mode == ContactMode::lock) {
        return c.springs.normal * along + c.springs.shear * (Mat3::identity() - along);
    }
    const Vec3 across = cross(c.normal, c.trial.direction);
    return c.springs.normal * along + c.trial.across * outer(across, across);
}

/// Force of a contact on a at zero displacement of the unknowns; b gets the opposite.
Vec3 force_at_start(const ContactTerm& c) {
    Vec3 force = c.springs.normal * c.gap * c.normal;
    const Vec3 slip = c.trial.slip_before + c.prescribed - dot(c.prescribed, c.normal) * c.normal;
    if (c.trial.mode == ContactMode::lock) {
        force -= c.springs.shear * slip;
    } else {
        const Vec3 across = cross(c.normal, c.trial.direction);
        force -= c.trial.friction * c.trial.direction + (c.trial.across * dot(across, slip)) * across;
    }
    return force;
}

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

void link_rows(std::int64_t rows, std::vector<ContactTerm>& contacts, Equations& equations) {
    std::vector<std::array<std::int32_t, 2>> pairs;
    RowContacts& incident = equations.incident;
    incident.start.assign(at(rows) + 1, 0);
    for (const ContactTerm& c : contacts) {
        for (const std::int32_t row : {c.row_a, c.row_b}) {
            incident.start[at(row >= 0 ? row + 1 : 0)] += row >= 0 ? 1 : 0;
        }
        if (c.row_a >= 0 && c.row_b >= 0 && (pairs.empty() || pairs.back() != std::array{c.row_a, c.row_b})) {
            pairs.push_back({c.row_a, c.row_b});
        }
    }
    for (std::size_t r = 1; r < incident.start.size(); ++r) {
        incident.start[r] += incident.start[r - 1];
    }
    incident.contact.resize(at(incident.start.back()));
    std::vector<std::int32_t> next(incident.start.begin(), incident.start.end() - 1);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        for (const std::int32_t row : {contacts[k].row_a, contacts[k].row_b}) {
            if (row >= 0) {
                incident.contact[at(next[at(row)]++)] = static_cast<std::int32_t>(k);
            }
        }
    }
    linear::BlockPattern pattern = linear::symmetric_pattern(rows, pairs);
    if (!(pattern == equations.matrix.pattern()) || equations.right.size() != at(rows) * 12) {
        equations.matrix.set_pattern(std::move(pattern));
        equations.right.assign(at(rows) * 12, 0);
    }
    equations.is_stale.assign(at(rows), 1);
    equations.is_new.assign(at(rows), 1);
    for (ContactTerm& c : contacts) {
        const bool is_inner = c.row_a >= 0 && c.row_b >= 0;
        c.entry_ab = is_inner ? equations.matrix.pattern().find(c.row_a, c.row_b) : -1;
        c.entry_ba = is_inner ? equations.matrix.pattern().find(c.row_b, c.row_a) : -1;
    }
}

namespace {

bool is_same(const Mat3& a, const Mat3& b) {
    return a.row[0] == b.row[0] && a.row[1] == b.row[1] && a.row[2] == b.row[2];
}

/// Sums of one row. Contacts come sorted by pair, and those of a face share normal and springs: arms are summed as long
/// as stiffness and neighbour stay, blocks as long as the neighbour stays. Neighbours come in the order of the row's
/// entries, so that every number of the matrix is written once and none is read.
class RowSum {
 public:
    RowSum(linear::BlockCsr<12>& matrix, std::int64_t row)
        : matrix_(matrix), next_(matrix.pattern().first(row)), end_(matrix.pattern().end(row)) {}

    void add(const Vec3& arm, const Vec3& other, const Mat3& stiffness, std::int64_t entry) {
        if (!is_same(stiffness, stiffness_) || entry != entry_) {
            close_group();
            stiffness_ = stiffness;
        }
        if (entry != entry_) {
            close_neighbour();
            entry_ = entry;
        }
        add_arms(arm, arm, own_arms_);
        if (entry >= 0) {
            add_arms(arm, other, shared_arms_);
        }
    }
    /// Brings everything to the unknowns; the block of the row itself is `diagonal` and its contacts.
    void close(const Matrix12& diagonal, double* own_block) {
        close_group();
        close_neighbour();
        write_zeros(end_);
        bring_to_unknowns(own_, own_block);
        for (std::size_t i = 0; i < 144; ++i) {
            own_block[i] += diagonal[i];
        }
    }

 private:
    void close_group() {
        if (own_arms_[0] > 0) {
            add_affine_springs(own_arms_, stiffness_, 1, own_.data());
            own_arms_.fill(0);
        }
        if (shared_arms_[0] > 0) {
            add_affine_springs(shared_arms_, stiffness_, -1, shared_.data());
            shared_arms_.fill(0);
        }
    }
    void close_neighbour() {
        if (entry_ >= 0) {
            write_zeros(entry_);
            bring_to_unknowns(shared_, matrix_.block(entry_));
            next_ = entry_ + 1;
            shared_.fill(0);
        }
        entry_ = -1;
    }

    /// Entries before `end` that no closed contact has written.
    void write_zeros(std::int64_t end) {
        if (next_ < end) {
            std::fill(matrix_.block(next_), matrix_.block(next_) + 144 * (end - next_), 0.0);
        }
    }

    linear::BlockCsr<12>& matrix_;
    std::int64_t next_, end_;  ///< entries not yet written
    Matrix12 own_{}, shared_{};
    ArmMoments own_arms_{}, shared_arms_{};
    Mat3 stiffness_{};
    std::int64_t entry_{-1};
};

void assemble_row(const std::vector<ContactTerm>& contacts, std::int64_t row, Equations& equations) {
    linear::BlockCsr<12>& k = equations.matrix;
    double* const right = &equations.right[at(row) * 12];
    RowSum sum(k, row);
    Vec3 force{};
    Mat3 dipole{};
    for (const std::int32_t number : equations.incident.of(row)) {
        const ContactTerm& c = contacts[at(number)];
        if (c.trial.mode == ContactMode::open) {
            continue;
        }
        const bool is_a = c.row_a == row;
        const Vec3 &arm = is_a ? c.arm_a : c.arm_b, &other = is_a ? c.arm_b : c.arm_a;
        sum.add(arm, other, stiffness_of(c), is_a ? c.entry_ab : c.entry_ba);
        const Vec3 push = (is_a ? 1.0 : -1.0) * force_at_start(c);
        force += push;
        dipole = dipole + outer(push, arm);
    }
    sum.close(equations.diagonal[at(row)], k.block(k.pattern().find(row, row)));
    const Vector12 load = load_vector(force, dipole);
    for (std::size_t i = 0; i < 12; ++i) {
        right[i] = equations.given[at(row)][i] + load[i];
    }
}

}  // namespace

void assemble(const std::vector<ContactTerm>& contacts, Equations& equations) {
    parallel::for_each_uneven(equations.matrix.rows(), 16, [&](std::int64_t row) {
        if (equations.is_stale[at(row)] != 0) {
            assemble_row(contacts, row, equations);
            equations.is_stale[at(row)] = 0;
            equations.is_new[at(row)] = 1;
        }
    });
}

linear::SolveReport solve(const SolveSettings& settings, Equations& equations) {
    equations.solution.resize(equations.right.size(), 0);
    equations.singular_row = -1;
    if (settings.solver == Solver::sor) {
        return solve_sor(settings, equations);
    }
    if (settings.solver == Solver::cholmod) {
        return linear::solve_cholmod(equations.matrix, equations.right, equations.solution);
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

namespace {

/// T D as translation and gradient: nine products where T has 36.
Vec3 displacement_at(const Vec3& arm, const double* d) { return Vec3{d[0], d[1], d[2]} + gradient_of(d) * arm; }

}  // namespace

void evaluate(const Equations& equations, ContactTerm& c) {
    Vec3 moved{};
    if (c.row_a >= 0) {
        moved += displacement_at(c.arm_a, &equations.solution[at(c.row_a) * 12]);
    }
    if (c.row_b >= 0) {
        moved -= displacement_at(c.arm_b, &equations.solution[at(c.row_b) * 12]);
    }
    c.trial.gap = c.gap - dot(c.normal, moved);
    const Vec3 total = moved + c.prescribed;
    c.trial.step_slip = total - dot(c.normal, total) * c.normal;
    c.trial.slip = c.trial.slip_before + c.trial.step_slip;
}

}  // namespace riprap::solid::implicit_dda

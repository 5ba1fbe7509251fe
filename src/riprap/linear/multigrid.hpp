// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/linear/cell_box.hpp"

namespace riprap::linear {

/// The symmetric operator of a variable-coefficient Poisson equation on a box of cells,
///
///     (A p)_i = sum over faces f of cell i of c_f (p_i - p_j),
///
/// with the conductance c_f >= 0 of every face. A face on the rim of the box with c_f > 0 leads to a cell of value 0
/// (Dirichlet), one with c_f = 0 is closed (Neumann). A cell without an open face has no equation and keeps p = 0.
struct FaceConductance {
    CellBox box;
    std::array<std::vector<double>, 3> face;  ///< [axis][flat index]: of the face below the cell, >= 0

    FaceConductance() = default;
    explicit FaceConductance(const CellBox& b) : box(b) {
        for (int a = 0; a < 3; ++a) {
            face[static_cast<std::size_t>(a)].assign(b.has_axis(a) ? static_cast<std::size_t>(b.size) : 0, 0.0);
        }
    }
};

/// Outcome of a solve.
struct PoissonReport {
    int iterations{0};     ///< of conjugate gradients [-]
    double residual{0};    ///< ||b - A p||_2 at the end over that at the start [-]
    double first{0};       ///< ||b - A p||_2 of the guess
    bool converged{true};  ///< the residual is at or below the tolerance
};

/// One V-cycle of geometric multigrid as a symmetric positive preconditioner z = M r, in single precision: two sweeps
/// of two-colour Gauss-Seidel before (red, black) and two after (black, red) each coarse correction.
///
/// The conductance of a coarse face is the sum of the fine ones on it over the growth of the distance between centres,
/// 2: the discretisation on the coarse cells where the coefficient is constant, and the density of the shared fine
/// faces where it jumps. Fine conductances in series across the face, the textbook's other mean, need two to three
/// times as many iterations at a density ratio of 833, as one face in air then hides the water behind it. The
/// correction is interpolated by conductances, p = p_own + sum over axes of w_a (p_neighbour - p_own) with
/// w = g_n/(g_o + g_n), where g_o and g_n are the conductances from the fine centre to the two coarse ones, w = 1/4
/// where they are constant; the restriction is the transpose. An axis is coarsened while its mean conductance is at
/// least 0.3 of the largest, so that stretched cells are first coarsened across their short side.
class Multigrid {
 public:
    /// Builds all levels. Memory is kept between calls.
    void build(const FaceConductance& fine);
    /// z = M r.
    void apply(const std::vector<double>& r, std::vector<double>& z);
    /// Returns M r in single precision, without the factor that `factor` is set to.
    /// @param size  of r, so that r over it fits single precision: its norm, say
    const std::vector<float>& apply(const std::vector<double>& r, double size, double& factor);
    std::size_t bytes() const;

 private:
    struct Level {
        CellBox box;
        std::array<std::vector<float>, 3> face;    ///< conductance of the face below
        std::array<std::vector<float>, 3> weight;  ///< of the coarse neighbour in the interpolation, per axis
        std::vector<float> inverse;                ///< 1/diagonal, 0 without an open face
        std::vector<float> x, b, r;
        std::array<bool, 3> coarsened{};  ///< axes along which the next level has half as many cells
    };
    static void set_box(Level& level, const CellBox& box);
    static void find_inverse(Level& level);
    static std::array<bool, 3> axes_to_coarsen(const Level& level);
    static void find_weights(Level& fine);
    static void coarsen(const Level& fine, Level& coarse);
    static void smooth(Level& level, int colour);
    static void start_smooth(Level& level);
    static void find_residual(Level& level);
    static void restrict_to(const Level& fine, Level& coarse);
    static void prolong(const Level& coarse, Level& fine);
    void cycle(std::size_t l);

    std::vector<Level> levels_;
    std::size_t level_count_{0};
    double scale_{1};  ///< of conductances, so that the largest is 1 in single precision
};

/// Conjugate gradients preconditioned by Multigrid, with sums in a fixed order: the same bits at any thread count.
class PoissonSolver {
 public:
    /// Takes the operator for the solves that follow.
    void set_operator(const FaceConductance& a);
    /// Solves A p = b from the guess in p until ||b - A p||_2 is at most `tolerance` times that of the guess, or
    /// `enough`, or 1e-14 times ||b||_2, where round-off ends any solve. Where no face leads out of the box the sum of
    /// b over cells has to vanish to round-off, and p is fixed by the guess up to a constant. b may be work().r.
    PoissonReport solve(const FaceConductance& a, const std::vector<double>& b, std::vector<double>& p,
                        double tolerance, int max_iterations, double enough = 0);
    std::size_t bytes() const;
    /// Arrays that hold nothing between two solves: free for other uses until the next.
    struct Work {
        std::vector<double> r, d, q;
    };
    Work& work() { return work_; }

 private:
    Multigrid multigrid_;
    Work work_;
};

/// Dot product over the cells of the box (not its pads), in a fixed order.
double dot_cells(const CellBox& box, const std::vector<double>& x, const std::vector<double>& y);

}  // namespace riprap::linear

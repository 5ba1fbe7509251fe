// SPDX-License-Identifier: Apache-2.0
// Our multigrid against PFMG of hypre, where CMake finds it (Debian: libhypre-dev).
#ifdef RIPRAP_HYPRE
#include <HYPRE_struct_ls.h>
#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <random>

#include "riprap/linear/multigrid.hpp"

namespace riprap::linear {
namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Water below air at a density ratio of 833, the surface a step within each column; open at the top.
FaceConductance tank(const std::array<int, 3>& cells) {
    FaceConductance a(CellBox(cells, 2, 3));
    std::mt19937 random(3);
    std::vector<int> level(at(static_cast<std::int64_t>(cells[0]) * cells[1]));
    for (int& l : level) {
        l = cells[2] / 2 + static_cast<int>(random() % 5) - 2;
    }
    const auto density = [&](int i, int j, int k) {
        return k < level[at(i + std::int64_t{cells[0]} * j)] ? 833.0 : 1.0;
    };
    for (int k = 0; k < cells[2]; ++k) {
        for (int j = 0; j < cells[1]; ++j) {
            for (int i = 0; i < cells[0]; ++i) {
                const std::int64_t c = a.box.index(i, j, k);
                const std::array<int, 3> place{i, j, k};
                for (int d = 0; d < 3; ++d) {
                    std::array<int, 3> below = place;
                    below[at(d)] -= 1;
                    if (place[at(d)] > 0) {
                        a.face[at(d)][at(c)] = 2 / (density(i, j, k) + density(below[0], below[1], below[2]));
                    }
                }
                if (k == cells[2] - 1) {
                    a.face[2][at(c + a.box.stride[2])] = 2 / density(i, j, k);
                }
            }
        }
    }
    return a;
}

/// Values of cells, x fastest, as hypre has them.
std::vector<double> packed(const CellBox& box, const std::vector<double>& field) {
    std::vector<double> values;
    for (int k = 0; k < box.cells[2]; ++k) {
        for (int j = 0; j < box.cells[1]; ++j) {
            for (int i = 0; i < box.cells[0]; ++i) {
                values.push_back(field[at(box.index(i, j, k))]);
            }
        }
    }
    return values;
}

struct Solved {
    std::vector<double> p;
    int iterations{0};
};

/// Conjugate gradients of hypre, preconditioned by one cycle of PFMG.
Solved solve_by_hypre(const FaceConductance& a, const std::vector<double>& b, double tolerance) {
    const CellBox& box = a.box;
    std::array<int, 3> low{0, 0, 0}, high{box.cells[0] - 1, box.cells[1] - 1, box.cells[2] - 1};
    HYPRE_StructGrid grid{};
    HYPRE_StructGridCreate(MPI_COMM_SELF, 3, &grid);
    HYPRE_StructGridSetExtents(grid, low.data(), high.data());
    HYPRE_StructGridAssemble(grid);
    HYPRE_StructStencil stencil{};
    HYPRE_StructStencilCreate(3, 4, &stencil);
    std::array<std::array<int, 3>, 4> offsets{{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    for (int s = 0; s < 4; ++s) {
        HYPRE_StructStencilSetElement(stencil, s, offsets[at(s)].data());
    }
    HYPRE_StructMatrix matrix{};
    HYPRE_StructMatrixCreate(MPI_COMM_SELF, grid, stencil, &matrix);
    HYPRE_StructMatrixSetSymmetric(matrix, 1);
    HYPRE_StructMatrixInitialize(matrix);
    std::vector<double> values;
    for (int k = 0; k < box.cells[2]; ++k) {
        for (int j = 0; j < box.cells[1]; ++j) {
            for (int i = 0; i < box.cells[0]; ++i) {
                const std::int64_t c = box.index(i, j, k);
                double sum = 0;
                for (int d = 0; d < 3; ++d) {
                    sum += a.face[at(d)][at(c)] + a.face[at(d)][at(c + box.stride[at(d)])];
                }
                values.push_back(sum);
                for (int d = 0; d < 3; ++d) {
                    const bool is_rim = std::array{i, j, k}[at(d)] == 0;
                    values.push_back(is_rim ? 0 : -a.face[at(d)][at(c)]);
                }
            }
        }
    }
    std::array<int, 4> entries{0, 1, 2, 3};
    HYPRE_StructMatrixSetBoxValues(matrix, low.data(), high.data(), 4, entries.data(), values.data());
    HYPRE_StructMatrixAssemble(matrix);
    HYPRE_StructVector right{}, left{};
    for (HYPRE_StructVector* v : {&right, &left}) {
        HYPRE_StructVectorCreate(MPI_COMM_SELF, grid, v);
        HYPRE_StructVectorInitialize(*v);
    }
    std::vector<double> given = packed(box, b), start(given.size(), 0.0);
    HYPRE_StructVectorSetBoxValues(right, low.data(), high.data(), given.data());
    HYPRE_StructVectorSetBoxValues(left, low.data(), high.data(), start.data());
    HYPRE_StructVectorAssemble(right);
    HYPRE_StructVectorAssemble(left);
    HYPRE_StructSolver pcg{}, pfmg{};
    HYPRE_StructPCGCreate(MPI_COMM_SELF, &pcg);
    HYPRE_StructPCGSetTol(pcg, tolerance);
    HYPRE_StructPCGSetMaxIter(pcg, 200);
    HYPRE_StructPCGSetTwoNorm(pcg, 1);
    HYPRE_StructPFMGCreate(MPI_COMM_SELF, &pfmg);
    HYPRE_StructPFMGSetMaxIter(pfmg, 1);
    HYPRE_StructPFMGSetTol(pfmg, 0);
    HYPRE_StructPFMGSetZeroGuess(pfmg);
    HYPRE_StructPFMGSetRelaxType(pfmg, 2);  // red-black, symmetric
    HYPRE_StructPCGSetPrecond(pcg, HYPRE_StructPFMGSolve, HYPRE_StructPFMGSetup, pfmg);
    HYPRE_StructPCGSetup(pcg, matrix, right, left);
    HYPRE_StructPCGSolve(pcg, matrix, right, left);
    Solved solved{std::vector<double>(given.size()), 0};
    HYPRE_StructPCGGetNumIterations(pcg, &solved.iterations);
    HYPRE_StructVectorGetBoxValues(left, low.data(), high.data(), solved.p.data());
    HYPRE_StructPCGDestroy(pcg);
    HYPRE_StructPFMGDestroy(pfmg);
    HYPRE_StructVectorDestroy(right);
    HYPRE_StructVectorDestroy(left);
    HYPRE_StructMatrixDestroy(matrix);
    HYPRE_StructStencilDestroy(stencil);
    HYPRE_StructGridDestroy(grid);
    return solved;
}

TEST(Multigrid, solves_as_hypres_pfmg_does_in_no_more_iterations) {
    MPI_Init(nullptr, nullptr);
    const FaceConductance a = tank({24, 17, 20});
    std::vector<double> b(at(a.box.size), 0.0), p(at(a.box.size), 0.0);
    std::mt19937 random(7);
    for (int k = 0; k < a.box.cells[2]; ++k) {
        for (int j = 0; j < a.box.cells[1]; ++j) {
            for (int i = 0; i < a.box.cells[0]; ++i) {
                b[at(a.box.index(i, j, k))] = static_cast<double>(random()) / 4294967296.0 - 0.5;
            }
        }
    }
    constexpr double tolerance = 1e-11;
    const Solved by_hypre = solve_by_hypre(a, b, tolerance);
    PoissonSolver solver;
    solver.set_operator(a);
    const PoissonReport report = solver.solve(a, b, p, tolerance, 200);
    ASSERT_TRUE(report.converged);
    const std::vector<double> ours = packed(a.box, p);
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        largest = std::max(largest, std::abs(by_hypre.p[i]));
        difference = std::max(difference, std::abs(ours[i] - by_hypre.p[i]));
    }
    EXPECT_LT(difference, 1e-8 * largest);
    EXPECT_LE(report.iterations, by_hypre.iterations);
    RecordProperty("hypre_iterations", by_hypre.iterations);
    RecordProperty("iterations", report.iterations);
    MPI_Finalize();
}

}  // namespace
}  // namespace riprap::linear
#endif

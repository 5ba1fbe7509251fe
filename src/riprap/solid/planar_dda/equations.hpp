// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/block_jacobi.hpp"
#include "riprap/linear/pcg.hpp"
#include "riprap/solid/planar_dda/block_cholesky.hpp"

namespace riprap::solid::planar_dda {

/// Chooses the solver of the equations of a step.
enum class Way : std::uint8_t {
    direct,    ///< sparse factors: static steps, stiff springs, few blocks
    iterative  ///< conjugate gradients: many blocks whose inertia 2 m/dt^2 keeps up with the springs
};

/// The equations K D = F of one step, K symmetric and positive definite in blocks of 6 x 6.
class Equations {
 public:
    /// Sets the pattern: `count` rows and the pairs of rows that are coupled, in any order, repeated or not.
    void set_pattern(std::int32_t count, std::span<const std::pair<std::int32_t, std::int32_t>> couplings, Way way);
    void set_zero();
    /// Adds to the diagonal block of a row.
    void add_diagonal(std::int32_t row, const Block6& block);
    /// Adds s u v^T to the block (row_u, row_v) and its transpose to (row_v, row_u); equal rows: s u v^T once.
    void add_outer(std::int32_t row_u, std::int32_t row_v, double s, const Unknowns& u, const Unknowns& v);
    /// Makes ready to solve with the values as they are. @returns the row whose pivot is not positive, or -1
    std::int32_t prepare();
    /// x = K^-1 b from the guess in x. Where conjugate gradients do not get to 1e-12 of b, K is factorised after all.
    /// @returns the row whose pivot is not positive, or -1
    std::int32_t solve(std::span<const Unknowns> b, std::span<Unknowns> x);

 private:
    std::int32_t factorize_rows();

    Way way_{Way::direct};
    bool is_factorized_{false};  ///< of the iterative way: conjugate gradients have failed with these values
    std::vector<std::pair<std::int32_t, std::int32_t>> couplings_;
    BlockCholesky factors_;
    linear::BlockCsr<6> rows_;
    linear::BlockJacobi<6> preconditioner_;
    linear::PcgScratch buffers_;
    std::vector<double> right_, solution_;
};

}  // namespace riprap::solid::planar_dda

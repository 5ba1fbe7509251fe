// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/pcg.hpp"

namespace riprap::linear {

const char* describe(SolveStatus status) {
    switch (status) {
        case SolveStatus::converged:
            return "converged";
        case SolveStatus::too_many_iterations:
            return "not converged in the iterations allowed";
        case SolveStatus::stagnated:
            return "stopped converging at round-off above the tolerance";
        case SolveStatus::not_positive_definite:
            return "the matrix or its preconditioner is not positive definite";
        case SolveStatus::not_finite:
            return "a number of the system is not finite";
    }
    return "unknown";
}

}  // namespace riprap::linear

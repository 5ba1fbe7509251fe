// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "riprap/contact/law/joint_laws.hpp"
#include "riprap/solid/affine/elasticity.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::solid::implicit_dda {

enum class Solver : std::uint8_t {
    pcg_jacobi,    ///< conjugate gradients, diagonal blocks as preconditioner
    pcg_cholesky,  ///< conjugate gradients, incomplete Cholesky factors
    sor            ///< block successive over-relaxation, the source's solver [Ding2021, eq. 4.120]
};

struct SolveSettings {
    Solver solver{Solver::pcg_jacobi};
    double tolerance{1e-10};  ///< |F - K D|/|F| [-]
    int max_iterations{2000};
    double relaxation{1.3};  ///< of SOR [-]
};

struct Settings {
    SolveSettings solve{};
    int open_close{6};   ///< iterations before the step is cut
    double cut{0.3};     ///< share of the step tried then [-]
    double reach{0.01};  ///< contacts are sought up to this share of the smallest block apart, besides the way
                         ///< of a step [-]
    double max_displacement{
        0.1};  ///< of a corner in a step, share of the smallest block; a longer one cuts the step [-]
    std::optional<double> slide_tolerance{};  ///< see OpenCloseRule; empty = by reversal [m]
    double dynamic{1};                        ///< kappa: share of the velocity that a step starts with; 0 = static [-]
    contact::JointLaws joint_law{};
};

struct State;  // state.hpp

}  // namespace riprap::solid::implicit_dda

namespace riprap::solid {

class ImplicitDda;

/// Keys of `solid.method = "implicit_dda"`.
struct ImplicitDdaSettings {
    using Method = ImplicitDda;
    using Fields = implicit_dda::State;
    static constexpr std::string_view method_name = "implicit_dda";
    static MethodKeys<ImplicitDdaSettings> keys();
    implicit_dda::Settings engine;
    affine::Elasticity elasticity;
    double step{1e-3};  ///< that the method wants; shorter where the open-close iteration does not settle [s]
};

}  // namespace riprap::solid

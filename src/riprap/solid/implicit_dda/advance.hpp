// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "riprap/core/step.hpp"
#include "riprap/solid/implicit_dda/settings.hpp"
#include "riprap/solid/implicit_dda/state.hpp"
#include "riprap/solid/implicit_dda/system.hpp"
#include "riprap/solid/solid_times.hpp"

// Implicit DDA in three dimensions [Ding2021, chapter 4, corrected]: deformable convex blocks of twelve unknowns,
// common- plane contact, open-close iteration, Newmark with beta = 1/2 and gamma = 1. Settings and BlockSystem are
// Model, State is saved, Scratch may be dropped between steps.

namespace riprap::solid::implicit_dda {

struct Scratch {
    affine::PlacedBlocks placed;
    affine::ContactFinder finder;
    std::vector<ContactTerm> contacts;     ///< one for every contact point found
    affine::BlockContactHistory old;       ///< its buffers are those of the next history
    std::vector<std::int32_t> row, block;  ///< row of a block, -1 = fixed; block of a row
    Equations equations;
    const std::vector<affine::BlockContact>& found() const { return finder.found(); }
    SolidTimes times;
    double solve_time{0};                             ///< of times.contact_loads, spent in solutions [s]
    std::vector<std::pair<Vec3, Vec3>> point_forces;  ///< arm [m] and force [N] of every fixed point, after the step
};

/// Energies at the end of the step and what it did [J].
struct StepReport {
    affine::BlockSums sums;
    double strain{0}, contact{0};    ///< stored in blocks, and in contact springs and fixed points [J]
    double friction_loss{0};         ///< taken by sliding [J]
    double numerical_loss{0};        ///< taken by the integrator: 1/2 D K D over all springs [J]
    double static_loss{0};           ///< kinetic energy that Settings::dynamic leaves behind [J]
    double lost_energy{0};           ///< of contact springs, where contact points are found elsewhere than the step of
                                     ///< the equations left them: on new corners, or not at all [J]
    double external_work{0};         ///< of given loads [J]
    double deepest{0};               ///< overlap [m]
    double largest_displacement{0};  ///< of a corner [m]
    int open_close{0}, solver_iterations{0};
    std::int64_t contact_count{0}, sliding_count{0};
    std::int64_t open_frictions{0};  ///< sliding contacts whose friction was still changing after the last round
    std::array<std::int32_t, 2> unsettled{-1, -1};  ///< blocks of a contact that opened and closed without end
    std::int32_t singular{-1};                      ///< block whose rows of the equations have no solution
};

/// One step of length dt. Where the open-close iteration does not settle, the solver fails or a corner moves too far,
/// nothing in `state` has changed and the answer names the pair or block and a shorter step.
Outcome advance(const affine::BlockSystem& system, const Settings& settings, double dt,
                const affine::BlockLoads& external, State& state, Scratch& scratch, StepReport& report);

}  // namespace riprap::solid::implicit_dda

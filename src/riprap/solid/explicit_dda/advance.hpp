// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/law/penalty.hpp"
#include "riprap/core/step.hpp"
#include "riprap/solid/affine/block_contacts.hpp"
#include "riprap/solid/explicit_dda/block_motion.hpp"
#include "riprap/solid/explicit_dda/settings.hpp"
#include "riprap/solid/explicit_dda/state.hpp"
#include "riprap/solid/solid_times.hpp"

// Explicit DDA in three dimensions [MikolaSitar2013]: deformable convex blocks, common-plane contact, penalty springs
// with Coulomb friction, central differences. Block-local: nothing is assembled, no open-close iteration. Settings and
// BlockSystem are Model, State is saved, Scratch may be dropped between steps.

namespace riprap::solid::explicit_dda {

/// Answer of one contact point, for loads, history and output.
struct ContactForce {
    Vec3 force{};     ///< on a [N]
    Vec3 velocity{};  ///< of a against b before the kick [m/s]
    contact::PenaltyAnswer answer;
    bool was_intact{false};             ///< before
    bool is_apart{false};               ///< open, with a bond that is still intact
    double share_a{0}, share_b{0};      ///< in the highest omega^2 of both blocks [1/s^2]
    double damping_a{0}, damping_b{0};  ///< the same of the dashpots [1/s]
};

struct Scratch {
    affine::PlacedBlocks placed;
    affine::ContactFinder finder;
    std::vector<ContactForce> forces;  ///< of every contact point found
    std::vector<BlockForce> loads;
    affine::BlockContactHistory old;
    std::vector<std::uint8_t> is_carried;  ///< rows of `old` that were found again
    std::vector<Mat3> softness;            ///< S^-1 of every block [1/(kg m^2)]
    std::vector<double> squared, damping;  ///< sums of ContactForce::share and damping, per block
    SolidTimes times;
    const std::vector<affine::BlockContact>& contacts() const { return finder.found(); }
};

/// Energies at the mid-step pose with the velocities v_n + a dt/2, and the losses of the step [J].
struct StepReport {
    affine::BlockSums sums;
    double strain{0}, contact{0};  ///< stored in blocks and in contact springs [J]
    double friction_loss{0}, dashpot_loss{0}, damping_loss{0}, external_work{0};
    double lost_energy{0};  ///< of springs whose contact opened [J]
    double deepest{0};      ///< overlap [m]
    double stable_step{0};  ///< that the contacts and blocks as they are allow [s]
    std::int64_t contact_count{0}, sliding_count{0};
};

/// Stable step before any contact is known: strain modes of every block, and `springs` contact points per block at its
/// farthest corner, each against a block as light as itself [s]; see critical_step.cpp.
double stable_step(const affine::BlockSystem& system, const affine::BlockState& state, int springs = 8);

/// Moves all blocks from t to t + dt: half a drift, contacts and forces there, kick, half a drift. With constant dt the
/// central difference scheme of [MikolaSitar2013, eqs. 5-7, corrected].
Outcome advance(const affine::BlockSystem& system, const Settings& settings, double dt,
                const affine::BlockLoads& external, State& state, Scratch& scratch, StepReport& report);

}  // namespace riprap::solid::explicit_dda

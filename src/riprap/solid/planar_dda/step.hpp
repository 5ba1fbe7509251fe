// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/core/step.hpp"
#include "riprap/solid/planar_dda/contacts.hpp"
#include "riprap/solid/planar_dda/equations.hpp"
#include "riprap/solid/solid_times.hpp"

namespace riprap::solid::planar_dda {

/// Loads of one step.
struct Step {
    double dt{0};                        ///< [s]
    Vec2 gravity{};                      ///< body force per mass [m/s^2]
    std::span<const Unknowns> loads{};   ///< generalized force per block: force, torque, pull; empty = none
    std::span<const Unknowns> driven{};  ///< displacement of fixed blocks in this step; empty = at rest
};

struct StepReport {
    int iterations{0};  ///< solutions of the equations
    int factorizations{0};
    std::int32_t closed_contacts{0};
    std::int64_t open_frictions{0};  ///< sliding contacts whose friction was still changing after the last solution
    std::int64_t touching_pairs{0};  ///< of blocks with closed contacts
    double largest_displacement{0};  ///< of a corner [m]
    double largest_overlap{0};       ///< of a closed contact, after the step [m]
};

/// A contact as the open-close iteration sees it.
struct Trial {
    Mode mode{Mode::open};
    bool is_bonded{false};
    bool has_broken{false};  ///< in this step
    int flips{0};            ///< how often it has opened or closed in this step
    double multiplier{0};    ///< [N]
    double gap_before{0};    ///< from which the dashpot counts [m]
    double gap{0}, slip{0};  ///< after the last solution [m]
    double slip_start{0};    ///< at the start of the step, against the lock point [m]
    double normal{0};        ///< force of spring, multiplier and dashpot, positive in compression [N]
    double plastic_slip{0};  ///< of a bond, in all [m]
    double kept{0};          ///< friction that a sliding contact goes on with after the step [N]
    double friction{0};      ///< force used where it slides, with the sign of the slip [N]
    double change{0};        ///< of that force after the last solution [N]
};

/// Buffers of a step; nothing that has to be kept.
struct Scratch {
    std::vector<Vec2> corners;
    ContactSearch search;
    std::vector<Contact> contacts;
    std::vector<Trial> trials;
    std::vector<std::int32_t> row;  ///< of a block in the equations, -1 = fixed
    std::vector<std::int32_t> block_of_row;
    std::vector<std::pair<std::int32_t, std::int32_t>> couplings;
    std::vector<Block6> stiffness;  ///< per row, without contacts
    std::vector<Unknowns> force;    ///< per row, without contacts
    std::vector<Unknowns> right, solution;
    std::vector<Unknowns> motion;  ///< D per block, of fixed ones too
    Equations equations;
    SolidTimes times;
};

/// Takes one step, or refuses it and leaves the state as it was.
///
/// Solves (K + 2 M/dt^2) D = F + 2 M V/dt with the open-close iteration, then moves the blocks: centroids by (u0, v0),
/// corners by R(gamma0)(I + eps) about them, stress by R (sigma + E eps) R^T and rates by V' = 2 D/dt - V, their strain
/// part turned with the block [Shi1988; Ding2021, sections 3.1 to 3.3]. A constant force is followed exactly at any dt.
/// Differs from the source: corners are turned exactly, so that area does not grow by 1 + gamma0^2 a step; the
/// friction of a sliding contact stays on its lock point, which follows the slip with the elastic slip of its limit
/// force, so that a reversed slip unloads the spring.
Outcome advance(const Model& model, const Settings& settings, const Step& step, State& state, Scratch& scratch,
                StepReport& report);

/// Energies of a state [J].
struct Energies {
    double kinetic{0}, strain{0}, contact{0}, fixed_points{0}, bolts{0};
    double total() const { return kinetic + strain + contact + fixed_points + bolts; }
};
Energies energies_of(const Model& model, const State& state);

}  // namespace riprap::solid::planar_dda

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "riprap/solid/planar_dda/unknowns.hpp"

namespace riprap::solid::planar_dda {

/// Of a contact: apart; touching and sliding; touching and held by the shear spring.
enum class Mode : std::uint8_t { open, sliding, locked };

/// Energies of the method [J], running totals since the start. `linearization` is what contacts and masses gain when
/// the step's linear displacement is replaced by the exact rotation; it is measured term by term.
struct Accounts {
    double work_gravity{0};     ///< on free blocks
    double work_loads{0};       ///< of point loads and of loads given from outside
    double work_driven{0};      ///< of fixed blocks that are moved
    double friction_loss{0};    ///< by sliding contacts
    double dashpot_loss{0};     ///< by normal dashpots
    double bond_loss{0};        ///< stored energy given up by bonds that break
    double newmark_loss{0};     ///< numerical damping: 1/2 k (change of length)^2 of every spring and every strain
    double static_loss{0};      ///< kinetic energy taken between steps (dynamic_factor below 1)
    double constraint_work{0};  ///< of the Lagrange multipliers
    double linearization{0};    ///< gained
};

/// Everything that changes.
struct State {
    std::vector<double> x, y;                                ///< of the centroids [m]
    std::vector<double> angle;                               ///< R, whole turns included [rad]
    std::vector<double> stretch_xx, stretch_yy, stretch_xy;  ///< U: corners are x_c + R U X [-]
    std::vector<double> rates;                               ///< six per block, see Unknowns
    std::vector<double> stress_x, stress_y, stress_xy;       ///< world axes, tension positive [Pa]

    std::vector<std::int32_t> contact_corner, contact_edge;  ///< sorted by corner, then edge
    std::vector<std::uint8_t> contact_mode, contact_is_bonded;
    std::vector<double> contact_lock;   ///< place of the lock point along its edge, from its end (0) to its begin (1)
                                        ///< [-]; of a disc its slip [m]
    std::vector<double> contact_share;  ///< see Contact::share [-]
    std::vector<double> contact_multiplier;    ///< [N]
    std::vector<double> contact_plastic_slip;  ///< by which a bond has slid at its strength so far [m]
    std::vector<double> contact_force;         ///< normal force at the end of the last step [N]

    Accounts accounts;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("x", self.x);
        visit("y", self.y);
        visit("angle", self.angle);
        visit("stretch_xx", self.stretch_xx);
        visit("stretch_yy", self.stretch_yy);
        visit("stretch_xy", self.stretch_xy);
        visit("rates", self.rates);
        visit("stress_x", self.stress_x);
        visit("stress_y", self.stress_y);
        visit("stress_xy", self.stress_xy);
        visit("contact_corner", self.contact_corner);
        visit("contact_edge", self.contact_edge);
        visit("contact_mode", self.contact_mode);
        visit("contact_is_bonded", self.contact_is_bonded);
        visit("contact_lock", self.contact_lock);
        visit("contact_share", self.contact_share);
        visit("contact_multiplier", self.contact_multiplier);
        visit("contact_plastic_slip", self.contact_plastic_slip);
        visit("contact_force", self.contact_force);
        visit("work_gravity", self.accounts.work_gravity);
        visit("work_loads", self.accounts.work_loads);
        visit("work_driven", self.accounts.work_driven);
        visit("friction_loss", self.accounts.friction_loss);
        visit("dashpot_loss", self.accounts.dashpot_loss);
        visit("bond_loss", self.accounts.bond_loss);
        visit("newmark_loss", self.accounts.newmark_loss);
        visit("static_loss", self.accounts.static_loss);
        visit("constraint_work", self.accounts.constraint_work);
        visit("linearization", self.accounts.linearization);
    }
};

/// The lists that have one entry per contact.
inline auto contact_lists(State& state) {
    return std::tie(state.contact_corner, state.contact_edge, state.contact_mode, state.contact_is_bonded,
                    state.contact_lock, state.contact_share, state.contact_multiplier, state.contact_plastic_slip,
                    state.contact_force);
}

/// Forgets all contacts.
inline void clear_contacts(State& state) {
    std::apply([](auto&... list) { (list.clear(), ...); }, contact_lists(state));
}

/// Offset from the centroid of a point with the offset X in the reference shape: R U X [m].
Vec2 offset_of(const State& state, std::int32_t block, const Vec2& local);
/// Place of a point with the offset X in the reference shape [m].
Vec2 place_of(const State& state, std::int32_t block, const Vec2& local);
Unknowns rates_of(const State& state, std::int32_t block);
/// Velocity of such a point [m/s].
Vec2 velocity_of(const State& state, std::int32_t block, const Vec2& local);

}  // namespace riprap::solid::planar_dda

namespace riprap::solid {

/// State of planar DDA: the blocks, and what its pieces hand on.
struct PlanarDdaFields {
    planar_dda::State blocks;
    std::vector<std::uint8_t> was_held;  ///< per block: not moved by forces in the last piece
    std::vector<double> around;          ///< centre and radius of the bodies at the start: see make_blocks [m]

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        planar_dda::State::visit_fields(self.blocks, visit);
        visit("was_held", self.was_held);
        visit("around", self.around);
    }
};

}  // namespace riprap::solid

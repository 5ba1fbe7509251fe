// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_set.hpp"

namespace riprap::body {

/// Degrees of freedom that a free body lacks, along and about the axes of the world: guides and hinges without friction
/// through its centre of mass. They do no work.
///
/// With F the projection on the axes that it may turn about and M the torque of everything but the guides, d(F L)/dt =
/// F M, and omega = W L with
///
///     W = F (F J F)^-1 F,   from J^-1 by W <- W - (W e_k)(W e_k)^T / W_kk for each locked axis e_k.
///
/// State keeps F L; the kinetic energy of the rotation is omega . F L / 2. With two free axes the constraint is not
/// holonomic: the body gets to any orientation, but never turns about the third axis.
struct Locks {
    static constexpr int axes = 3;
    std::uint8_t bits{0};  ///< 0 to 2: translation along x, y, z; 3 to 5: rotation about them

    bool any() const { return bits != 0; }
    bool translation(int axis) const { return (bits >> axis & 1) != 0; }
    bool rotation(int axis) const { return (bits >> (axes + axis) & 1) != 0; }
    bool any_rotation() const { return bits >> axes != 0; }

    /// Returns the part of a vector along the free axes of translation.
    Vec3 free_translation(const Vec3& v) const {
        return {translation(0) ? 0 : v.x, translation(1) ? 0 : v.y, translation(2) ? 0 : v.z};
    }
    /// Returns the part of a vector about the free axes of rotation.
    Vec3 free_rotation(const Vec3& v) const {
        return {rotation(0) ? 0 : v.x, rotation(1) ? 0 : v.y, rotation(2) ? 0 : v.z};
    }
};

/// Returns the locks of a body.
inline Locks locks_of(const BodySet& bodies, std::size_t body) {
    return {bodies.locks.empty() ? std::uint8_t{0} : bodies.locks[body]};
}
/// Puts a free body into guides; what it has of velocities along them goes.
void guide(BodySet& bodies, BodyState& state, BodyId body, const Locks& locks);

/// True where `count` bodies from `first` on are moved by forces alone, in all directions, now and ever.
bool are_free(const BodySet& bodies, std::int64_t first, std::int64_t count);

/// W of the inverse inertia J^-1, both in world axes [1/(kg m^2)].
Sym3 lock(const Locks& locks, const Sym3& inverse_inertia);

/// W of a body at an orientation, J^-1 where it has no guides; 0 without inertia [1/(kg m^2)].
Sym3 inverse_inertia_of(const BodySet& bodies, std::size_t body, const Quat& orientation);

/// Orientation of a body after `dt` without torque but that of its guides: rotate_free, or the turn with omega = W L,
/// exact about one free axis and by the implicit midpoint rule about two.
Quat turn_body(const BodySet& bodies, std::size_t body, const Quat& orientation, const Vec3& angular_momentum,
               double dt);

}  // namespace riprap::body

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/core/bytes.hpp"

namespace riprap::body {

/// Forces on every body, gathered by the transpose of the map that moves its points, x = x_c + R U X: with f at the
/// points and r = x - x_c,
///
///     force = sum f,   torque = sum r x f,   pull = sum sym(f r^T),
///
/// so that the power is force . v_c + torque . omega + pull : D, D the rate of stretching in world axes. Rigid bodies
/// have no `pull`: the array is empty where no body of the scene deforms. In planar scenes all per metre of width.
struct Loads {
    std::vector<Vec3> force;   ///< [N]
    std::vector<Vec3> torque;  ///< about the centre of mass [N m]
    std::vector<Sym3> pull;    ///< world axes [N m]; empty: rigid bodies only

    std::size_t size() const { return force.size(); }
    bool empty() const { return force.empty(); }
    std::size_t bytes() const { return bytes_of(force, torque, pull); }
    Loads& operator+=(const Loads& other) {
        for (std::size_t b = 0; b < other.force.size(); ++b) {
            force[b] += other.force[b];
            torque[b] += other.torque[b];
        }
        for (std::size_t b = 0; b < other.pull.size(); ++b) {
            pull[b] += other.pull[b];
        }
        return *this;
    }
    /// Makes zeros for `bodies` bodies; of the pull too where `deforms`.
    void clear(std::size_t bodies, bool deforms = false) {
        force.assign(bodies, {});
        torque.assign(bodies, {});
        pull.assign(deforms ? bodies : 0, {});
    }
};

/// View of loads held elsewhere; empty = none.
struct LoadView {
    std::span<const Vec3> force, torque;
    std::span<const Sym3> pull;

    LoadView() = default;
    LoadView(std::span<const Vec3> forces, std::span<const Vec3> torques, std::span<const Sym3> pulls = {})
        : force(forces), torque(torques), pull(pulls) {}
    LoadView(const Loads& loads)  // NOLINT(google-explicit-constructor): loads are a view of themselves
        : force(loads.force), torque(loads.torque), pull(loads.pull) {}
    LoadView(Loads&&) = delete;
    bool empty() const { return force.empty(); }
};

}  // namespace riprap::body

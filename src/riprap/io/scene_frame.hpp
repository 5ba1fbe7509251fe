// SPDX-License-Identifier: Apache-2.0
#pragma once

// A scene at one moment, for viewers: every body as polygons, every contact as a point with its force.

#include <array>
#include <span>
#include <vector>

#include "riprap/contact/shown_contact.hpp"
#include "riprap/io/vtp.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::io {

/// A half-space as drawn: a square of its plane around the scene, in the frame of its part, so that it moves with
/// its body.
struct DrawnPlane {
    std::array<Vec3, 4> corners;  ///< counter-clockwise seen from outside [m]
};

/// The drawn planes of a scene, one entry per part (meaningless for parts that are not half-spaces). Sized to the
/// bodies at time 0, so that a plane keeps its size from frame to frame and after a restart.
std::vector<DrawnPlane> draw_planes(const sim::Model& model, const sim::State& initial);

/// Bodies as polygons, in world coordinates [m]. Cell arrays: body, material, is_free, velocity, speed,
/// angular_velocity, displacement, distance, contact_force where it is known, and "NAME [UNIT]" for each field that the
/// solid method shows (core/shown.hpp).
/// Faces between the convex parts of one body are left out. Field arrays, one tuple per body and in double precision:
/// body_position [m], the centre of mass, and body_orientation (w, x, y, z).
PolyData draw_bodies(const sim::Model& model, const sim::State& initial, const sim::State& state,
                     std::span<const DrawnPlane> planes, std::span<const Vec3> contact_force);

/// Contacts as points. Point arrays: body_a, body_b, force (on body a) [N], normal_force, shear_force [N],
/// overlap [m], area [m^2], is_sliding.
PolyData draw_contacts(std::span<const contact::ShownContact> contacts);

/// One line per body at the end of a run: name, mass, pose, velocities, displacement, rotation, contact force.
/// `contact_force` may be empty. @throws FileError
void write_bodies_csv(const std::filesystem::path& path, const sim::Model& model, const sim::State& initial,
                      const sim::State& state, std::span<const Vec3> contact_force);

}  // namespace riprap::io

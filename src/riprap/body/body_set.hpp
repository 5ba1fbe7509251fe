// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "riprap/body/prescribed_motion.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/ids.hpp"
#include "riprap/core/sym3.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::body {

/// Who decides where a body goes.
enum class Drive : std::uint8_t {
    free,    ///< forces
    fixed,   ///< nobody
    driven,  ///< a PrescribedMotion
};

/// A convex piece of a body. Most bodies have one, with the identity as `local`.
struct Part {
    BodyId body;
    ShapeId shape;
    Pose local;  ///< pose of the shape in the body frame (origin: centre of mass of the body)
};

/// A body that moves as it is told.
struct DrivenBody {
    std::int32_t motion;  ///< index into motions
    Pose start;           ///< that the motion counts from
};

/// Constant properties of the bodies: Model. All arrays have one entry per body unless said.
struct BodySet {
    std::vector<std::int32_t> name_id;     ///< index into names
    std::vector<std::int32_t> name_index;  ///< number within the name, -1 where the name is unique
    std::vector<std::string> names;
    std::vector<MaterialId> material;
    std::vector<Drive> drive;
    std::vector<double> mass;               ///< [kg]; also of fixed bodies where known
    std::vector<Vec3> principal_moments;    ///< of inertia [kg m^2]
    std::vector<Quat> principal_axes;       ///< principal frame -> body frame
    std::vector<std::int32_t> driven;       ///< index into driven_bodies; -1 = none
    std::vector<std::uint8_t> locks;        ///< Locks::bits (locks.hpp); empty where no body is locked
    std::vector<double> release_time;       ///< a fixed or driven body becomes free then [s]; infinity = never
    std::vector<std::int32_t> part_begin;   ///< size() + 1 entries
    std::vector<Part> parts;                ///< grouped by body
    std::vector<DrivenBody> driven_bodies;  ///< one entry per body that is driven
    std::vector<PrescribedMotion> motions;
    bool is_planar{false};  ///< dimension = 2: motion stays in the x-y plane

    std::int32_t size() const { return static_cast<std::int32_t>(mass.size()); }
    std::int32_t part_count() const { return static_cast<std::int32_t>(parts.size()); }
    std::string name(BodyId body) const;  ///< "block" or "block[17]"
};

/// Poses and velocities of the bodies: State. Both at the same time.
struct BodyState {
    std::vector<Vec3> position;          ///< of the centre of mass [m]
    std::vector<Quat> orientation;       ///< body -> world
    std::vector<Vec3> velocity;          ///< [m/s]
    std::vector<Vec3> angular_momentum;  ///< about the centre of mass, world axes [kg m^2/s]
    /// Of driven bodies: what corrections have moved them beyond their motion, and how fast they do now; empty where no
    /// body is corrected [m], [m/s].
    std::vector<Vec3> drive_offset, drive_rate;
    /// Of deformable bodies: the stretch U of x = x_c + R U X, body axes [-], and its rate D, world axes [1/s]. Empty
    /// in scenes of rigid bodies.
    std::vector<Sym3> stretch, stretch_rate;

    bool deforms() const { return !stretch.empty(); }
    std::int32_t size() const { return static_cast<std::int32_t>(position.size()); }
    friend bool operator==(const BodyState&, const BodyState&) = default;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("body.position", self.position);
        visit("body.orientation", self.orientation);
        visit("body.velocity", self.velocity);
        visit("body.angular_momentum", self.angular_momentum);
        visit("body.drive_offset", self.drive_offset);
        visit("body.drive_rate", self.drive_rate);
        if (self.deforms()) {
            visit("body.stretch", self.stretch);
            visit("body.stretch_rate", self.stretch_rate);
        }
    }
};

/// omega = R J^-1 R^T L, world axes [rad/s]. Bodies without inertia (half-spaces) do not spin.
Vec3 angular_velocity(const BodySet& bodies, const BodyState& state, BodyId body);
/// L = R J R^T omega [kg m^2/s].
Vec3 angular_momentum_of(const BodySet& bodies, BodyId body, const Quat& orientation, const Vec3& angular_velocity);
/// True while forces decide: a free body, or a fixed or driven one past its release time.
bool is_free(const BodySet& bodies, BodyId body, double time);

/// One body as the scene reader adds it.
struct NewBody {
    std::string name;
    std::int32_t name_index{-1};
    MaterialId material;
    double density{0};  ///< [kg/m^3]
    Drive drive{Drive::free};
    Pose pose;                                                     ///< of the given shape frame(s)
    Vec3 velocity{};                                               ///< of the centre of mass [m/s]
    Vec3 angular_velocity{};                                       ///< world axes [rad/s]
    double release_time{std::numeric_limits<double>::infinity()};  ///< [s]
    std::int32_t motion{-1};
    std::vector<Part> parts;  ///< `body` ignored; `local` relative to `pose`
};

/// Where a driven body is and how it moves at a time, corrections aside.
DrivenState driven_state(const BodySet& bodies, BodyId body, double time);

/// Returns the number of looks at a driven body between 0 and `end` that find its extremes: 64 in the shortest period
/// of its motion, 2000 at least and 200 000 at most.
std::int64_t look_count(const BodySet& bodies, BodyId body, double end);

/// Gives back memory kept for growth. Worth calling once the scene is read.
void shrink_to_fit(BodySet& bodies, BodyState& state);

/// Drives a body by a motion that counts from `start`.
void drive(BodySet& bodies, BodyId body, std::int32_t motion, const Pose& start);

/// Adds a body: mass, centre of mass and principal axes from its parts, exact. The parts of one body must not
/// overlap (concave bodies are unions of touching parts); the State pose is that of the centre of mass.
BodyId add_body(BodySet& bodies, BodyState& state, const geometry::ShapeSet& shapes, const NewBody& body);

}  // namespace riprap::body

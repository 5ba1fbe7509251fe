// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/distance_potential.hpp"

#include "riprap/contact/narrowphase/overlap_energy.hpp"
#include "riprap/contact/narrowphase/separation.hpp"
#include "riprap/contact/narrowphase/surface_in_field.hpp"

namespace riprap::contact {

namespace {

using geometry::ConvexView;

/// Positions closer to a plane than this fraction of the pair's size lie in it.
constexpr double relative_tolerance = 1e-14;

/// Maps points of one body into the frame of another.
Frame relative_frame(const Frame& from, const Frame& to) {
    const Mat3 back = transpose(to.axes);
    return {back * (from.origin - to.origin), back * from.axes};
}

void remember(const Frame& frame_a, const Vec3& direction, SeparatingCache& cache) {
    const Vec3 d = transpose_times(frame_a.axes, direction);
    cache = {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
}

/// Keeps a direction for the next look at a pair that does not touch: the face that separates it, or any other.
void remember_gap(const ConvexView& a, const Frame& frame_a, const ConvexView& b, const Frame& frame_b,
                  const Vec3& face_direction, SeparatingCache& cache) {
    const Vec3 start = norm_squared(face_direction) > 0 ? face_direction : frame_b.origin - frame_a.origin;
    remember(frame_a, find_separating_direction(a, frame_a, b, frame_b, start), cache);
}

/// Workspaces of the two sides, one set per thread.
struct Workspaces {
    SurfaceWorkspace on_a, on_b;
};
Workspaces& workspaces() {
    static thread_local Workspaces spaces;
    return spaces;
}

}  // namespace

bool find_contact(const ConvexView& a, const Frame& frame_a, double stiffness_a, const ConvexView& b,
                  const Frame& frame_b, double stiffness_b, const DistancePotentialOptions& options,
                  SeparatingCache& cache, NormalContact& contact) {
    const bool a_is_solid = a.vertex_count > 0, b_is_solid = b.vertex_count > 0;
    if (!a_is_solid && !b_is_solid) {
        return false;
    }
    const bool are_solid = a_is_solid && b_is_solid;
    if (are_solid && is_surely_apart(a, frame_a, b, frame_b, cache)) {
        return false;
    }
    const double tolerance =
        relative_tolerance * ((a_is_solid ? a.circumradius : 0) + (b_is_solid ? b.circumradius : 0));
    // Moments are taken about the centre of the smaller body: short arms beside a large platform.
    const bool about_a = !b_is_solid || (a_is_solid && a.circumradius <= b.circumradius);
    const Frame a_in_b = relative_frame(frame_a, frame_b), b_in_a = relative_frame(frame_b, frame_a);
    Workspaces& work = workspaces();
    const SurfaceInField on_a{
        a, a_in_b, b, options.potential, about_a ? a_in_b.origin : Vec3{}, tolerance, options.with_energy, work.on_a};
    const SurfaceInField on_b{
        b, b_in_a, a, options.potential, about_a ? Vec3{} : b_in_a.origin, tolerance, options.with_energy, work.on_b};

    SurfaceIntegrals integrals_a{}, integrals_b{};
    const bool has_a = b_is_solid;
    const bool has_b = a_is_solid && (options.sides == Sides::both || !has_a);
    if (has_a) {
        const Separation gap = integrate_surface(on_a, integrals_a);
        if (gap.face >= 0) {
            if (are_solid) {
                remember_gap(a, frame_a, b, frame_b, -(frame_b.axes * b.normal(gap.face)), cache);
            }
            return false;
        }
    }
    if (has_b) {
        const Separation gap = integrate_surface(on_b, integrals_b);
        if (gap.face >= 0) {
            if (are_solid) {
                remember_gap(a, frame_a, b, frame_b, frame_a.axes * a.normal(gap.face), cache);
            }
            return false;
        }
    }
    if (!(integrals_a.sum + integrals_b.sum > 0)) {
        if (are_solid) {
            remember_gap(a, frame_a, b, frame_b, {}, cache);
        }
        return false;
    }
    if (options.with_energy) {
        integrals_a.volume_sum = has_a ? volume_sum(on_a, has_b ? &work.on_b.reaches : nullptr) : 0;
        integrals_b.volume_sum = has_b ? volume_sum(on_b, has_a ? &work.on_a.reaches : nullptr) : 0;
    }
    assemble_contact({integrals_a, stiffness_b, frame_b.axes}, {integrals_b, stiffness_a, frame_a.axes},
                     about_a ? frame_a.origin : frame_b.origin, has_a && has_b ? 2 : 1, contact);
    return true;
}

}  // namespace riprap::contact

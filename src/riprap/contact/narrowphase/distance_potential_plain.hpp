// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/contact/narrowphase/overlap_integrals.hpp"
#include "riprap/contact/narrowphase/polygon_plain.hpp"

/// The contact of two convex parts, written the way the theory page reads: every face is cut by every plane, every
/// piece by every other cell. No culling, no caches, no allocation; host and device. The oracle of the fast kernel.
namespace riprap::contact::plain {

using geometry::ConvexView;

/// Lengths below this fraction of the pair's size are round-off of positions.
inline constexpr double relative_tolerance = 1e-14;

/// w_j of face j: phi = min over faces j with a field of w_j h_j [1/m]; 0 where the face carries none.
RIPRAP_HD inline double weight(const ConvexView& view, int face, Potential potential) {
    if (view.vertex_count == 0 || view.is_internal[face] != 0) {
        return 0;
    }
    return potential == Potential::distance ? 1 / view.inscribed_radius : view.fdem_weight[face];
}

/// Maps points of the surface body into the frame of the field body: x_field = origin + axes * x_surface.
RIPRAP_HD inline Frame relative_frame(const Frame& surface, const Frame& field) {
    const Mat3 back = transpose(field.axes);
    return {back * (surface.origin - field.origin), back * surface.axes};
}

/// One surface body in the field of another, all in the frame of the field body.
template <int Capacity>
struct OneSide {
    using Loop = Polygon<Capacity>;

    const ConvexView& surface;
    const Frame& frame;  ///< of the surface body in the frame of the field body
    const ConvexView& field;
    Potential potential;
    Vec3 reference;    ///< point that moments are taken about
    double tolerance;  ///< [m]
    bool overflows{false};

    RIPRAP_HD Plane surface_plane(int face) const {
        const Vec3 n = frame.axes * surface.normal(face);
        return {n, surface.offset[face] + dot(n, frame.origin)};
    }
    RIPRAP_HD Plane field_plane(int face) const { return {field.normal(face), field.offset[face]}; }
    /// w_j h_j as the gap of a plane.
    RIPRAP_HD Plane potential_of(int face) const {
        const double w = weight(field, face, potential);
        return {w * field.normal(face), w * field.offset[face]};
    }
    RIPRAP_HD bool has_cell(int face) const { return weight(field, face, potential) > 0; }

    /// A ball that holds the overlap.
    RIPRAP_HD double ball_radius() const {
        return field.vertex_count == 0 || (surface.vertex_count > 0 && surface.circumradius < field.circumradius)
                   ? surface.circumradius
                   : field.circumradius;
    }
    RIPRAP_HD Vec3 ball_centre() const {
        return field.vertex_count == 0 || (surface.vertex_count > 0 && surface.circumradius < field.circumradius)
                   ? frame.origin
                   : Vec3{};
    }
    RIPRAP_HD Loop face_polygon(int face) const {
        if (surface.vertex_count == 0) {
            return square_in<Capacity>(surface_plane(face), ball_centre(), 1.01 * ball_radius());
        }
        Loop polygon;
        for (int i = surface.face_start[face]; i < surface.face_start[face + 1]; ++i) {
            polygon.push(frame.origin + frame.axes * surface.vertex(surface.face_vertex[i]));
        }
        return polygon;
    }

    /// Cuts a polygon in a face of the surface body, or in any plane, to the field body. A surface face that lies in
    /// a face plane of the field body counts as inside when both bodies are on the same side of it.
    /// @returns 1, or 1/2 for such a face: the patch belongs to the surfaces of both bodies; 0 when nothing is left.
    RIPRAP_HD double cut_to_field(Loop& polygon, const Vec3& normal) {
        double share = 1;
        for (int j = 0; j < field.face_count; ++j) {
            const Cut cut = clip(polygon, field_plane(j), tolerance);
            if (cut == Cut::coplanar) {
                if (dot(normal, field.normal(j)) < 0) {
                    return 0;
                }
                share = 0.5;
            }
            if (cut == Cut::empty) {
                return 0;
            }
        }
        overflows = overflows || polygon.overflows;
        return share;
    }

    /// Cuts a polygon to the cell of face j, { x : w_l h_l >= w_j h_j for all l }. A polygon that lies in the boundary
    /// of two cells goes to the cell on the side of -inner_normal, where the overlap is.
    RIPRAP_HD bool cut_to_cell(Loop& polygon, int j, int except, const Vec3& inner_normal) {
        const Plane own = potential_of(j);
        const double steepness = norm(own.gradient);
        for (int l = 0; l < field.face_count; ++l) {
            if (l == j || l == except || !has_cell(l)) {
                continue;
            }
            const Plane other = potential_of(l);
            const Plane wall{other.gradient - own.gradient, other.offset - own.offset};
            const Cut cut = clip(polygon, wall, tolerance * (steepness + norm(other.gradient)));
            if (cut == Cut::empty) {
                return false;
            }
            if (cut == Cut::coplanar) {
                const double side = dot(wall.gradient, inner_normal);
                if (side < 0 || (side == 0 && l < j)) {
                    return false;
                }
            }
        }
        overflows = overflows || polygon.overflows;
        return true;
    }

    /// Integrals over the faces of the surface body; also, per cell, 4 times the integral of phi over the volume as
    /// far as the faces contribute (see volume_sum).
    RIPRAP_HD SurfaceIntegrals integrate_faces() {
        SurfaceIntegrals total;
        for (int f = 0; f < surface.face_count; ++f) {
            const Plane plane = surface_plane(f);
            Loop patch = face_polygon(f);
            const double share = cut_to_field(patch, plane.gradient);
            if (share == 0) {
                continue;
            }
            total.area += (share * integrate(patch, plane.gradient, plane, reference).area) * plane.gradient;
            for (int j = 0; j < field.face_count; ++j) {
                Loop piece = patch;
                if (!has_cell(j) || !cut_to_cell(piece, j, -1, plane.gradient)) {
                    continue;
                }
                add_piece(total, piece, plane, j, surface.is_internal[f] != 0);
            }
        }
        return total;
    }

    RIPRAP_HD void add_piece(SurfaceIntegrals& total, const Loop& piece, const Plane& face, int j,
                             bool is_internal) const {
        const Plane phi = potential_of(j);
        const LinearIntegral part = integrate(piece, face.gradient, phi, reference);
        total.volume_sum += 0.25 * part.sum * face.gap(apex(j));
        if (is_internal) {
            return;  // bounds the part, but the neighbouring part has the same face with the opposite normal
        }
        const double w = weight(field, j, potential);
        total.force += part.sum * face.gradient;
        total.moment += cross(part.first, face.gradient);
        total.first += part.first;
        total.sum += part.sum;
        total.weighted += w * part.sum;
        total.potential = part.largest > total.potential ? part.largest : total.potential;
        total.depth = part.largest / w > total.depth ? part.largest / w : total.depth;
    }

    /// Any point with w_j h_j = 0; here the foot of the reference point.
    RIPRAP_HD Vec3 apex(int j) const {
        const Plane plane = field_plane(j);
        return reference + plane.gap(reference) * plane.gradient;
    }

    /// Integral of phi over the overlap. In the cell of face j, phi is linear and vanishes at the apex c_j, so that
    /// div(phi (x - c_j)) = 4 phi: each cell's share is 1/4 of the sum over its bounding polygons of the distance of
    /// c_j below the polygon's plane times the integral of phi over the polygon. The polygons are: pieces of surface
    /// faces (added above), walls to other cells, and internal faces of the field body. Its other faces have phi = 0.
    RIPRAP_HD double volume_sum_of_walls() {
        double total = 0;
        for (int j = 0; j < field.face_count; ++j) {
            if (!has_cell(j)) {
                continue;
            }
            const Plane phi = potential_of(j);
            for (int l = 0; l < field.face_count; ++l) {
                if (l == j) {
                    continue;
                }
                const Plane other = has_cell(l) ? potential_of(l) : field_plane(l);
                const Plane wall =
                    has_cell(l) ? Plane{other.gradient - phi.gradient, other.offset - phi.offset} : other;
                const double steepness = norm(wall.gradient);
                if (steepness == 0) {
                    continue;
                }
                Loop polygon = square_in<Capacity>(wall, ball_centre(), 1.01 * ball_radius());
                const Vec3 normal = wall.gradient / steepness;
                if (cut_to_surface(polygon) && cut_to_field_except(polygon, l) && cut_to_cell(polygon, j, l, normal)) {
                    const double share = integrate(polygon, normal, phi, reference).sum;
                    total += 0.25 * share * wall.gap(apex(j)) / steepness;
                }
            }
        }
        return total;
    }

    /// Cuts to the open interior of the surface body: its faces have had their share already.
    RIPRAP_HD bool cut_to_surface(Loop& polygon) {
        for (int f = 0; f < surface.face_count; ++f) {
            if (clip(polygon, surface_plane(f), tolerance) != Cut::inside) {
                return false;
            }
        }
        return true;
    }
    RIPRAP_HD bool cut_to_field_except(Loop& polygon, int face) {
        for (int l = 0; l < field.face_count; ++l) {
            if (l != face && clip(polygon, field_plane(l), tolerance) == Cut::empty) {
                return false;
            }
        }
        return true;
    }
};

enum class Outcome { apart, touching, overflow };

/// As contact::find_contact without the cache; `Capacity` bounds the corners of any polygon met on the way.
template <int Capacity>
RIPRAP_HD Outcome find_contact(const ConvexView& a, const Frame& frame_a, double stiffness_a, const ConvexView& b,
                               const Frame& frame_b, double stiffness_b, const DistancePotentialOptions& options,
                               NormalContact& contact) {
    if (a.vertex_count == 0 && b.vertex_count == 0) {
        return Outcome::apart;
    }
    const double size = (a.vertex_count > 0 ? a.circumradius : 0) + (b.vertex_count > 0 ? b.circumradius : 0);
    // Moments are taken about the centre of the smaller body: short arms beside a large platform.
    const bool about_a = b.vertex_count == 0 || (a.vertex_count > 0 && a.circumradius <= b.circumradius);
    const Vec3 reference = about_a ? frame_a.origin : frame_b.origin;
    const Frame a_in_b = relative_frame(frame_a, frame_b), b_in_a = relative_frame(frame_b, frame_a);
    OneSide<Capacity> on_a{
        a, a_in_b, b, options.potential, about_a ? a_in_b.origin : Vec3{}, relative_tolerance * size};
    OneSide<Capacity> on_b{
        b, b_in_a, a, options.potential, about_a ? Vec3{} : b_in_a.origin, relative_tolerance * size};

    SurfaceIntegrals integrals_a{}, integrals_b{};
    const bool has_a = b.vertex_count > 0;
    const bool has_b = a.vertex_count > 0 && (options.sides == Sides::both || !has_a);
    if (has_a) {
        integrals_a = on_a.integrate_faces();
        integrals_a.volume_sum += options.with_energy ? on_a.volume_sum_of_walls() : 0.0;
    }
    if (has_b) {
        integrals_b = on_b.integrate_faces();
        integrals_b.volume_sum += options.with_energy ? on_b.volume_sum_of_walls() : 0.0;
    }
    if (on_a.overflows || on_b.overflows) {
        return Outcome::overflow;
    }
    if (!(integrals_a.sum + integrals_b.sum > 0)) {
        return Outcome::apart;
    }
    assemble_contact({integrals_a, stiffness_b, frame_b.axes}, {integrals_b, stiffness_a, frame_a.axes}, reference,
                     has_a && has_b ? 2 : 1, contact);
    if (!options.with_energy) {
        contact.energy = 0;
    }
    return Outcome::touching;
}

}  // namespace riprap::contact::plain

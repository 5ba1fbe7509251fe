// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/overlap_energy.hpp"

#include <cmath>

#include "riprap/contact/narrowphase/polygon_plain.hpp"
#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {

using plain::Cut, plain::Plane;

/// phi at an apex below this counts as zero: the cells meet in a corner of the field body, to round-off.
constexpr double shared_corner = 1e-13;
/// Corners of a wall polygon: hardly ever more than a few; no shape of this program needs more than the large room.
constexpr int usual_capacity = 32, large_capacity = 4096;

struct Cell {
    std::int32_t face;
    Plane phi;  ///< w_j h_j, with x from the reference point
    Vec3 apex;
    bool has_apex;
};

/// Lists that stay between calls, so that no call allocates.
struct Scratch {
    std::vector<Cell> cells;
    std::vector<Plane> surface, internal;
    std::vector<std::int32_t> corner_uses;
};

class Walls {
 public:
    Walls(const SurfaceInField& side, Scratch& scratch) : side_(side), cells_(scratch.cells), scratch_(scratch) {}

    double sum(const std::vector<std::uint8_t>* field_reaches) {
        list_cells(field_reaches);
        choose_apexes();
        list_planes();
        double total = 0;
        for (const Cell& cell : cells_) {
            const CellSum& pieces = side_.work.cells[at(cell.face)];
            total += pieces.offset - dot(pieces.normal, cell.apex);
        }
        for (std::size_t j = 0; j < cells_.size(); ++j) {
            for (std::size_t l = j + 1; l < cells_.size(); ++l) {
                total += wall_between(cells_[j], cells_[l]);
            }
            for (const Plane& plane : scratch_.internal) {
                const double distance = plane.gap(cells_[j].apex);
                if (std::abs(distance) > side_.tolerance) {
                    total += distance * integral_in(plane, cells_[j], nullptr);
                }
            }
        }
        return 0.25 * total;
    }

 private:
    double weight(std::int32_t face) const {
        return side_.potential == Potential::distance ? 1 / side_.field.inscribed_radius
                                                      : side_.field.fdem_weight[face];
    }
    Plane from_reference(const Vec3& gradient, double offset) const {
        return {gradient, offset - dot(gradient, side_.reference)};
    }
    /// A cell that the overlap reaches is met by the surface, or its face reaches into the surface body.
    void list_cells(const std::vector<std::uint8_t>* field_reaches) {
        const geometry::ConvexView& field = side_.field;
        cells_.clear();
        for (std::int32_t j = 0; j < field.face_count; ++j) {
            const bool may_reach = field_reaches == nullptr || (*field_reaches)[at(j)] != 0;
            if (field.is_internal[j] == 0 && (may_reach || side_.work.is_met[at(j)] != 0)) {
                const double w = weight(j);
                cells_.push_back({j, from_reference(w * field.normal(j), w * field.offset[j]), {}, false});
            }
        }
    }

    /// Cells take the corner of the field body that most cells without an apex yet can share.
    void choose_apexes() {
        const geometry::ConvexView& field = side_.field;
        std::vector<std::int32_t>& uses = scratch_.corner_uses;
        for (std::size_t left = cells_.size(); left > 0;) {
            uses.assign(at(field.vertex_count), 0);
            std::int32_t best = 0;
            for (const Cell& cell : cells_) {
                for (std::int32_t i = field.face_start[cell.face];
                     !cell.has_apex && i < field.face_start[cell.face + 1]; ++i) {
                    const std::int32_t v = field.face_vertex[i];
                    ++uses[at(v)];
                    best = uses[at(v)] > uses[at(best)] || (uses[at(v)] == uses[at(best)] && v < best) ? v : best;
                }
            }
            for (Cell& cell : cells_) {
                for (std::int32_t i = field.face_start[cell.face];
                     !cell.has_apex && i < field.face_start[cell.face + 1]; ++i) {
                    if (field.face_vertex[i] == best) {
                        const Vec3 corner = field.vertex(best) - side_.reference;
                        cell.apex =
                            corner + (cell.phi.gap(corner) / norm_squared(cell.phi.gradient)) * cell.phi.gradient;
                        cell.has_apex = true;
                        --left;
                    }
                }
            }
        }
    }

    void list_planes() {
        scratch_.surface.clear();
        for (std::int32_t f = 0; f < side_.surface.face_count; ++f) {
            const Vec3 n = side_.frame.axes * side_.surface.normal(f);
            scratch_.surface.push_back(from_reference(n, side_.surface.offset[f] + dot(n, side_.frame.origin)));
        }
        scratch_.internal.clear();
        for (std::int32_t j = 0; j < side_.field.face_count; ++j) {
            if (side_.field.is_internal[j] != 0) {
                scratch_.internal.push_back(from_reference(side_.field.normal(j), side_.field.offset[j]));
            }
        }
        const bool by_surface = side_.surface.vertex_count > 0 && side_.surface.circumradius < side_.field.circumradius;
        centre_ = (by_surface ? side_.frame.origin : Vec3{}) - side_.reference;
        radius_ = 1.01 * (by_surface ? side_.surface.circumradius : side_.field.circumradius);
    }

    double wall_between(const Cell& j, const Cell& l) const {
        const double mismatch = l.phi.gap(j.apex) + j.phi.gap(l.apex);
        const Plane wall{l.phi.gradient - j.phi.gradient, l.phi.offset - j.phi.offset};
        const double steepness = norm(wall.gradient);
        if (steepness == 0 || std::abs(mismatch) < shared_corner) {
            return 0;
        }
        return mismatch / steepness * integral_in(wall, j, &l);
    }

    double integral_in(const Plane& plane, const Cell& j, const Cell* l) const {
        auto usual = plain::square_in<usual_capacity>(plane, centre_, radius_);
        const double sum = cut_and_integrate(usual, plane, j, l);
        if (!usual.overflows) {
            return sum;
        }
        auto large = plain::square_in<large_capacity>(plane, centre_, radius_);
        return cut_and_integrate(large, plane, j, l);
    }

    /// Integral of phi_j over the part of a square in a plane in the overlap where j (and l) have the least w h.
    template <int Capacity>
    double cut_and_integrate(plain::Polygon<Capacity>& polygon, const Plane& plane, const Cell& j,
                             const Cell* l) const {
        const Vec3 normal = normalized(plane.gradient);
        const double steepness = norm(j.phi.gradient);
        if (plain::clip(polygon, j.phi, side_.tolerance * steepness) != Cut::inside) {
            return 0;
        }
        for (const Cell& k : cells_) {
            if (&k == &j || &k == l) {
                continue;
            }
            const Plane other{k.phi.gradient - j.phi.gradient, k.phi.offset - j.phi.offset};
            const Cut cut = plain::clip(polygon, other, side_.tolerance * (steepness + norm(k.phi.gradient)));
            if (cut == Cut::empty || (cut == Cut::coplanar && dot(other.gradient, normal) < 0)) {
                return 0;
            }
        }
        for (const Plane& face : scratch_.surface) {
            if (plain::clip(polygon, face, side_.tolerance) != Cut::inside) {
                return 0;
            }
        }
        for (const Plane& face : scratch_.internal) {
            if (&face != &plane && plain::clip(polygon, face, side_.tolerance) == Cut::empty) {
                return 0;
            }
        }
        return plain::integrate(polygon, normal, j.phi, Vec3{}).sum;
    }

    const SurfaceInField& side_;
    std::vector<Cell>& cells_;
    Scratch& scratch_;
    Vec3 centre_{};
    double radius_{0};
};

}  // namespace

double volume_sum(const SurfaceInField& side, const std::vector<std::uint8_t>* field_reaches) {
    static thread_local Scratch scratch;
    return Walls(side, scratch).sum(field_reaches);
}

}  // namespace riprap::contact

// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/surface_in_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/contact/narrowphase/corner_table.hpp"
#include "riprap/contact/narrowphase/polygon_plain.hpp"

namespace riprap::contact {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Index = std::int32_t;

using Loop = CornerLoop;

template <int Groups>
class SurfacePass {
 public:
    SurfacePass(const SurfaceInField& side, SurfaceIntegrals& total)
        : side_(side), field_(side.field), total_(total), corners_(side) {}

    Separation run() {
        reserve();
        place_corners();
        const Separation separation = find_separation();
        if (separation.face < 0) {
            for (Index f = 0; f < side_.surface.face_count; ++f) {
                visit_face(f);
            }
        }
        return separation;
    }

 private:
    void reserve() {
        const Index faces = field_.face_count, groups = corners_.groups();
        SurfaceWorkspace& work = side_.work;
        if (work.fields.size() < at(2 * groups)) {
            work.fields.resize(at(2 * groups));
        }
        if (work.kept.size() < at(faces)) {
            work.kept.resize(at(faces));
        }
        if (side_.with_energy) {
            work.cells.assign(at(faces), {});
            work.is_met.assign(at(faces), 0);
            work.reaches.assign(at(side_.surface.face_count), 0);
        }
        fields_ = work.fields.data();
        lows_ = fields_ + groups;
        for (Index g = 0; g < groups; ++g) {
            fields_[g] = Lanes(-infinity);
        }
        field_count_ = faces;
        for (Index j = 0; j < faces; ++j) {
            if (field_.is_internal[j] != 0) {
                reinterpret_cast<double*>(fields_)[j] = infinity;
                --field_count_;
            }
        }
        for (Index j = faces; j < 8 * groups && faces > 0 && field_.is_internal[faces - 1] != 0; ++j) {
            reinterpret_cast<double*>(fields_)[j] = infinity;
        }
    }

    void place_corners() {
        const geometry::ConvexView& s = side_.surface;
        if (s.vertex_count == 0) {
            const Vec3 n = side_.frame.axes * s.normal(0);
            const plain::Plane plane{n, s.offset[0] + dot(n, side_.frame.origin)};
            const auto square = plain::square_in<4>(plane, {}, 1.01 * field_.circumradius);
            for (Index i = 0; i < 4; ++i) {
                corners_.place(i, square.x[i]);
            }
            return;
        }
        for (Index i = 0; i < s.vertex_count; ++i) {
            corners_.place(i, side_.frame.origin + side_.frame.axes * s.vertex(i));
        }
    }

    Separation find_separation() const {
        for (Index g = 0; g < corners_.groups(); ++g) {
            Lanes top = corners_.row(0)[g];
            for (Index i = 1; i < corners_.corner_count(); ++i) {
                top = max(top, corners_.row(i)[g]);
            }
            if (const unsigned outside = bits_not_above(top, Lanes(0)); outside != 0) {
                return {8 * g + __builtin_ctz(outside)};
            }
        }
        return {};
    }

    void visit_face(Index f) {
        const geometry::ConvexView& s = side_.surface;
        static constexpr Index square[4] = {0, 1, 2, 3};
        Loop patch{square, 4};
        if (s.vertex_count > 0) {
            patch = {s.face_vertex + s.face_start[f], s.face_start[f + 1] - s.face_start[f]};
        }
        corners_.forget_rows(corners_.corner_count());
        double share = 1;
        if (!cut_to_field(f, patch, share)) {
            return;
        }
        if (side_.with_energy) {
            side_.work.reaches[at(f)] = 1;
        }
        normal_ = side_.frame.axes * s.normal(f);
        is_internal_ = s.is_internal[f] != 0;
        patch_area_ = 0;
        patch_sum_ = 0;
        patch_first_ = Arm(0);
        choose_plane();
        offset_ = dot(normal_, corners_.position(patch.corner[0]));
        const Index kept = keep_cells(patch);
        if (kept == 0) {
            total_.area += (share * area_of(patch)) * normal_;
            return;
        }
        for (Index c = 0; c < kept; ++c) {
            const Index j = side_.work.kept[at(c)];
            Loop piece = patch;
            const Index rows = corners_.row_count();
            if (kept == 1 || cut_to_cell(j, kept, piece)) {
                integrate(piece, j);
            }
            corners_.forget_rows(rows);
        }
        total_.area += (share * patch_area_) * normal_;
        if (!is_internal_) {
            const Vec3 first{patch_first_[0], patch_first_[1], patch_first_[2]};
            total_.force += patch_sum_ * normal_;
            total_.moment += cross(first, normal_);
            total_.first += first;
            total_.sum += patch_sum_;
        }
    }

    /// Cuts a face to the field body by the planes that cross it. False when nothing is left.
    bool cut_to_field(Index f, Loop& patch, double& share) {
        corners_.use_bank(0);
        for (Index g = 0; g < corners_.groups(); ++g) {
            Lanes low = corners_.row(patch.corner[0])[g], high = low;
            for (Index i = 1; i < patch.size; ++i) {
                low = min(low, corners_.row(patch.corner[i])[g]);
                high = max(high, corners_.row(patch.corner[i])[g]);
            }
            unsigned flat = bits_not_above(high, Lanes(0));
            if (flat != 0) {
                if (8 * g + 8 > field_.face_count) {
                    flat &= (1U << (field_.face_count - 8 * g)) - 1U;
                }
                if ((flat & bits_below(low, Lanes(0))) != 0) {
                    return false;
                }
                // The whole polygon lies in face planes of the field body.
                const Vec3 n = side_.frame.axes * side_.surface.normal(f);
                bool is_outside = false;
                for_each_bit(flat,
                             [&](int lane) { is_outside = is_outside || dot(n, field_.normal(8 * g + lane)) < 0; });
                if (is_outside) {
                    return false;
                }
                share = 0.5;
            }
            unsigned crossing = bits_below(low, Lanes(0));
            if (8 * g + 8 > field_.face_count) {
                crossing &= (1U << (field_.face_count - 8 * g)) - 1U;
            }
            for (; crossing != 0; crossing &= crossing - 1) {
                const Index j = 8 * g + __builtin_ctz(crossing);
                const auto where = corners_.gather(patch, [&](Index i) { return corners_.value(i, j); });
                if (!where.inside || (where.outside && !corners_.cut(patch, j))) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Cuts a patch to the cell of face j. A patch in the wall between two cells goes to the one on its inner side.
    bool cut_to_cell(Index j, Index kept, Loop& piece) {
        corners_.use_bank(1);  // the patch itself must outlive its pieces
        for (Index c = 0; c < kept; ++c) {
            const Index l = side_.work.kept[at(c)];
            if (l == j) {
                continue;
            }
            const double wl = corners_.weight(l), wj = corners_.weight(j), slack = side_.tolerance * (wl + wj);
            const auto where = corners_.gather(piece, [&](Index i) {
                const double s = corners_.value(i, l) - corners_.value(i, j);
                return std::abs(s) > slack ? s : 0.0;
            });
            if (where.inside && where.outside) {
                if (!corners_.cut(piece, -1)) {
                    return false;
                }
            } else if (where.outside) {
                return false;
            } else if (!where.inside) {
                const double lean = dot(wl * field_.normal(l) - wj * field_.normal(j), normal_);
                if (lean < 0 || (lean == 0 && l < j)) {
                    return false;
                }
            }
        }
        return true;
    }

    /// The cells that can hold the least w_j h_j anywhere on the patch. None where phi vanishes all over it.
    Index keep_cells(const Loop& patch) {
        if (field_count_ == 0) {
            return 0;
        }
        double ceiling = infinity;
        for (Index g = 0; g < corners_.groups(); ++g) {
            Lanes low = corners_.row(patch.corner[0])[g], high = low;
            for (Index i = 1; i < patch.size; ++i) {
                low = min(low, corners_.row(patch.corner[i])[g]);
                high = max(high, corners_.row(patch.corner[i])[g]);
            }
            lows_[g] = max(low, fields_[g]);
            ceiling = std::min(ceiling, least(max(high, fields_[g])));
        }
        if (ceiling <= 0) {
            return 0;
        }
        Index kept = 0;
        for (Index g = 0; g < corners_.groups(); ++g) {
            for_each_bit(bits_not_above(lows_[g], Lanes(ceiling)), [&](int lane) {
                if (8 * g + lane < field_.face_count) {
                    side_.work.kept[at(kept++)] = 8 * g + lane;
                }
            });
        }
        return kept;
    }

    double area_of(const Loop& loop) const {
        const Vec3 x0 = corners_.position(loop.corner[0]);
        Vec3 before = corners_.position(loop.corner[1]) - x0, sum{};
        for (Index i = 2; i < loop.size; ++i) {
            const Vec3 here = corners_.position(loop.corner[i]) - x0;
            sum += cross(before, here);
            before = here;
        }
        return 0.5 * dot(normal_, sum);
    }

    /// See plain::integrate for the formulas; areas are taken in the coordinate plane that the face is steepest on.
    void integrate(const Loop& loop, Index j) {
        const Arm x0 = corners_.arm(loop.corner[0]);
        Arm x1 = corners_.arm(loop.corner[1]);
        const double p0 = corners_.value(loop.corner[0], j);
        double p1 = corners_.value(loop.corner[1], j);
        const double u0 = corners_.coordinate(loop.corner[0], axis_u_),
                     v0 = corners_.coordinate(loop.corner[0], axis_v_);
        double u1 = corners_.coordinate(loop.corner[1], axis_u_) - u0,
               v1 = corners_.coordinate(loop.corner[1], axis_v_) - v0;
        double largest = std::max(p0, p1), shadow = 0, six_sum = 0;
        Arm first(0);
        for (Index i = 2; i < loop.size; ++i) {
            const Index corner = loop.corner[i];
            const Arm x2 = corners_.arm(corner);
            const double p2 = corners_.value(corner, j), u2 = corners_.coordinate(corner, axis_u_) - u0,
                         v2 = corners_.coordinate(corner, axis_v_) - v0;
            const double twice = u1 * v2 - u2 * v1;
            const double sum = p0 + p1 + p2;
            shadow += twice;
            six_sum += twice * sum;
            first += twice * ((sum + p0) * x0 + (sum + p1) * x1 + (sum + p2) * x2);
            largest = std::max(largest, p2);
            x1 = x2;
            p1 = p2;
            u1 = u2;
            v1 = v2;
        }
        const double sum = six_sum * stretch_ * (1.0 / 6);
        patch_area_ += 0.5 * stretch_ * shadow;
        patch_sum_ += sum;
        patch_first_ += (stretch_ * (1.0 / 24)) * first;
        if (!is_internal_) {
            const double w = corners_.weight(j);
            total_.weighted += w * sum;
            total_.potential = std::max(total_.potential, largest);
            total_.depth = std::max(total_.depth, largest / w);
        }
        if (side_.with_energy) {
            side_.work.cells[at(j)].offset += offset_ * sum;
            side_.work.cells[at(j)].normal += sum * normal_;
            side_.work.is_met[at(j)] = 1;
        }
    }

    /// Chooses the coordinate plane onto which the face casts its largest shadow, and area / shadow.
    void choose_plane() {
        const Vec3 size{std::abs(normal_.x), std::abs(normal_.y), std::abs(normal_.z)};
        const Index axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        axis_u_ = axis == 2 ? 0 : axis + 1;
        axis_v_ = axis == 0 ? 2 : axis - 1;
        stretch_ = 1 / normal_[axis];
    }

    const SurfaceInField& side_;
    const geometry::ConvexView& field_;
    SurfaceIntegrals& total_;
    CornerTable<Groups> corners_;
    Index field_count_{0};
    Lanes *fields_{nullptr}, *lows_{nullptr};
    bool is_internal_{false};
    Vec3 normal_{};
    Arm patch_first_{};
    Index axis_u_{0}, axis_v_{1};
    double stretch_{1}, offset_{0}, patch_area_{0}, patch_sum_{0};
};

}  // namespace

Separation integrate_surface(const SurfaceInField& side, SurfaceIntegrals& total) {
    return side.field.face_count <= 8 ? SurfacePass<1>(side, total).run() : SurfacePass<0>(side, total).run();
}

}  // namespace riprap::contact

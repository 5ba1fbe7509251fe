// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/surface_in_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "riprap/contact/narrowphase/polygon_plain.hpp"

namespace riprap::contact {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Index = std::int32_t;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

struct Loop {
    const Index* corner;
    Index size;
};

/// Groups: number of vectors of eight faces, or 0 when known at run time only.
template <int Groups>
class SurfacePass {
 public:
    SurfacePass(const SurfaceInField& side, SurfaceIntegrals& total)
        : side_(side), field_(side.field), total_(total), groups_count_((side.field.face_count + 7) / 8) {}

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
    Index groups() const { return Groups > 0 ? Groups : groups_count_; }
    Index stride() const { return groups() + 1; }
    Lanes* row(Index i) const { return rows_ + std::ptrdiff_t{i} * stride(); }
    double value(Index i, Index face) const { return reinterpret_cast<const double*>(row(i))[face]; }
    Vec3 position(Index i) const {
        const auto* x = reinterpret_cast<const double*>(row(i) + groups());
        return {x[0], x[1], x[2]};
    }

    void reserve() {
        const bool is_plane = side_.surface.vertex_count == 0;
        corner_count_ = is_plane ? 4 : side_.surface.vertex_count;
        const Index faces = field_.face_count;
        const Index row_count = corner_count_ + 4 * faces + 8;
        SurfaceWorkspace& work = side_.work;
        if (const auto need = at(row_count * stride() + 3 * groups()); work.rows.size() < need) {
            work.rows.resize(need);
        }
        loop_room_ = corner_count_ + 2 * faces + 8;
        if (work.loops.size() < at(4 * loop_room_)) {
            work.loops.resize(at(4 * loop_room_));
        }
        if (work.kept.size() < at(faces)) {
            work.kept.resize(at(faces));
        }
        if (side_.with_energy) {
            work.cells.assign(at(faces), {});
            work.is_met.assign(at(faces), 0);
            work.reaches.assign(at(side_.surface.face_count), 0);
        }
        if (work.gaps.size() < at(loop_room_)) {
            work.gaps.resize(at(loop_room_));
        }
        gaps_ = work.gaps.data();
        rows_ = work.rows.data();
        weights_ = rows_ + std::ptrdiff_t{row_count} * stride();
        fields_ = weights_ + groups();
        lows_ = fields_ + groups();
        for (Index g = 0; g < groups(); ++g) {
            weights_[g] = side_.potential == Potential::distance ? broadcast(1 / field_.inscribed_radius)
                                                                 : load(field_.fdem_weight + std::ptrdiff_t{8} * g);
            fields_[g] = broadcast(-infinity);
        }
        field_count_ = faces;
        for (Index j = 0; j < faces; ++j) {
            if (field_.is_internal[j] != 0) {
                reinterpret_cast<double*>(fields_)[j] = infinity;
                --field_count_;
            }
        }
        for (Index j = faces; j < 8 * groups() && faces > 0 && field_.is_internal[faces - 1] != 0; ++j) {
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
                place(i, square.x[i]);
            }
            return;
        }
        for (Index i = 0; i < s.vertex_count; ++i) {
            place(i, side_.frame.origin + side_.frame.axes * s.vertex(i));
        }
    }

    void place(Index i, const Vec3& x) {
        Lanes* r = row(i);
        for (Index g = 0; g < groups(); ++g) {
            const Lanes h = load(field_.offset + std::ptrdiff_t{8} * g) -
                            load(field_.normal_x + std::ptrdiff_t{8} * g) * x.x -
                            load(field_.normal_y + std::ptrdiff_t{8} * g) * x.y -
                            load(field_.normal_z + std::ptrdiff_t{8} * g) * x.z;
            r[g] = weights_[g] * snap(h, broadcast(side_.tolerance));
        }
        const Vec3 arm = x - side_.reference;
        r[groups()] = Lanes{arm.x, arm.y, arm.z, 0, 0, 0, 0, 0};
    }

    Separation find_separation() const {
        for (Index g = 0; g < groups(); ++g) {
            Lanes top = row(0)[g];
            for (Index i = 1; i < corner_count_; ++i) {
                top = max(top, row(i)[g]);
            }
            if (const unsigned outside = bits_not_above(top, broadcast(0)); outside != 0) {
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
        row_count_ = corner_count_;
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
        patch_first_ = broadcast(0);
        choose_plane();
        offset_ = dot(normal_, position(patch.corner[0]));
        const Index kept = keep_cells(patch);
        if (kept == 0) {
            total_.area += (share * area_of(patch)) * normal_;
            return;
        }
        for (Index c = 0; c < kept; ++c) {
            const Index j = side_.work.kept[at(c)];
            Loop piece = patch;
            const Index rows = row_count_;
            if (kept == 1 || cut_to_cell(j, kept, piece)) {
                integrate(piece, j);
            }
            row_count_ = rows;
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
        loop_bank_ = 0;
        for (Index g = 0; g < groups(); ++g) {
            Lanes low = row(patch.corner[0])[g], high = low;
            for (Index i = 1; i < patch.size; ++i) {
                low = min(low, row(patch.corner[i])[g]);
                high = max(high, row(patch.corner[i])[g]);
            }
            unsigned flat = bits_not_above(high, broadcast(0));
            if (flat != 0) {
                if (8 * g + 8 > field_.face_count) {
                    flat &= (1U << (field_.face_count - 8 * g)) - 1U;
                }
                if ((flat & bits_below(low, broadcast(0))) != 0) {
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
            unsigned crossing = bits_below(low, broadcast(0));
            if (8 * g + 8 > field_.face_count) {
                crossing &= (1U << (field_.face_count - 8 * g)) - 1U;
            }
            for (; crossing != 0; crossing &= crossing - 1) {
                const Index j = 8 * g + __builtin_ctz(crossing);
                const Where where = gather(patch, [&](Index i) { return value(i, j); });
                if (!where.inside || (where.outside && !cut(patch, j))) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Cuts a patch to the cell of face j. A patch in the wall between two cells goes to the one on its inner side.
    bool cut_to_cell(Index j, Index kept, Loop& piece) {
        loop_bank_ = 2;  // the patch itself must outlive its pieces
        for (Index c = 0; c < kept; ++c) {
            const Index l = side_.work.kept[at(c)];
            if (l == j) {
                continue;
            }
            const double wl = weight(l), wj = weight(j), slack = side_.tolerance * (wl + wj);
            const Where where = gather(piece, [&](Index i) {
                const double s = value(i, l) - value(i, j);
                return std::abs(s) > slack ? s : 0.0;
            });
            if (where.inside && where.outside) {
                if (!cut(piece, -1)) {
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

    struct Where {
        bool inside, outside;
    };

    /// Fills gaps_ with the signed distances of a loop's corners from a plane.
    template <class Gap>
    Where gather(const Loop& loop, const Gap& gap) {
        bool inside = false, outside = false;
        for (Index i = 0; i < loop.size; ++i) {
            const double s = gap(loop.corner[i]);
            gaps_[i] = s;
            inside |= s > 0;
            outside |= s < 0;
        }
        return {inside, outside};
    }

    /// Cuts a loop to gap >= 0 after gather(); new corners become new rows. `face` >= 0: the plane is that face's,
    /// where new corners lie exactly. False when nothing is left.
    bool cut(Loop& loop, Index face) {
        Index* out = side_.work.loops.data() + std::ptrdiff_t{loop_bank_ + (loop_turn_ ^= 1)} * loop_room_;
        Index count = 0;
        Index before = loop.corner[loop.size - 1];
        double s_before = gaps_[loop.size - 1];
        for (Index i = 0; i < loop.size; ++i) {
            const Index here = loop.corner[i];
            const double s = gaps_[i];
            if (s * s_before < 0) {
                out[count++] = interpolate(before, here, s_before / (s_before - s), face);
            }
            out[count] = here;
            count += s >= 0 ? 1 : 0;
            before = here;
            s_before = s;
        }
        loop = {out, count};
        return count > 2;
    }

    Index interpolate(Index i, Index k, double t, Index face) {
        constexpr Lanes lane_number{0, 1, 2, 3, 4, 5, 6, 7};
        const Index made = row_count_++;
        const Lanes *a = row(i), *b = row(k);
        Lanes* r = row(made);
        for (Index g = 0; g < groups(); ++g) {
            const Lanes p = snap(a[g] + t * (b[g] - a[g]), side_.tolerance * weights_[g]);
            // Whole vectors only: a scalar store here would hold up the next vector load.
            r[g] = lane_number == broadcast(face - 8 * g) ? broadcast(0) : p;
        }
        r[groups()] = a[groups()] + t * (b[groups()] - a[groups()]);
        return made;
    }

    /// The cells that can hold the least w_j h_j anywhere on the patch. None where phi vanishes all over it.
    Index keep_cells(const Loop& patch) {
        if (field_count_ == 0) {
            return 0;
        }
        double ceiling = infinity;
        for (Index g = 0; g < groups(); ++g) {
            Lanes low = row(patch.corner[0])[g], high = low;
            for (Index i = 1; i < patch.size; ++i) {
                low = min(low, row(patch.corner[i])[g]);
                high = max(high, row(patch.corner[i])[g]);
            }
            lows_[g] = max(low, fields_[g]);
            ceiling = std::min(ceiling, least(max(high, fields_[g])));
        }
        if (ceiling <= 0) {
            return 0;
        }
        Index kept = 0;
        for (Index g = 0; g < groups(); ++g) {
            for_each_bit(bits_not_above(lows_[g], broadcast(ceiling)), [&](int lane) {
                if (8 * g + lane < field_.face_count) {
                    side_.work.kept[at(kept++)] = 8 * g + lane;
                }
            });
        }
        return kept;
    }

    double weight(Index face) const { return reinterpret_cast<const double*>(weights_)[face]; }

    double area_of(const Loop& loop) const {
        const Vec3 x0 = position(loop.corner[0]);
        Vec3 before = position(loop.corner[1]) - x0, sum{};
        for (Index i = 2; i < loop.size; ++i) {
            const Vec3 here = position(loop.corner[i]) - x0;
            sum += cross(before, here);
            before = here;
        }
        return 0.5 * dot(normal_, sum);
    }

    /// See plain::integrate for the formulas; areas are taken in the coordinate plane that the face is steepest on.
    void integrate(const Loop& loop, Index j) {
        const Lanes x0 = row(loop.corner[0])[groups()];
        Lanes x1 = row(loop.corner[1])[groups()];
        const double p0 = value(loop.corner[0], j);
        double p1 = value(loop.corner[1], j);
        const double u0 = coordinate(loop.corner[0], axis_u_), v0 = coordinate(loop.corner[0], axis_v_);
        double u1 = coordinate(loop.corner[1], axis_u_) - u0, v1 = coordinate(loop.corner[1], axis_v_) - v0;
        double largest = std::max(p0, p1), shadow = 0, six_sum = 0;
        Lanes first = broadcast(0);
        for (Index i = 2; i < loop.size; ++i) {
            const Index corner = loop.corner[i];
            const Lanes x2 = row(corner)[groups()];
            const double p2 = value(corner, j), u2 = coordinate(corner, axis_u_) - u0,
                         v2 = coordinate(corner, axis_v_) - v0;
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
            const double w = weight(j);
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

    double coordinate(Index i, Index axis) const { return reinterpret_cast<const double*>(row(i) + groups())[axis]; }

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
    Index groups_count_, corner_count_{0}, row_count_{0}, loop_room_{0}, loop_turn_{0}, loop_bank_{0}, field_count_{0};
    double* gaps_{nullptr};
    Lanes *rows_{nullptr}, *weights_{nullptr}, *fields_{nullptr}, *lows_{nullptr};
    bool is_internal_{false};
    Vec3 normal_{};
    Lanes patch_first_{};
    Index axis_u_{0}, axis_v_{1};
    double stretch_{1}, offset_{0}, patch_area_{0}, patch_sum_{0};
};

}  // namespace

Separation integrate_surface(const SurfaceInField& side, SurfaceIntegrals& total) {
    return side.field.face_count <= 8 ? SurfacePass<1>(side, total).run() : SurfacePass<0>(side, total).run();
}

}  // namespace riprap::contact

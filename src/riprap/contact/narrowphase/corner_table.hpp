// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "riprap/contact/narrowphase/surface_in_field.hpp"
#include "riprap/core/index.hpp"

namespace riprap::contact {

/// A polygon as a list of corners of a CornerTable.
struct CornerLoop {
    const std::int32_t* corner;
    std::int32_t size;
};

/// The corners of polygons that are being cut, each with its w_j h_j for all faces j of the field body in lanes, and
/// its arm from the reference point. A cut makes new corners by interpolating whole rows. Lives in a SurfaceWorkspace.
/// Groups: number of vectors of eight faces, or 0 when known at run time only.
template <int Groups>
class CornerTable {
 public:
    using Index = std::int32_t;
    struct Sides {
        bool inside, outside;
    };

    /// Makes room for the corners of the surface and all that cuts can add.
    explicit CornerTable(const SurfaceInField& side)
        : side_(side),
          groups_count_((side.field.face_count + 7) / 8),
          corner_count_(side.surface.vertex_count == 0 ? 4 : side.surface.vertex_count),
          row_count_(corner_count_) {
        const Index faces = side.field.face_count, room = corner_count_ + 4 * faces + 8;
        loop_room_ = corner_count_ + 2 * faces + 8;
        SurfaceWorkspace& work = side.work;
        grow(work.rows, room * stride() + groups());
        grow(work.loops, 4 * loop_room_);
        grow(work.gaps, loop_room_);
        rows_ = work.rows.data();
        weights_ = rows_ + std::ptrdiff_t{room} * stride();
        loops_ = work.loops.data();
        gaps_ = work.gaps.data();
        for (Index g = 0; g < groups(); ++g) {
            weights_[g] = side.potential == Potential::distance
                              ? Lanes(1 / side.field.inscribed_radius)
                              : Lanes::load(side.field.fdem_weight + std::ptrdiff_t{8} * g);
        }
    }

    Index groups() const { return Groups > 0 ? Groups : groups_count_; }
    Index corner_count() const { return corner_count_; }  ///< of the surface itself
    Lanes* row(Index i) const { return rows_ + std::ptrdiff_t{i} * stride(); }
    Arm arm(Index i) const { return Arm::load(arm_place(i)); }
    /// w_j h_j of corner i above face j.
    double value(Index i, Index face) const { return reinterpret_cast<const double*>(row(i))[face]; }
    double weight(Index face) const { return reinterpret_cast<const double*>(weights_)[face]; }
    double coordinate(Index i, Index axis) const { return arm_place(i)[axis]; }
    Vec3 position(Index i) const { return {coordinate(i, 0), coordinate(i, 1), coordinate(i, 2)}; }

    /// Corners made after `count` are forgotten.
    Index row_count() const { return row_count_; }
    void forget_rows(Index count) { row_count_ = count; }
    /// Loops are cut from one buffer of a bank to the other, so a loop of bank 0 outlives those cut in bank 1.
    void use_bank(Index bank) { loop_bank_ = 2 * bank; }

    void place(Index i, const Vec3& x) {
        const geometry::ConvexView& field = side_.field;
        Lanes* r = row(i);
        for (Index g = 0; g < groups(); ++g) {
            const Lanes h = Lanes::load(field.offset + std::ptrdiff_t{8} * g) -
                            Lanes::load(field.normal_x + std::ptrdiff_t{8} * g) * x.x -
                            Lanes::load(field.normal_y + std::ptrdiff_t{8} * g) * x.y -
                            Lanes::load(field.normal_z + std::ptrdiff_t{8} * g) * x.z;
            r[g] = weights_[g] * snap(h, Lanes(side_.tolerance));
        }
        const Vec3 from_reference = x - side_.reference;
        Arm arm(0);
        arm.set(0, from_reference.x);
        arm.set(1, from_reference.y);
        arm.set(2, from_reference.z);
        arm.store(arm_place(i));
    }

    /// Takes the signed distances of a loop's corners from a plane, for cut().
    template <class Gap>
    Sides gather(const CornerLoop& loop, const Gap& gap) {
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
    bool cut(CornerLoop& loop, Index face) {
        Index* out = loops_ + std::ptrdiff_t{loop_bank_ + (loop_turn_ ^= 1)} * loop_room_;
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

 private:
    template <class T>
    static void grow(std::vector<T>& buffer, Index size) {
        if (buffer.size() < at(size)) {
            buffer.resize(at(size));
        }
    }
    Index stride() const { return groups() + 1; }
    double* arm_place(Index i) const { return reinterpret_cast<double*>(row(i) + groups()); }

    Index interpolate(Index i, Index k, double t, Index face) {
        static constexpr double lane_numbers[]{0, 1, 2, 3, 4, 5, 6, 7};
        const Index made = row_count_++;
        const Lanes *a = row(i), *b = row(k);
        Lanes* r = row(made);
        for (Index g = 0; g < groups(); ++g) {
            const Lanes p = snap(a[g] + t * (b[g] - a[g]), side_.tolerance * weights_[g]);
            // Whole vectors only: a scalar store here would hold up the next vector load.
            r[g] = select(Lanes::load(lane_numbers) == Lanes(face - 8 * g), Lanes(0), p);
        }
        (arm(i) + t * (arm(k) - arm(i))).store(arm_place(made));
        return made;
    }

    const SurfaceInField& side_;
    Index groups_count_, corner_count_, row_count_, loop_room_{0}, loop_turn_{0}, loop_bank_{0};
    Lanes *rows_{nullptr}, *weights_{nullptr};
    Index* loops_{nullptr};
    double* gaps_{nullptr};
};

}  // namespace riprap::contact

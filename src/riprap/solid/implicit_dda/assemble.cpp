// SPDX-License-Identifier: Apache-2.0
// The equations of one step from its contacts: pairs are summed each by itself, rows gather the sums.
#include <algorithm>
#include <array>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/linear/past_caches.hpp"
#include "riprap/solid/affine/plane.hpp"
#include "riprap/solid/implicit_dda/system.hpp"

namespace riprap::solid::implicit_dda {

namespace {

/// Pairs of rows, one after the other, as their contacts come.
void find_pairs(const std::vector<ContactTerm>& contacts, std::vector<PairTerm>& pairs) {
    pairs.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const ContactTerm& c = contacts[i];
        const auto here = static_cast<std::int32_t>(i);
        if (pairs.empty() || pairs.back().row_a != c.row_a || pairs.back().row_b != c.row_b) {
            pairs.push_back({c.row_a, c.row_b, here, here, -1, -1, -1, -1});
        }
        pairs.back().end = here + 1;
    }
}

/// Gives every row its sides.
void place_sides(std::int64_t rows, Equations& equations) {
    std::vector<std::int64_t>& start = equations.side_start;
    start.assign(at(rows) + 1, 0);
    for (const PairTerm& pair : equations.pairs) {
        for (const std::int32_t row : {pair.row_a, pair.row_b}) {
            start[at(row >= 0 ? row + 1 : 0)] += row >= 0 ? 1 : 0;
        }
    }
    for (std::size_t r = 1; r < start.size(); ++r) {
        start[r] += start[r - 1];
    }
    std::vector<std::int64_t> next(start.begin(), start.end() - 1);
    for (PairTerm& pair : equations.pairs) {
        pair.side_a = pair.row_a >= 0 ? static_cast<std::int32_t>(next[at(pair.row_a)]++) : -1;
        pair.side_b = pair.row_b >= 0 ? static_cast<std::int32_t>(next[at(pair.row_b)]++) : -1;
    }
    linear::make_room(at(start.back()), equations.sides);
    equations.sides.resize(at(start.back()));
}

/// Stiffness of a contact point in its mode: k_n n n^T, besides k_s (1 - n n^T) where it is locked and F_f/|t| across
/// the slip where it slides.
PointStiffness stiffness_of(const ContactTerm& c) {
    const Vec3& n = c.normal;
    if (c.trial.mode == ContactMode::lock) {
        const double more = c.springs.normal - c.springs.shear, shear = c.springs.shear;
        return {more * n.x * n.x + shear, more * n.y * n.y + shear, more * n.z * n.z + shear,
                more * n.x * n.y,         more * n.y * n.z,         more * n.z * n.x};
    }
    const Vec3 t = cross(n, c.trial.direction);
    const double k = c.springs.normal, across = c.trial.across;
    return {k * n.x * n.x + across * t.x * t.x, k * n.y * n.y + across * t.y * t.y, k * n.z * n.z + across * t.z * t.z,
            k * n.x * n.y + across * t.x * t.y, k * n.y * n.z + across * t.y * t.z, k * n.z * n.x + across * t.z * t.x};
}

/// Force of a contact on a at zero displacement of the unknowns; b gets the opposite.
Vec3 force_at_start(const ContactTerm& c) {
    Vec3 force = c.springs.normal * c.gap * c.normal;
    const Vec3 slip = c.trial.slip_before + c.prescribed - riprap::dot(c.prescribed, c.normal) * c.normal;
    if (c.trial.mode == ContactMode::lock) {
        force -= c.springs.shear * slip;
    } else {
        const Vec3 across = cross(c.normal, c.trial.direction);
        force -= c.trial.friction * c.trial.direction + (c.trial.across * riprap::dot(across, slip)) * across;
    }
    return force;
}

/// Uncouples the unknowns out of the plane from all others; a block of a row keeps its own entries, so that it stays
/// positive definite and its unknowns are exactly the right-hand side, nought.
void uncouple_plane(bool is_own, double* block) {
    for (const std::size_t i : affine::out_of_plane) {
        const double own = is_own ? block[13 * i] : 0;
        for (std::size_t k = 0; k < 12; ++k) {
            block[12 * i + k] = block[12 * k + i] = 0;
        }
        block[13 * i] = own;
    }
}

void add_force(double force, const Four& arm, double* load) { (Four::load(load) + force * arm).store(load); }

/// Sums of one pair. Contacts of a face share their stiffness as long as they are locked: arms are summed while it
/// stays.
struct PairSum {
    SideSum a, b;
    SharedSprings shared;

    void add(const ContactTerm& c) {
        const PointStiffness n = stiffness_of(c);
        if (n != stiffness_) {
            close_group();
            stiffness_ = n;
        }
        const Four arm_a = with_one(c.arm_a), arm_b = with_one(c.arm_b);
        arms_a_.add(arm_a, c.arm_a);
        arms_b_.add(arm_b, c.arm_b);
        arms_ab_.add(arm_a, c.arm_b);
        const Vec3 push = force_at_start(c);
        const double along[3]{push.x, push.y, push.z};
        for (std::size_t i = 0; i < 3; ++i) {
            add_force(along[i], arm_a, &a.load[4 * i]);
            add_force(-along[i], arm_b, &b.load[4 * i]);
        }
        is_empty_ = false;
    }
    void close_group() {
        if (!is_empty_) {
            a.springs.add(stiffness_, arms_a_);
            b.springs.add(stiffness_, arms_b_);
            const PointStiffness& n = stiffness_;
            shared.add({-n[0], -n[1], -n[2], -n[3], -n[4], -n[5]}, arms_ab_);
            arms_a_ = arms_b_ = arms_ab_ = {};
            is_empty_ = true;
        }
    }

 private:
    ArmSum arms_a_, arms_b_, arms_ab_;
    PointStiffness stiffness_{};
    bool is_empty_{true};
};

void store_past_caches(const SideSum& from, SideSum& to) {
    linear::store_past_caches(from.springs.value.data(), sizeof(SideSum) / sizeof(double), to.springs.value.data());
}

void sum_pair(const std::vector<ContactTerm>& contacts, const PairTerm& pair, Equations& equations) {
    PairSum sum;
    for (std::int32_t i = pair.first; i < pair.end; ++i) {
        if (contacts[at(i)].trial.mode != ContactMode::open) {
            sum.add(contacts[at(i)]);
        }
    }
    sum.close_group();
    if (pair.side_a >= 0) {
        store_past_caches(sum.a, equations.sides[at(pair.side_a)]);
    }
    if (pair.side_b >= 0) {
        store_past_caches(sum.b, equations.sides[at(pair.side_b)]);
    }
    if (pair.entry_ab >= 0) {
        alignas(64) Matrix12 ab, ba;
        write_blocks(sum.shared, ab.data(), ba.data());
        if (equations.is_planar) {
            uncouple_plane(false, ab.data());
            uncouple_plane(false, ba.data());
        }
        linear::store_past_caches(ab.data(), 144, equations.matrix.block(pair.entry_ab));
        linear::store_past_caches(ba.data(), 144, equations.matrix.block(pair.entry_ba));
    }
}

/// Asks for the contact points of a pair, so that they come while the one before is summed.
void ask_for(const std::vector<ContactTerm>& contacts, const PairTerm& pair) {
    const auto* const from = reinterpret_cast<const char*>(&contacts[at(pair.first)]);
    const std::size_t bytes = at(pair.end - pair.first) * sizeof(ContactTerm);
    for (std::size_t byte = 0; byte < bytes; byte += 64) {
        __builtin_prefetch(from + byte);
    }
}

/// Fills the diagonal block and the right-hand side of a row from the sums of its pairs.
void fill_row(std::int64_t row, Equations& equations) {
    SideSum sum;
    for (std::int64_t s = equations.side_start[at(row)]; s < equations.side_start[at(row) + 1]; ++s) {
        const SideSum& side = equations.sides[at(s)];
        for (std::size_t i = 0; i < side.springs.value.size(); ++i) {
            sum.springs.value[i] += side.springs.value[i];
        }
        for (std::size_t i = 0; i < side.load.size(); ++i) {
            sum.load[i] += side.load[i];
        }
    }
    const linear::BlockPattern& pattern = equations.matrix.pattern();
    double* const own = equations.matrix.block(pattern.find(row, row));
    write_block(sum.springs, own);
    for (std::size_t i = 0; i < 144; ++i) {
        own[i] += equations.diagonal[at(row)][i];
    }
    if (equations.is_planar) {
        uncouple_plane(true, own);
    }
    const auto& f = sum.load;
    const Vector12 load =
        load_vector({f[0], f[4], f[8]}, {{{f[1], f[2], f[3]}, {f[5], f[6], f[7]}, {f[9], f[10], f[11]}}});
    for (std::size_t i = 0; i < 12; ++i) {
        equations.right[at(row) * 12 + i] = equations.given[at(row)][i] + load[i];
    }
    for (const std::size_t i : affine::out_of_plane) {
        equations.right[at(row) * 12 + i] *= equations.is_planar ? 0 : 1;
    }
}

}  // namespace

void link_rows(std::int64_t rows, const std::vector<ContactTerm>& contacts, Equations& equations) {
    find_pairs(contacts, equations.pairs);
    place_sides(rows, equations);
    std::vector<std::array<std::int32_t, 2>> inner;
    inner.reserve(equations.pairs.size());
    for (const PairTerm& pair : equations.pairs) {
        if (pair.row_a >= 0 && pair.row_b >= 0) {
            inner.push_back({pair.row_a, pair.row_b});
        }
    }
    linear::BlockPattern pattern = linear::symmetric_pattern(rows, inner);
    if (!(pattern == equations.matrix.pattern()) || equations.right.size() != at(rows) * 12) {
        equations.matrix.set_pattern(std::move(pattern));
        equations.right.assign(at(rows) * 12, 0);
    }
    parallel::for_each(static_cast<std::int64_t>(equations.pairs.size()), [&](std::int64_t i) {
        PairTerm& pair = equations.pairs[at(i)];
        if (pair.row_a >= 0 && pair.row_b >= 0) {
            pair.entry_ab = equations.matrix.pattern().find(pair.row_a, pair.row_b);
            pair.entry_ba = equations.matrix.pattern().find(pair.row_b, pair.row_a);
        }
    });
    equations.is_stale.assign(equations.pairs.size(), 1);
    equations.is_new.assign(at(rows), 1);
    equations.is_due.assign(at(rows), 1);
}

void assemble(const std::vector<ContactTerm>& contacts, Equations& equations) {
    std::vector<std::int32_t>& stale = equations.stale_pairs;
    stale.clear();
    for (std::size_t i = 0; i < equations.pairs.size(); ++i) {
        if (equations.is_stale[i] == 0) {
            continue;
        }
        equations.is_stale[i] = 0;
        stale.push_back(static_cast<std::int32_t>(i));
        for (const std::int32_t row : {equations.pairs[i].row_a, equations.pairs[i].row_b}) {
            if (row >= 0) {
                equations.is_due[at(row)] = 1;
            }
        }
    }
    parallel::for_ranges(static_cast<std::int64_t>(stale.size()), 64, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            if (i + 1 < end) {
                ask_for(contacts, equations.pairs[at(stale[at(i + 1)])]);
            }
            sum_pair(contacts, equations.pairs[at(stale[at(i)])], equations);
        }
        linear::finish_stores();
    });
    parallel::for_each_uneven(equations.matrix.rows(), 16, [&](std::int64_t row) {
        if (equations.is_due[at(row)] != 0) {
            fill_row(row, equations);
            equations.is_due[at(row)] = 0;
            equations.is_new[at(row)] = 1;
        }
    });
}

}  // namespace riprap::solid::implicit_dda

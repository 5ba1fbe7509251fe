// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/pack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/coupling/fill_lattice.hpp"
#include "riprap/coupling/fill_level.hpp"
#include "riprap/coupling/fill_solids.hpp"
#include "riprap/coupling/pack_sums.hpp"
#include "riprap/coupling/zone.hpp"
#include "riprap/fluid/mps_operators/mps_lattice.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::coupling {

namespace {

constexpr double depth = 5;    ///< packed_depth() over dp
constexpr int sweeps = 500;    ///< at most
constexpr double even = 1e-4;  ///< |sum V grad W| dp at which places are even
/// Places of a pocket too narrow for a particle never become even: sweeps end where of those that are not, this share
/// is still so after as many sweeps.
constexpr double gain = 0.85;
constexpr int patience = 20;
constexpr double keeps = 0.85;    ///< share of its last move that a particle goes on with
constexpr double pull = 3;        ///< move over that which ends the stiffest wave of the lattice at once
constexpr double longest = 0.1;   ///< move over dp
constexpr int faces_at_once = 3;  ///< that may meet in a corner

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Places that are packed among others that stay.
class Crowd {
 public:
    explicit Crowd(const fluid::ParticleSettings& settings)
        : kernel_(settings.smoothing_length(), settings.domain.dimension),
          reach_{settings.support_radius(), settings.domain},
          spacing_(settings.spacing),
          volume_(std::pow(settings.spacing, settings.domain.dimension)) {}

    std::vector<Vec3> moving;        ///< [m]
    std::vector<Vec3> rest;          ///< [m]
    std::vector<double> rest_share;  ///< their volume over that of a particle [-]

    /// sum V grad W at the places that move [1/m]
    const std::vector<Vec3>& slopes() {
        slopes_.resize(moving.size());
        std::array<fluid::FieldSink, 3> sums;
        for (int axis = 0; axis < 3; ++axis) {
            sums[at(axis)] = fluid::sink_component(slopes_, axis);
        }
        fluid::exchange_within<fluid::PackedSlope>(fluid::PackedSlope::of(kernel_, spacing_, volume_), reach_,
                                                   {moving, {}}, fluid::fresh(sums), among_moving_);
        fluid::sweep<fluid::PackedSlopeOfRest>({kernel_}, reach_, {moving, {}}, {rest, {fluid::field(rest_share)}},
                                               sums, with_rest_);
        parallel::for_each(static_cast<std::int64_t>(moving.size()), [&](std::int64_t m) {
            slopes_[at(m)] = volume_ * fluid::in_plane(slopes_[at(m)], reach_.domain);
        });
        return slopes_;
    }
    /// sum V W [-] at the places that move, and then at the rest.
    std::vector<double> counts() const {
        std::vector<Vec3> all = moving;
        all.insert(all.end(), rest.begin(), rest.end());
        std::vector<double> share(moving.size(), 1), sums(all.size());
        share.insert(share.end(), rest_share.begin(), rest_share.end());
        fluid::SweepScratch scratch;
        fluid::sweep<fluid::PackedCount>({kernel_}, reach_, {all, {}}, {all, {fluid::field(share)}},
                                         {fluid::sink(sums)}, scratch);
        for (double& sum : sums) {
            sum *= volume_;
        }
        return sums;
    }
    /// sum V W on the lattice [-]
    double lattice_count() const {
        const int n = static_cast<int>(std::ceil(reach_.support_radius / spacing_));
        const int deep = reach_.domain.dimension == 3 ? n : 0;
        double sum = 0;
        for (int c = -deep; c <= deep; ++c) {
            for (int b = -n; b <= n; ++b) {
                for (int a = -n; a <= n; ++a) {
                    sum += volume_ * kernel_.value(spacing_ * std::sqrt(static_cast<double>(a * a + b * b + c * c)));
                }
            }
        }
        return sum;
    }

 private:
    fluid::WendlandC2 kernel_;
    fluid::SweepReach reach_;
    double spacing_, volume_;
    std::vector<Vec3> slopes_;
    fluid::SweepScratch among_moving_, with_rest_;
};

/// Sum and largest of what is uneven [-].
struct Uneven {
    double sum{0}, most{0};

    template <class By>
    static void join(Uneven& a, const Uneven& b, const By& by) {
        by.add(a.sum, b.sum);
        by.largest(a.most, b.most);
    }
};

/// The place next to x that is as far from faces as `fill` allows, on the plane of x in planar scenes; still near one
/// where solids leave no such place.
Vec3 put_off_faces(const FillSolids& solids, const fluid::ParticleSettings& settings, Vec3 x) {
    const double distance = face_distance(settings), z = x.z;
    for (int n = 0; n < faces_at_once && solids.are_near(x, distance); ++n) {
        x = solids.push_out(x, (1 + lattice_slack) * distance);
        x.z = settings.domain.dimension == 2 ? z : x.z;
    }
    return x;
}

/// Keeps places off faces while they move. A row that is too full beside the edge of two walls is pressed out between
/// their boundary particles, and others follow; put back at the end they would share places.
class FaceGuard {
 public:
    FaceGuard(const FillSolids& solids, const fluid::ParticleSettings& settings, std::size_t places)
        : solids_(&solids), settings_(&settings), free_way_(places, 0), off_(places) {}

    /// Takes a place that went by `step` to x off faces, and shortens the step by as much.
    void hold(std::size_t place, Vec3& step, Vec3& x) {
        double& free_way = free_way_[place];
        free_way -= norm(step);
        if (free_way > 0) {
            return;
        }
        off_[place] = {};
        const double dp = settings_->spacing, distance = face_distance(*settings_);
        for (const double way : {0.5, 0.25, 0.1}) {
            if (!solids_->are_near(x, distance + way * dp)) {
                free_way = way * dp;
                return;
            }
        }
        free_way = 0;
        const Vec3 held = put_off_faces(*solids_, *settings_, x);
        const double back = norm(held - x);
        off_[place] = back > 0 ? (held - x) / back : Vec3{};
        step += held - x;
        x = held;
    }
    /// The slope along which a place can move: without what presses it on the face that held it last.
    Vec3 along_faces(std::size_t place, const Vec3& slope) const {
        return slope - std::max(0.0, dot(slope, off_[place])) * off_[place];
    }

 private:
    const FillSolids* solids_;
    const fluid::ParticleSettings* settings_;
    std::vector<double> free_way_;  ///< that each place may go before faces are looked for again [m]
    std::vector<Vec3> off_;         ///< unit, off the faces that hold a place; 0: none does [-]
};

/// Moves places of a crowd until they are even.
void settle(const fluid::ParticleSettings& settings, const FillSolids& solids, Crowd& crowd, Packed& packed) {
    const double dp = settings.spacing;
    const double ratio = settings.support_radius() / dp;
    const fluid::MpsLattice lattice =
        fluid::mps_lattice(fluid::MpsWeightLaw::smooth, ratio, dp, settings.domain.dimension);
    const double per_slope = pull / (0.5 * lattice.wave_stiffness);  // which is that of pairs that count twice
    const auto count = static_cast<std::int64_t>(crowd.moving.size());
    std::vector<Vec3> move(crowd.moving.size());
    FaceGuard guard(solids, settings, crowd.moving.size());
    double left = std::numeric_limits<double>::infinity();  // sum of what is uneven when progress was looked at last
    for (packed.sweeps = 0; packed.sweeps < sweeps; ++packed.sweeps) {
        const std::vector<Vec3>& slope = crowd.slopes();
        const Uneven uneven = parallel::sum(count, [&](std::int64_t m) {
            const double left_over = dp * norm(guard.along_faces(at(m), slope[at(m)]));
            return Uneven{left_over, left_over};
        });
        packed.unevenness = uneven.most;
        const bool is_look = packed.sweeps % patience == patience - 1;
        if (uneven.most < even || (is_look && uneven.sum > gain * left)) {
            return;
        }
        left = is_look ? uneven.sum : left;
        parallel::for_each(count, [&](std::int64_t m) {
            Vec3& step = move[at(m)];
            step = keeps * step - per_slope * slope[at(m)];
            const double length = norm(step);
            step *= length > longest * dp ? longest * dp / length : 1;
            crowd.moving[at(m)] += step;
            guard.hold(at(m), step, crowd.moving[at(m)]);
        });
    }
}

/// Tells whether x lies in a piece of a region, or in the domain where it names none.
bool is_in(const FillRegion& region, const fluid::Domain& domain, const Vec3& x) {
    return region.pieces.empty() ? domain.admits(x)
                                 : std::ranges::any_of(region.pieces, [&](const geometry::Polyhedron& piece) {
                                       return std::ranges::all_of(piece.faces, [&](const auto& face) {
                                           const geometry::Plane plane = geometry::face_plane(piece.vertices, face);
                                           return dot(plane.normal, x) <= plane.offset;
                                       });
                                   });
}

/// The last place of the way from the start to x that lies in the region of the start, no nearer to faces than both;
/// x where the start lay in none. Back at their starts particles would meet others that were packed there.
Vec3 kept_in(const FillRegion& region, const FillSolids& solids, const fluid::ParticleSettings& settings,
             const Vec3& start, const Vec3& x) {
    if (!is_in(region, settings.domain, start) || is_in(region, settings.domain, x)) {
        return x;
    }
    constexpr int halvings = 30;
    double inside = 0, outside = 1;
    for (int n = 0; n < halvings; ++n) {
        const double half = 0.5 * (inside + outside);
        (is_in(region, settings.domain, start + half * (x - start)) ? inside : outside) = half;
    }
    const Vec3 last = start + inside * (x - start);
    return solids.are_near(last, face_distance(settings)) ? start : last;
}

/// Where a particle may stand that was packed at x: as far from faces as at the start, and on its side of them.
Vec3 clear_of_faces(const FillSolids& solids, const fluid::ParticleSettings& settings, const Vec3& start, Vec3 x) {
    x = put_off_faces(solids, settings, x);
    return solids.are_near(x, face_distance(settings)) || solids.lie_between(start, x) ? start : x;
}

/// Tells whether a face cuts any of some cells of a lattice, by their middles: else the surface does.
bool cut_by_faces(const FillSolids& solids, const fluid::ParticleSettings& settings, std::span<const Vec3> middles) {
    const double half_diagonal = 0.5 * std::sqrt(static_cast<double>(settings.domain.dimension)) * settings.spacing;
    return std::ranges::any_of(middles, [&](const Vec3& middle) {
        const Lattice cell{middle, {1, 1, 1}, settings.spacing};
        return solids.are_near(middle, half_diagonal) &&
               CellPoints(solids, cell, settings.domain.dimension, 0, 0, 0).free_share() < 1;
    });
}

}  // namespace

double packed_depth(const fluid::ParticleSettings& settings) { return depth * settings.spacing; }

Packed pack(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
            const fluid::ParticleSettings& settings, const SampleSet& samples, std::span<const FillRegion> regions,
            Filling& filling) {
    std::vector<Vec3>& position = filling.particles.position;
    Packed packed;
    packed.lack.assign(position.size(), 0);
    if (filling.misfits.empty()) {
        return packed;
    }
    const double reach = settings.support_radius();
    const auto within = [&](double distance) {
        return Zone(filling.misfits, settings.domain, packed_depth(settings) + distance);
    };
    const Zone moves = within(0), is_felt = within(reach), counts = within(2 * reach);
    std::vector<Vec3> places;  // of water, then of air
    std::vector<std::size_t> water;
    for (std::size_t i = 0; i < position.size(); ++i) {
        if (counts.holds(position[i])) {
            water.push_back(i);
            places.push_back(position[i]);
        }
    }
    const FillSolids solids(shapes, bodies, initial, settings.domain, settings.spacing);
    const bool has_faces = cut_by_faces(solids, settings, filling.misfits);
    const Zone beside_water(places, settings.domain, reach);
    places.insert(places.end(), filling.air.begin(), filling.air.end());
    Crowd crowd(settings);
    std::vector<std::size_t> moving, rest;  // of places
    for (const std::uint32_t n : fluid::order_by_place(places, settings.domain, settings.spacing)) {
        const bool may_move = n < water.size() || (has_faces && beside_water.holds(places[n]));
        const bool moves_too = may_move && moves.holds(places[n]);
        (moves_too ? moving : rest).push_back(n);
        (moves_too ? crowd.moving : crowd.rest).push_back(places[n]);
    }
    const double volume = std::pow(settings.spacing, settings.domain.dimension);
    crowd.rest_share.assign(crowd.rest.size(), 1);
    for (std::size_t s = 0; s < at(samples.size()); ++s) {
        const auto b = at(samples.body[s].value);
        const Vec3 x = initial.position[b] + rotate(initial.orientation[b], samples.anchor[s]);
        if (counts.holds(x)) {
            crowd.rest.push_back(x);
            crowd.rest_share.push_back(samples.volume[s] / volume);
        }
    }
    settle(settings, solids, crowd, packed);

    const fluid::PeriodicImages images(settings.domain);
    const Vec3 middle = 0.5 * (settings.domain.low + settings.domain.high);
    parallel::for_each_uneven(static_cast<std::int64_t>(moving.size()), 64, [&](std::int64_t m) {
        if (moving[at(m)] >= water.size()) {
            return;
        }
        const std::size_t i = water[moving[at(m)]];
        Vec3& x = position[i];
        const FillRegion& region = regions[static_cast<std::size_t>(filling.region[i])];
        const Vec3 packed_at = clear_of_faces(solids, settings, x, images.nearest(crowd.moving[at(m)], x));
        x = images.nearest(kept_in(region, solids, settings, x, packed_at), middle);
        crowd.moving[at(m)] = x;
    });
    const double full = crowd.lattice_count();
    const std::vector<double> sums = crowd.counts();
    moving.insert(moving.end(), rest.begin(), rest.end());
    for (std::size_t n = 0; n < moving.size(); ++n) {
        if (moving[n] < water.size() && is_felt.holds(position[water[moving[n]]])) {
            packed.lack[water[moving[n]]] = 1 - sums[n] / full;
        }
    }
    return packed;
}

}  // namespace riprap::coupling

// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/pack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/coupling/fill_lattice.hpp"
#include "riprap/coupling/fill_solids.hpp"
#include "riprap/coupling/zone.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/mps_lattice.hpp"

namespace riprap::coupling {

namespace {

constexpr double depth = 5;    ///< packed_depth() over dp
constexpr int sweeps = 500;    ///< at most
constexpr double even = 1e-4;  ///< |sum V grad W| dp at which places are even
/// Places of a pocket too narrow for a particle never become even: sweeps end where of those that are not, this share
/// is still so after as many sweeps.
constexpr double gain = 0.9;
constexpr int patience = 40;
constexpr double keeps = 0.9;     ///< share of its last move that a particle goes on with
constexpr double pull = 1.5;      ///< move over that which ends the stiffest wave of the lattice at once
constexpr double longest = 0.1;   ///< move over dp
constexpr double slack = 0.15;    ///< of lists of neighbours, beyond the support [-]
constexpr double looks = 8;       ///< for solid on the way of a particle, in a spacing
constexpr int faces_at_once = 3;  ///< that may meet in a corner

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Places that count each other, and those of walls.
class Crowd {
 public:
    explicit Crowd(const fluid::ParticleSettings& settings)
        : settings_(settings),
          kernel_(settings.smoothing_length(), settings.domain.dimension),
          image_(settings.domain),
          is_periodic_(std::ranges::any_of(settings.domain.is_periodic, [](bool repeats) { return repeats; })),
          reach_(settings.support_radius()),
          volume_(std::pow(settings.spacing, settings.domain.dimension)) {}

    std::vector<Vec3> place;  ///< [m]

    void add_wall(const Vec3& x, double volume) {
        wall_place_.push_back(x);
        wall_volume_.push_back(volume);
    }
    void sort_walls() {
        if (!wall_place_.empty()) {
            walls_.build(wall_place_, settings_.domain, (1 + slack) * reach_);
        }
    }
    void sort() { grid_.build(place, settings_.domain, reach_); }

    /// Notes what may come within the support of some places while none moves by more than half of the slack.
    void list_near(const std::vector<std::size_t>& of) {
        const double far = (1 + slack) * reach_;
        grid_.build(place, settings_.domain, far);
        std::vector<std::vector<Near>> rows(of.size());
        parallel::for_each_uneven(static_cast<std::int64_t>(of.size()), 64, [&](std::int64_t m) {
            const Vec3& x = place[of[at(m)]];
            const auto add = [&](const Vec3& other, std::uint32_t number, bool is_wall) {
                if (norm_squared(image_(x - other)) < far * far) {
                    rows[at(m)].push_back({number, is_wall});
                }
            };
            grid_.for_each_near(x, [&](std::int64_t j) { add(place[at(j)], static_cast<std::uint32_t>(j), false); });
            if (!wall_place_.empty()) {
                walls_.for_each_near(
                    x, [&](std::int64_t w) { add(wall_place_[at(w)], static_cast<std::uint32_t>(w), true); });
            }
        });
        near_ = std::move(rows);
    }
    double room() const { return 0.5 * slack * reach_; }  ///< that places may move before lists are made anew [m]

    /// sum V W [-]
    double count(std::size_t i) const {
        double sum = 0;
        for_each_near(i, [&](double v, const Vec3& d) { sum += v * kernel_.value(norm(d)); });
        return sum;
    }
    /// sum V grad W at the place of row m of the lists [1/m]
    Vec3 slope(std::size_t m, std::size_t i) const {
        Vec3 sum{};
        const Vec3 x = place[i];
        const double reach_squared = reach_ * reach_;
        for (const Near& near : near_[m]) {
            const Vec3 apart = x - (near.is_wall ? wall_place_ : place)[near.number];
            const Vec3 d = is_periodic_ ? image_(apart) : apart;
            if (const double squared = norm_squared(d); squared < reach_squared) {
                const double v = near.is_wall ? wall_volume_[near.number] : volume_;
                sum += v * kernel_.slope_over_r(std::sqrt(squared)) * d;
            }
        }
        return fluid::in_plane(sum, settings_.domain);
    }
    /// sum V W on the lattice [-]
    double lattice_count() const {
        const double dp = settings_.spacing;
        const int n = static_cast<int>(std::ceil(reach_ / dp)), deep = settings_.domain.dimension == 3 ? n : 0;
        double sum = 0;
        for (int c = -deep; c <= deep; ++c) {
            for (int b = -n; b <= n; ++b) {
                for (int a = -n; a <= n; ++a) {
                    sum += volume_ * kernel_.value(dp * std::sqrt(static_cast<double>(a * a + b * b + c * c)));
                }
            }
        }
        return sum;
    }

 private:
    /// add(V, x_i - x_j) for all within the support.
    template <class Add>
    void for_each_near(std::size_t i, const Add& add) const {
        grid_.for_each_near(place[i], [&](std::int64_t j) {
            const Vec3 d = image_(place[i] - place[at(j)]);
            if (norm_squared(d) < reach_ * reach_) {
                add(volume_, d);
            }
        });
        if (!wall_place_.empty()) {
            walls_.for_each_near(place[i], [&](std::int64_t w) {
                const Vec3 d = image_(place[i] - wall_place_[at(w)]);
                if (norm_squared(d) < reach_ * reach_) {
                    add(wall_volume_[at(w)], d);
                }
            });
        }
    }

    const fluid::ParticleSettings& settings_;
    fluid::WendlandC2 kernel_;
    fluid::NearestImage image_;
    bool is_periodic_;
    double reach_, volume_;
    std::vector<Vec3> wall_place_;
    std::vector<double> wall_volume_;
    fluid::CellGrid grid_, walls_;

    struct Near {
        std::uint32_t number;
        bool is_wall;
    };
    std::vector<std::vector<Near>> near_;  ///< by row of the last list_near
};

/// Moves some places of a crowd until they are even.
void settle(const fluid::ParticleSettings& settings, const std::vector<std::size_t>& moving, Crowd& crowd,
            Packed& packed) {
    const double dp = settings.spacing;
    const double ratio = settings.support_radius() / dp;
    const fluid::MpsLattice lattice =
        fluid::mps_lattice(fluid::MpsWeightLaw::smooth, ratio, dp, settings.domain.dimension);
    const double per_slope = pull / (0.5 * lattice.wave_stiffness);  // which is that of pairs that count twice
    std::vector<Vec3> move(moving.size()), slope(moving.size()), listed(moving.size());
    double left = std::numeric_limits<double>::infinity();  // sum of what is uneven when progress was looked at last
    double moved = crowd.room();                            // from where the lists were made, at most [m]
    for (packed.sweeps = 0; packed.sweeps < sweeps; ++packed.sweeps) {
        if (moved >= crowd.room()) {
            crowd.list_near(moving);
            for (std::size_t m = 0; m < moving.size(); ++m) {
                listed[m] = crowd.place[moving[m]];
            }
        }
        parallel::for_each_uneven(static_cast<std::int64_t>(moving.size()), 64,
                                  [&](std::int64_t m) { slope[at(m)] = crowd.slope(at(m), moving[at(m)]); });
        packed.unevenness = 0;
        double sum = 0;
        for (const Vec3& s : slope) {
            packed.unevenness = std::max(packed.unevenness, dp * norm(s));
            sum += dp * norm(s);
        }
        const bool is_look = packed.sweeps % patience == patience - 1;
        if (packed.unevenness < even || (is_look && sum > gain * left)) {
            return;
        }
        left = is_look ? sum : left;
        double most = 0;
        for (std::size_t m = 0; m < moving.size(); ++m) {
            move[m] = keeps * move[m] - per_slope * slope[m];
            const double length = norm(move[m]);
            move[m] *= length > longest * dp ? longest * dp / length : 1;
            crowd.place[moving[m]] += move[m];
            most = std::max(most, norm(crowd.place[moving[m]] - listed[m]));
        }
        moved = most;
    }
}

/// Tells whether solid lies on the way between two places.
bool is_between(const FillSolids& solids, const Vec3& a, const Vec3& b, double spacing) {
    const int steps = static_cast<int>(std::ceil(looks * norm(b - a) / spacing));
    for (int n = 1; n < steps; ++n) {
        if (solids.contain(a + (static_cast<double>(n) / steps) * (b - a))) {
            return true;
        }
    }
    return false;
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

/// Where a particle may stand that was packed at x: as far from faces as at the start, and on its side of them.
Vec3 clear_of_faces(const FillSolids& solids, const fluid::ParticleSettings& settings, const Vec3& start, Vec3 x) {
    const double distance = face_distance(settings);
    for (int n = 0; n < faces_at_once && solids.are_near(x, distance); ++n) {
        x = solids.push_out(x, (1 + lattice_slack) * distance);
        x.z = settings.domain.dimension == 2 ? start.z : x.z;
    }
    return solids.are_near(x, distance) || is_between(solids, start, x, settings.spacing) ? start : x;
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
    Crowd crowd(settings);
    std::vector<std::size_t> water, moving;
    for (std::size_t i = 0; i < position.size(); ++i) {
        if (counts.holds(position[i])) {
            water.push_back(i);
            crowd.place.push_back(position[i]);
        }
    }
    const Zone beside_water(crowd.place, settings.domain, reach);
    crowd.place.insert(crowd.place.end(), filling.air.begin(), filling.air.end());
    for (std::size_t n = 0; n < crowd.place.size(); ++n) {
        if (moves.holds(crowd.place[n]) && (n < water.size() || beside_water.holds(crowd.place[n]))) {
            moving.push_back(n);
        }
    }
    for (std::size_t s = 0; s < at(samples.size()); ++s) {
        const auto b = at(samples.body[s].value);
        const Vec3 x = initial.position[b] + rotate(initial.orientation[b], samples.anchor[s]);
        if (counts.holds(x)) {
            crowd.add_wall(x, samples.volume[s]);
        }
    }
    crowd.sort_walls();
    settle(settings, moving, crowd, packed);

    const FillSolids solids(shapes, bodies, initial, settings.domain, settings.spacing);
    const fluid::PeriodicImages images(settings.domain);
    const Vec3 middle = 0.5 * (settings.domain.low + settings.domain.high);
    const auto in_water =
        static_cast<std::size_t>(std::lower_bound(moving.begin(), moving.end(), water.size()) - moving.begin());
    parallel::for_each_uneven(static_cast<std::int64_t>(in_water), 64, [&](std::int64_t m) {
        const std::size_t n = moving[at(m)];
        Vec3& x = position[water[n]];
        const FillRegion& region = regions[static_cast<std::size_t>(filling.region[water[n]])];
        const Vec3 packed_at = clear_of_faces(solids, settings, x, images.nearest(crowd.place[n], x));
        const bool left = is_in(region, settings.domain, x) && !is_in(region, settings.domain, packed_at);
        x = left ? x : images.nearest(packed_at, middle);
        crowd.place[n] = x;
    });
    const double full = crowd.lattice_count();
    crowd.sort();
    parallel::for_each_uneven(static_cast<std::int64_t>(water.size()), 64, [&](std::int64_t n) {
        packed.lack[water[at(n)]] = is_felt.holds(position[water[at(n)]]) ? 1 - crowd.count(at(n)) / full : 0;
    });
    return packed;
}

}  // namespace riprap::coupling

// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill_level.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

namespace {

constexpr double least_raise = 0.01;  ///< of a layer; less is what the points of a cell resolve
constexpr int corrections = 2;        ///< of the raise, as shores spread where the surface rises

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Shifts the points of cell (i, j, k) along `axis` by a part in [0, 1) of their distance: a Kronecker sequence of
/// three dimensions, so that the points of neighbouring cells halve each other's distances.
double shift_of(std::int64_t i, std::int64_t j, std::int64_t k, int axis) {
    constexpr std::array<double, 3> steps{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    const double sum = steps[at(axis)] * static_cast<double>(i) + steps[at((axis + 1) % 3)] * static_cast<double>(j) +
                       steps[at((axis + 2) % 3)] * static_cast<double>(k);
    return sum - std::floor(sum);
}

/// Asks the lattice, cell by cell.
struct Survey {
    std::span<const RegionPlanes> regions;
    const Lattice& lattice;
    const FillSolids& solids;
    Vec3 up;
    double distance;  ///< that places keep from solids [m]
    int dimension;

    int owner(std::int64_t i, std::int64_t j, std::int64_t k) const { return region_of(regions, lattice, up, i, j, k); }
    bool is_filled(std::int64_t i, std::int64_t j, std::int64_t k) const {
        return owner(i, j, k) >= 0 && !solids.are_near(lattice.place(i, j, k), distance);
    }
    bool has_filled_neighbour(std::int64_t i, std::int64_t j, std::int64_t k) const {
        for (const std::int64_t step : {-1, 1}) {
            if (is_filled(i + step, j, k) || is_filled(i, j + step, k) ||
                (dimension == 3 && is_filled(i, j, k + step))) {
                return true;
            }
        }
        return false;
    }
    /// Share of a cell that lies in no solid.
    double room(std::int64_t i, std::int64_t j, std::int64_t k) const {
        const int across = dimension == 3 ? 4 : 8;
        const int deep = dimension == 3 ? 4 : 1;
        const Vec3 shift{shift_of(i, j, k, 0), shift_of(i, j, k, 1), shift_of(i, j, k, 2)};
        const auto offset = [&](int n, int axis) { return ((n + shift[axis]) / across - 0.5) * lattice.spacing; };
        int free = 0;
        for (int c = 0; c < deep; ++c) {
            for (int b = 0; b < across; ++b) {
                for (int a = 0; a < across; ++a) {
                    const Vec3 from{offset(a, 0), offset(b, 1), dimension == 3 ? offset(c, 2) : 0};
                    free += solids.contain(lattice.place(i, j, k) + from) ? 0 : 1;
                }
            }
        }
        return free / 64.0;
    }
    void visit(std::int64_t i, std::int64_t j, std::int64_t k, std::span<RegionRoom> sums) const {
        const int region = owner(i, j, k);
        if (region < 0) {
            return;
        }
        RegionRoom& sum = sums[at(region)];
        const Vec3 x = lattice.place(i, j, k);
        const double half_diagonal = 0.5 * std::sqrt(static_cast<double>(dimension)) * lattice.spacing;
        const bool is_beside = solids.are_near(x, half_diagonal);
        const bool is_full = !is_beside || !solids.are_near(x, distance);
        if (is_full) {
            const double below = (regions[at(region)].surface - dot(up, x)) / lattice.spacing + 0.5;
            sum.places += 1;
            sum.top += below >= 1 - lattice_slack && below < 2 - lattice_slack ? 1 : 0;
        }
        if (is_beside && (is_full || has_filled_neighbour(i, j, k))) {
            sum.shortage += room(i, j, k) - (is_full ? 1 : 0);
        }
    }
};

}  // namespace

std::vector<RegionRoom> measure_room(std::span<const RegionPlanes> regions, const Lattice& lattice,
                                     const FillSolids& solids, const Vec3& up, double distance, int dimension) {
    const Survey survey{regions, lattice, solids, up, distance, dimension};
    const std::size_t count = regions.size();
    std::vector<RegionRoom> of_rows(at(lattice.rows()) * count);
    parallel::for_each_uneven(lattice.rows(), 4, [&](std::int64_t row) {
        const std::span<RegionRoom> sums{&of_rows[at(row) * count], count};
        for (std::int64_t i = 0; i < lattice.counts[0]; ++i) {
            survey.visit(i, row % lattice.counts[1], row / lattice.counts[1], sums);
        }
    });
    std::vector<RegionRoom> sums(count);
    for (std::size_t n = 0; n < of_rows.size(); ++n) {
        RegionRoom& sum = sums[n % count];
        sum.places += of_rows[n].places;
        sum.shortage += of_rows[n].shortage;
        sum.top += of_rows[n].top;
    }
    return sums;
}

bool raise_to_volume(std::span<RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                     const FillSolids& solids, const Vec3& up, double distance, std::span<FillReport> reports) {
    const double dp = settings.spacing;
    const int dimension = settings.domain.dimension;
    const auto measure = [&] {
        return measure_room(regions, lattice_over(regions, settings, corner, up), solids, up, distance, dimension);
    };
    std::vector<RegionRoom> rooms = measure();
    std::vector<double> wanted(regions.size()), raised(regions.size(), 0);
    for (std::size_t r = 0; r < regions.size(); ++r) {
        wanted[r] = rooms[r].places + rooms[r].shortage;
        reports[r].room = wanted[r] * std::pow(dp, dimension);
    }
    bool has_moved = false;
    for (int n = 0; n < corrections; ++n) {
        bool moves = false;
        for (std::size_t r = 0; r < regions.size(); ++r) {
            if (rooms[r].top < 1) {
                continue;
            }
            const double target = std::clamp(raised[r] + (wanted[r] - rooms[r].places) / rooms[r].top, -1.0, 1.0);
            if (std::abs(target - raised[r]) < least_raise) {
                continue;
            }
            raise_surface(regions[r], up, (target - raised[r]) * dp, dp);
            raised[r] = target;
            moves = true;
        }
        if (!moves) {
            break;
        }
        has_moved = true;
        rooms = measure();
    }
    return has_moved;
}

}  // namespace riprap::coupling

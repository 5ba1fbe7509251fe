// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill_level.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

namespace {

constexpr int corrections = 8;  ///< of the raise: shores spread as it grows, and layers fill up by whole places

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Shifts the points of cell (i, j, k) along `axis` by a part in [0, 1) of their distance: a Kronecker sequence of
/// three dimensions, so that the points of neighbouring cells halve each other's distances, and none lies on the
/// rim of the first.
double shift_of(std::int64_t i, std::int64_t j, std::int64_t k, int axis) {
    constexpr std::array<double, 3> steps{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    const double sum = 0.5 + steps[at(axis)] * static_cast<double>(i) +
                       steps[at((axis + 1) % 3)] * static_cast<double>(j) +
                       steps[at((axis + 2) % 3)] * static_cast<double>(k);
    return sum - std::floor(sum);
}

/// Where particles of a region are, in cells.
struct Count {
    double places{0};  ///< that are filled
    double top{0};     ///< of them, those of the uppermost whole layer
    Count& operator+=(const Count& other) {
        places += other.places;
        top += other.top;
        return *this;
    }
};

/// Asks the lattice, cell by cell.
struct Survey {
    std::span<const RegionPlanes> regions;
    const Lattice& lattice;
    const FillSolids& solids;
    Vec3 up;
    double distance;  ///< that places keep from solids [m]
    int dimension;

    bool is_open(std::int64_t i, std::int64_t j, std::int64_t k) const {
        const auto is_in = [&](const RegionPlanes& region) { return share_of(region, lattice, up, i, j, k) > 0; };
        return std::any_of(regions.begin(), regions.end(), is_in) && !solids.are_near(lattice.place(i, j, k), distance);
    }
    bool has_open_neighbour(std::int64_t i, std::int64_t j, std::int64_t k) const {
        for (const std::int64_t step : {-1, 1}) {
            if (is_open(i + step, j, k) || is_open(i, j + step, k) || (dimension == 3 && is_open(i, j, k + step))) {
                return true;
            }
        }
        return false;
    }
    /// Share of a cell that water reaches.
    double reached(std::int64_t i, std::int64_t j, std::int64_t k) const {
        const Vec3 x = lattice.place(i, j, k);
        const double half_diagonal = 0.5 * std::sqrt(static_cast<double>(dimension)) * lattice.spacing;
        if (!solids.are_near(x, half_diagonal)) {
            return 1;
        }
        return !solids.are_near(x, distance) || has_open_neighbour(i, j, k)
                   ? CellPoints(solids, lattice, dimension, i, j, k).free_share()
                   : 0;
    }
    void add_room(std::int64_t i, std::int64_t j, std::int64_t k, std::span<double> room) const {
        double taken = 0, cell = -1;
        for (std::size_t r = 0; r < regions.size(); ++r) {
            const double share = share_of(regions[r], lattice, up, i, j, k);
            if (share > taken) {
                cell = cell < 0 ? reached(i, j, k) : cell;
                room[r] += (share - taken) * cell;
                taken = share;
            }
        }
    }
    void add_place(std::int64_t i, std::int64_t j, std::int64_t k, std::span<Count> counts) const {
        const int region = region_of(regions, lattice, up, i, j, k);
        const Vec3 x = lattice.place(i, j, k);
        if (region < 0 || solids.are_near(x, distance)) {
            return;
        }
        Count& count = counts[at(region)];
        const double below = (regions[at(region)].surface - dot(up, x)) / lattice.spacing + 0.5;
        count.places += 1;
        count.top += below >= 1 - lattice_slack && below < 2 - lattice_slack ? 1 : 0;
    }
};

/// Sums over the lattice what add(i, j, k, sums) adds for every region, row by row, so that threads change no bit.
template <class Sum, class Add>
std::vector<Sum> sum_over(const Lattice& lattice, std::size_t regions, const Add& add) {
    std::vector<Sum> of_rows(at(lattice.rows()) * regions);
    parallel::for_each_uneven(lattice.rows(), 4, [&](std::int64_t row) {
        for (std::int64_t i = 0; i < lattice.counts[0]; ++i) {
            add(i, row % lattice.counts[1], row / lattice.counts[1],
                std::span<Sum>(&of_rows[at(row) * regions], regions));
        }
    });
    std::vector<Sum> sums(regions);
    for (std::size_t n = 0; n < of_rows.size(); ++n) {
        sums[n % regions] += of_rows[n];
    }
    return sums;
}

/// Room of every region below its surface [cells].
std::vector<double> measure_room(const Survey& survey) {
    return sum_over<double>(
        survey.lattice, survey.regions.size(),
        [&](std::int64_t i, std::int64_t j, std::int64_t k, auto sums) { survey.add_room(i, j, k, sums); });
}

std::vector<Count> count_places(const Survey& survey) {
    return sum_over<Count>(
        survey.lattice, survey.regions.size(),
        [&](std::int64_t i, std::int64_t j, std::int64_t k, auto sums) { survey.add_place(i, j, k, sums); });
}

}  // namespace

CellPoints::CellPoints(const FillSolids& solids, const Lattice& lattice, int dimension, std::int64_t i, std::int64_t j,
                       std::int64_t k)
    : across(dimension == 3 ? 4 : 8), deep(dimension == 3 ? 4 : 1) {
    const Vec3 shift{shift_of(i, j, k, 0), shift_of(i, j, k, 1), shift_of(i, j, k, 2)};
    const auto offset = [&](int n, int axis) { return ((n + shift[axis]) / across - 0.5) * lattice.spacing; };
    std::size_t n = 0;
    for (int c = 0; c < deep; ++c) {
        for (int b = 0; b < across; ++b) {
            for (int a = 0; a < across; ++a, ++n) {
                point[n] = lattice.place(i, j, k) + Vec3{offset(a, 0), offset(b, 1), dimension == 3 ? offset(c, 2) : 0};
                is_free[n] = !solids.contain(point[n]);
            }
        }
    }
}

double CellPoints::free_share() const { return static_cast<double>(std::ranges::count(is_free, true)) / 64.0; }

double CellPoints::share_about(const Vec3& place) const {
    std::array<bool, 64> is_open = is_free;
    std::vector<int> joined;
    double least = std::numeric_limits<double>::infinity();
    for (int n = 0; n < 64; ++n) {
        if (const double squared = norm_squared(point[at(n)] - place); is_free[at(n)] && squared < least) {
            least = squared;
            joined = {n};
        }
    }
    for (std::size_t next = 0; next < joined.size(); ++next) {
        const int n = joined[next], a = n % across, b = n / across % across, c = n / (across * across);
        is_open[at(n)] = false;
        const auto join = [&](int to, bool is_within) {
            if (is_within && is_open[at(to)]) {
                is_open[at(to)] = false;
                joined.push_back(to);
            }
        };
        join(n - 1, a > 0);
        join(n + 1, a + 1 < across);
        join(n - across, b > 0);
        join(n + across, b + 1 < across);
        join(n - across * across, c > 0);
        join(n + across * across, c + 1 < deep);
    }
    return static_cast<double>(joined.size()) / 64.0;
}

bool raise_to_volume(std::span<RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                     const FillSolids& solids, const Vec3& up, double distance, std::span<FillReport> reports) {
    const double dp = settings.spacing;
    const int dimension = settings.domain.dimension;
    const auto survey_with = [&](const auto& ask) {
        const Lattice lattice = lattice_over(regions, settings, corner, up);
        return ask(Survey{regions, lattice, solids, up, distance, dimension});
    };
    const std::vector<double> wanted = survey_with(measure_room);
    std::vector<double> raised(regions.size(), 0), best = raised, least(regions.size(), 1e300);
    const auto move_to = [&](std::size_t r, double height) {
        raise_surface(regions[r], up, (height - raised[r]) * dp, dp);
        raised[r] = height;
    };
    for (int n = 0; n <= corrections; ++n) {
        const std::vector<Count> counts = survey_with(count_places);
        bool moves = false;
        for (std::size_t r = 0; r < regions.size(); ++r) {
            const double missing = wanted[r] - counts[r].places;
            if (std::abs(missing) < least[r]) {
                least[r] = std::abs(missing);
                best[r] = raised[r];
            }
            const bool is_open = std::abs(missing) > 0.5 + lattice_slack && counts[r].top >= 1;
            const double target = is_open ? std::clamp(raised[r] + missing / counts[r].top, -1.0, 1.0) : raised[r];
            if (target != raised[r] && n < corrections) {
                move_to(r, target);
                moves = true;
            }
        }
        if (!moves) {
            break;
        }
    }
    bool has_moved = false;
    for (std::size_t r = 0; r < regions.size(); ++r) {
        move_to(r, best[r]);
        reports[r].room = wanted[r] * std::pow(dp, dimension);
        has_moved = has_moved || best[r] != 0;
    }
    return has_moved;
}

void measure_rooms(std::span<const RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                   const FillSolids& solids, const Vec3& up, double distance, std::span<FillReport> reports) {
    const Lattice lattice = lattice_over(regions, settings, corner, up);
    const int dimension = settings.domain.dimension;
    const std::vector<double> rooms = measure_room(Survey{regions, lattice, solids, up, distance, dimension});
    for (std::size_t r = 0; r < regions.size(); ++r) {
        reports[r].room = rooms[r] * std::pow(settings.spacing, dimension);
    }
}

}  // namespace riprap::coupling

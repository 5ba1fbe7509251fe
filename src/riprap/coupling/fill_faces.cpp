// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill_faces.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/coupling/fill_level.hpp"
#include "riprap/coupling/pack.hpp"
#include "riprap/coupling/zone.hpp"

namespace riprap::coupling {

namespace {

/// Spacings: boundary particles of thinner walls do not hold an even count, and the water is left on the lattice there.
constexpr double thinnest = 1;

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

}  // namespace

CutCells::CutCells(const Lattice& lattice, std::span<const RegionPlanes> regions, const FillSolids& solids,
                   const fluid::ParticleSettings& settings, const Vec3& up, double distance)
    : lattice_(lattice),
      wide_(lattice),
      regions_(regions),
      solids_(&solids),
      settings_(&settings),
      up_(up),
      distance_(distance) {
    const double dp = settings.spacing;
    // Water at its rim feels one support, what it feels is counted within another one.
    const auto margin = static_cast<std::int64_t>(std::ceil(3 * settings.support_radius() / dp)) + 1;
    for (int axis = 0; axis < settings.domain.dimension; ++axis) {
        const bool repeats = settings.domain.is_periodic[at(axis)];
        const double low = settings.domain.low[axis], high = settings.domain.high[axis];
        const auto to_low = static_cast<std::int64_t>(std::floor((lattice.first[axis] - low) / dp + lattice_slack));
        before_[at(axis)] = repeats ? to_low : margin;
        wide_.counts[at(axis)] =
            repeats ? static_cast<std::int64_t>(std::round((high - low) / dp)) : lattice.counts[at(axis)] + 2 * margin;
        wide_.first[axis] -= static_cast<double>(before_[at(axis)]) * dp;
    }
    find_cells();
    has_faces_ = !empty();
    if (has_faces_) {
        fill_cells();
    } else {
        cells_.clear();
        find_surface();
    }
}

std::array<std::int64_t, 3> CutCells::rim() const {
    std::array<std::int64_t, 3> rim{};
    for (int axis = 0; axis < 3 && has_faces_; ++axis) {
        rim[at(axis)] = before_[at(axis)] > 0 && !settings_->domain.is_periodic[at(axis)] ? 1 : 0;
    }
    return rim;
}

const CutCell* CutCells::in_row(std::int64_t row, std::int64_t i) const {
    const auto first = cells_.begin() + row_begin_[at(row)], last = cells_.begin() + row_begin_[at(row + 1)];
    const auto found =
        std::lower_bound(first, last, i, [](const CutCell& cut, std::int64_t n) { return cut.cell[0] < n; });
    return found != last && found->cell[0] == i ? &*found : nullptr;
}

const CutCell* CutCells::find(std::int64_t i, std::int64_t j, std::int64_t k) const {
    const std::int64_t b = j + before_[1], c = k + before_[2];
    const bool is_within = b >= 0 && c >= 0 && b < wide_.counts[1] && c < wide_.counts[2];
    return !has_faces_ || !is_within ? nullptr : in_row(c * wide_.counts[1] + b, i);
}

bool CutCells::is_open(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return !solids_->are_near(lattice_.place(i, j, k), distance_);
}

bool CutCells::is_reached(std::int64_t i, std::int64_t j, std::int64_t k) const {
    if (is_open(i, j, k)) {
        return true;
    }
    for (const std::int64_t step : {-1, 1}) {
        if (is_open(i + step, j, k) || is_open(i, j + step, k) ||
            (settings_->domain.dimension == 3 && is_open(i, j, k + step))) {
            return true;
        }
    }
    return false;
}

/// Gives a cell the place of its particle. False where solids leave none.
bool CutCells::place(CutCell& cut) const {
    constexpr int faces = 3;  // that may meet in a corner
    Vec3 x = lattice_.place(cut.cell[0], cut.cell[1], cut.cell[2]);
    const double z = x.z;
    for (int n = 0; n < faces && solids_->are_near(x, distance_); ++n) {
        x = solids_->push_out(x, distance_ + lattice_slack * lattice_.spacing);
        x.z = settings_->domain.dimension == 2 ? z : x.z;
    }
    cut.place = x;
    return !solids_->are_near(x, distance_);
}

void CutCells::find_cells() {
    const double half_diagonal = 0.5 * std::sqrt(static_cast<double>(settings_->domain.dimension)) * wide_.spacing;
    std::vector<std::vector<CutCell>> rows(at(wide_.rows()));
    parallel::for_each_uneven(wide_.rows(), 4, [&](std::int64_t row) {
        const std::int64_t j = row % wide_.counts[1] - before_[1], k = row / wide_.counts[1] - before_[2];
        for (std::int64_t i = -before_[0]; i < wide_.counts[0] - before_[0]; ++i) {
            const Vec3 middle = lattice_.place(i, j, k);
            if (!solids_->are_near(middle, half_diagonal) ||
                solids_->thin_are_near(middle, half_diagonal, thinnest * wide_.spacing)) {
                continue;
            }
            const CellPoints points(*solids_, lattice_, settings_->domain.dimension, i, j, k);
            CutCell cut{{i, j, k}, points.free_share(), -1, false, {}};
            if (cut.share > 0 && cut.share < 1 && is_reached(i, j, k) && place(cut)) {
                cut.share = points.share_about(cut.place);
                const bool is_within = settings_->domain.admits(cut.place);
                cut.region = is_within ? region_beside(regions_, lattice_, up_, i, j, k, cut.place) : -1;
                rows[at(row)].push_back(cut);
            }
        }
    });
    row_begin_.push_back(0);
    for (const auto& row : rows) {
        cells_.insert(cells_.end(), row.begin(), row.end());
        row_begin_.push_back(static_cast<std::int64_t>(cells_.size()));
    }
    for (const CutCell& cut : cells_) {
        const auto& [i, j, k] = cut.cell;
        if (cut.region >= 0) {
            misfits_.push_back(lattice_.place(i, j, k));
        }
    }
}

void CutCells::fill_cells() {
    std::vector<double> wanted;
    wanted.reserve(cells_.size());
    for (const CutCell& cut : cells_) {
        wanted.push_back(cut.share);
    }
    for (std::size_t n = 0; n < cells_.size(); ++n) {
        CutCell& cut = cells_[n];
        cut.is_filled = wanted[n] >= 0.5;
        const double left = wanted[n] - (cut.is_filled ? 1 : 0);
        const auto is_like = [&](const CutCell& other) { return (other.region < 0) == (cut.region < 0); };
        std::array<std::size_t, 13> after{};  // the half of its neighbours that follow
        std::size_t count = 0;
        const auto& [i, j, k] = cut.cell;
        for (int step = 14; step < 27; ++step) {
            const CutCell* const next = find(i + step % 3 - 1, j + step / 3 % 3 - 1, k + step / 9 - 1);
            if (next != nullptr && is_like(*next)) {
                after[count++] = static_cast<std::size_t>(next - cells_.data());
            }
        }
        for (std::size_t next = n + 1; count == 0 && next < cells_.size(); ++next) {
            if (is_like(cells_[next])) {
                after[count++] = next;
            }
        }
        for (std::size_t a = 0; a < count; ++a) {
            wanted[after[a]] += left / static_cast<double>(count);
        }
    }
}

/// The share of a cell of a last layer that lies below the surface, where that is part of it and a place for water; 1
/// in whole cells of water and 0 in all others.
double CutCells::below_surface(std::int64_t i, std::int64_t j, std::int64_t k) const {
    double share = 0;
    for (const RegionPlanes& region : regions_) {
        share = std::max(share, share_of(region, lattice_, up_, i, j, k));
    }
    return share > 0 && find(i, j, k) == nullptr && is_open(i, j, k) ? share : 0;
}

/// Finds how far the air of a cell stands below it, so that air begins at the surface beneath [spacings]; 1 in the last
/// layer of water itself, 0 where that is whole, and in scenes that faces cut.
double CutCells::sunk(std::int64_t i, std::int64_t j, std::int64_t k) const {
    const auto layers = static_cast<std::int64_t>(std::ceil(3 * settings_->support_radius() / lattice_.spacing)) + 5;
    const std::array<std::int64_t, 3> down{std::lround(-up_.x), std::lround(-up_.y), std::lround(-up_.z)};
    for (std::int64_t n = 0;
         !has_faces_ && n <= layers && std::abs(down[0]) + std::abs(down[1]) + std::abs(down[2]) == 1; ++n) {
        if (const double share = below_surface(i + n * down[0], j + n * down[1], k + n * down[2]); share > 0) {
            return share < 1 ? (n > 0 ? 1 - share : 1) : 0;
        }
    }
    return 0;
}

/// Adds the cells that the surface cuts, unless thin walls are near: a region on top of another, which goes on where
/// that ends, is no surface.
void CutCells::find_surface() {
    const std::array<std::int64_t, 3> up{std::lround(up_.x), std::lround(up_.y), std::lround(up_.z)};
    std::vector<std::vector<Vec3>> rows(at(lattice_.rows()));
    parallel::for_each_uneven(lattice_.rows(), 4, [&](std::int64_t row) {
        const std::int64_t j = row % lattice_.counts[1], k = row / lattice_.counts[1];
        for (std::int64_t i = 0; i < lattice_.counts[0]; ++i) {
            const double share = below_surface(i, j, k);
            if (share > 0 && share < 1 && below_surface(i + up[0], j + up[1], k + up[2]) == 0) {
                rows[at(row)].push_back(lattice_.place(i, j, k));
            }
        }
    });
    for (const auto& row : rows) {
        misfits_.insert(misfits_.end(), row.begin(), row.end());
    }
    const auto is_beside_thin = [&](const Vec3& middle) {
        return solids_->thin_are_near(middle, packed_depth(*settings_), thinnest * lattice_.spacing);
    };
    if (std::ranges::any_of(misfits_, is_beside_thin)) {
        misfits_.clear();
    }
}

std::vector<Vec3> CutCells::air(double reach) const {
    const Zone zone(misfits_, settings_->domain, reach);
    std::vector<std::vector<Vec3>> rows(at(wide_.rows()));
    parallel::for_each_uneven(wide_.rows(), 4, [&](std::int64_t row) {
        const std::int64_t j = row % wide_.counts[1] - before_[1], k = row / wide_.counts[1] - before_[2];
        for (std::int64_t i = -before_[0]; i < wide_.counts[0] - before_[0]; ++i) {
            if (!zone.holds(lattice_.place(i, j, k))) {
                continue;
            }
            if (const CutCell* cut = has_faces_ ? in_row(row, i) : nullptr) {
                if (cut->is_filled && cut->region < 0) {
                    rows[at(row)].push_back(cut->place);
                }
            } else if (region_of(regions_, lattice_, up_, i, j, k) < 0 && is_open(i, j, k)) {
                if (const double down = sunk(i, j, k); down < 1) {
                    rows[at(row)].push_back(lattice_.place(i, j, k) - down * lattice_.spacing * up_);
                }
            }
        }
    });
    std::vector<Vec3> places;
    for (const auto& row : rows) {
        places.insert(places.end(), row.begin(), row.end());
    }
    return places;
}

}  // namespace riprap::coupling

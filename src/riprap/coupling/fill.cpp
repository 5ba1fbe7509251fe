// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/fill_faces.hpp"
#include "riprap/coupling/fill_lattice.hpp"
#include "riprap/coupling/fill_level.hpp"
#include "riprap/coupling/fill_solids.hpp"
#include "riprap/coupling/pack.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::coupling {

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Spacings to a face, at least. Water comes to stand at half a spacing; of a face that the lattice does not follow
/// half a spacing would leave out half a layer, and what then sinks stirs the rest. Nearer than a fifth the guard
/// pushes.
constexpr double nearest = 0.25;

/// Makes room for all particles and puts those of each row where it begins.
/// @param visit_row  (row, put): calls put(place, region) for each particle of a row
template <class VisitRow>
void place_particles(Filling& filling, const std::vector<std::int64_t>& begin, const fluid::ParticleSettings& settings,
                     std::span<const FillRegion> regions, const VisitRow& visit_row) {
    fluid::ParticleState& particles = filling.particles;
    const auto count = at(begin.back());
    particles.position.resize(count);
    particles.velocity.resize(count);
    particles.density.assign(count, settings.rest_density);
    particles.dilution.assign(count, 0);
    particles.id.resize(count);
    filling.region.resize(count);
    parallel::for_each_uneven(static_cast<std::int64_t>(begin.size()) - 1, 4, [&](std::int64_t line) {
        std::int64_t next = begin[at(line)];
        visit_row(line, [&](const Vec3& x, int region) {
            particles.position[at(next)] = x;
            particles.velocity[at(next)] = regions[at(region)].velocity;
            particles.id[at(next)] = static_cast<std::int32_t>(next);
            filling.region[at(next)] = static_cast<std::int8_t>(region);
            ++next;
        });
    });
    const double cell = std::pow(settings.spacing, settings.domain.dimension);
    for (const std::int8_t region : filling.region) {
        filling.regions[at(region)].count += 1;
        filling.regions[at(region)].volume += cell;
    }
}

/// Cells of the lattice, and of its rim that water reaches, with the particles that they have.
struct Cells {
    std::span<const RegionPlanes> regions;
    const Lattice& lattice;
    const FillSolids& solids;
    Vec3 up;
    double distance;
    const CutCells& cut;

    std::array<std::int64_t, 3> rim() const { return cut.rim(); }
    std::int64_t row_length() const { return lattice.counts[0] + 2 * rim()[0]; }
    std::int64_t rows() const { return (lattice.counts[1] + 2 * rim()[1]) * (lattice.counts[2] + 2 * rim()[2]); }
    /// put(place, region) for the particle of the cell of that number in a row, where it has one.
    template <class Put>
    void visit(std::int64_t number, std::int64_t row, const Put& put) const {
        const auto [before, under, behind] = rim();
        const std::int64_t across = lattice.counts[1] + 2 * under;
        const std::int64_t i = number - before, j = row % across - under, k = row / across - behind;
        if (const CutCell* const cell = cut.find(i, j, k)) {
            if (cell->is_filled && cell->region >= 0) {
                put(cell->place, cell->region);
            }
            return;
        }
        const int region = region_of(regions, lattice, up, i, j, k);
        if (region >= 0 && !solids.are_near(lattice.place(i, j, k), distance)) {
            put(lattice.place(i, j, k), region);
        }
    }
};

[[noreturn]] void refuse(std::string message, std::string allowed) {
    throw CaseError(Diagnostic{{}, std::move(message), std::move(allowed)});
}

/// Where the particles of each row begin, and after them all.
std::vector<std::int64_t> count_rows(const Cells& cells, const FillLimit& limit) {
    const Lattice& lattice = cells.lattice;
    const double places = static_cast<double>(lattice.counts[0]) * static_cast<double>(lattice.counts[1]) *
                          static_cast<double>(lattice.counts[2]);
    if (places > 64.0 * static_cast<double>(limit.most)) {
        refuse(fmt::format("the regions of water span about {:.3g} places of the lattice", places),
               fmt::format("particles are at most {}: use a larger spacing or tighter regions", limit.most));
    }
    std::vector<std::int64_t> begin(at(cells.rows() + 1), 0);
    constexpr double stretch = 1 << 22;  // places between two looks at the limit: a slip in the spacing is told soon
    const double row_places = static_cast<double>(std::max<std::int64_t>(1, lattice.counts[0]));
    const std::int64_t rows_at_once = static_cast<std::int64_t>(stretch / row_places) + 1;
    for (std::int64_t first = 0, counted = 0; first < cells.rows(); first += rows_at_once) {
        const std::int64_t past = std::min(cells.rows(), first + rows_at_once);
        parallel::for_each_uneven(past - first, 4, [&](std::int64_t nth) {
            for (std::int64_t i = 0; i < cells.row_length(); ++i) {
                cells.visit(i, first + nth, [&](const Vec3&, int) { begin[at(first + nth)] += 1; });
            }
        });
        counted = std::accumulate(begin.begin() + first, begin.begin() + past, counted);
        if (counted > limit.most) {
            refuse(fmt::format("the regions of water hold more than {} particles of {:.3g} places of the lattice",
                               limit.most, places),
                   fmt::format("at most {}: use a larger spacing", limit.most));
        }
    }
    const std::int64_t count = parallel::exclusive_scan<std::int64_t>(begin, begin);
    if (const std::int64_t most = std::min(limit.most, limit.fitting); count > most) {
        refuse(fmt::format("the regions of water hold {} particles", count),
               fmt::format("at most {}{}: use a larger spacing", most, limit.fitting < limit.most ? limit.reason : ""));
    }
    return begin;
}

}  // namespace

double face_distance(const fluid::ParticleSettings& settings) { return (nearest - lattice_slack) * settings.spacing; }

Filling fill(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
             const fluid::ParticleSettings& settings, const Vec3& up, std::span<const FillRegion> regions,
             const FillLimit& limit, FillFaces faces) {
    Filling filling;
    filling.regions.resize(regions.size());
    std::vector<RegionPlanes> cut;
    for (std::size_t r = 0; r < regions.size(); ++r) {
        cut.push_back(planes_of(regions[r], settings, up, filling.regions[r]));
    }
    if (cut.empty()) {
        return filling;
    }
    filling.lattice_corner = lattice_corner(cut, settings.domain);
    const FillSolids solids(shapes, bodies, initial, settings.domain, settings.spacing);
    const double distance = face_distance(settings);
    Lattice lattice = lattice_over(cut, settings, filling.lattice_corner, up);
    CutCells at_faces;
    const Cells cells{cut, lattice, solids, up, distance, at_faces};
    std::vector<std::int64_t> begin = count_rows(cells, limit);
    if (faces == FillFaces::fitted) {
        at_faces = CutCells(lattice, cut, solids, settings, up, distance);
    }
    if (at_faces.has_faces()) {
        begin = count_rows(cells, limit);
        measure_rooms(cut, settings, filling.lattice_corner, solids, up, distance, filling.regions);
    } else if (raise_to_volume(cut, settings, filling.lattice_corner, solids, up, distance, filling.regions)) {
        lattice = lattice_over(cut, settings, filling.lattice_corner, up);
        begin = count_rows(cells, limit);
        if (faces == FillFaces::fitted) {
            at_faces = CutCells(lattice, cut, solids, settings, up, distance);
        }
    }
    if (!at_faces.empty()) {
        filling.misfits.assign(at_faces.misfits().begin(), at_faces.misfits().end());
        filling.air = at_faces.air(packed_depth(settings) + 2 * settings.support_radius());
    }
    place_particles(filling, begin, settings, regions, [&](std::int64_t row, const auto& put) {
        for (std::int64_t i = 0; i < cells.row_length(); ++i) {
            cells.visit(i, row, put);
        }
    });
    return filling;
}

void set_hydrostatic_density(Filling& filling, const fluid::ParticleSettings& settings, const Vec3& gravity) {
    const double strength = norm(gravity);
    for (std::size_t i = 0; i < filling.region.size() && strength > 0; ++i) {
        const double height = -dot(gravity, filling.particles.position[i]) / strength;
        const double depth = std::max(0.0, filling.regions[at(filling.region[i])].surface - height);
        filling.particles.density[i] = fluid::density_of(settings, settings.rest_density * strength * depth);
    }
}

}  // namespace riprap::coupling

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// A region of water at the start: convex pieces, and what is below a level.
struct FillRegion {
    std::vector<geometry::Polyhedron> pieces;               ///< world axes; empty = the whole domain [m]
    double level{std::numeric_limits<double>::infinity()};  ///< of the surface, along `up` [m]
    Vec3 velocity{};                                        ///< [m/s]
};

/// Result of filling a region.
struct FillReport {
    std::int64_t count{0};    ///< particles
    double volume{0};         ///< that they stand for [m^3]; in 2D [m^2]
    double region_volume{0};  ///< of the region below its level, solids not taken out [m^3]; in 2D [m^2]
    double room{0};     ///< the same outside of solids, but for gaps narrower than a particle needs [m^3]; in 2D [m^2]
    double surface{0};  ///< height of its free surface along `up` [m]
};

/// Largest number of particles.
struct FillLimit {
    std::int64_t most;     ///< in any case
    std::int64_t fitting;  ///< in the memory at hand; may be more
    std::string reason{};  ///< for the message, where fitting is less
};

/// Water at the start.
struct Filling {
    fluid::ParticleState particles;
    std::vector<std::int8_t> region;  ///< of each particle
    std::vector<FillReport> regions;  ///< one per region
    std::vector<Vec3> misfits;        ///< middles of cells of water that a face cuts; empty where the lattice fits [m]
    std::vector<Vec3> air;            ///< places of the lattice beside the water, near these cells [m]
    Vec3 lattice_corner{};  ///< low corner of a cell of the lattice; particles start in the middle of cells [m]
};

/// Places of particles beside faces that the lattice does not follow.
enum class FillFaces : std::uint8_t {
    lattice,  ///< those of the lattice that keep their distance
    fitted,   ///< as many as there is room for (fill_faces.hpp), to be packed (pack.hpp)
};

/// Height along `up` at which a region ends, whatever its level [m].
double top_of(const FillRegion& region, const fluid::Domain& domain, const Vec3& up);

/// Fills regions with particles on one lattice of spacing dp for all of them, so regions that touch or overlap join
/// without a seam; a place in several regions belongs to the first. The lattice starts half a spacing inside the low
/// corner of the first region. A place is filled when it lies in a region, half a spacing below its level at least,
/// outside every solid and no nearer than a quarter of a spacing to its faces: water never starts inside a solid. Dry
/// bodies count too. The last layer is raised by what is left out beside solids, so that the volume is that below the
/// level (fill_level.hpp). Particles get the ids 0, 1, ... along the lattice, x fastest.
///
/// With FillFaces::fitted cells that faces cut are filled by the share of them that is free, in place of a raised
/// layer; a scene in which no face cuts a cell of water has the same places either way.
///
/// Density is that of rest without pressure: see set_hydrostatic_density.
/// @param up     unit vector against gravity, along which levels count
/// Places are counted before memory is taken for them.
/// @param limit  of particles; regions are at most 127
/// @throws CaseError  with the cause when more than `limit` particles would be made, or when a period of the domain is
/// not a whole number of spacings
Filling fill(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
             const fluid::ParticleSettings& settings, const Vec3& up, std::span<const FillRegion> regions,
             const FillLimit& limit, FillFaces faces = FillFaces::lattice);

/// Gives every particle the density of rest under gravity g: p = rho_0 |g| d at depth d below the surface of its
/// region (its level or else its highest point), through the state equation of `settings`.
void set_hydrostatic_density(Filling& filling, const fluid::ParticleSettings& settings, const Vec3& gravity);

}  // namespace riprap::coupling

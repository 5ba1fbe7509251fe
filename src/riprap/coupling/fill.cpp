// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "riprap/body/ground.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/geometry/clip.hpp"
#include "riprap/geometry/convex_query.hpp"

namespace riprap::coupling {

using geometry::Plane;
using geometry::Polyhedron;

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Spacings to a face, at least. Water comes to stand at half a spacing; of a face that the lattice does not follow
/// half a spacing would leave out half a layer, and what then sinks stirs the rest. Nearer than a fifth the guard
/// pushes.
constexpr double nearest = 0.25;
constexpr double slack = 1e-6;        ///< of a spacing: a lattice that fits is not lost to round-off
constexpr double least_layer = 0.01;  ///< share of a cell below the level from which on it counts

struct Bounds {
    Vec3 low, high;
};

/// A region as planes: a place is inside when it is below all planes of one piece, and below the level.
struct RegionPlanes {
    std::vector<std::vector<Plane>> pieces;
    Bounds bounds;
    double surface;
};

Polyhedron slab_of(const fluid::Domain& domain) {
    Polyhedron box;
    const bool is_flat = domain.dimension == 2;
    const double low = is_flat ? -0.5 : domain.low.z, high = is_flat ? 0.5 : domain.high.z;
    for (const double z : {low, high}) {
        for (const auto& [x, y] : {std::pair{domain.low.x, domain.low.y}, std::pair{domain.high.x, domain.low.y},
                                   std::pair{domain.high.x, domain.high.y}, std::pair{domain.low.x, domain.high.y}}) {
            box.vertices.push_back({x, y, z});
        }
    }
    box.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return box;
}

/// The pieces of a region: the whole domain where it names none.
std::vector<Polyhedron> pieces_of(const FillRegion& region, const fluid::Domain& domain) {
    return region.pieces.empty() ? std::vector<Polyhedron>{slab_of(domain)} : region.pieces;
}

/// The region cut at its level, with its volume and surface.
RegionPlanes planes_of(const FillRegion& region, const fluid::ParticleSettings& settings, const Vec3& up,
                       FillReport& report) {
    RegionPlanes result{{}, {{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}}, -1e300};
    for (const Polyhedron& whole : pieces_of(region, settings.domain)) {
        const Polyhedron piece = std::isfinite(region.level) ? geometry::clip_convex(whole, {up, region.level}) : whole;
        if (piece.faces.empty()) {
            continue;
        }
        const bool is_planar = settings.domain.dimension == 2;
        const geometry::Range z = geometry::range_along(piece, {0, 0, 1});
        report.region_volume += geometry::mass_properties(piece).volume / (is_planar ? z.high - z.low : 1);
        result.surface = std::max(result.surface, geometry::range_along(piece, up).high);
        std::vector<Plane> planes;
        for (const auto& face : piece.faces) {
            const Plane plane = geometry::face_plane(piece.vertices, face);
            if (!(is_planar && std::abs(plane.normal.z) > 0.5)) {
                planes.push_back(plane);
            }
        }
        result.pieces.push_back(std::move(planes));
        for (const Vec3& x : piece.vertices) {
            result.bounds.low = min(result.bounds.low, x);
            result.bounds.high = max(result.bounds.high, x);
        }
    }
    report.surface = result.surface;
    return result;
}

/// The lattice that all regions share.
struct Lattice {
    Vec3 first;
    std::array<std::int64_t, 3> counts;
    double spacing;
    Vec3 place(std::int64_t i, std::int64_t j, std::int64_t k) const {
        return first + spacing * Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
    }
};

/// Where the lattice starts: at the low corner of the first region that has any extent, or else of the domain.
Vec3 lattice_corner(std::span<const RegionPlanes> regions, const fluid::Domain& domain) {
    const auto has_extent = [](const RegionPlanes& region) { return !region.pieces.empty(); };
    const auto first = std::find_if(regions.begin(), regions.end(), has_extent);
    return first != regions.end() ? first->bounds.low : domain.low;
}

[[noreturn]] void refuse(std::string message, std::string allowed) {
    throw CaseError(Diagnostic{{}, std::move(message), std::move(allowed)});
}

Lattice lattice_over(std::span<const RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                     const Vec3& up) {
    const double dp = settings.spacing;
    Lattice lattice{{}, {1, 1, 1}, dp};
    Bounds all{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
    for (const RegionPlanes& region : regions) {
        all = {min(all.low, region.bounds.low), max(all.high, region.bounds.high)};
    }
    for (int axis = 0; axis < settings.domain.dimension; ++axis) {
        const double period = settings.domain.high[axis] - settings.domain.low[axis];
        if (settings.domain.is_periodic[at(axis)] && std::abs(period / dp - std::round(period / dp)) > slack) {
            refuse(fmt::format("the domain repeats every {:.9g} m along {}, which is {:.9g} spacings", period,
                               "xyz"[axis], period / dp),
                   "a whole number of spacings");
        }
        const double anchor = corner[axis] + 0.5 * dp;
        const double low = std::max(all.low[axis] - 0.5 * dp * std::max(0.0, -up[axis]), settings.domain.low[axis]);
        // The last layer along `up` may lie half a spacing above the level (region_of).
        const double high = std::min(all.high[axis] + 0.5 * dp * std::max(0.0, up[axis]), settings.domain.high[axis]);
        const double before = std::ceil((low - anchor) / dp - slack);
        lattice.first[axis] = anchor + before * dp;
        const double steps = std::floor((high - lattice.first[axis]) / dp + slack);
        constexpr double most = 1e9;  // beyond any limit of particles, and far from the end of the integers
        if (!(steps < most)) {
            refuse(fmt::format("water spans {:.3g} spacings of {:.3g} m along {}", (high - low) / dp, dp, "xyz"[axis]),
                   fmt::format("a spacing of which at most {:.0g} fit into the water", most));
        }
        lattice.counts[at(axis)] = static_cast<std::int64_t>(std::max(-1.0, steps)) + 1;
    }
    return lattice;
}

/// A number in [0, 1) for every column of the lattice, spread evenly over neighbouring ones (Kronecker's sequence of
/// the plastic number).
double turn_of(std::int64_t i, std::int64_t j) {
    constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
    const double sum = first * static_cast<double>(i) + second * static_cast<double>(j);
    return sum - std::floor(sum);
}

/// The first region that a place is in; -1 = none. Where the spacing does not divide the depth, the last layer, of
/// whose cells a share lies below the level, gets that share of its places, so that the volume is the one asked for.
/// @param turn  of its column
int region_of(std::span<const RegionPlanes> regions, const Vec3& x, const Vec3& up, double spacing, double turn) {
    const bool is_along_axis = std::max({std::abs(up.x), std::abs(up.y), std::abs(up.z)}) > 1 - 1e-9;
    for (std::size_t r = 0; r < regions.size(); ++r) {
        const double below = (regions[r].surface - dot(up, x)) / spacing + 0.5;  // share of the cell; 1 and more: all
        const bool is_last = below < 1 - slack;
        if (is_last && !(is_along_axis && below > least_layer && turn < below)) {
            continue;
        }
        for (const auto& planes : regions[r].pieces) {
            // A last layer alone would be a film; it lies on a whole one.
            const Vec3 place = is_last ? x - spacing * up : x;
            const bool is_inside = std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
                const bool is_level = is_last && dot(plane.normal, up) > 1 - 1e-9;
                return is_level || (dot(plane.normal, x) <= plane.offset - slack * spacing &&
                                    dot(plane.normal, place) <= plane.offset - slack * spacing);
            });
            if (is_inside) {
                return static_cast<int>(r);
            }
        }
    }
    return -1;
}

/// Keeps places out of solids and a distance away from their faces.
class Solids {
 public:
    Solids(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
           double keep_away)
        : grounds_(body::find_grounds(bodies, shapes)), keep_away_(keep_away) {
        std::vector<std::uint8_t> is_ground(at(bodies.size()), 0);
        for (const body::Ground& ground : grounds_) {
            const auto b = at(ground.body.value);
            is_ground[b] = 1;
            poses_.push_back({state.position[b], state.orientation[b]});
        }
        for (const body::Part& part : bodies.parts) {
            const auto b = at(part.body.value);
            if (is_ground[b] != 0) {
                continue;
            }
            const Pose pose{state.position[b], state.orientation[b]};
            const geometry::ConvexView view = shapes.view(part.shape);
            parts_.push_back({view,
                              {to_world(pose, part.local.position), pose.orientation * part.local.orientation},
                              view.circumradius + keep_away});
        }
    }
    bool touch(const Vec3& x) const {
        for (std::size_t g = 0; g < grounds_.size(); ++g) {
            const Vec3 local = to_body(poses_[g], x);
            if (grounds_[g].field.is_inside(local) || grounds_[g].field.nearest(local, keep_away_)) {
                return true;
            }
        }
        return std::any_of(parts_.begin(), parts_.end(), [&](const Placed& part) {
            if (norm_squared(x - part.pose.position) > part.reach * part.reach) {
                return false;
            }
            const Vec3 local = to_body(part.pose, x);
            return geometry::depth_below_faces(part.shape, local) > -keep_away_ &&
                   geometry::closest_surface_point(part.shape, local).distance < keep_away_;
        });
    }

 private:
    struct Placed {
        geometry::ConvexView shape;
        Pose pose;
        double reach;
    };
    std::vector<Placed> parts_;
    std::vector<body::Ground> grounds_;
    std::vector<Pose> poses_;  ///< of the grounds
    double keep_away_;
};

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

}  // namespace

double top_of(const FillRegion& region, const fluid::Domain& domain, const Vec3& up) {
    double top = -std::numeric_limits<double>::infinity();
    for (const Polyhedron& piece : pieces_of(region, domain)) {
        top = std::max(top, geometry::range_along(piece, up).high);
    }
    return top;
}

Filling fill(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
             const fluid::ParticleSettings& settings, const Vec3& up, std::span<const FillRegion> regions,
             const FillLimit& limit) {
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
    const Lattice lattice = lattice_over(cut, settings, filling.lattice_corner, up);
    double places = 1;
    for (const std::int64_t count : lattice.counts) {
        places *= static_cast<double>(count);
    }
    if (places > 64.0 * static_cast<double>(limit.most)) {
        refuse(fmt::format("the regions of water span about {:.3g} places of the lattice", places),
               fmt::format("particles are at most {}: use a larger spacing or tighter regions", limit.most));
    }

    const Solids solids(shapes, bodies, initial, (nearest - slack) * settings.spacing);
    const std::int64_t rows = lattice.counts[1] * lattice.counts[2];
    const auto row = [&lattice](std::int64_t line) {
        return std::pair{line % lattice.counts[1], line / lattice.counts[1]};
    };
    const int up_axis = std::abs(up.x) > 0.5 ? 0 : std::abs(up.y) > 0.5 ? 1 : 2;
    const auto owner_of = [&](const Vec3& x, std::int64_t i, std::int64_t j, std::int64_t k) {
        const double turn = up_axis == 0 ? turn_of(j, k) : up_axis == 1 ? turn_of(i, k) : turn_of(i, j);
        const int region = region_of(cut, x, up, settings.spacing, turn);
        return region < 0 || solids.touch(x) ? -1 : region;
    };
    std::vector<std::int64_t> begin(at(rows + 1), 0);  // of each row among the particles
    constexpr double stretch = 1 << 22;  // places between two looks at the limit: a slip in the spacing is told soon
    const double row_places = static_cast<double>(std::max<std::int64_t>(1, lattice.counts[0]));
    const std::int64_t rows_at_once = static_cast<std::int64_t>(stretch / row_places) + 1;
    for (std::int64_t first = 0, counted = 0; first < rows; first += rows_at_once) {
        const std::int64_t past = std::min(rows, first + rows_at_once);
        parallel::for_each_uneven(past - first, 4, [&](std::int64_t nth) {
            const std::int64_t line = first + nth;
            const auto [j, k] = row(line);
            for (std::int64_t i = 0; i < lattice.counts[0]; ++i) {
                begin[at(line)] += owner_of(lattice.place(i, j, k), i, j, k) < 0 ? 0 : 1;
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
    place_particles(filling, begin, settings, regions, [&](std::int64_t line, const auto& put) {
        const auto [j, k] = row(line);
        for (std::int64_t i = 0; i < lattice.counts[0]; ++i) {
            const Vec3 x = lattice.place(i, j, k);
            if (const int region = owner_of(x, i, j, k); region >= 0) {
                put(x, region);
            }
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

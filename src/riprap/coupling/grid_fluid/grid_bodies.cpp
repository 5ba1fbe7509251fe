// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/grid_fluid/grid_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "riprap/coupling/grid_fluid/carried_water.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;

/// Returns the part of a half-space in the domain and a cell around it; empty where there is none.
geometry::Polyhedron fill_half_space(const GridFluidSettings& settings, const Vec3& normal, double offset) {
    const fluid::grid::Mesh& mesh = settings.grid.mesh;
    Vec3 low{}, high{};
    for (int a = 0; a < 3; ++a) {
        const auto& edge = mesh.edge[at(a)];
        const double beyond = a < mesh.box.axes ? settings.stretch[a] * settings.spacing : 0;
        low[a] = edge.front() - beyond;
        high[a] = edge.back() + beyond;
    }
    const auto whole = geometry::moved(geometry::box(high - low), Pose{(low + high) * 0.5, Quat{}});
    return geometry::clip_convex(whole, {normal, offset});
}

bool is_half_space(const FluidScene& scene, std::size_t b) {
    return scene.bodies.part_begin[b + 1] > scene.bodies.part_begin[b] &&
           scene.shapes.is_half_space(scene.bodies.parts[at(scene.bodies.part_begin[b])].shape);
}

}  // namespace

std::vector<std::vector<geometry::Polyhedron>> body_shapes(const FluidScene& scene, const GridFluidSettings& settings) {
    std::vector<std::vector<geometry::Polyhedron>> shapes(at(scene.bodies.size()));
    for (std::size_t b = 0; b < shapes.size(); ++b) {
        if (settings.is_dry(b) || is_half_space(scene, b)) {
            continue;
        }
        for (std::int32_t p = scene.bodies.part_begin[b]; p < scene.bodies.part_begin[b + 1]; ++p) {
            const body::Part& part = scene.bodies.parts[at(p)];
            shapes[b].push_back(geometry::moved(scene.shapes.polyhedron(part.shape), part.local));
        }
    }
    return shapes;
}

std::vector<std::uint8_t> still_bodies(const FluidScene& scene, const GridFluidSettings& settings) {
    std::vector<std::uint8_t> still(at(scene.bodies.size()));
    for (std::size_t b = 0; b < still.size(); ++b) {
        still[b] = settings.is_dry(b) || settings.coupling == GridCoupling::one_way ||
                           (scene.bodies.drive[b] == body::Drive::fixed && std::isinf(scene.bodies.release_time[b]))
                       ? 1
                       : 0;
    }
    return still;
}

body::Motion cut_motion(const GridFluidFields& fields) {
    body::Motion motion;
    for (std::size_t b = 0; b < fields.cut_position.size(); ++b) {
        motion.pose.push_back({fields.cut_position[b], fields.cut_orientation[b]});
    }
    const std::vector<Vec3> rest(motion.pose.size());
    motion.velocity = motion.angular_velocity = motion.acceleration = motion.angular_acceleration = rest;
    motion.stretch = fields.cut_stretch;
    motion.stretch_rate.assign(motion.stretch.size(), {});
    return motion;
}

void set_velocities(const body::Motion& motion, double ahead, std::vector<GridBody>& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        bodies[b].velocity = motion.velocity[b] + ahead * motion.acceleration[b];
        bodies[b].angular_velocity = motion.angular_velocity[b] + ahead * motion.angular_acceleration[b];
    }
}

void place_bodies(const FluidScene& scene, const GridFluidSettings& settings,
                  const std::vector<std::vector<geometry::Polyhedron>>& shapes, const body::Motion& motion,
                  double ahead, bool all, std::vector<GridBody>& bodies) {
    bodies.resize(shapes.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const bool stays = scene.bodies.drive[b] == body::Drive::fixed && std::isinf(scene.bodies.release_time[b]);
        if (settings.is_dry(b) || (stays && !all)) {
            continue;
        }
        GridBody& body = bodies[b];
        body.centre = motion.pose[b].position;
        body.parts = shapes[b];
        for (geometry::Polyhedron& part : body.parts) {
            for (Vec3& x : part.vertices) {
                x = body.centre + arm_of(motion, b, x);
            }
        }
        if (is_half_space(scene, b)) {
            const geometry::ConvexView view =
                scene.shapes.view(scene.bodies.parts[at(scene.bodies.part_begin[b])].shape);
            const Vec3 normal = rotate(motion.pose[b].orientation, view.normal(0));
            auto filled = fill_half_space(settings, normal, view.offset[0] + dot(normal, body.centre));
            body.parts.clear();
            if (!filled.faces.empty()) {
                body.parts.push_back(std::move(filled));
            }
        }
    }
    if (settings.coupling == GridCoupling::two_way) {
        set_velocities(motion, ahead, bodies);
    }
}

CutBodies cut_again(const FluidScene& scene, const GridFluidSettings& settings, const GridFluidFields& fields) {
    std::vector<GridBody> bodies;
    place_bodies(scene, settings, body_shapes(scene, settings), cut_motion(fields), 0, true, bodies);
    return cut_bodies(settings.grid.mesh, bodies);
}

namespace {

double volume_of(const geometry::Polyhedron& piece) {
    return piece.faces.empty() ? 0 : geometry::mass_properties(piece).volume;
}

/// The part of a convex piece inside another convex polyhedron.
geometry::Polyhedron common(geometry::Polyhedron piece, const geometry::Polyhedron& other) {
    for (const auto& face : other.faces) {
        if (piece.faces.empty()) {
            break;
        }
        piece = geometry::clip_convex(piece, geometry::face_plane(other.vertices, face));
    }
    return piece;
}

bool meets(const geometry::Polyhedron& piece, const Vec3& low, const Vec3& high) {
    Vec3 least = piece.vertices.front(), most = least;
    for (const Vec3& x : piece.vertices) {
        least = min(least, x);
        most = max(most, x);
    }
    return least.x < high.x && least.y < high.y && least.z < high.z && most.x > low.x && most.y > low.y &&
           most.z > low.z;
}

/// Adds what of a convex piece lies outside of another, as convex pieces that do not overlap.
void add_outside(geometry::Polyhedron piece, const geometry::Polyhedron& other,
                 std::vector<geometry::Polyhedron>& outside) {
    for (const auto& face : other.faces) {
        geometry::CutPieces cut = geometry::cut_convex(piece, geometry::face_plane(other.vertices, face));
        if (!cut.above.faces.empty()) {
            outside.push_back(std::move(cut.above));
        }
        if (cut.below.faces.empty()) {
            return;
        }
        piece = std::move(cut.below);
    }
}

/// Takes out of pieces what earlier regions have filled: the first one counts where they overlap.
void take_out(const std::vector<geometry::Polyhedron>& filled, std::vector<geometry::Polyhedron>& pieces) {
    for (const geometry::Polyhedron& other : filled) {
        std::vector<geometry::Polyhedron> outside;
        for (geometry::Polyhedron& piece : pieces) {
            add_outside(std::move(piece), other, outside);
        }
        pieces = std::move(outside);
    }
}

/// Water of the regions in a cell, solids taken out where they cut it [m^3].
double water_in(const GridFluidSettings& settings, const std::vector<GridBody>& bodies, const Vec3& low,
                const Vec3& high, bool is_cut) {
    const auto cell = geometry::moved(geometry::box(high - low), Pose{(low + high) * 0.5, Quat{}});
    double sum = 0;
    std::vector<geometry::Polyhedron> filled;  // by the regions so far
    for (const FillRegion& region : settings.scene.regions) {
        std::vector<geometry::Polyhedron> wet;
        if (region.pieces.empty()) {
            wet.push_back(cell);
        }
        for (const geometry::Polyhedron& piece : region.pieces) {
            if (meets(piece, low, high)) {
                wet.push_back(common(cell, piece));
            }
        }
        for (geometry::Polyhedron& piece : wet) {
            if (!piece.faces.empty() && std::isfinite(region.level)) {
                piece = geometry::clip_convex(piece, {settings.scene.up, region.level});
            }
        }
        std::erase_if(wet, [](const geometry::Polyhedron& piece) { return piece.faces.empty(); });
        std::vector<geometry::Polyhedron> added = wet;
        take_out(filled, added);
        filled.insert(filled.end(), std::make_move_iterator(wet.begin()), std::make_move_iterator(wet.end()));
        for (const geometry::Polyhedron& piece : added) {
            sum += volume_of(piece);
            for (std::size_t b = 0; is_cut && b < bodies.size(); ++b) {
                for (const geometry::Polyhedron& part : bodies[b].parts) {
                    sum -= meets(part, low, high) ? volume_of(common(piece, part)) : 0;
                }
            }
        }
    }
    return sum;
}

/// Whether a wall splits a cell and closes one side of it: bodies and what is open do not make the whole cell.
bool is_split(const std::vector<GridBody>& bodies, const Vec3& low, const Vec3& high, double open_share) {
    constexpr double least_closed = 1e-4;
    const auto cell = geometry::moved(geometry::box(high - low), Pose{(low + high) * 0.5, Quat{}});
    const double whole = volume_of(cell);
    double room = whole;
    for (const GridBody& body : bodies) {
        for (const geometry::Polyhedron& part : body.parts) {
            room -= meets(part, low, high) ? volume_of(common(cell, part)) : 0;
        }
    }
    return room / whole - open_share > least_closed;
}

/// Mean of a field over the cells that open faces lead to, by the area of these; of the cell itself where there are
/// none.
double mean_beside(const fluid::grid::CellBox& box, const fluid::grid::OpenShares& open,
                   const std::vector<double>& field, const std::vector<std::uint8_t>& is_left_out, std::int64_t c) {
    double sum = 0, area = 0;
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t t = box.stride[at(a)];
        for (const auto& [face, beside] : {std::pair{c, c - t}, std::pair{c + t, c + t}}) {
            if (box.has_cell(beside) && open.volume[at(beside)] > 0 && is_left_out[at(beside)] == 0) {
                sum += open.area[at(a)][at(face)] * field[at(beside)];
                area += open.area[at(a)][at(face)];
            }
        }
    }
    return area > 0 ? sum / area : field[at(c)];
}

}  // namespace

fluid::grid::GridState fill_grid(const GridFluidSettings& settings, const std::vector<GridBody>& bodies,
                                 const fluid::grid::OpenShares& open) {
    constexpr double round_off = 1e-9;
    const fluid::grid::Mesh& mesh = settings.grid.mesh;
    std::vector<double> share(at(mesh.box.size));
    std::vector<std::uint8_t> split(at(mesh.box.size));  // by a wall: the water in them may be on its closed side
    fluid::grid::for_cells(mesh.box, [&](std::int64_t c, int i, int j, int k) {
        const double open_share = open.volume[at(c)], volume = mesh.volume(i, j, k);
        if (open_share == 0) {
            return;
        }
        const Vec3 centre = mesh.centre(i, j, k), half = Vec3{mesh.h(0, i), mesh.h(1, j), mesh.h(2, k)} * 0.5;
        const double water = water_in(settings, bodies, centre - half, centre + half, open_share < 1) / volume;
        const double fraction = std::clamp(water / open_share, 0.0, 1.0);
        share[at(c)] = fraction < round_off ? 0 : fraction > 1 - round_off ? 1 : fraction;
        split[at(c)] = open_share < 1 && is_split(bodies, centre - half, centre + half, open_share) ? 1 : 0;
    });
    const std::vector<double> found = share;
    fluid::grid::for_cells(mesh.box, [&](std::int64_t c, int, int, int) {
        share[at(c)] = split[at(c)] != 0 ? mean_beside(mesh.box, open, found, split, c) : share[at(c)];
    });
    const auto speed = [&](const Vec3& x) {
        for (const FillRegion& region : settings.scene.regions) {
            const bool holds = region.pieces.empty() ||
                               std::any_of(region.pieces.begin(), region.pieces.end(), [&](const auto& piece) {
                                   return std::all_of(piece.faces.begin(), piece.faces.end(), [&](const auto& face) {
                                       const auto plane = geometry::face_plane(piece.vertices, face);
                                       return dot(plane.normal, x) <= plane.offset;
                                   });
                               });
            if (holds && dot(settings.scene.up, x) <= region.level) {
                return region.velocity;
            }
        }
        return Vec3{};
    };
    fluid::grid::GridState state = fluid::grid::make_state(
        settings.grid, [](const Vec3&) { return 0.0; }, speed);
    state.fraction = std::move(share);
    if (settings.scene.flow) {
        set_flow_velocity(settings, 0, state.velocity);
    }
    return state;
}

std::vector<double> water_at_start(const GridFluidSettings& settings) {
    return fill_grid(settings, {}, cut_bodies(settings.grid.mesh, {}).open).fraction;
}

}  // namespace riprap::coupling

// SPDX-License-Identifier: Apache-2.0
// Instruments in the water of a grid.
#include <algorithm>
#include <cmath>

#include "riprap/coupling/grid_fluid/carried_water.hpp"
#include "riprap/coupling/grid_fluid/grid_bodies.hpp"
#include "riprap/coupling/grid_fluid/grid_parts.hpp"
#include "riprap/fluid/grid/datum.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/pockets.hpp"
#include "riprap/fluid/grid/read.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::Mesh;

/// The water of a grid as gauges read it, with the share of cells that solids leave to it.
struct Reader : fluid::WaterReader {
    const GridFluidSettings& settings;
    const GridFluidFields& fields;
    const fluid::grid::GridState& water;
    const FaceGauge* wall;  ///< of a gauge in a face
    const fluid::grid::OpenShares& open;
    const fluid::grid::Room* room;                 ///< that `open` leaves, where it has been made
    const std::vector<double>* at_start{nullptr};  ///< water fraction then, where the gauge asks for it

    Reader(const GaugeQuery<GridFluid>& query, const fluid::grid::OpenShares& left, const fluid::grid::Room* made)
        : settings(query.settings),
          fields(query.fields),
          water(query.fields.water),
          wall(query.face),
          open(left),
          room(made) {}
    const Mesh& mesh() const { return settings.grid.mesh; }

    double share(std::int64_t c) const { return open.has_bodies ? open.volume[at(c)] : 1; }
    std::int64_t cell_at(const Vec3& x) const {
        return mesh().box.index(mesh().cell_at(0, x.x), mesh().cell_at(1, x.y), mesh().cell_at(2, x.z));
    }
    bool holds(const Vec3& x) const {
        for (int a = 0; a < mesh().box.axes; ++a) {
            if (x[a] < mesh().edge[at(a)].front() || x[a] > mesh().edge[at(a)].back()) {
                return false;
            }
        }
        return true;
    }
    bool is_wet(const Vec3& x) const {
        const std::int64_t c = cell_at(x);
        return holds(x) && share(c) > 0 && water.fraction[at(c)] >= 0.5;
    }
    /// Open share of the face below a cell.
    double open_area(int axis, std::int64_t face, const std::array<int, 3>& place) const {
        if (room != nullptr) {
            return room->area[at(axis)][at(face)] / mesh().face_area(axis, place[0], place[1], place[2]);
        }
        return open.has_bodies ? open.area[at(axis)][at(face)] : 1;
    }
    /// The plane of the surface tells in mixed cells; in one that solids cut, the height to which its water fills it,
    /// with a section that changes evenly from one of its faces to the other.
    bool is_below_surface(const Vec3& x) const {
        const std::int64_t c = cell_at(x);
        const double f = water.fraction[at(c)];
        if (!holds(x) || share(c) == 0 || !fluid::grid::is_mixed(f)) {
            return is_wet(x);
        }
        const std::array<int, 3> place = fluid::grid::place_of(mesh().box, c);
        const fluid::grid::CellPlane plane = plane_in(c);
        const auto from_centre = [&](int a) {
            return (x[a] - mesh().centre(a, place[at(a)])) / mesh().h(a, place[at(a)]);
        };
        if (share(c) == 1) {
            double along = -plane.d;
            for (int a = 0; a < 3; ++a) {
                along += plane.n[at(a)] * from_centre(a);
            }
            return along <= 0;
        }
        const int a = steepest(plane);
        const bool is_below = plane.n[at(a)] > 0;
        const double low = open_area(a, c, place), high = open_area(a, c + mesh().box.stride[at(a)], place);
        const double wet_end = is_below ? low : high, grown = (is_below ? high : low) - wet_end;
        const double volume = f * (wet_end + 0.5 * grown);  // = A z + (B - A) z^2/2
        const double root = std::sqrt(std::max(0.0, wet_end * wet_end + 2 * grown * volume));
        const double depth = wet_end + root > 0 ? 2 * volume / (wet_end + root) : 1;
        return (is_below ? from_centre(a) : -from_centre(a)) + 0.5 <= depth;
    }
    static int steepest(const fluid::grid::CellPlane& plane) {
        int axis = 0;
        for (int a = 1; a < 3; ++a) {
            axis = std::abs(plane.n[at(a)]) > std::abs(plane.n[at(axis)]) ? a : axis;
        }
        return axis;
    }
    bool is_open(std::int64_t c) const { return mesh().box.has_cell(c) && share(c) > 0; }
    /// The plane of the surface in a mixed cell. Cells that are closed, or beyond the sides, count as what they mirror.
    fluid::grid::CellPlane plane_in(std::int64_t c) const {
        const auto& box = mesh().box;
        const fluid::grid::CellBox around({1, 1, 1}, 1, box.axes);
        std::vector<double> fraction(at(around.size), water.fraction[at(c)]);
        for (int k = -around.pad[2]; k <= around.pad[2]; ++k) {
            for (int j = -around.pad[1]; j <= around.pad[1]; ++j) {
                for (int i = -around.pad[0]; i <= around.pad[0]; ++i) {
                    const std::array<std::int64_t, 3> step{i * box.stride[0], j * box.stride[1], k * box.stride[2]};
                    const std::int64_t there = c + step[0] + step[1] + step[2];
                    std::int64_t read = is_open(there) ? there : c;
                    for (std::size_t a = 0; a < 3 && read == c; ++a) {
                        read = step[a] != 0 && is_open(there - step[a]) ? there - step[a] : c;
                    }
                    fraction[at(around.index(i, j, k))] = water.fraction[at(read)];
                }
            }
        }
        const auto normal = fluid::grid::surface_normal(around, fraction, around.index(0, 0, 0));
        return fluid::grid::place_plane(normal, water.fraction[at(c)]);
    }
    /// Before the first step no pressure has been solved for: that of water at rest up to its highest surface.
    double pressure_at_start(std::int64_t c, const Vec3& x) const {
        const double weight = fluid::grid::density_of(settings.grid, water.fraction[at(c)]) *
                              norm(fluid::grid::body_force(settings.grid, water.time));
        return settings.grid.has_surface ? std::max(0.0, weight * (still_level(settings) - dot(settings.scene.up, x)))
                                         : 0;
    }
    /// P of the cell and the weight of water below the place; air counts as air.
    double pressure(const Vec3& x) const override {
        const std::int64_t c = cell_at(x);
        if (!holds(x) || share(c) == 0) {
            return 0;
        }
        if (water.step == 0) {
            return pressure_at_start(c, x);
        }
        if (share(c) == 1 && water.fraction[at(c)] == 1) {
            return read_pressure(settings.grid, water, x);
        }
        const double density = fluid::grid::density_of(settings.grid, water.fraction[at(c)]);
        return water.pressure[at(c)] + density * dot(fluid::grid::body_force(settings.grid, water.time),
                                                     x - fluid::grid::datum_of(settings.grid.mesh));
    }
    Vec3 velocity(const Vec3& x) const override { return is_wet(x) ? read_velocity(settings.grid, water, x) : Vec3{}; }
    double level(const Vec3& x, const Vec3& up) const override {
        int axis = 0;
        for (int a = 1; a < 3; ++a) {
            axis = std::abs(up[a]) > std::abs(up[axis]) ? a : axis;
        }
        std::array<int, 3> cell{mesh().cell_at(0, x.x), mesh().cell_at(1, x.y), mesh().cell_at(2, x.z)};
        const double way = up[axis] > 0 ? 1 : -1;
        double sum = 0;
        for (int i = 0; i < mesh().box.cells[at(axis)]; ++i) {
            cell[at(axis)] = i;
            const double h = mesh().h(axis, i), middle = mesh().centre(axis, i);
            const double above = std::clamp((way * (middle - x[axis]) + 0.5 * h) / h, 0.0, 1.0);
            const auto c = mesh().box.index(cell[0], cell[1], cell[2]);
            sum += above * water.fraction[at(c)] * share(c) * h;
        }
        return sum;
    }
    double surface(const Vec3& start, const Vec3& end) const override { return along(start, end, false); }
    double run_up(const Vec3& start, const Vec3& end) const override { return along(start, end, true); }
    /// Distance along a line of its last wet place, or of the first dry one.
    double along(const Vec3& from, const Vec3& to, bool is_first) const {
        const double length = norm(to - from), step = 0.1 * settings.spacing;
        const auto count = static_cast<std::int64_t>(std::ceil(length / step));
        double found = 0;
        for (std::int64_t i = 0; i <= count; ++i) {
            const double s = std::min(length, static_cast<double>(i) * step);
            if (is_below_surface(from + (s / length) * (to - from))) {
                found = s;
            } else if (is_first) {
                break;
            }
        }
        double dry = std::min(length, found + step);
        for (int halving = 0; halving < 20; ++halving) {
            const double middle = 0.5 * (found + dry);
            (is_below_surface(from + (middle / length) * (to - from)) ? found : dry) = middle;
        }
        return found;
    }
    /// Water through the cell faces nearest to a rectangle, along the axis across it [m^3/s].
    double flow(const Vec3& low, const Vec3& high) const override {
        const auto& box = mesh().box;
        int axis = 0;
        for (int a = 0; a < box.axes; ++a) {
            axis = low[a] == high[a] ? a : axis;
        }
        const auto& edge = mesh().edge[at(axis)];
        const auto face = static_cast<int>(
            std::min_element(edge.begin(), edge.end(),
                             [&](double a, double b) { return std::abs(a - low[axis]) < std::abs(b - low[axis]); }) -
            edge.begin());
        double sum = 0;
        std::array<int, 3> last = box.cells;
        last[at(axis)] = 1;
        for (int k = 0; k < last[2]; ++k) {
            for (int j = 0; j < last[1]; ++j) {
                for (int i = 0; i < last[0]; ++i) {
                    std::array<int, 3> place{i, j, k};
                    place[at(axis)] = face;
                    double covered = 1;
                    for (int b = 0; b < box.axes; ++b) {
                        if (b != axis) {
                            const double from = mesh().edge[at(b)][at(place[at(b)])], h = mesh().h(b, place[at(b)]);
                            covered *= std::max(0.0, std::min(high[b], from + h) - std::max(low[b], from)) / h;
                        }
                    }
                    const std::int64_t f = box.index(place[0], place[1], place[2]);
                    const double u = water.velocity[at(axis)][at(f)];
                    std::array<int, 3> inside = place;
                    inside[at(axis)] = std::min(face, box.cells[at(axis)] - 1);
                    const double area = mesh().face_area(axis, inside[0], inside[1], inside[2]) *
                                        (open.has_bodies && room == nullptr ? open.area[at(axis)][at(f)] : 1);
                    sum += covered * u * (room != nullptr ? room->area[at(axis)][at(f)] : area) *
                           water.fraction[at(u > 0 ? f - box.stride[at(axis)] : f)];
                }
            }
        }
        return sum;
    }
    /// Share of a cell that lies in a box.
    double covered(const Vec3& low, const Vec3& high, const std::array<int, 3>& place) const {
        double part = 1;
        for (int a = 0; a < mesh().box.axes; ++a) {
            const double from = mesh().edge[at(a)][at(place[at(a)])], h = mesh().h(a, place[at(a)]);
            part *= std::max(0.0, std::min(high[a], from + h) - std::max(low[a], from)) / h;
        }
        return part;
    }
    /// Sum over the water in a box of `times(cell)` times its volume.
    template <class Times>
    double sum_in_box(const Vec3& low, const Vec3& high, const Times& times) const {
        return fluid::grid::sum_cells(mesh().box, [&](std::int64_t c, int i, int j, int k) {
            return covered(low, high, {i, j, k}) * share(c) * water.fraction[at(c)] * mesh().volume(i, j, k) * times(c);
        });
    }
    double volume(const Vec3& low, const Vec3& high) const override {
        return sum_in_box(low, high, [](std::int64_t) { return 1.0; });
    }
    /// Mean over the water in a box of a vector of each cell, by volume; zero without water.
    template <class Value>
    Vec3 mean_of(const Vec3& low, const Vec3& high, const Value& value) const {
        const double whole = volume(low, high);
        const Vec3 sum = fluid::grid::sum_cells(mesh().box, [&](std::int64_t c, int i, int j, int k) {
            const double part =
                covered(low, high, {i, j, k}) * share(c) * water.fraction[at(c)] * mesh().volume(i, j, k);
            return part > 0 ? part * value(c, i, j, k) : Vec3{};
        });
        return whole > 0 ? sum / whole : Vec3{};
    }
    Vec3 centre(const Vec3& low, const Vec3& high) const override {
        return mean_of(low, high, [&](std::int64_t, int i, int j, int k) { return mesh().centre(i, j, k); });
    }
    Vec3 mean_velocity(const Vec3& low, const Vec3& high) const override {
        return mean_of(low, high, [&](std::int64_t c, int, int, int) {
            Vec3 u{};
            for (int a = 0; a < mesh().box.axes; ++a) {
                const auto& v = water.velocity[at(a)];
                u[a] = 0.5 * (v[at(c)] + v[at(c + mesh().box.stride[at(a)])]);
            }
            return u;
        });
    }
    /// Squares of differences and their number.
    struct Misfit {
        double square{0};
        std::int64_t count{0};

        template <class By>
        static void join(Misfit& a, const Misfit& b, const By& by) {
            by.add(a.square, b.square);
            by.add(a.count, b.count);
        }
    };
    /// Of the velocity across a face of a cell, where water lies on all sides of it that are in the domain.
    Misfit misfit_at(int a, std::array<int, 3> place, const Vec3& low, const Vec3& high) const {
        const auto& box = mesh().box;
        Vec3 x{};
        for (int b = 0; b < box.axes; ++b) {
            x[b] = b == a ? mesh().edge[at(b)][at(place[at(b)])] : mesh().centre(b, place[at(b)]);
            if (x[b] < low[b] || x[b] > high[b]) {
                return {};
            }
        }
        const std::int64_t f = box.index(place[0], place[1], place[2]);
        for (const int beside : {place[at(a)] - 1, place[at(a)]}) {
            const std::int64_t c = f + (beside - place[at(a)]) * box.stride[at(a)];
            const bool is_cell = beside >= 0 && beside < box.cells[at(a)];
            if (is_cell && (share(c) == 0 || water.fraction[at(c)] < 0.5)) {
                return {};
            }
        }
        const double error =
            water.velocity[at(a)][at(f)] -
            mean_across(mesh(), *settings.scene.flow, settings.kinematic_viscosity, a, place, water.time);
        return {error * error, 1};
    }
    Vec3 flow_error(const Vec3& low, const Vec3& high) const override {
        if (!settings.scene.flow) {
            return {unknown, unknown, unknown};
        }
        Vec3 error{};
        for (int a = 0; a < mesh().box.axes; ++a) {
            const Misfit all = fluid::grid::sum_cells(mesh().box, [&](std::int64_t, int i, int j, int k) {
                std::array<int, 3> place{i, j, k};
                Misfit misfit = misfit_at(a, place, low, high);
                place[at(a)] += 1;
                if (place[at(a)] == mesh().box.cells[at(a)]) {
                    const Misfit above = misfit_at(a, place, low, high);
                    misfit = {misfit.square + above.square, misfit.count + above.count};
                }
                return misfit;
            });
            error[a] = all.count > 0 ? std::sqrt(all.square / static_cast<double>(all.count)) : 0;
        }
        return error;
    }
    double changed(const Vec3& low, const Vec3& high) const override {
        return fluid::grid::sum_cells(mesh().box, [&](std::int64_t c, int i, int j, int k) {
            return covered(low, high, {i, j, k}) * share(c) * std::abs(water.fraction[at(c)] - (*at_start)[at(c)]) *
                   mesh().volume(i, j, k);
        });
    }
    double turbulent_energy(const Vec3& low, const Vec3& high) const override {
        const std::vector<double>& k = water.turbulent_energy;
        return k.empty() ? 0 : sum_in_box(low, high, [&k](std::int64_t c) { return k[at(c)]; });
    }
    /// In front of a face: half a cell away from it, and the weight of water back to it. Nothing where a solid is
    /// there.
    std::optional<double> pressure_on(const Vec3& foot, const Vec3& normal) const {
        for (const double away : {0.1, 0.5, 1.0}) {
            const Vec3 place = foot + (away * settings.spacing) * normal;
            const std::int64_t c = cell_at(place);
            if (holds(place) && share(c) > 0.05) {
                if (water.step == 0) {
                    return pressure_at_start(c, foot);
                }
                const double density = fluid::grid::density_of(settings.grid, water.fraction[at(c)]);
                return water.pressure[at(c)] + density * dot(fluid::grid::body_force(settings.grid, water.time),
                                                             foot - fluid::grid::datum_of(settings.grid.mesh));
            }
        }
        return std::nullopt;
    }
    /// Mean over the square of the sensor, at points at most half a cell apart, without those that a solid covers.
    double wall_pressure() const override {
        if (wall == nullptr) {
            return 0;
        }
        const auto b = at(wall->body.value);
        const Quat& turn = fields.cut_orientation[b];
        const Vec3 middle = fields.cut_position[b] + rotate(turn, wall->anchor), normal = rotate(turn, wall->normal);
        const bool is_planar = mesh().box.axes == 2;
        const Vec3 first = rotate(turn, tangent(wall->normal, is_planar)), second = cross(normal, first);
        const int count = std::max(1, static_cast<int>(std::ceil(2 * wall->side / settings.spacing)));
        double sum = 0, open_points = 0;
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j < (is_planar ? 1 : count); ++j) {
                const auto way = [&](int k) { return ((k + 0.5) / count - 0.5) * wall->side; };
                const Vec3 foot = middle + way(i) * first + (is_planar ? 0.0 : way(j)) * second;
                if (const std::optional<double> p = pressure_on(foot, normal)) {
                    sum += *p;
                    open_points += 1;
                }
            }
        }
        return open_points > 0 ? sum / open_points : 0;
    }
};

}  // namespace

fluid::GaugeReading GridFluid::read(const GaugeQuery<GridFluid>& query) {
    const Scratch* const scratch = query.scratch;
    const bool is_ready = scratch != nullptr && scratch->cutter.has_value();
    fluid::grid::OpenShares anew;
    if (!is_ready && query.scene.bodies.size() > 0) {
        anew = cut_again(query.scene, query.settings, query.fields).open;
    }
    Reader reader(query, is_ready ? scratch->grid.open : anew, is_ready ? &scratch->grid.room : nullptr);
    std::vector<double> filled;
    if ((query.gauge.kind->needs & fluid::reading::changed) != 0) {
        const bool is_kept = is_ready && !scratch->at_start.empty();
        filled = is_kept ? std::vector<double>{} : water_at_start(query.settings);
        reader.at_start = is_kept ? &scratch->at_start : &filled;
    }
    return query.gauge.kind->read(query.gauge, reader);
}

fluid::ShownFluid GridFluid::shown(const ShownQuery<Settings>& query) {
    const fluid::grid::OpenShares open = query.scene.bodies.size() > 0
                                             ? cut_again(query.scene, query.settings, query.fields).open
                                             : fluid::grid::OpenShares{};
    return show_water(query.settings.grid, query.fields.water, open);
}

}  // namespace riprap::coupling

// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/closed_pocket.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"

namespace riprap::coupling {

namespace {

constexpr double least_filling = 0.9;  ///< of a pocket: less has a free surface [-]
constexpr double least_gap = 1.25;     ///< of a spacing, of cells of a half: three spacings from wall to wall
constexpr std::int64_t named = 4;      ///< bodies

/// Water in one room.
struct Filling {
    std::int64_t particles{0};
    double density{0};    ///< sum [kg/m^3]
    Vec3 first{}, way{};  ///< a particle; sum of the ways from it [m]
};

std::vector<Filling> fillings_of(const RoomCells& cells, const fluid::ParticleSettings& settings,
                                 const fluid::ParticleState& water) {
    const fluid::PeriodicImages images(settings.domain);
    std::vector<Filling> found(cells.rooms().size());
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        const std::int32_t room = cells.room_at(water.position[i]);
        if (room < 0) {
            continue;
        }
        Filling& filling = found[at(room)];
        filling.first = filling.particles == 0 ? water.position[i] : filling.first;
        filling.way += images.nearest(water.position[i], filling.first) - filling.first;
        filling.density += water.density[i];
        ++filling.particles;
    }
    return found;
}

/// Orders walls by what they do to a room: take it away, or else press on it.
void order_by_blame(const body::BodySet& bodies, std::vector<RoomWall>& walls) {
    const double area = std::ranges::max(walls, {}, &RoomWall::area).area;
    constexpr double still = 1e-6;  // [m/s]
    std::ranges::stable_sort(walls, [&](const RoomWall& a, const RoomWall& b) {
        const auto rank = [&](const RoomWall& wall) {
            const bool takes = wall.inflow > still * area;
            const bool presses = body::may_move(bodies, at(wall.body));
            return std::pair(takes ? 2 : presses ? 1 : 0, takes ? wall.inflow : wall.area);
        };
        return rank(a) > rank(b);
    });
}

std::string describe(const RoomWalls& scene, std::vector<RoomWall> walls, const Filling& filling, const Room& room,
                     double excess, double time) {
    order_by_blame(scene.bodies, walls);
    std::string names;
    for (std::size_t k = 0; k < walls.size() && k < at(named); ++k) {
        const bool is_last = k + 1 == std::min(walls.size(), at(named)) && walls.size() <= at(named);
        names += (k == 0 ? "" : is_last ? " and " : ", ") + scene.bodies.name(BodyId{walls[k].body});
    }
    if (walls.size() > at(named)) {
        names += fmt::format(" and {} more", walls.size() - at(named));
    }
    const Vec3 middle = filling.first + filling.way / static_cast<double>(filling.particles);
    return fmt::format(
        "{} leaves too little room to the water in a closed pocket about ({:.4g}, {:.4g}, {:.4g}) m, {:.4g} {} between "
        "{}: "
        "it is {:.3g} % denser than at rest at t = {:.6g} s; allowed: {:g} %",
        scene.bodies.name(BodyId{walls.front().body}), middle.x, middle.y, middle.z, room.volume,
        scene.bodies.is_planar ? "m^2" : "m^3", names, 100 * excess, time, 100 * most_crowding);
}

}  // namespace

bool is_time_to_look(const fluid::ParticleSettings& settings, const fluid::ParticleState& water, const TimeSpan& span,
                     bool carries_density) {
    constexpr double spacings = 8, unseen = 20, dense = 2.0 / 3;
    const double piece = (carries_density ? spacings : unseen) * settings.spacing / settings.sound_speed;
    if (std::floor(span.time / piece) == std::floor(span.end() / piece)) {
        return false;
    }
    if (!carries_density) {
        return true;
    }
    const double limit = (1 + dense * most_crowding) * settings.rest_density;
    const std::int64_t least = settings.domain.dimension == 2 ? 9 : 27;  // three spacings wide
    const auto is_dense = [&](std::int64_t i) -> std::int64_t { return water.density[at(i)] > limit ? 1 : 0; };
    return parallel::reduce(water.size(), std::int64_t{0}, is_dense,
                            [](std::int64_t a, std::int64_t b) { return a + b; }) >= least;
}

std::string crowded_pocket(const RoomWalls& walls, const fluid::ParticleSettings& settings,
                           const fluid::ParticleState& water, double time) {
    const RoomCells cells(walls, water.position, settings.domain, settings.spacing);
    const std::vector<Filling> fillings = fillings_of(cells, settings, water);
    for (std::size_t r = 0; r < fillings.size(); ++r) {
        const Room& room = cells.rooms()[r];
        const auto particles = static_cast<double>(fillings[r].particles);
        const double filled = particles * settings.particle_mass / (settings.rest_density * room.volume);
        if (!room.is_closed || room.widest_gap < least_gap * settings.spacing || filled < least_filling) {
            continue;
        }
        const double excess = std::max(filled, fillings[r].density / (particles * settings.rest_density)) - 1;
        const std::vector<RoomWall> about =
            excess > most_crowding ? cells.walls_of(static_cast<std::int32_t>(r)) : std::vector<RoomWall>{};
        if (!about.empty()) {
            return describe(walls, about, fillings[r], room, excess, time);
        }
    }
    return {};
}

}  // namespace riprap::coupling

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "riprap/coupling/face_gauge.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/coupling/sample_shapes.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/fluid/sph/state_equation.hpp"
#include "riprap/geometry/shapes.hpp"
#include "riprap/scene/build_case.hpp"
#include "riprap/scene/fluid_warnings.hpp"
#include "riprap/scene/limits.hpp"
#include "riprap/scene/paddle_warnings.hpp"
#include "riprap/scene/shape_library.hpp"

namespace riprap::scene {

namespace {

bool read_domain(CaseBuild& build, const Value& table, fluid::Domain& domain) {
    domain.dimension = build.is_planar ? 2 : 3;
    domain.low = get_vector(table, "low");
    domain.high = get_vector(table, "high");
    bool is_good = true;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        if (!(domain.low[axis] < domain.high[axis])) {
            build.problem(table.place,
                          fmt::format("the domain reaches from {} m to {} m along {}", domain.low[axis],
                                      domain.high[axis], "xyz"[axis]),
                          "low below high");
            is_good = false;
        }
    }
    if (const Value* periodic = table.find("periodic")) {
        for (std::size_t axis = 0; axis < periodic->items.size(); ++axis) {
            domain.is_periodic[axis] = periodic->items[axis].boolean && (axis < 2 || !build.is_planar);
        }
    }
    return is_good;
}

fluid::SphSettings read_settings(const CaseBuild& build, const Value& table) {
    fluid::SphSettings sph;
    sph.spacing = get_number(table, "spacing");
    sph.smoothing_ratio = get_number(table, "smoothing_ratio");
    sph.rest_density = get_number(table, "density");
    sph.particle_mass = sph.rest_density * std::pow(sph.spacing, build.is_planar ? 2 : 3);
    sph.scheme = get_text(table, "scheme") == "muller" ? fluid::SphScheme::muller : fluid::SphScheme::delta_sph;
    sph.state_equation =
        get_text(table, "state_equation") == "linear" ? fluid::StateEquation::linear : fluid::StateEquation::tait;
    sph.tait_exponent = get_number(table, "tait_exponent");
    sph.viscosity =
        get_text(table, "viscosity") == "artificial" ? fluid::Viscosity::artificial : fluid::Viscosity::laminar_sps;
    sph.artificial_alpha = get_number(table, "artificial_alpha");
    sph.kinematic_viscosity = get_number(table, "kinematic_viscosity");
    sph.smagorinsky = get_number(table, "smagorinsky");
    sph.density_diffusion = get_number(table, "density_diffusion");
    sph.acoustic_damping = get_number(table, "acoustic_damping");
    sph.gradient_correction = get_boolean(table, "gradient_correction");
    sph.shifting = get_number(table, "shifting");
    sph.courant = get_number(table, "courant");
    sph.sort_interval = get_integer(table, "sort_interval");
    return sph;
}

/// Refuses a level that its region does not reach: the water would end at the top of the region instead.
void check_level(CaseBuild& build, const Value& table, const coupling::FillRegion& region,
                 const fluid::SphSettings& sph) {
    constexpr double slack = 1e-6;  // of a spacing: the level may be the top
    if (!std::isfinite(region.level)) {
        return;
    }
    const double top = coupling::top_of(region, sph.domain, build.up());
    if (region.level > top + slack * sph.spacing) {
        build.problem(
            get(table, "level").place,
            fmt::format("the level {:.6g} m lies above its region, which ends at {:.6g} m", region.level, top),
            "a level in the region, or none to fill it whole");
    }
}

/// The region of one table. Nothing with a problem.
std::optional<coupling::FillRegion> read_region(CaseBuild& build, const Value& table) {
    coupling::FillRegion region;
    region.velocity = get_vector(table, "velocity");
    region.level = get_number_or(table, "level", region.level);
    if (const Value* box = table.find("box")) {
        Vec3 low = get_vector(*box, "low"), high = get_vector(*box, "high");
        if (build.is_planar) {
            low.z = -0.5;
            high.z = 0.5;
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (!(low[axis] < high[axis])) {
                build.problem(
                    box->place,
                    fmt::format("the box reaches from {} m to {} m along {}", low[axis], high[axis], "xyz"[axis]),
                    "low below high");
                return std::nullopt;
            }
        }
        region.pieces.push_back(geometry::moved(geometry::box(high - low), {0.5 * (low + high), {}}));
    } else if (const Value* shape = table.find("shape")) {
        if (ShapeLibrary::is_half_space(*shape)) {
            build.problem(shape->place, "a region of water cannot be a half-space", "a level, or another shape");
            return std::nullopt;
        }
        const auto pieces = build.shapes.pieces(*shape);
        if (!pieces) {
            return std::nullopt;
        }
        const Pose pose{get_vector(table, "position"), orientation_of(table.find("orientation"))};
        for (const geometry::Polyhedron& piece : *pieces) {
            region.pieces.push_back(geometry::moved(piece, pose));
        }
    }
    return region;
}

/// How far a body reaches from its centre; nothing for half-spaces, which do not turn [m].
double rim_of(const CaseBuild& build, std::size_t body) {
    double rim = 0;
    const body::BodySet& bodies = build.model.bodies;
    for (auto p = static_cast<std::size_t>(bodies.part_begin[body]);
         p < static_cast<std::size_t>(bodies.part_begin[body + 1]); ++p) {
        const double radius = build.model.shapes.view(bodies.parts[p].shape).circumradius;
        rim = std::isfinite(radius) ? std::max(rim, norm(bodies.parts[p].local.position) + radius) : rim;
    }
    return rim;
}

/// The fastest that the case itself makes something move [m/s].
double fastest_start(const CaseBuild& build, const Value& table, const std::vector<coupling::FillRegion>& regions) {
    double fastest = 0;
    for (const char* openings : {"inflow", "outflow"}) {
        for (const Value& opening : get(table, openings).items) {
            fastest = std::max(fastest, get_number_or(opening, "speed", 0));
        }
    }
    for (const coupling::FillRegion& region : regions) {
        fastest = std::max(fastest, norm(region.velocity));
    }
    const body::BodySet& bodies = build.model.bodies;
    for (std::size_t b = 0; b < bodies.mass.size(); ++b) {
        const double rim = rim_of(build, b);
        const BodyId body{static_cast<std::int32_t>(b)};
        const Vec3 spin = angular_velocity(bodies, build.state.bodies, body);
        fastest = std::max(fastest, norm(build.state.bodies.velocity[b]) + rim * norm(spin));
        const std::int64_t looks = bodies.driven[b] >= 0 ? look_count(bodies, body, build.model.time.end) : -1;
        for (std::int64_t k = 0; k <= looks; ++k) {
            const double time = build.model.time.end * static_cast<double>(k) / static_cast<double>(looks);
            const auto state = driven_state(bodies, body, time);
            fastest = std::max(fastest, norm(state.velocity) + rim * norm(state.angular_velocity));
        }
    }
    return fastest;
}

/// c_0 from the depth of the water that is there; filling does not need it yet.
void choose_sound_speed(CaseBuild& build, const Value& table, const std::vector<coupling::FillRegion>& regions,
                        const fluid::ParticleState& particles, sim::FluidModel& fluid) {
    // Along a periodic axis water has no depth.
    const Vec3 gravity = fluid::without_periodic(build.model.gravity.value, fluid.sph.domain);
    const double strength = norm(gravity);
    double low = 1e300, high = -1e300;
    for (const Vec3& x : particles.position) {
        const double height = strength > 0 ? -dot(gravity, x) / strength : 0;
        low = std::min(low, height);
        high = std::max(high, height);
    }
    fluid.depth = particles.size() > 0 && strength > 0 ? high - low + fluid.sph.spacing : 0;
    const Value& given = get(table, "sound_speed");
    if (!given.is_text()) {
        fluid.sph.sound_speed = given.as_number();
        fluid.sound_speed_reason = "as given";
        return;
    }
    const Value& expected = get(table, "expected_speed");
    const double tip = 2 * std::sqrt(strength * fluid.depth);
    const fluid::SoundSpeed chosen = fluid::choose_sound_speed(
        strength, fluid.depth,
        std::max(expected.is_text() ? tip : expected.as_number(), fastest_start(build, table, regions)));
    fluid.sph.sound_speed = chosen.value;
    fluid.sound_speed_reason = chosen.reason;
    if (!(chosen.value > 0) && build.has_all_bodies) {
        build.problem(given.place, "nothing moves and nothing weighs: no sound speed follows from the case",
                      "a sound_speed");
    }
}

/// Problems of the coupling know no place in the case: they get that of `table`.
template <class Work>
bool place_problems(CaseBuild& build, const Value& table, const Work& work) {
    try {
        work();
    } catch (const CaseError& error) {
        for (const Diagnostic& found : error.problems()) {
            build.problem(table.place, found.message, found.allowed);
        }
        return false;
    }
    return true;
}

/// Paddles that absorb waves look at the water as it lies at the start.
void build_absorptions(CaseBuild& build, const fluid::ParticleState& particles, sim::FluidModel& fluid) {
    for (std::size_t k = 0; k < build.absorptions.size(); ++k) {
        sim::PaddleAbsorption& paddle = build.absorptions[k];
        paddle.still = sim::surface_at_paddle(paddle, 0, fluid.sph, particles);
        const std::string& name = build.model.bodies.name(paddle.body);
        const Vec3& foot = paddle.foot;
        const std::string where = fmt::format("({:.6g}, {:.6g}, {:.6g}) m", foot.x, foot.y, foot.z);
        if (!coupling::find_face(build.model.shapes, build.model.bodies, build.state.bodies, {}, foot,
                                 fluid.sph.spacing, paddle.body)) {
            build.problem(
                build.absorption_places[k],
                fmt::format("'absorb' is at {}, more than a spacing from the faces of '{}'", where, name),
                "the foot of the face that makes waves: the surface of the water before it is looked at there");
        } else if (paddle.still < fluid.sph.spacing) {
            build.problem(
                build.absorption_places[k],
                fmt::format("no water stands {} spacings in front of {}, the foot of '{}', which is to absorb waves",
                            sim::absorption_gauge_distance, where, name),
                "'absorb' at the foot of its face, in water");
        }
        fluid.absorptions.push_back(paddle);
    }
    if (!fluid.absorptions.empty()) {
        const auto count = static_cast<std::size_t>(build.model.bodies.size());
        build.state.bodies.drive_offset.assign(count, {});
        build.state.bodies.drive_rate.assign(count, {});
    }
}

/// The regions of the case; false where one of them has a problem.
bool read_regions(CaseBuild& build, const Value& list, std::vector<coupling::FillRegion>& regions) {
    if (static_cast<std::int64_t>(list.items.size()) > limits::fluid_regions) {
        build.problem(list.place, fmt::format("{} regions of water", list.items.size()),
                      fmt::format("at most {}", limits::fluid_regions));
        return false;
    }
    for (const Value& entry : list.items) {
        if (auto region = read_region(build, entry)) {
            regions.push_back(std::move(*region));
        }
    }
    return regions.size() == list.items.size();
}

/// Water where bodies leave room for it, and the boundary particles of those that are wet. False with a problem.
bool place_particles(CaseBuild& build, const Value& table, const std::vector<coupling::FillRegion>& regions,
                     sim::FluidModel& fluid, coupling::Filling& filling) {
    const geometry::ShapeSet& shapes = build.model.shapes;
    const body::BodySet& bodies = build.model.bodies;
    fluid.is_dry = build.is_dry;
    fluid.is_dry.resize(static_cast<std::size_t>(bodies.size()), 0);
    std::vector<std::uint8_t> is_slippery(fluid.is_dry.size(), 1);
    for (std::size_t b = 0; b < build.sticks.size(); ++b) {
        is_slippery[b] = build.sticks[b] != 0 ? 0 : 1;
    }
    bool is_good = place_problems(build, get(table, "region"), [&] {
        filling = coupling::fill(shapes, bodies, build.state.bodies, fluid.sph, build.up(), regions, limits::particles);
    });
    if (is_good && fluid.wall == sim::WallTreatment::boundary_particles) {
        is_good = place_problems(build, table, [&] {
            fluid.samples =
                coupling::sample_shapes(shapes, bodies, build.state.bodies,
                                        {fluid.sph.spacing, fluid.sph.support_radius(), fluid.sph.domain,
                                         filling.lattice_corner, limits::particles, fluid.is_dry, is_slippery});
        });
    }
    return is_good;
}

/// Sums the volume up and refuses regions without water.
void check_filling(CaseBuild& build, const Value& list, const coupling::Filling& filling, sim::FluidModel& fluid) {
    for (std::size_t r = 0; r < filling.regions.size(); ++r) {
        const coupling::FillReport& report = filling.regions[r];
        fluid.filled_volume += report.volume;
        if (report.count == 0) {
            build.problem(
                list.items[r].place,
                fmt::format("no particle of water fits into this region at a spacing of {:.4g} m", fluid.sph.spacing),
                "a region larger than the spacing, in the domain, outside of solids and earlier regions");
        }
    }
}

}  // namespace

void build_fluid(CaseBuild& build) {
    const Value* table = build.root.find("fluid");
    if (table == nullptr) {
        if (!build.absorptions.empty()) {
            build.problem(build.root.place, "a paddle that absorbs waves in a case without water", "a [fluid]");
        }
        return;
    }
    sim::FluidModel fluid;
    fluid.sph = read_settings(build, *table);
    fluid.wall =
        get_text(*table, "wall") == "penalty" ? sim::WallTreatment::penalty : sim::WallTreatment::boundary_particles;
    const Value& list = get(*table, "region");
    const bool has_domain = read_domain(build, get(*table, "domain"), fluid.sph.domain);
    if (has_domain) {
        build.domain = fluid.sph.domain;  // gauges are checked against it, whatever becomes of the water
    }
    std::vector<coupling::FillRegion> regions;
    coupling::Filling filling;
    if (!read_regions(build, list, regions) || !has_domain) {
        return;
    }
    build_joints(build, *table, fluid);
    for (std::size_t r = 0; r < regions.size(); ++r) {
        check_level(build, list.items[r], regions[r], fluid.sph);
    }
    if (!place_particles(build, *table, regions, fluid, filling)) {
        return;
    }
    check_filling(build, list, filling, fluid);
    if (filling.particles.size() == 0) {
        return;
    }
    choose_sound_speed(build, *table, regions, filling.particles, fluid);
    coupling::set_hydrostatic_density(filling, fluid.sph,
                                      fluid::without_periodic(build.model.gravity.at(0), fluid.sph.domain));
    fluid.region_volume = room_for_water(build, fluid.sph.domain, regions);
    warn_of_thin_bodies(build, fluid, filling.particles);
    warn_of_paddles(build, fluid, filling);
    warn_of_scheme(build, fluid.sph);
    build_absorptions(build, filling.particles, fluid);
    warn_of_bodies_outside(build, fluid);
    build.state.fluid = std::move(filling.particles);
    build_openings(build, *table, fluid);
    start_openings(fluid.open, fluid.sph, build.state.fluid, build.state.open);
    build.model.fluid = std::move(fluid);
}

}  // namespace riprap::scene

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <limits>

#include "riprap/body/ground.hpp"
#include "riprap/core/memory.hpp"
#include "riprap/coupling/face_gauge.hpp"
#include "riprap/coupling/field_scene.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/coupling/pack.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/fluid_tables.hpp"
#include "riprap/scene/assemble/random_stream.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"
#include "riprap/scene/warnings/grid_warnings.hpp"
#include "riprap/scene/warnings/paddle_warnings.hpp"
#include "riprap/sim/method_traits.hpp"

namespace riprap::scene {

namespace {

/// Calls `work` and reports its problems at the place of `table`, since the coupling knows no places in the case.
/// @returns false after a problem
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

/// Finds the law by which a paddle that makes a sea absorbs other waves, and notes the share of energy that it
/// reflects. Refuses a law that would return waves higher than they came.
void build_sea_absorption(CaseBuild& build, const SourcePlace& place, double spacing,
                          coupling::PaddleAbsorption& paddle) {
    prepare_sea(paddle, spacing);
    const std::string name = build.model.bodies.name(paddle.body);
    if (paddle.law.highest > wave::most_returned) {
        build.problem(place,
                      fmt::format("'{}' would send short waves back {:.3g} times as high as they come: the surface is "
                                  "looked at {:g} spacings before it",
                                  name, paddle.law.highest, coupling::absorption_gauge_distance),
                      "a smaller fluid.spacing, a longer period, or no 'absorb'");
        return;
    }
    build.state.coupling.surge.assign(static_cast<std::size_t>(build.model.bodies.size()), 0);
    build.notes.push_back(fmt::format("'{}' absorbs a sea: of the energy of waves like its own {:.2g} % goes back",
                                      name, 100 * paddle.law.returned));
}

/// Gives absorbing paddles the still surface before them, and refuses paddles without a face or water there.
void build_absorptions(CaseBuild& build, const fluid::ParticleState& particles, coupling::ParticleFluid& fluid) {
    for (std::size_t k = 0; k < build.absorptions.size(); ++k) {
        coupling::PaddleAbsorption& paddle = build.absorptions[k];
        paddle.still = coupling::surface_at_paddle(paddle, 0, fluid.settings(), particles);
        if (paddle.sea) {
            build_sea_absorption(build, build.absorption_places[k], fluid.settings().spacing, paddle);
        }
        const std::string& name = build.model.bodies.name(paddle.body);
        const Vec3& foot = paddle.foot;
        const std::string where = fmt::format("({:.6g}, {:.6g}, {:.6g}) m", foot.x, foot.y, foot.z);
        if (!coupling::find_face(build.model.shapes, build.model.bodies, build.state.bodies, {}, foot,
                                 fluid.settings().spacing, paddle.body)) {
            build.problem(
                build.absorption_places[k],
                fmt::format("'absorb' is at {}, more than a spacing from the faces of '{}'", where, name),
                "the foot of the face that makes waves: the surface of the water before it is looked at there");
        } else if (paddle.still < fluid.settings().spacing) {
            build.problem(
                build.absorption_places[k],
                fmt::format("no water stands {} spacings in front of {}, the foot of '{}', which is to absorb waves",
                            coupling::absorption_gauge_distance, where, name),
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

/// Returns the number of particles that limits.hpp accepts and the memory of this machine holds.
coupling::FillLimit most_particles() {
    constexpr double bytes_each = 800;  // with lists of neighbours and the copies that a refused step is taken back to
    const double available = available_memory();
    return {limits::particles, static_cast<std::int64_t>(std::min(available / bytes_each, 1e18)),
            fmt::format(" in the {:.2g} GB of memory that are free here, as each takes some {:.0f} bytes",
                        1e-9 * available, bytes_each)};
}

/// Places water where bodies leave room, and boundary particles on wet bodies. @returns false after a problem
bool place_particles(CaseBuild& build, const Value& table, const std::vector<coupling::FillRegion>& regions,
                     coupling::ParticleFluid& fluid, coupling::Filling& filling) {
    const geometry::ShapeSet& shapes = build.model.shapes;
    const body::BodySet& bodies = build.model.bodies;
    fluid.is_dry = build.is_dry;
    fluid.is_dry.resize(static_cast<std::size_t>(bodies.size()), 0);
    std::vector<std::uint8_t> is_slippery(fluid.is_dry.size(), 1);
    for (std::size_t b = 0; b < build.sticks.size(); ++b) {
        is_slippery[b] = build.sticks[b] != 0 ? 0 : 1;
    }
    const bool has_samples = fluid.wall == coupling::WallTreatment::boundary_particles;
    bool is_good = place_problems(build, get(table, "region"), [&] {
        filling =
            coupling::fill(shapes, bodies, build.state.bodies, fluid.settings(), build.up(), regions, most_particles(),
                           has_samples ? coupling::FillFaces::fitted : coupling::FillFaces::lattice);
    });
    if (is_good && has_samples) {
        is_good = place_problems(build, table, [&] {
            fluid.samples = coupling::sample_shapes(
                shapes, bodies, build.state.bodies,
                {fluid.settings().spacing, fluid.settings().support_radius(), fluid.settings().domain,
                 filling.lattice_corner, limits::particles, fluid.is_dry, is_slippery});
            coupling::Packed packed =
                coupling::pack(shapes, bodies, build.state.bodies, fluid.settings(), fluid.samples, regions, filling);
            const auto* const mps = std::get_if<fluid::MpsSettings>(&fluid.scheme);
            if (mps != nullptr && mps->divergence_share > 0) {  // the density of its water is the count
                filling.particles.dilution = std::move(packed.lack);
            }
        });
    }
    return is_good;
}

/// Sums up the volume of water and refuses regions without any.
/// @return  the room of the regions that particles reach [m^3]; in 2D [m^2]
double check_filling(CaseBuild& build, const Value& list, const coupling::Filling& filling,
                     coupling::ParticleFluid& fluid) {
    double room = 0;
    for (std::size_t r = 0; r < filling.regions.size(); ++r) {
        const coupling::FillReport& report = filling.regions[r];
        fluid.filled_volume += report.volume;
        room += report.room;
        if (report.count == 0) {
            build.problem(list.items[r].place,
                          fmt::format("no particle of water fits into this region at a spacing of {:.4g} m",
                                      fluid.settings().spacing),
                          "a region larger than the spacing, in the domain, outside of solids and earlier regions");
        }
    }
    return room;
}

/// Moves the particles off their lattice.
void move_at_random(const CaseBuild& build, const Value& table, double spacing, fluid::ParticleState& particles) {
    const double most = get_number(table, "jitter") * spacing;
    for (std::size_t i = 0; most > 0 && i < particles.position.size(); ++i) {
        RandomStream random(build.model.seed, "fluid", i);
        const double x = random.uniform(-most, most), y = random.uniform(-most, most);
        const double z = random.uniform(-most, most);
        particles.position[i] += Vec3{x, y, build.is_planar ? 0 : z};
    }
}

/// Gives the particles the velocity of the flow that the case names.
void start_flow(const Value& table, fluid::ParticleState& particles) {
    if (const std::optional<fluid::Flow> flow = read_flow(table)) {
        const double viscosity = get_number_or(table, "kinematic_viscosity", 0);
        for (std::size_t i = 0; i < particles.position.size(); ++i) {
            particles.velocity[i] = velocity_of(*flow, particles.position[i], 0, viscosity);
        }
    }
}

/// Builds a fluid of particles: their places at the start, their walls, inflow and outflow.
void build_particles(CaseBuild& build, const Value* table, fluid::SchemeSettings scheme) {
    if (build.model.time.settle > 0) {
        build.problem(table->place, "bodies that settle in the dry, and particles of water that lie around them",
                      "settle = 0, or a fluid without particles");
        return;
    }
    coupling::ParticleFluid fluid;
    fluid.scheme = std::move(scheme);
    fluid.settings().particle_mass =
        fluid.settings().rest_density * std::pow(fluid.settings().spacing, build.is_planar ? 2 : 3);
    read_keys(*table, fluid_model_keys(), fluid);
    const Value& list = get(*table, "region");
    const bool has_domain = read_domain(build, get(*table, "domain"), fluid.settings().domain);
    if (has_domain) {
        build.domain = fluid.settings().domain;  // gauges are checked against it, whatever becomes of the water
    }
    std::vector<coupling::FillRegion> regions;
    coupling::Filling filling;
    if (!read_regions(build, list, regions) || !has_domain) {
        return;
    }
    build_joints(build, *table, fluid);
    for (std::size_t r = 0; r < regions.size(); ++r) {
        check_level(build, list.items[r], regions[r], fluid.settings().domain, 1e-6 * fluid.settings().spacing);
    }
    if (!place_particles(build, *table, regions, fluid, filling)) {
        return;
    }
    fluid.reached_volume = check_filling(build, list, filling, fluid);
    for (std::size_t r = 0; r < regions.size(); ++r) {
        warn_of_cut_region(build, list.items[r].place, regions[r], fluid);
    }
    if (filling.particles.size() == 0) {
        return;
    }
    move_at_random(build, *table, fluid.settings().spacing, filling.particles);
    start_flow(*table, filling.particles);
    choose_sound_speed(build, *table, regions, filling.particles, fluid);
    coupling::set_hydrostatic_density(filling, fluid.settings(),
                                      fluid::without_periodic(build.model.gravity.at(0), fluid.settings().domain));
    // Ground is solid below its cells too, where room_for_water() would count room.
    fluid.region_volume = body::find_grounds(build.model.bodies, build.model.shapes).empty()
                              ? room_for_water(build, fluid.settings().domain, regions)
                              : fluid.reached_volume;
    warn_of_thin_bodies(build, fluid, filling.particles);
    warn_of_shallow_water(build, list, fluid, filling);
    warn_of_paddles(build, fluid, filling);
    if (const auto* sph = std::get_if<fluid::SphSettings>(&fluid.scheme)) {
        warn_of_scheme(build, *sph, fluid);
    }
    build_absorptions(build, filling.particles, fluid);
    warn_of_bodies_outside(build, fluid);
    warn_of_driven_leaving(build, fluid, filling.particles.position);
    warn_of_dry_walls(build, fluid, filling.particles.position);
    build.state.fluid = std::move(filling.particles);
    build_openings(build, *table, fluid);
    warn_of_open_sides(build, get(*table, "domain").place, fluid, build.state.fluid.position);
    start_openings(fluid.open, fluid.settings(), build.state.fluid, build.state.open);
    build.model.fluid = std::move(fluid);
}

template <std::derived_from<fluid::ParticleSettings> Settings>
void build_fluid_of(CaseBuild& build, const Value& table, Settings& settings) {
    Settings::traits.complete(settings);
    build_particles(build, &table, settings);
}

/// Refuses what has a pressure by its depth, or waves, at a side where gravity grows or turns, and still water where it
/// turns.
void refuse_changing_gravity(CaseBuild& build, const Value& table) {
    if (!build.model.gravity.changes()) {
        return;
    }
    const auto refuse = [&build](const SourcePlace& place, std::string_view what) {
        build.problem(place, fmt::format("{} in gravity that grows or turns", what), "gravity that stays as it is");
    };
    if (get_text(table, "method") == coupling::HydrostaticSettings::method_name && build.model.gravity.turns()) {
        refuse(get(table, "method").place, "water that lies still");
    }
    for (const char* opening : {"inflow", "outflow"}) {
        const Value* entries = table.find(opening);
        for (const Value& entry : entries != nullptr ? entries->items : std::vector<Value>{}) {
            if (const Value* level = entry.find("level")) {
                refuse(level->place, fmt::format("the level of an {}", opening));
            }
        }
    }
    if (const Value* waves = table.find("wave"); waves != nullptr && !waves->items.empty()) {
        refuse(waves->place, "waves");
    }
}

/// Reads domain, regions and levels of a fluid without particles; without the key "domain" it is unbounded.
/// @returns false after a problem
bool read_field_scene(CaseBuild& build, const Value& table, coupling::FieldScene& scene) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    scene.up = build.up();
    scene.gravity = build.model.gravity;
    scene.is_dry = build.is_dry;
    scene.domain = {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}, {}, build.is_planar ? 2 : 3};
    if (const Value* domain = table.find("domain"); domain != nullptr && !read_domain(build, *domain, scene.domain)) {
        return false;
    }
    if (const Value* regions = table.find("region");
        regions != nullptr && !read_regions(build, *regions, scene.regions)) {
        return false;
    }
    build.domain = scene.domain;
    bool has_water = true;
    for (std::size_t r = 0; r < scene.regions.size() && table.find("domain") != nullptr; ++r) {
        const Value& entry = get(table, "region").items[r];
        check_level(build, entry, scene.regions[r], scene.domain, 1e-9 * std::abs(scene.regions[r].level));
        has_water = check_region(build, entry, scene.regions[r], scene.domain) && has_water;
    }
    if (!has_water || !read_field_tables(build, table, scene)) {
        return false;
    }
    if (const Value* levels = table.find("levels")) {
        for (const Value& row : levels->items) {
            scene.levels.push_back({row.items[0].as_number(), row.items[1].as_number()});
            if (scene.levels.size() > 1 && !(scene.levels[scene.levels.size() - 2].time < scene.levels.back().time)) {
                build.problem(row.place,
                              fmt::format("the time {} s of the levels does not follow {} s", scene.levels.back().time,
                                          scene.levels[scene.levels.size() - 2].time),
                              "each time later than the one before");
                return false;
            }
        }
    }
    return true;
}

/// Returns the place of a key of the table, or of an entry of a list, "wave[1]"; of the table, where it has neither.
const SourcePlace& place_of(const Value& table, std::string_view key) {
    const std::size_t bracket = key.find('[');
    const Value* given = table.find(key.substr(0, bracket));
    if (given != nullptr && bracket != std::string_view::npos) {
        std::size_t entry = 0;
        std::from_chars(key.data() + bracket + 1, key.data() + key.size(), entry);
        given = entry < given->items.size() ? &given->items[entry] : given;
    }
    return given != nullptr ? given->place : table.place;
}

/// Builds a fluid without particles: its settings receive domain, regions and levels.
template <class Settings>
void build_fluid_of(CaseBuild& build, const Value& table, Settings& settings) {
    coupling::FieldScene scene;
    if (!read_field_scene(build, table, scene)) {
        return;
    }
    for (const KeyProblem& problem : settings.prepare(scene)) {
        build.problem(place_of(table, problem.key), problem.message, problem.allowed);
    }
    if (table.find("domain") != nullptr) {  // a fluid with a domain cuts solids into its cells
        check_lengths(build, scene.domain);
        warn_of_hollow_ground(build, scene.domain);
        if (const Value* waves = table.find("wave")) {
            warn_of_waves_over_depth(build, *waves, scene);
        }
    }
    build.model.fluid = settings;
    const std::string cells = sim::cells_text(build.model);
    if (!cells.empty()) {
        warn_of_water_in_cells(build, get(table, "region"), scene, sim::fluid_spacing(build.model));
        build.notes.push_back("the grid of the water: " + cells);
    }
    if constexpr (std::is_same_v<Settings, coupling::HydrostaticSettings>) {
        warn_of_regions_at_faces(build, get(table, "region"), settings);
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
    build.is_dry.resize(static_cast<std::size_t>(build.model.bodies.size()), 0);  // those of packs say nothing
    refuse_changing_gravity(build, *table);
    FluidMethods::Settings chosen = FluidMethods::read(*table, "[fluid]", build.problems, build.warnings);
    std::visit([&](auto& settings) { build_fluid_of(build, *table, settings); }, chosen);
}

}  // namespace riprap::scene

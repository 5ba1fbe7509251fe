// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "riprap/body/locks.hpp"
#include "riprap/core/direction.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/random_stream.hpp"
#include "riprap/scene/case/orientation.hpp"
#include "riprap/scene/keys/freedom_words.hpp"
#include "riprap/scene/motions/build_motion.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/warnings/initial_overlaps.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::scene {

namespace {

/// Fixed, driven or free, with the checks between the keys that say so. Nothing with a problem.
bool read_drive(CaseBuild& build, const Value& table, body::NewBody& body) {
    const bool is_fixed = get_boolean(table, "fixed");
    const Value* motion = table.find("motion");
    const Value* release = table.find("release_time");
    const bool is_half_space = ShapeLibrary::is_half_space(get(table, "shape"));
    const bool is_ground = ShapeLibrary::is_ground(get(table, "shape"));
    if (is_fixed && motion != nullptr) {
        build.problem(motion->place, fmt::format("body '{}' is fixed and has a motion", body.name), "one of the two");
        return false;
    }
    const bool is_moving = norm_squared(body.velocity) > 0 || norm_squared(body.angular_velocity) > 0;
    if ((is_fixed || motion != nullptr) && is_moving) {
        build.problem(table.place,
                      fmt::format("body '{}' has a velocity of its own and does not follow forces", body.name),
                      "leave out velocity and angular_velocity");
        return false;
    }
    if (release != nullptr && !is_fixed && motion == nullptr) {
        build.problem(release->place, fmt::format("body '{}' is free from the start", body.name),
                      "release_time is for fixed = true or a motion");
        return false;
    }
    if (is_half_space && ((!is_fixed && motion == nullptr) || release != nullptr)) {
        build.problem(table.place,
                      fmt::format("body '{}' is a half-space, which has no mass, and would fall", body.name),
                      "fixed = true or a motion, without release_time");
        return false;
    }
    if (is_ground && ((!is_fixed && motion == nullptr) || release != nullptr)) {
        build.problem(table.place, fmt::format("body '{}' is ground, which does not follow forces", body.name),
                      "fixed = true or a motion, without release_time");
        return false;
    }
    body.drive = is_fixed ? body::Drive::fixed : motion != nullptr ? body::Drive::driven : body::Drive::free;
    body.release_time = release != nullptr ? release->as_number() : body.release_time;
    body.motion = motion != nullptr ? add_motion(build, *motion) : -1;
    return motion == nullptr || body.motion >= 0;
}

/// Reads the degrees of freedom that a body lacks; nothing with a problem.
std::optional<body::Locks> read_locks(CaseBuild& build, const Value& table, const body::NewBody& body) {
    const Value* locked = table.find("locked");
    body::Locks locks;
    if (locked == nullptr) {
        return locks;
    }
    constexpr unsigned planar = 0x23, spatial = 0x3F;  // x, y and rotation_z; all six
    const unsigned there = build.is_planar ? planar : spatial;
    for (const Value& word : locked->items) {
        const unsigned bits = key::value_of(freedoms(), word.text);
        if ((bits & there) == 0) {
            build.problem(locked->place,
                          fmt::format("nothing moves along '{}' in a scene with dimension = 2", word.text),
                          "x, y, rotation_z");
            return std::nullopt;
        }
        locks.bits = static_cast<std::uint8_t>(locks.bits | (bits & there));
    }
    if (locks.bits == there) {
        build.problem(locked->place, fmt::format("body '{}' cannot move at all", body.name), "fixed = true");
    } else if (body.drive == body::Drive::driven) {
        build.problem(locked->place, fmt::format("body '{}' has a motion, which says all of its freedoms", body.name),
                      "leave out 'locked' or 'motion'");
    } else if (!(locks.free_translation(body.velocity) == body.velocity &&
                 locks.free_rotation(body.angular_velocity) == body.angular_velocity)) {
        build.problem(locked->place, fmt::format("body '{}' starts with a velocity that is locked", body.name),
                      "velocity and angular_velocity 0 along locked axes");
    } else {
        return locks;
    }
    return std::nullopt;
}

Vec3 read_spin(const Value& value) { return value.is_array() ? to_vector(value) : Vec3{0, 0, value.as_number()}; }

/// Refuses speeds whose energy is beyond double precision.
bool check_speeds(CaseBuild& build, const Value& table, const body::NewBody& body) {
    constexpr double most = 1e100;  // [m/s, rad/s]
    for (const auto& [key, v] : {std::pair{"velocity", body.velocity}, {"angular_velocity", body.angular_velocity}}) {
        if (std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > most) {
            build.problem(get(table, key).place,
                          fmt::format("body '{}' has {} = ({:.3g}, {:.3g}, {:.3g}), whose energy is beyond double "
                                      "precision",
                                      body.name, key, v.x, v.y, v.z),
                          fmt::format("components of at most {:g}", most));
            return false;
        }
    }
    return true;
}

/// Refuses bodies that double precision cannot tell from nothing, or from what lies beside them.
void check_magnitudes(CaseBuild& build, const Value& table, BodyId id, const std::string& name) {
    const body::BodySet& bodies = build.model.bodies;
    const auto i = static_cast<std::size_t>(id.value);
    const double mass = bodies.mass[i];
    const Vec3& moments = bodies.principal_moments[i];
    const auto first_part = static_cast<std::size_t>(bodies.part_begin[i]);
    if (!build.model.shapes.is_half_space(bodies.parts[first_part].shape) &&
        !(std::isnormal(mass) && std::isnormal(std::max({moments.x, moments.y, moments.z})))) {
        build.has_sound_bodies = false;
        build.problem(table.place,
                      fmt::format("body '{}' has a mass of {:.3g} {} and moments of inertia of {:.3g} {} at most", name,
                                  mass, sim::unit_in("kg", build.is_planar),
                                  std::max({moments.x, moments.y, moments.z}), sim::unit_in("kg m^2", build.is_planar)),
                      "sizes and densities that leave both a positive finite number in double precision");
        return;
    }
    constexpr double resolution = 1e-6;  // of the inscribed radius: overlaps are small shares of it
    const double rounding = std::numeric_limits<double>::epsilon() * norm(build.state.bodies.position[i]);
    for (std::int32_t p = bodies.part_begin[i]; p < bodies.part_begin[i + 1]; ++p) {
        const double radius = build.model.shapes.view(bodies.parts[static_cast<std::size_t>(p)].shape).inscribed_radius;
        if (rounding > resolution * radius) {
            build.has_sound_bodies = false;
            const double limit = resolution * radius / std::numeric_limits<double>::epsilon();
            build.problem(
                table.place,
                fmt::format("body '{}' lies {:.3g} m from the origin, where double precision resolves {:.2g} m", name,
                            norm(build.state.bodies.position[i]), rounding),
                fmt::format("at most {:.3g} m, for its inscribed radius of {:.3g} m", limit, radius));
            return;
        }
    }
}

/// @param spheres  that stand for it; null where the method samples it
/// @param scale    of its shape against what the case gives
void add_with_loads(CaseBuild& build, const Value& table, const body::NewBody& body, const BodySpheres* spheres,
                    double scale = 1) {
    const BodyId id = body::add_body(build.model.bodies, build.state.bodies, build.model.shapes, body);
    if (spheres != nullptr) {
        give_spheres(build, *spheres, body, id, scale);
    }
    check_magnitudes(build, table, id, body.name);
    if (const Value* loads = table.find("load")) {
        add_loads(build, *loads, id, body.pose, scale);
    }
}

/// Copies of `body` on a lattice.
void add_copies(CaseBuild& build, const Value& table, const Value& shape, const body::NewBody& body,
                const BodySpheres* spheres, const Value& repeat) {
    const Lattice lattice(repeat);
    const Quat slope = orientation_of(repeat.find("orientation"));
    const bool is_turned = get_boolean(repeat, "random_orientation");
    const double jitter = get_number(repeat, "jitter");
    const double turn = get_number(repeat, "turn");
    const Vec3 axis = direction_of(get_vector(repeat, "turn_axis")), center = get_vector(repeat, "turn_center");
    const Value* scales = repeat.find("scales");
    for (std::int64_t i = 0; i < lattice.size(); ++i) {
        body::NewBody copy = body;
        RandomStream random(build.model.seed, body.name, static_cast<std::uint64_t>(i));
        copy.name_index = static_cast<std::int32_t>(i);
        copy.pose.position += rotate(slope, lattice.point(i));
        if (turn != 0) {
            const Quat by = from_rotation_vector(static_cast<double>(i) * turn * axis);
            copy.pose.position = center + rotate(by, copy.pose.position - center);
            copy.pose.orientation = by * copy.pose.orientation;
        }
        if (jitter > 0) {
            const double x = random.uniform(-jitter, jitter), y = random.uniform(-jitter, jitter);
            const double z = random.uniform(-jitter, jitter);
            copy.pose.position += {x, y, build.is_planar ? 0 : z};
        }
        if (is_turned) {
            copy.pose.orientation = random.orientation(build.is_planar) * copy.pose.orientation;
        }
        double scale = 1;
        if (scales != nullptr) {
            scale = scales->items[static_cast<std::size_t>(i) % scales->items.size()].as_number();
            const auto parts = build.shapes.parts(shape, scale);
            if (!parts) {
                return;
            }
            copy.parts = *parts;
        }
        add_with_loads(build, table, copy, spheres, scale);
    }
}

/// In a planar scene a body may only be turned about z.
/// @param what  is turned
bool check_planar_turn(CaseBuild& build, const Value& table, std::string_view what, const Quat& turn) {
    constexpr double tolerance = 1e-12;  // of a unit quaternion
    if (!build.is_planar || (std::abs(turn.x) < tolerance && std::abs(turn.y) < tolerance)) {
        return true;
    }
    build.problem(get(table, "orientation").place,
                  fmt::format("the {} is turned out of the plane of a scene with dimension = 2", what),
                  "orientation = { angle_deg = ... }");
    return false;
}

/// Notes that the body with index `first` is a paddle, and absorbs waves, if it is and does.
void note_paddle(CaseBuild& build, const Value& table, std::size_t first, std::size_t count) {
    const Value* motion = table.find("motion");
    const Value* maker = motion != nullptr ? motion->find("wave_maker") : nullptr;
    if (maker == nullptr || count == first) {
        return;
    }
    if (auto wave = paddle_wave(build, *maker)) {
        wave->paddle = get_text(table, "name");
        build.paddles.push_back({BodyId{static_cast<std::int32_t>(first)},
                                 direction_of(get_vector(*maker, "direction")), get(*maker, "depth").place,
                                 std::move(*wave)});
    }
    auto absorption = paddle_absorption(build, *maker);
    if (!absorption) {
        return;
    }
    if (count != first + 1) {
        build.problem(table.place, "copies of a paddle that absorbs waves", "one paddle");
        return;
    }
    if (const Value* stop = motion->find("stop")) {
        build.problem(stop->place, "a paddle that stops and absorbs waves: it would answer waves it no longer makes",
                      "leave out 'stop' or 'absorb'");
        return;
    }
    absorption->body = BodyId{static_cast<std::int32_t>(first)};
    absorption->start = get_number(*motion, "start");
    build.absorptions.push_back(*absorption);
    build.absorption_places.push_back(get(*maker, "absorb").place);
}

/// The density that gives a body of these parts, or of the union of these spheres, its mass.
double density_of(CaseBuild& build, const Value& table, const Value& mass, const std::vector<body::Part>& parts,
                  const std::optional<BodySpheres>& spheres) {
    double volume = 0;
    for (const body::Part& part : parts) {
        volume += build.model.shapes.volume(part.shape);
    }
    if (spheres && spheres->whole) {
        volume = spheres->whole->volume;
    }
    if (table.find("density") != nullptr || !(volume > 0)) {
        build.problem(mass.place,
                      volume > 0 ? "a body has a mass and a density" : "a half-space has no volume to hold a mass",
                      volume > 0 ? "one of the two" : "leave 'mass' out");
        return 1;
    }
    return mass.as_number() / volume;
}

void build_body(CaseBuild& build, const Value& table) {
    body::NewBody body;
    body.name = get_text(table, "name");
    body.material = build.material_of(table);
    body.velocity = get_vector(table, "velocity");
    body.angular_velocity = read_spin(get(table, "angular_velocity"));
    body.pose = {get_vector(table, "position"), orientation_of(table.find("orientation"))};
    if (body.material.is_valid()) {
        body.density = get_number_or(table, "density", build.model.materials[body.material].density);
    }
    const Value shape = build.shapes.sized(get(table, "shape"), body.density > 0 ? body.density : 1);
    const Value* repeat = table.find("repeat");
    const bool is_turned_well = check_planar_turn(build, table, "body", body.pose.orientation) &&
                                (repeat == nullptr || check_planar_turn(build, *repeat, "lattice",
                                                                        orientation_of(repeat->find("orientation"))));
    const bool is_driven_well = check_speeds(build, table, body) && read_drive(build, table, body);
    const auto locks = is_driven_well ? read_locks(build, table, body) : std::nullopt;
    if (repeat != nullptr && ShapeLibrary::is_half_space(shape)) {
        build.problem(repeat->place, "a half-space cannot be repeated", "");
        return;
    }
    if (build.is_planar && repeat != nullptr && !Lattice(*repeat).is_flat()) {
        build.problem(repeat->place, "copies along z leave the plane of a scene with dimension = 2",
                      "counts = [nx, ny]");
        return;
    }
    const auto parts = build.shapes.parts(shape);
    const Value* loads = table.find("load");
    const bool is_loaded_well =
        loads == nullptr || check_loads(build, *loads, body, repeat != nullptr ? Lattice(*repeat).size() : 1);
    if (!body.material.is_valid() || !parts || !is_turned_well || !locks || !is_loaded_well) {
        return;
    }
    body.parts = *parts;
    std::optional<BodySpheres> spheres;
    if (table.find("spheres") != nullptr) {
        spheres = read_spheres(build, table, body);
        if (!spheres) {
            return;
        }
    }
    const auto first = static_cast<std::size_t>(build.model.bodies.size());
    if (const Value* mass = table.find("mass")) {
        body.density = density_of(build, table, *mass, body.parts, spheres);
    }
    const BodySpheres* given = spheres ? &*spheres : nullptr;
    if (repeat != nullptr) {
        add_copies(build, table, shape, body, given, *repeat);
    } else {
        add_with_loads(build, table, body, given);
    }
    const auto count = static_cast<std::size_t>(build.model.bodies.size());
    for (std::size_t b = first; b < count && locks->any(); ++b) {
        guide(build.model.bodies, build.state.bodies, BodyId{static_cast<std::int32_t>(b)}, *locks);
    }
    note_paddle(build, table, first, count);
    build.is_dry.resize(first, 0);
    build.is_dry.resize(count, get_boolean(table, "wet") ? 0 : 1);
    build.sticks.resize(first, 0);
    build.sticks.resize(count, get_boolean(table, "slip") ? 0 : 1);
}

}  // namespace

void check_overlaps(CaseBuild& build) {
    constexpr std::size_t most = 10;  // a shifted pack has thousands
    const double max_share = get_number(get(build.root, "contact"), "max_initial_overlap");
    const auto overlaps = find_initial_overlaps(build.model, build.state, max_share);
    const body::BodySet& bodies = build.model.bodies;
    for (std::size_t i = 0; i < std::min(overlaps.size(), most); ++i) {
        const InitialOverlap& overlap = overlaps[i];
        const std::string& name =
            bodies.names[static_cast<std::size_t>(bodies.name_id[static_cast<std::size_t>(overlap.b.value)])];
        const std::string how_deep =
            std::isfinite(overlap.depth)
                ? fmt::format("starts {:.3g} m deep in '{}', {:.3g} % of the smaller inscribed radius", overlap.depth,
                              bodies.name(overlap.a), 100 * overlap.share)
                : fmt::format("starts inside '{}', in a part that has no outer face", bodies.name(overlap.a));
        build.problem(build.names[name], fmt::format("'{}' {}", bodies.name(overlap.b), how_deep),
                      fmt::format("at most {:.3g} % (max_initial_overlap of [contact])", 100 * max_share));
    }
    if (overlaps.size() > most) {
        build.problem(build.root.place,
                      fmt::format("{} more pairs of bodies start inside each other", overlaps.size() - most), "");
    }
}

Lattice::Lattice(const Value& table)
    : pitch_(get_vector(table, "pitch")), stagger_(get_number_or(table, "stagger", 0)) {
    const auto& counts = get(table, "counts").items;
    nx_ = counts[0].integer;
    ny_ = counts[1].integer;
    nz_ = counts.size() > 2 ? counts[2].integer : 1;
}

Vec3 Lattice::point(std::int64_t i) const {
    const std::int64_t row = i / nx_ % ny_, layer = i / nx_ / ny_;
    const double shift = (row + layer) % 2 != 0 ? stagger_ : 0;
    return {pitch_.x * static_cast<double>(i % nx_) + shift, pitch_.y * static_cast<double>(row),
            pitch_.z * static_cast<double>(layer)};
}

void build_bodies(CaseBuild& build) {
    for (const Value& table : get(build.root, "body").items) {
        build.claim_name(table);
        build_body(build, table);
    }
}

}  // namespace riprap::scene

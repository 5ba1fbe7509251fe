// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/pile_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "riprap/core/error.hpp"
#include "riprap/geometry/polyhedra/convex_hull.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/geometry/polyhedra/voronoi.hpp"

namespace riprap::bench {

sim::StepReport advance(Pile& pile, sim::Scratch& scratch, int steps) {
    sim::StepReport report;
    for (int i = 0; i < steps; ++i) {
        report = sim::advance(pile.model, pile.state, scratch, pile.dt, sim::Measure::flow);
        if (!report.status.ok()) {
            throw InternalError(report.status.text);
        }
    }
    return report;
}

namespace {

using geometry::mix_bits;
using geometry::Polyhedron;
using geometry::unit_interval;

constexpr double stiffness = 1e6;  // [Pa]
constexpr double gravity = 9.81;   // [m/s^2]

/// Numbers in [0, 1), one after the other.
class Draw {
 public:
    explicit Draw(std::uint64_t key) : key_(key) {}
    double operator()() { return unit_interval(mix_bits(key_, counter_++)); }
    double between(double low, double high) { return low + (high - low) * (*this)(); }

 private:
    std::uint64_t key_, counter_{0};
};

/// Uniform over all rotations.
Quat random_orientation(Draw& draw) {
    const double u = draw(), a = 2 * std::numbers::pi * draw(), b = 2 * std::numbers::pi * draw();
    const double s = std::sqrt(1 - u), t = std::sqrt(u);
    return {t * std::cos(b), s * std::sin(a), s * std::cos(a), t * std::sin(b)};
}

Pile empty_scene() {
    Pile pile;
    material::Material rock{.name = "rock", .density = 2500, .normal_stiffness = stiffness};
    rock.friction = 0.4877;
    rock.damping_ratio = 0.01;
    pile.model.materials.materials.push_back(rock);
    material::mix_pairs(pile.model.materials, material::Mixing::mean, material::Mixing::mean);
    pile.model.gravity.value = {0, 0, -gravity};
    return pile;
}

void add_block(Pile& pile, ShapeId shape, const Pose& pose, body::Drive drive = body::Drive::free) {
    body::NewBody body;
    body.name = drive == body::Drive::free ? "block" : "wall";
    body.name_index = pile.model.bodies.size();
    body.material = MaterialId{0};
    body.density = pile.model.materials.materials[0].density;
    body.drive = drive;
    body.pose = pose;
    body.parts = {{BodyId{}, shape, Pose{}}};
    body::add_body(pile.model.bodies, pile.state.bodies, pile.model.shapes, body);
}

/// Floor z = 0 and walls x = 0, x = size_x, y = 0, y = size_y.
void add_box(Pile& pile, double size_x, double size_y) {
    const std::array<std::pair<Vec3, double>, 5> planes{
        {{{0, 0, 1}, 0}, {{-1, 0, 0}, -size_x}, {{1, 0, 0}, 0}, {{0, -1, 0}, -size_y}, {{0, 1, 0}, 0}}};
    for (const auto& [normal, offset] : planes) {
        add_block(pile, pile.model.shapes.add_half_space(normal, offset), {}, body::Drive::fixed);
    }
}

/// As the reader of a case does when it has all bodies.
void shrink_to_fit(Pile& pile) {
    pile.model.shapes.shrink_to_fit();
    body::shrink_to_fit(pile.model.bodies, pile.state.bodies);
}

/// Lets blocks sink slowly and come to rest: mass damping limits their speed to g/c, contacts are ten times softer
/// until all have come down, local damping then takes what moves about its place, and the step follows what the
/// contacts allow at the time.
/// @param fall  height that the highest block sinks, about [m]
/// @param size  inscribed radius of the smallest block [m]
void settle(Pile& pile, double fall, double size) {
    constexpr double terminal_speed = 0.4;  // [m/s]
    constexpr double softest = 0.1;         // of the stiffness
    const double free_step = 0.1 * size / terminal_speed;
    sim::Scratch scratch;
    sim::initialise(pile.model, pile.state);
    pile.model.dem()->mass_damping = gravity / terminal_speed;
    pile.dt = free_step;
    const auto go_on = [&](double soft_factor, double duration, int most_steps) {
        pile.model.materials.materials[0].normal_stiffness = soft_factor * stiffness;
        double shortest = std::numeric_limits<double>::infinity();
        const double end = pile.state.time + duration;
        for (int i = 0; i < most_steps && pile.state.time < end; ++i) {
            const sim::StepReport report = advance(pile, scratch, 1);
            // Bodies that do not touch bound no step, and the next contact is as stiff as those before: soft ones bear
            // the longest step all the same.
            shortest = soft_factor > softest ? std::min(shortest, report.dt_bound) : report.dt_bound;
            pile.dt = std::min(free_step, 0.4 * shortest);
        }
    };
    go_on(softest, 2 * fall / terminal_speed, 4000);
    pile.model.dem()->local_damping = 0.7;
    for (const double soft_factor : {0.2, 0.4, 0.7}) {
        pile.dt *= 0.5;  // before the first stiffer contacts report theirs
        go_on(soft_factor, 1, 50);
    }
    go_on(1, 1, 800);
    pile.model.dem()->local_damping = 0;
    pile.model.dem()->mass_damping = 0;
    pile.dt = sim::largest_time_step(pile.model, sim::time_step_bound(pile.model));
}

/// The 18 shapes of the mix, six of each size, largest first.
struct Mix {
    std::vector<Polyhedron> shape;
    std::vector<double> circumradius;  ///< [m]
};

/// Scales a shape about its centre of mass to the circumradius.
Polyhedron scaled_to(Polyhedron shape, double circumradius) {
    const Vec3 centroid = geometry::mass_properties(shape).centroid;
    double largest = 0;
    for (const Vec3& x : shape.vertices) {
        largest = std::max(largest, norm(x - centroid));
    }
    for (Vec3& x : shape.vertices) {
        x = (circumradius / largest) * (x - centroid);
    }
    return shape;
}

Mix block_mix() {
    Draw draw(18);
    std::vector<Vec3> points;
    while (points.size() < 16) {
        const Vec3 x{draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)};
        if (norm(x) > 0.5 && norm(x) < 1) {
            points.push_back(x / norm(x));
        }
    }
    const std::array<Polyhedron, 6> kinds{geometry::regular_tetrahedron(1),   geometry::cube(1),
                                          geometry::prism(6, 1, 1.2).value(), geometry::octahedron(1),
                                          geometry::dodecahedron(1),          geometry::convex_hull(points).value()};
    Mix mix;
    for (const double circumradius : {2e-3, 1e-3, 0.5e-3}) {
        for (const Polyhedron& kind : kinds) {
            mix.shape.push_back(scaled_to(kind, circumradius));
            mix.circumradius.push_back(circumradius);
        }
    }
    return mix;
}

constexpr double tile_width = 22e-3, tile_height = 36e-3;  // [m]

/// A thousand blocks in a box, largest first, each where its bounding sphere finds room at random; one in ten is big,
/// three in ten are medium.
Pile scattered_tile() {
    Pile pile = empty_scene();
    add_box(pile, tile_width, tile_width);
    const Mix mix = block_mix();
    std::vector<ShapeId> shapes;
    for (const Polyhedron& shape : mix.shape) {
        shapes.push_back(pile.model.shapes.add_convex(shape));
    }
    Draw draw(1000);
    std::vector<Vec3> centers;
    std::vector<double> radii;
    for (int block = 0; block < 1000; ++block) {
        const int size = block < 100 ? 0 : block < 400 ? 1 : 2;
        const auto kind = static_cast<std::size_t>(6 * size + block % 6);
        const double radius = mix.circumradius[kind];
        Vec3 x{};
        bool has_room = false;
        while (!has_room) {
            x = {draw.between(radius, tile_width - radius), draw.between(radius, tile_width - radius),
                 draw.between(radius, tile_height - radius)};
            has_room = true;
            for (std::size_t i = 0; i < centers.size() && has_room; ++i) {
                has_room = norm(x - centers[i]) > radius + radii[i];
            }
        }
        centers.push_back(x);
        radii.push_back(radius);
        add_block(pile, shapes[kind], {x, random_orientation(draw)});
    }
    return pile;
}

const Pile& settled_tile() {
    static const Pile pile = [] {
        Pile made = scattered_tile();
        settle(made, tile_height - 8e-3, 0.166e-3);
        return made;
    }();
    return pile;
}

}  // namespace

Pile drop_cubes(int cubes_x, int cubes_y, int layers) {
    constexpr double edge = 1e-3, room = 13e-3 / 7, pitch = 1.8e-3;  // [m]; a cube's diagonal is 1.73 edges
    Pile pile = empty_scene();
    add_box(pile, cubes_x * room, cubes_y * room);
    const ShapeId cube = pile.model.shapes.add_convex(geometry::cube(edge));
    Draw draw(735);
    for (int k = 0; k < layers; ++k) {
        for (int j = 0; j < cubes_y; ++j) {
            for (int i = 0; i < cubes_x; ++i) {
                const Vec3 center{(i + 0.5) * room, (j + 0.5) * room, (k + 0.5) * pitch};
                add_block(pile, cube, {center, random_orientation(draw)});
            }
        }
    }
    shrink_to_fit(pile);
    settle(pile, layers * (pitch - edge * edge * edge / (room * room)), 0.5 * edge);
    return pile;
}

const Pile& settled_cubes() {
    static const Pile pile = drop_cubes(7, 7, 15);
    return pile;
}

Pile mixed_bed(int tiles_x, int tiles_y) {
    const Pile& tile = settled_tile();
    Pile bed = empty_scene();
    bed.model.shapes = tile.model.shapes;
    bed.dt = tile.dt;
    add_box(bed, tiles_x * tile_width, tiles_y * tile_width);
    for (int j = 0; j < tiles_y; ++j) {
        for (int i = 0; i < tiles_x; ++i) {
            for (std::int32_t body = 0; body < tile.model.bodies.size(); ++body) {
                const auto b = static_cast<std::size_t>(body);
                if (tile.model.bodies.drive[b] == body::Drive::free) {
                    add_block(bed, tile.model.bodies.parts[b].shape,
                              {tile.state.bodies.position[b] + Vec3{i * tile_width, j * tile_width, 0},
                               tile.state.bodies.orientation[b]});
                }
            }
        }
    }
    shrink_to_fit(bed);
    sim::initialise(bed.model, bed.state);
    return bed;
}

Pile voronoi_pack(std::int64_t block_count) {
    const double width = 1e-3 * std::cbrt(static_cast<double>(block_count));  // 1 mm^3 a block
    Pile pack = empty_scene();
    add_box(pack, width, width);
    const Polyhedron region = geometry::moved(geometry::cube(width), {{0.5 * width, 0.5 * width, 0.5 * width}, Quat{}});
    const std::vector<Polyhedron> blocks =
        geometry::voronoi_blocks(region, {.block_count = block_count, .seed = 1, .lloyd_iterations = 2}).value();
    for (const Polyhedron& block : blocks) {
        Vec3 centroid{};
        const ShapeId shape = pack.model.shapes.add_convex(block, false, &centroid);
        add_block(pack, shape, {centroid, Quat{}});
    }
    shrink_to_fit(pack);
    pack.dt = sim::largest_time_step(pack.model, sim::time_step_bound(pack.model));
    sim::initialise(pack.model, pack.state);
    return pack;
}

}  // namespace riprap::bench

// SPDX-License-Identifier: Apache-2.0
// Armour units on a slope.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/random_stream.hpp"
#include "riprap/scene/assemble/recipe_blocks.hpp"
#include "riprap/scene/case/orientation.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

namespace {

/// A sphere around a part of a unit, in the frame of the unit.
struct Ball {
    Vec3 centre;
    double radius;
};

/// A unit as far as placing it goes.
struct Unit {
    std::vector<body::Part> parts;
    std::vector<Ball> balls;
    std::vector<Vec3> corners;  ///< of all parts
    double nominal_diameter{0};
};

Unit unit_of(const CaseBuild& build, std::vector<body::Part> parts) {
    Unit unit;
    double volume = 0;
    for (const body::Part& part : parts) {
        const geometry::Polyhedron shape = build.model.shapes.polyhedron(part.shape);
        double radius = 0;
        for (Vec3 corner : shape.vertices) {
            corner.z = build.is_planar ? 0 : corner.z;
            radius = std::max(radius, norm(corner));
            unit.corners.push_back(part.local.position + rotate(part.local.orientation, corner));
        }
        unit.balls.push_back({part.local.position, radius});
        volume += build.model.shapes.volume(part.shape);
    }
    unit.nominal_diameter = build.is_planar ? std::sqrt(volume) : std::cbrt(volume);
    unit.parts = std::move(parts);
    return unit;
}

/// The slope: its foot, unit vectors up it, along the breakwater and out of it, and its lengths.
struct Slope {
    Vec3 foot, along, across, out;
    double length, width;
    Quat frame;
};

/// Axes with x up the slope and its normal y in planar scenes, else z.
Quat frame_of(const Vec3& along, const Vec3& out, bool is_planar) {
    const Vec3 third = cross(out, along);  // y of a frame with z = out
    const Vec3 y = is_planar ? out : third, z = is_planar ? cross(along, out) : out;
    Mat3 m;
    for (int r = 0; r < 3; ++r) {
        m(r, 0) = along[r];
        m(r, 1) = y[r];
        m(r, 2) = z[r];
    }
    return from_matrix(m);
}

std::optional<Slope> read_slope(CaseBuild& build, const Value& table) {
    const Vec3 from = get_vector(table, "from"), to = get_vector(table, "to"), up = build.up();
    const Vec3 way = to - from;
    const Value* width = table.find("width");
    if (!(dot(way, up) > 0) || norm(cross(way, up)) < 1e-9 * norm(way)) {
        build.problem(get(table, "to").place, "a slope that does not rise, or stands upright",
                      "'to' above 'from' and beside it");
        return std::nullopt;
    }
    if (build.is_planar == (width != nullptr)) {
        build.problem(table.place, build.is_planar ? "a 'width' in a planar scene" : "a slope in space without 'width'",
                      build.is_planar ? "no width: a planar scene is one metre wide"
                                      : "the width of the layer along the breakwater");
        return std::nullopt;
    }
    Slope slope{from, normalized(way), normalized(cross(up, way)), {}, norm(way), 0, {}};
    slope.out = cross(slope.along, slope.across);
    slope.width = width != nullptr ? width->as_number() : 0;
    slope.frame = frame_of(slope.along, slope.out, build.is_planar);
    return slope;
}

/// Places of the units of one layer, up the slope and across it, and their orientations.
struct Spot {
    double along, across;
    Quat orientation;
};

/// Farthest that a ball of the unit reaches from its frame.
double reach_of(const Unit& unit) {
    double reach = 0;
    for (const Ball& ball : unit.balls) {
        reach = std::max(reach, norm(ball.centre) + ball.radius);
    }
    return reach;
}

/// Units placed so far, in cells as wide as two of them reach: those that one can touch lie in the cells beside its
/// own.
class PlacedUnits {
 public:
    explicit PlacedUnits(double width) : width_(width) {}

    void add(std::size_t unit, const Vec3& place) { cells_[cell_of(place)].push_back(unit); }

    template <class Touches>
    bool none_near(const Vec3& place, const Touches& touches) const {
        const std::array<std::int64_t, 3> own = cell_of(place);
        for (int n = 0; n < 27; ++n) {
            const auto cell = cells_.find({own[0] + n % 3 - 1, own[1] + n / 3 % 3 - 1, own[2] + n / 9 - 1});
            if (cell != cells_.end() && std::any_of(cell->second.begin(), cell->second.end(), touches)) {
                return false;
            }
        }
        return true;
    }

 private:
    std::array<std::int64_t, 3> cell_of(const Vec3& x) const {
        const auto along = [this](double c) { return static_cast<std::int64_t>(std::floor(c / width_)); };
        return {along(x.x), along(x.y), along(x.z)};
    }

    double width_;
    std::map<std::array<std::int64_t, 3>, std::vector<std::size_t>> cells_;
};

class Placer {
 public:
    Placer(CaseBuild& build, const Value& table, const body::NewBody& common, Unit unit, const Slope& slope)
        : build_(build),
          table_(table),
          common_(common),
          unit_(std::move(unit)),
          slope_(slope),
          units_(2 * reach_of(unit_)) {}

    void place() {
        const auto layers = static_cast<int>(get_integer(table_, "layers"));
        const double per_layer = get_number(table_, "packing_density") / layers, diameter = unit_.nominal_diameter;
        const double pitch = build_.is_planar ? diameter / per_layer : diameter / std::sqrt(per_layer);
        const auto rows = static_cast<std::int64_t>(slope_.length / pitch + 1e-9);
        const auto columns = build_.is_planar ? 1 : static_cast<std::int64_t>(slope_.width / pitch + 1e-9);
        const auto count = rows * columns * layers;
        if (count < 1) {
            build_.problem(table_.place, fmt::format("no unit fits on the slope at a pitch of {:.4g} m", pitch),
                           "a longer or wider slope, smaller units or a higher packing density");
            return;
        }
        if (!has_room(build_, table_.place, common_.name, static_cast<std::size_t>(count))) {
            return;
        }
        const bool is_random = get_text(table_, "placement") == "random";
        const std::uint64_t seed = seed_for(build_, table_, common_.name);
        for (int layer = 0; layer < layers; ++layer) {
            for (std::int64_t row = 0; row < rows; ++row) {
                for (std::int64_t column = 0; column < columns; ++column) {
                    const auto number = static_cast<std::int64_t>(placed_.size());
                    RandomStream random(seed, common_.name, static_cast<std::uint64_t>(number));
                    add(is_random ? random_spot(random) : regular_spot(pitch, layer, row, column, rows, columns),
                        number);
                }
            }
        }
    }

 private:
    Spot random_spot(RandomStream& random) const {
        const double along = random.uniform(0, slope_.length);
        const double across = build_.is_planar ? 0 : random.uniform(0, slope_.width);
        return {along, across, random.orientation(build_.is_planar)};
    }
    Spot regular_spot(double pitch, int layer, std::int64_t row, std::int64_t column, std::int64_t rows,
                      std::int64_t columns) const {
        const Value* lowest = table_.find("orientation");
        const Value* upper = table_.find("upper_orientation");
        const double shift = layer % 2 == 0 ? 0.0 : 0.5;
        const double beside = (row + layer) % 2 == 0 ? 0.25 : 0.75;
        const double first = 0.5 * (slope_.length - static_cast<double>(rows) * pitch);
        const double left = 0.5 * (slope_.width - static_cast<double>(columns) * pitch);
        return {first + (static_cast<double>(row) + 0.25 + shift) * pitch,
                build_.is_planar ? 0 : left + (static_cast<double>(column) + beside) * pitch,
                slope_.frame * orientation_of(layer > 0 && upper != nullptr ? upper : lowest)};
    }
    /// The lowest place over the spot at which the unit is clear of the slope and of all units before.
    void add(const Spot& spot, std::int64_t number) {
        constexpr double clear = 1e-3, step = 0.02;  // of the nominal diameter
        const double diameter = unit_.nominal_diameter;
        double lowest = 0;
        for (const Vec3& corner : unit_.corners) {
            lowest = std::min(lowest, dot(rotate(spot.orientation, corner), slope_.out));
        }
        Vec3 place = slope_.foot + spot.along * slope_.along + spot.across * slope_.across +
                     (clear * diameter - lowest) * slope_.out;
        while (!is_clear(place, spot.orientation)) {
            place += step * diameter * slope_.out;
        }
        units_.add(placed_.size(), place);
        placed_.push_back({place, spot.orientation});
        body::NewBody block = common_;
        block.parts = unit_.parts;
        block.pose = {place, spot.orientation};
        add_recipe_block(build_, std::move(block), number);
    }
    bool is_clear(const Vec3& place, const Quat& orientation) const {
        return units_.none_near(place, [&](std::size_t near) {
            const Pose& other = placed_[near];
            for (const Ball& a : unit_.balls) {
                const Vec3 x = place + rotate(orientation, a.centre);
                for (const Ball& b : unit_.balls) {
                    if (norm(x - other.position - rotate(other.orientation, b.centre)) < a.radius + b.radius) {
                        return true;
                    }
                }
            }
            return false;
        });
    }

    CaseBuild& build_;
    const Value& table_;
    const body::NewBody& common_;
    Unit unit_;
    Slope slope_;
    std::vector<Pose> placed_;
    PlacedUnits units_;
};

}  // namespace

void build_slope(CaseBuild& build, const Value& table, const body::NewBody& common) {
    const Value& shape = get(table, "shape");
    if (ShapeLibrary::is_half_space(shape)) {
        build.problem(shape.place, "a half-space is no armour unit", "a shape with a volume");
        return;
    }
    auto parts = build.shapes.parts(shape);
    const std::optional<Slope> slope = read_slope(build, table);
    if (parts && slope && common.material.is_valid()) {
        Placer(build, table, common, unit_of(build, std::move(*parts)), *slope).place();
    }
}

}  // namespace riprap::scene

// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/ding/planar_ballast.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/geometry/random_bits.hpp"

namespace riprap::validation::ding {

using geometry::Vec2;
using solid::planar_dda::Joint;

namespace {

constexpr double smallest = 0.0315, largest = 0.063;  // sieve sizes [m]
constexpr double across = 0.0825;                     // thickness of the plane model, pi/4 of 105 mm [m]
constexpr double gravity = 9.81;

/// Spring of 1e7 N/m with a dashpot for a restitution of 0.4: xi = -ln e/sqrt(pi^2 + ln^2 e).
Joint ballast_joint() {
    const double l = std::log(0.4);
    return {.normal_stiffness = 1e7,
            .shear_stiffness = 4e6,
            .friction = 1,
            .damping_ratio = -l / std::sqrt(std::numbers::pi * std::numbers::pi + l * l)};
}

class Draw {
 public:
    explicit Draw(std::uint64_t seed) : seed_(seed) {}
    double operator()() { return geometry::unit_interval(geometry::mix_bits(seed_, count_++)); }

 private:
    std::uint64_t seed_, count_{0};
};

/// Corners on an ellipse at uneven angles: convex.
std::vector<Vec2> stone(Draw& draw, const Vec2& center) {
    const double size = smallest * std::pow(largest / smallest, draw());
    const double flatness = 0.7 + 0.3 * draw(), turn = 2 * std::numbers::pi * draw();
    const int count = 5 + static_cast<int>(3.999 * draw());
    std::vector<Vec2> corners;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.35 * (2 * draw() - 1)) / count;
        const Vec2 p{0.5 * size * std::cos(angle), 0.5 * size * flatness * std::sin(angle)};
        corners.push_back(
            center + Vec2{std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y});
    }
    return corners;
}

double surface_of(const PlanarTrial& trial, std::int32_t first, double length) {
    // the highest corner in each strip 60 mm wide of the middle half
    const int strips = static_cast<int>(0.5 * length / 0.06);
    std::vector<double> top(at(strips), 0.0);
    for (std::size_t k = at(trial.model.corner_begin[at(first)]); k < trial.model.corner.size(); ++k) {
        const Vec2 p = place_of(trial.state, trial.model.corner_block[k], trial.model.corner[k]);
        const int strip = static_cast<int>(std::floor((p.x + 0.25 * length) / 0.06));
        if (strip >= 0 && strip < strips) {
            top[at(strip)] = std::max(top[at(strip)], p.y);
        }
    }
    double sum = 0;
    for (const double height : top) {
        sum += height;
    }
    return sum / strips;
}

}  // namespace

BallastBed make_bed(double length, double thickness, std::uint64_t seed) {
    BallastBed bed{PlanarTrial({2600, 5e10, 0.2}, ballast_joint())};
    PlanarTrial& trial = bed.trial;
    trial.model.thickness = across;
    trial.settings = solid::planar_dda::settings_for(length, 0.0015);
    bed.ice_material = trial.add_material({934, 1e10, 0.06}, ballast_joint());
    trial.add_box({-0.5 * length - 0.3, -0.2}, {length + 0.6, 0.2}, true);
    bed.wall_height = 3 * thickness;
    bed.walls = {trial.add_box({-0.5 * length - 0.2, 0}, {0.2, bed.wall_height}, true),
                 trial.add_box({0.5 * length, 0}, {0.2, bed.wall_height}, true)};
    bed.first_stone = trial.model.block_count();
    Draw draw(seed);
    const double cell = 1.02 * largest;
    const int columns = static_cast<int>(length / cell);
    double area = 0;
    for (int row = 0; area < 0.8 * length * thickness; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x = -0.5 * length + (column + 0.5) * length / columns;
            trial.add(stone(draw, {x, (row + 0.5) * cell}));
            area += trial.model.area.back();
        }
    }
    bed.stone_count = trial.model.block_count() - bed.first_stone;
    // Pours the stones with low friction and damping to a dense packing, then restores the friction.
    Joint smooth = ballast_joint();
    smooth.friction = 0.1;
    trial.model.set_joint(0, 0, smooth);
    trial.settings.dynamic_factor = 0.998;
    trial.dt = 5e-4;
    trial.run(0.7);
    trial.model.set_joint(0, 0, ballast_joint());
    trial.settings.dynamic_factor = 0.9;
    trial.run(0.1);
    trial.settings.dynamic_factor = 1;
    trial.time = 0;
    std::fill(trial.state.rates.begin(), trial.state.rates.end(), 0.0);
    bed.surface = surface_of(trial, bed.first_stone, length);
    bed.porosity = 1 - area / (length * bed.surface);
    for (std::int32_t b = bed.first_stone; b < trial.model.block_count(); ++b) {
        bed.start.push_back(trial.center(b));
    }
    return bed;
}

namespace {

/// Watches one strike.
struct Watch {
    const BallastBed& bed;
    PlanarTrial& trial;
    std::int32_t ice;
    std::int32_t struck{-1};  ///< stone that the ice meets first: the marked one
    Strike result{};
    Vec2 touch{};
    double fastest{0};                       ///< rise of the ice so far [m/s]
    double last_touch{0};                    ///< time until which the ice has touched a stone [s]
    std::vector<double> rise{}, drift{};     ///< largest rise and drift of every stone [m]
    std::vector<std::vector<Vec2>> paths{};  ///< of every stone: time and height while it is well above the bed

    /// Looks for a strike after the ice has been clear of all stones for 50 ms, in which it falls by 12 mm.
    void look_for_second_strike() {
        if (result.impact_time == 0) {
            return;
        }
        for (std::int32_t b = bed.first_stone; b < bed.first_stone + bed.stone_count; ++b) {
            // a stone in flight that it meets is no strike on the bed
            if (trial.center(b).y <= bed.surface && trial.do_touch(ice, b)) {
                if (result.second_strike == 0 && last_touch > 0 && trial.time - last_touch > 0.05) {
                    result.second_strike = trial.time;
                }
                last_touch = trial.time;
            }
        }
    }

    void look() {
        if (result.impact_time == 0) {
            for (std::int32_t b = bed.first_stone; b < bed.first_stone + bed.stone_count; ++b) {
                if (trial.do_touch(ice, b) && struck < 0) {
                    result.impact_time = trial.time;
                    touch = trial.center(ice);
                    struck = b - bed.first_stone;
                }
            }
        }
        for (std::int32_t k = 0; k < bed.stone_count; ++k) {
            const Vec2 moved = trial.center(bed.first_stone + k) - bed.start[at(k)];
            if (k == struck && moved.y > rise[at(k)]) {
                result.marked_apex = trial.time;
            }
            rise[at(k)] = std::max(rise[at(k)], moved.y);
            drift[at(k)] = std::max(drift[at(k)], std::abs(moved.x));
            if (trial.center(bed.first_stone + k).y > bed.surface + 0.08) {
                paths[at(k)].push_back({trial.time, trial.center(bed.first_stone + k).y});
            }
        }
        if (result.impact_time > 0) {
            result.ice_way = std::max(result.ice_way, norm(trial.center(ice) - touch));
            result.ice_bounce = std::max(result.ice_bounce, trial.center(ice).y - touch.y);
            if (result.times.empty() || trial.time - result.impact_time > result.times.back() + 2e-3) {
                result.times.push_back(trial.time - result.impact_time);
                result.ice_ways.push_back(norm(trial.center(ice) - touch));
                result.marked_ways.push_back(norm(trial.center(bed.first_stone + struck) - bed.start[at(struck)]));
            }
            const Vec2 velocity = trial.velocity(ice);
            if (velocity.y > fastest) {
                fastest = velocity.y;
                result.ice_angle = std::atan2(velocity.y, std::abs(velocity.x));
            }
        }
    }

    /// Measures what is left of the bed.
    void look_at_crater() {
        double left = INFINITY, right = -INFINITY;
        for (std::int32_t k = 0; k < bed.stone_count; ++k) {
            const Vec2& start = bed.start[at(k)];
            const Vec2 moved = trial.center(bed.first_stone + k) - start;
            result.crater_depth = std::max(result.crater_depth, -moved.y);
            if (norm(moved) > 0.0235) {
                left = std::min(left, start.x);
                right = std::max(right, start.x);
            }
        }
        result.crater_width = std::max(0.0, right - left);
    }

    /// 1 - R^2 of the longest flight against the parabola of gravity through its ends.
    double misfit() const {
        const auto longest = std::max_element(paths.begin(), paths.end(),
                                              [](const auto& a, const auto& b) { return a.size() < b.size(); });
        if (longest == paths.end() || longest->size() < 20) {
            return std::nan("");
        }
        const Vec2 a = longest->front(), b = longest->back();
        const double span = b.x - a.x, speed = (b.y - a.y) / span + 0.5 * gravity * span;
        double mean = 0, off = 0, all = 0;
        for (const Vec2& p : *longest) {
            mean += p.y / static_cast<double>(longest->size());
        }
        for (const Vec2& p : *longest) {
            const double t = p.x - a.x, exact = a.y + speed * t - 0.5 * gravity * t * t;
            off += (p.y - exact) * (p.y - exact);
            all += (p.y - mean) * (p.y - mean);
        }
        return off / all;
    }
};

/// Returns the height of the centre of the ice at which its underside first touches a stone, coming straight down.
double height_clear_of(const BallastBed& bed, const Shot& shot) {
    const PlanarTrial& trial = bed.trial;
    const double half = shot.corners > 0 ? shot.size.x : 0.5 * shot.size.x;
    double height = -INFINITY;
    const auto clear_point = [&](const Vec2& p) {
        const double off = p.x - shot.place;
        if (std::abs(off) <= half) {
            height =
                std::max(height, p.y + (shot.corners > 0 ? std::sqrt(half * half - off * off) : 0.5 * shot.size.y));
        }
    };
    constexpr int shares = 20;  // of an edge
    for (std::int32_t b = bed.first_stone; b < bed.first_stone + bed.stone_count; ++b) {
        const std::int32_t first = trial.model.corner_begin[at(b)], end = trial.model.corner_begin[at(b) + 1];
        for (std::int32_t k = first; k < end; ++k) {
            const Vec2 p = place_of(trial.state, b, trial.model.corner[at(k)]);
            const Vec2 q = place_of(trial.state, b, trial.model.corner[at(k + 1 < end ? k + 1 : first)]);
            for (int i = 0; i < shares; ++i) {
                clear_point(p + (static_cast<double>(i) / shares) * (q - p));
            }
        }
    }
    return height;
}

/// Lowers the walls to half of the smallest stone below the surface, where ice that has fallen a little passes them.
void lower_walls(const BallastBed& bed, PlanarTrial& trial) {
    const double depth = bed.wall_height - (bed.surface - 0.5 * smallest);
    for (const std::int32_t wall : bed.walls) {
        trial.state.y[at(wall)] -= depth;
    }
    const auto is_wall = [&bed](std::int32_t block) { return std::ranges::find(bed.walls, block) != bed.walls.end(); };
    solid::planar_dda::drop_contacts(trial.state, [&](std::size_t k) {  // their lock points went along
        return is_wall(trial.model.corner_block[at(trial.state.contact_corner[k])]) ||
               is_wall(trial.model.corner_block[at(trial.state.contact_edge[k])]);
    });
}

}  // namespace

Strike strike(const BallastBed& bed, const Shot& shot) {
    PlanarTrial trial = bed.trial;
    if (shot.velocity.x != 0) {
        lower_walls(bed, trial);
    }
    const double reach = shot.corners > 0 ? shot.size.x : 0.5 * shot.size.y;
    const double lowest = shot.is_flat ? reach * std::cos(std::numbers::pi / std::max(3, shot.corners)) : reach;
    // Above the mean surface, and above what stands higher: a spring that begins pressed would throw stones by itself.
    const Vec2 center{shot.place, std::max(bed.surface + shot.height + lowest, height_clear_of(bed, shot) + 1e-4)};
    const std::int32_t ice = shot.corners > 0
                                 ? trial.add_regular(center, shot.size.x, shot.corners, shot.is_flat, bed.ice_material)
                                 : trial.add_box(center - 0.5 * shot.size, shot.size, false, bed.ice_material);
    trial.set_velocity(ice, shot.velocity);
    Watch watch{bed, trial, ice};
    watch.rise.assign(at(bed.stone_count), 0);
    watch.drift.assign(at(bed.stone_count), 0);
    watch.paths.resize(at(bed.stone_count));
    trial.dt = shot.height > 0.2 ? 1e-3 : 1e-4;
    const auto run = [&](double after, const auto& look) {
        const auto end = [&] { return watch.result.impact_time > 0 ? watch.result.impact_time + after : 2.0; };
        while (trial.time < end()) {
            const bool is_near = trial.center(ice).y - lowest < bed.surface + 0.08;
            trial.dt = is_near || watch.result.impact_time > 0 ? 1e-4 : trial.dt;
            trial.step();
            look();
            watch.look_for_second_strike();
        }
    };
    run(shot.after, [&] {
        watch.look();
        for (const std::int32_t rail : bed.rails) {
            watch.result.has_hit_rail = watch.result.has_hit_rail || trial.do_touch(ice, rail);
        }
    });
    for (const double rise : watch.rise) {
        watch.result.flying += rise > 0.047 ? 1 : 0;
        watch.result.above_330 += rise > 0.33 ? 1 : 0;
        watch.result.highest = std::max(watch.result.highest, rise);
    }
    if (watch.struck >= 0) {
        watch.result.marked = {watch.drift[at(watch.struck)], watch.rise[at(watch.struck)]};
    }
    watch.look_at_crater();
    watch.result.ice = trial.center(ice) - center;
    watch.result.parabola = watch.misfit();
    run(shot.watch, [] {});
    watch.result.ledger = trial.ledger_error();
    return watch.result;
}

}  // namespace riprap::validation::ding

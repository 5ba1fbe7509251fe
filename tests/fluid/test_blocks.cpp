// SPDX-License-Identifier: Apache-2.0
// Whole blocks of particles dealt to several holders, each with ghosts: what a holder decides has the bits of one
// holder that has everything.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <random>
#include <vector>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/schemes.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr double spacing = 0.02;
constexpr int columns = 330, rows = 92, layers = 4;

/// Water that sloshes, splashes and is not in order, over a floor and, unless it is periodic, between two walls.
template <class Settings>
struct Slosh {
    Settings settings;
    ParticleState state;
    BoundaryParticles walls;
    Vec3 gravity{0.3, -9.81, 0};

    explicit Slosh(const Settings& chosen, bool is_periodic) : settings(chosen) {
        Water water;
        water.settings = settings_2d(spacing, 20 * std::sqrt(9.81 * rows * spacing));
        ParticleSettings& base = settings;
        base.spacing = spacing;
        base.sound_speed = water.settings.sound_speed;
        base.particle_mass = water.settings.particle_mass;
        base.domain = water.settings.domain;
        if (is_periodic) {
            base.domain.is_periodic[0] = true;
            base.domain.low.x = 0;
            base.domain.high.x = columns * spacing;
        }
        for (int row = -layers; row < rows + 30; ++row) {
            for (int column = is_periodic ? 0 : -layers; column < columns + (is_periodic ? 0 : layers); ++column) {
                if (row < 0 || column < 0 || column >= columns) {
                    water.add_wall_particle({(column + 0.5) * spacing, (row + 0.5) * spacing, 0}, column % 3 == 0);
                }
            }
        }
        walls = water.walls;
        std::mt19937_64 random(4);
        std::uniform_real_distribution<double> off(-0.15, 0.15);
        for_lattice(spacing, columns * spacing, rows * spacing, [&](double x, double y) {
            const Vec3 place{x + off(random) * spacing, y + off(random) * spacing, 0};
            const Vec3 v{0.8 * std::sin(5 * x) + off(random), 0.5 * std::cos(7 * x) * y + off(random), 0};
            state.add(place, v, density_of(base, 1000 * 9.81 * (rows * spacing - y)),
                      static_cast<std::int32_t>(state.size()));
        });
        for (int k = 0; k < 40; ++k) {  // drops above the surface
            state.add({(0.1 + k / 41.0) * columns * spacing, (rows + 3 + k % 5) * spacing, 0}, {0, -1, 0}, 1000,
                      static_cast<std::int32_t>(state.size()));
        }
        sort_by_place(state, base.domain, spacing);
    }
};

/// One step as the driver makes it.
template <class Settings>
void step(const Settings& settings, ParticleScheme& scheme, ParticleState& state, BoundaryParticles& walls,
          const Vec3& gravity, double last_dt, double dt, ParticleReport& report) {
    const TimeSpan span{0, dt};
    scheme.update_density(state, walls, gravity, 0.5 * (last_dt + dt), report);
    drift(settings, state, 0.5 * dt);
    scheme.begin_forces(state, walls, span, gravity, report);
    if constexpr (std::is_same_v<Settings, MpsSettings>) {
        return;  // its pressure is one solve for all water: up to there, collisions and their velocities included
    }
    scheme.load_walls(state, walls, gravity);
    scheme.kick(state, walls, gravity, span, {}, report);
    drift(settings, state, 0.5 * dt);
}

/// Box around the particles of a block.
struct BlockBox {
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
};
/// Least distance along the axes, by the nearest periodic image.
double apart(const BlockBox& a, const BlockBox& b, double period) {
    const auto gap = [](double low_a, double high_a, double low_b, double high_b) {
        return std::max({low_a - high_b, low_b - high_a, 0.0});
    };
    double along_x = gap(a.low.x, a.high.x, b.low.x, b.high.x);
    for (const double shift : {-period, period}) {
        along_x = std::min(along_x, gap(a.low.x, a.high.x, b.low.x + shift, b.high.x + shift));
    }
    return std::max(along_x, gap(a.low.y, a.high.y, b.low.y, b.high.y));
}

/// Some of the blocks, and ghosts of all blocks that are near one of them.
template <class Settings>
struct Holder {
    std::unique_ptr<ParticleScheme> scheme;
    ParticleState state;
    BoundaryParticles walls;
    ParticleReport report;
    std::vector<std::size_t> entity;   ///< in the State of the whole
    std::vector<std::uint8_t> is_own;  ///< per entity

    Holder(const Slosh<Settings>& whole, const std::vector<BlockBox>& boxes, const std::vector<std::size_t>& owner,
           std::size_t self, double reach)
        : scheme(make_scheme(whole.settings)), walls(whole.walls) {
        const parallel::Blocks blocks = whole.state.blocks();
        const double period = whole.settings.domain.is_periodic[0] ? columns * spacing : 1e9;
        state.held.whole = blocks.whole();
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            bool is_near = false;
            for (std::size_t other = 0; other < boxes.size(); ++other) {
                is_near = is_near || (owner[other] == self && apart(boxes[b], boxes[other], period) < reach);
            }
            if (!is_near) {
                continue;
            }
            const parallel::Block block = blocks[static_cast<std::int64_t>(b)];
            state.held.add(block.number, owner[b] == self, block.count);
            for (std::int64_t i = block.first; i < block.first + block.count; ++i) {
                entity.push_back(static_cast<std::size_t>(i));
                is_own.push_back(owner[b] == self ? 1 : 0);
            }
        }
    }
    /// Calls f(of the holder, of the whole) for each column.
    template <class F>
    static void for_columns(ParticleState& part, const ParticleState& whole, const F& f) {
        f(part.position, whole.position);
        f(part.velocity, whole.velocity);
        f(part.density, whole.density);
        f(part.dilution, whole.dilution);
        f(part.damping, whole.damping);
        f(part.shift, whole.shift);
        f(part.id, whole.id);
    }
    /// Takes the ghosts, and at first everything, as the whole has them.
    void take(const ParticleState& whole, bool takes_own) {
        for_columns(state, whole, [&](auto& to, const auto& from) {
            to.resize(from.empty() ? 0 : entity.size());
            for (std::size_t i = 0; i < to.size(); ++i) {
                if (takes_own || is_own[i] == 0) {
                    to[i] = from[entity[i]];
                }
            }
        });
    }
    /// Counts own entries that differ from those of the whole.
    std::int64_t different(const ParticleState& whole) {
        std::int64_t count = 0;
        for_columns(state, whole, [&](const auto& part, const auto& all) {
            ASSERT_EQ(part.empty(), all.empty());
            for (std::size_t i = 0; i < part.size(); ++i) {
                count += is_own[i] != 0 && !(part[i] == all[entity[i]]) ? 1 : 0;
            }
        });
        return count;
    }
};

template <class Settings>
void expect_bits_of_the_whole(const Settings& settings, bool is_periodic, std::size_t holder_count) {
    Slosh<Settings> whole(settings, is_periodic);
    const parallel::Blocks blocks = whole.state.blocks();
    std::vector<BlockBox> boxes(static_cast<std::size_t>(blocks.count()));
    ASSERT_GT(boxes.size(), 10U);  // more than one round of patches
    for (std::size_t i = 0; i < whole.state.position.size(); ++i) {
        BlockBox& box = boxes[i / static_cast<std::size_t>(parallel::reduce_block)];
        box = {min(box.low, whole.state.position[i]), max(box.high, whole.state.position[i])};
    }
    std::mt19937_64 random(holder_count);
    std::vector<std::size_t> owner(boxes.size());
    for (std::size_t b = 0; b < owner.size(); ++b) {
        owner[b] = b < holder_count ? b : random() % holder_count;
    }
    std::shuffle(owner.begin(), owner.end(), random);
    std::vector<Holder<Settings>> holders;
    std::size_t fewest = whole.state.position.size();
    for (std::size_t self = 0; self < holder_count; ++self) {
        holders.emplace_back(whole, boxes, owner, self, 5 * whole.settings.support_radius());
        fewest = std::min(fewest, holders.back().entity.size());
    }
    ASSERT_LT(fewest, whole.state.position.size());

    const std::unique_ptr<ParticleScheme> scheme = make_scheme(whole.settings);
    double last_dt = 0;
    for (int k = 0; k < 4; ++k) {
        for (Holder<Settings>& holder : holders) {
            holder.take(whole.state, k == 0);
        }
        const double dt = scheme->limit(whole.state).limit;
        ParticleReport report;
        step(whole.settings, *scheme, whole.state, whole.walls, whole.gravity, last_dt, dt, report);
        ASSERT_EQ(report.problem, "");
        double kinetic = 0;
        for (Holder<Settings>& holder : holders) {
            holder.report = {};
            step(whole.settings, *holder.scheme, holder.state, holder.walls, whole.gravity, last_dt, dt, holder.report);
            ASSERT_EQ(holder.different(whole.state), 0) << "step " << k << ", " << holder_count << " holders";
            kinetic += holder.report.kinetic;
        }
        EXPECT_NEAR(kinetic, report.kinetic, 1e-12 * report.kinetic);  // ghosts are not counted
        last_dt = dt;
    }
}

struct MullerSettings : SphSettings {
    MullerSettings() { scheme = SphScheme::muller; }
};

template <class Settings>
class DealtBlocks : public ::testing::Test {};
using DealtSettings = ::testing::Types<SphSettings, MullerSettings, WcmpsSettings, MpsSettings>;
TYPED_TEST_SUITE(DealtBlocks, DealtSettings);

TYPED_TEST(DealtBlocks, step_to_the_bits_of_the_whole) {
    for (const std::size_t holders : {3U, 7U}) {
        expect_bits_of_the_whole(TypeParam{}, false, holders);
    }
}

TYPED_TEST(DealtBlocks, step_to_the_bits_of_the_whole_across_periodic_sides) {
    for (const std::size_t holders : {3U, 7U}) {
        expect_bits_of_the_whole(TypeParam{}, true, holders);
    }
}

}  // namespace
}  // namespace riprap::fluid::testing

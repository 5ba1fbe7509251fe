// SPDX-License-Identifier: Apache-2.0
// Bodies dealt to several holders, each with ghosts in reach: what a holder decides has the bits of one holder that has
// everything, springs of contacts included.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/solid/polyhedral_dem/polyhedral_dem.hpp"
#include "riprap/solid/sphere_dem/sphere_world.hpp"
#include "solid/body_scene.hpp"

namespace riprap::solid {
namespace {

/// Numbers of the bodies that a holder keeps, ascending, and which of them are its own. Body 0 is the floor.
struct Kept {
    std::vector<std::int32_t> number;
    std::vector<std::uint8_t> is_own;
};

/// Deals blocks of bodies out at random. Ghosts are all that lie within `reach` of an own one; everybody has the floor.
std::vector<Kept> deal(const std::vector<Vec3>& place, std::size_t holders, double reach) {
    constexpr std::size_t block = 32;
    std::mt19937_64 random(holders);
    std::vector<std::size_t> owner(place.size());
    for (std::size_t b = 0; b < owner.size(); ++b) {
        owner[b] = b % block > 0 ? owner[b - 1] : random() % holders;
    }
    std::vector<Kept> kept(holders);
    for (std::size_t self = 0; self < holders; ++self) {
        for (std::size_t b = 0; b < place.size(); ++b) {
            const bool is_own = b > 0 && owner[b] == self;
            bool is_near = b == 0 || is_own;
            for (std::size_t other = 1; other < place.size() && !is_near; ++other) {
                is_near = owner[other] == self && norm(place[b] - place[other]) < reach;
            }
            if (is_near) {
                kept[self].number.push_back(static_cast<std::int32_t>(b));
                kept[self].is_own.push_back(is_own ? 1 : 0);
            }
        }
    }
    return kept;
}

std::vector<std::int32_t> all_of(std::size_t count) {
    std::vector<std::int32_t> numbers(count);
    for (std::size_t b = 0; b < count; ++b) {
        numbers[b] = static_cast<std::int32_t>(b);
    }
    return numbers;
}

/// Calls f(of the holder, of the whole) for each column of bodies that move freely.
template <class F>
void for_columns(body::BodyState& part, const body::BodyState& whole, const F& f) {
    f(part.position, whole.position);
    f(part.orientation, whole.orientation);
    f(part.velocity, whole.velocity);
    f(part.angular_momentum, whole.angular_momentum);
}
/// Gives a holder its ghosts as the whole has them.
void take_ghosts(const Kept& kept, const body::BodyState& whole, body::BodyState& part) {
    for_columns(part, whole, [&](auto& to, const auto& from) {
        for (std::size_t b = 0; b < to.size(); ++b) {
            if (kept.is_own[b] == 0) {
                to[b] = from[at(kept.number[b])];
            }
        }
    });
}
/// Counts own entries that differ from those of the whole.
std::int64_t different(const Kept& kept, const body::BodyState& whole, body::BodyState& part) {
    std::int64_t count = 0;
    for_columns(part, whole, [&](const auto& one, const auto& all) {
        for (std::size_t b = 0; b < one.size(); ++b) {
            count += kept.is_own[b] != 0 && !(one[b] == all[at(kept.number[b])]) ? 1 : 0;
        }
    });
    return count;
}

struct Block {
    Pose pose;
    Vec3 velocity;
};

/// A long heap of cubes, a little turned, pressed into each other and moving.
std::vector<Block> heap() {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> off(-0.02, 0.02);
    std::vector<Block> blocks;
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 3; ++j) {
            for (int layer = 0; layer < 3; ++layer) {
                const Quat turn = normalized(Quat{1, off(random), off(random), off(random)});
                blocks.push_back({{{0.99 * i + off(random), 0.99 * j + off(random), 0.48 + 0.98 * layer}, turn},
                                  {off(random) * 20, off(random) * 20, -0.2}});
            }
        }
    }
    return blocks;
}

struct Cubes : BodyScene {
    DemSettings settings;
    NoFields fields;
    PolyhedralDem::Scratch scratch;
    double time{0};

    explicit Cubes(const std::vector<std::int32_t>& numbers) {
        static const std::vector<Block> blocks = heap();
        add_material({.name = "rock", .density = 2000, .normal_stiffness = 1e7, .friction = 0.5, .damping_ratio = 0.3});
        add({}, shapes.add_half_space({0, 0, 1}, 0), body::Drive::fixed);
        const ShapeId cube = shapes.add_convex(geometry::cube(1), false, nullptr);
        for (const std::int32_t number : numbers) {
            if (number > 0) {
                const Block& block = blocks[at(number - 1)];
                const BodyId id = add(block.pose, cube);
                state.velocity[at(id.value)] = block.velocity;
            }
        }
    }
    void step(double dt) {
        const SolidScene all = scene();
        PolyhedralDem method(all, settings, {state, contacts, previous_dt}, fields, scratch);
        SolidReport report;
        const Outcome outcome = method.advance({time, dt}, {}, Measure::energy, report);
        ASSERT_EQ(outcome.problem, "");
        time += dt;
    }
};

/// Springs of one contact of polyhedra.
struct Spring {
    Vec3 normal, force;
    double torsion, energy;
    friend bool operator==(const Spring&, const Spring&) = default;
};

std::map<std::pair<std::uint64_t, std::uint64_t>, Spring> springs_of(const contact::ContactHistory& history,
                                                                     const std::vector<std::int32_t>& number,
                                                                     const std::vector<std::uint8_t>& is_own) {
    std::map<std::pair<std::uint64_t, std::uint64_t>, Spring> springs;
    for (std::size_t c = 0; c < history.size(); ++c) {
        const std::size_t a = history.pair[c] >> 32, b = history.pair[c] & 0xFFFFFFFF;
        if (is_own[a] != 0 || is_own[b] != 0) {
            const auto key = static_cast<std::uint64_t>(number[a]) << 32 | static_cast<std::uint64_t>(number[b]);
            springs[{key, history.feature[c]}] = {history.normal[c], history.shear_force[c], history.torsion[c],
                                                  history.shear_energy[c]};
        }
    }
    return springs;
}

class DealtBodies : public ::testing::TestWithParam<std::size_t> {};

TEST_P(DealtBodies, PolyhedraStepToTheBitsOfTheWhole) {
    for (const PairContact law : {PairContact::distance_potential, PairContact::common_plane_soft}) {
        Cubes whole(all_of(heap().size() + 1));
        whole.settings.pair_contact = law;
        const std::vector<Kept> kept = deal(whole.state.position, GetParam(), 1.9);
        std::vector<Cubes> holders;
        for (const Kept& of : kept) {
            ASSERT_LT(of.number.size(), whole.state.position.size());
            holders.emplace_back(of.number).settings = whole.settings;
        }
        for (int k = 0; k < 20; ++k) {
            for (std::size_t h = 0; h < holders.size(); ++h) {
                take_ghosts(kept[h], whole.state, holders[h].state);
            }
            whole.step(2e-4);
            for (std::size_t h = 0; h < holders.size(); ++h) {
                holders[h].step(2e-4);
                ASSERT_EQ(different(kept[h], whole.state, holders[h].state), 0) << "step " << k;
            }
        }
        EXPECT_GT(whole.contacts.size(), 500U);
        std::size_t held = 0;
        for (std::size_t h = 0; h < holders.size(); ++h) {
            std::vector<std::uint8_t> is_own(whole.state.position.size());
            for (std::size_t b = 0; b < kept[h].number.size(); ++b) {
                is_own[at(kept[h].number[b])] = kept[h].is_own[b];
            }
            const auto springs = springs_of(holders[h].contacts, kept[h].number, kept[h].is_own);
            EXPECT_TRUE(springs == springs_of(whole.contacts, all_of(is_own.size()), is_own));
            held += springs.size();
        }
        EXPECT_GE(held, whole.contacts.size());  // those with the floor once, others once or twice
    }
}

/// A bed of spheres of three sizes that settles, more than two blocks of rows of them.
struct Bed : sphere_dem::SphereWorld {
    static constexpr int side = 12, layers = 9;
    static constexpr std::size_t count = side * side * layers;
    static constexpr double radius = 0.05;

    explicit Bed(const std::vector<std::int32_t>& numbers) {
        std::mt19937_64 random(9);
        std::uniform_real_distribution<double> off(-0.1, 0.1);
        gravity = {0.5, 0, -9.81};
        const MaterialId grain = add_material({.youngs_modulus = 1e7, .poisson_ratio = 0.3, .restitution = 0.6});
        materials.back().static_friction = materials.back().kinetic_friction = 0.4;
        settings.rolling = contact::RollingLaw::spring;
        materials.back().rolling_friction = 0.05;
        add_plane(grain, {0, 0, 1}, {});
        for (std::size_t s = 0; s < count; ++s) {
            const auto i = static_cast<int>(s) % side, j = static_cast<int>(s) / side % side,
                       k = static_cast<int>(s) / (side * side);
            const double r = radius * (1 + 0.02 * static_cast<double>(s % 3));
            const Vec3 place{0.1 * i + 0.1 * radius * off(random), 0.1 * j + 0.1 * radius * off(random),
                             0.99 * radius + 0.099 * k};
            const Vec3 velocity{off(random), off(random), off(random)}, spin{off(random), off(random), off(random)};
            if (std::ranges::binary_search(numbers, static_cast<std::int32_t>(s + 1))) {
                add_sphere(grain, r, 2500 * 4.19 * r * r * r, {{place, {}}, velocity, spin});
                spheres.number.push_back(static_cast<std::int32_t>(s));
            }
        }
        build();
    }
};

/// Springs of one contact of spheres.
struct SphereSpring {
    Vec3 force, rolling;
    double stiffness;
    friend bool operator==(const SphereSpring&, const SphereSpring&) = default;
};
std::map<std::uint64_t, SphereSpring> springs_of(const sphere_dem::Springs& springs,
                                                 const std::vector<std::int32_t>& number,
                                                 const std::vector<std::uint8_t>& is_own, bool are_walls) {
    std::map<std::uint64_t, SphereSpring> found;
    for (std::size_t c = 0; c < springs.size(); ++c) {
        const std::size_t a = springs.pair[c] >> 32, b = springs.pair[c] & 0xFFFFFFFF;
        if (is_own[a] != 0 || (!are_walls && is_own[b] != 0)) {
            const auto other = are_walls ? static_cast<std::uint64_t>(b) : static_cast<std::uint64_t>(number[b]);
            found[static_cast<std::uint64_t>(number[a]) << 32 | other] = {springs.force[c], springs.rolling[c],
                                                                          springs.stiffness[c]};
        }
    }
    return found;
}

TEST_P(DealtBodies, SpheresStepToTheBitsOfTheWhole) {
    Bed whole(all_of(Bed::count + 1));
    const std::vector<Kept> kept = deal(whole.state.position, GetParam(), 3 * Bed::radius);
    std::vector<Bed> holders;
    for (const Kept& of : kept) {
        ASSERT_LT(of.number.size(), whole.state.position.size());
        holders.emplace_back(of.number);
    }
    const double dt = whole.step_limit();
    for (int k = 0; k < 60; ++k) {
        for (std::size_t h = 0; h < holders.size(); ++h) {
            take_ghosts(kept[h], whole.state, holders[h].state);
        }
        whole.step(dt);
        for (std::size_t h = 0; h < holders.size(); ++h) {
            holders[h].step(dt);
            ASSERT_EQ(different(kept[h], whole.state, holders[h].state), 0) << "step " << k;
        }
    }
    EXPECT_GT(whole.contacts.contacts.size(), 1000U);
    EXPECT_GT(whole.contacts.walls.size(), 50U);
    for (std::size_t h = 0; h < holders.size(); ++h) {
        std::vector<std::uint8_t> is_own(Bed::count), is_own_there;
        std::vector<std::int32_t> number_there;
        for (std::size_t b = 1; b < kept[h].number.size(); ++b) {
            number_there.push_back(kept[h].number[b] - 1);
            is_own_there.push_back(kept[h].is_own[b]);
            is_own[at(number_there.back())] = is_own_there.back();
        }
        for (const bool are_walls : {false, true}) {
            const auto rows = [are_walls](const sphere_dem::SphereState& s) -> const sphere_dem::Springs& {
                return are_walls ? s.walls : s.contacts;
            };
            EXPECT_TRUE(springs_of(rows(holders[h].contacts), number_there, is_own_there, are_walls) ==
                        springs_of(rows(whole.contacts), all_of(Bed::count), is_own, are_walls));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Holders, DealtBodies, ::testing::Values(3U, 7U));

}  // namespace
}  // namespace riprap::solid

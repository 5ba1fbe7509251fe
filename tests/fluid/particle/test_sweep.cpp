// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <functional>

#include "fluid/particle/sample.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/particle/sweep/sweep_kernel.hpp"
#include "riprap/fluid/particle/sweep/sweep_lists.hpp"
#include "riprap/fluid/particle/sweep/sweep_plain.hpp"

namespace riprap::fluid {
namespace {

/// Sums of both pairs of the bench for all particles of a sample.
struct Rates {
    std::vector<double> density;
    std::vector<Vec3> acceleration;

    explicit Rates(std::size_t n) : density(n), acceleration(n) {}
    std::array<FieldSink, 3> force_sinks() {
        return {sink_component(acceleration, 0), sink_component(acceleration, 1), sink_component(acceleration, 2)};
    }
    friend bool operator==(const Rates&, const Rates&) = default;
};

Rates fast_rates(const Sample& s, SweepScratch& scratch) {
    Rates r(s.size());
    exchange_within(bench::DensityRatePair{s.constants}, s.reach(), s.density_side(), {sink(r.density)}, scratch);
    exchange_within(bench::AccelerationPair{s.constants}, s.reach(), s.force_side(), r.force_sinks(), scratch);
    return r;
}
Rates fast_rates(const Sample& s) {
    SweepScratch scratch;
    return fast_rates(s, scratch);
}

Rates plain_rates(const Sample& s) {
    Rates r(s.size());
    sweep_plain(bench::DensityRatePair{s.constants}, s.reach(), s.density_side(), s.density_side(), {sink(r.density)});
    sweep_plain(bench::AccelerationPair{s.constants}, s.reach(), s.force_side(), s.force_side(), r.force_sinks());
    return r;
}

/// Largest difference over largest value.
struct Difference {
    double density{0}, acceleration{0};
};
Difference compare(const Rates& a, const Rates& b) {
    double density = 0, acceleration = 0, largest_density = 0, largest_acceleration = 0;
    for (std::size_t i = 0; i < b.density.size(); ++i) {
        density = std::max(density, std::abs(a.density[i] - b.density[i]));
        largest_density = std::max(largest_density, std::abs(b.density[i]));
        acceleration = std::max(acceleration, norm(a.acceleration[i] - b.acceleration[i]));
        largest_acceleration = std::max(largest_acceleration, norm(b.acceleration[i]));
    }
    const auto relative = [](double difference, double largest) { return difference == 0 ? 0 : difference / largest; };
    return {relative(density, largest_density), relative(acceleration, largest_acceleration)};
}

/// The particles in order of place, as a State keeps them.
Sample in_order(Sample s) {
    const auto order = order_by_place(s.position, s.domain, s.spacing);
    const auto permute = [&](auto& values) {
        auto sorted = values;
        for (std::size_t i = 0; i < order.size(); ++i) {
            sorted[i] = values[order[i]];
        }
        values.swap(sorted);
    };
    permute(s.position);
    permute(s.velocity);
    permute(s.density);
    permute(s.excess);
    permute(s.volume);
    permute(s.pressure_term);
    return s;
}

// 1e-6 of the largest is about ten roundings of a float.
void expect_close(const Rates& fast, const Rates& plain, const std::string& what) {
    const Difference difference = compare(fast, plain);
    EXPECT_LT(difference.density, 1e-6) << what;
    EXPECT_LT(difference.acceleration, 1e-6) << what;
}

TEST(sweep, agrees_with_the_plain_double_sweep) {
    for (const int dimension : {2, 3}) {
        for (const double smoothing_ratio : {1.2, 1.732}) {
            const Sample s = in_order(jittered_lattice(dimension, {19, 17, 15}, smoothing_ratio));
            expect_close(fast_rates(s), plain_rates(s), std::to_string(dimension) + "D");
        }
    }
}

TEST(sweep, agrees_in_any_order_of_the_particles) {
    Sample s = jittered_lattice(3, {13, 12, 11}, 1.5);  // rows along x
    expect_close(fast_rates(s), plain_rates(s), "rows");
    std::shuffle(s.position.begin(), s.position.end(), std::mt19937_64(5));
    expect_close(fast_rates(s), plain_rates(s), "shuffled");
}

TEST(sweep, is_as_exact_far_from_the_origin_and_in_a_long_domain) {
    // 70 m of flume at 5 cm are 1400 spacings; UTM coordinates are some million metres away from their origin
    Sample s = in_order(jittered_lattice(3, {13, 12, 11}, 1.5, {4e5, -5e6, 100}));
    expect_close(fast_rates(s), plain_rates(s), "offset");
    Sample near_end = in_order(jittered_lattice(3, {13, 12, 11}, 1.5, {13.9, 0, 0}));
    near_end.domain.low = {};
    near_end.position[0] = {0, 0, 0};  // the other end
    expect_close(fast_rates(near_end), plain_rates(near_end), "long");
}

TEST(sweep, meets_the_images_across_periodic_sides) {
    for (const int dimension : {2, 3}) {
        Sample s = in_order(jittered_lattice(dimension, {13, 12, 11}, 1.3));
        s.domain.is_periodic = {true, dimension == 3, false};
        expect_close(fast_rates(s), plain_rates(s), "periodic");
        for (std::size_t i = 0; i < s.size(); i += 3) {
            s.position[i].x -= 13 * s.spacing;  // left through the side, not yet brought back
        }
        expect_close(fast_rates(s), plain_rates(s), "outside");
    }
}

TEST(sweep, takes_a_period_of_two_support_radii_and_refuses_a_shorter_one) {
    Sample s = in_order(jittered_lattice(3, {6, 12, 11}, 1.5));
    s.domain.is_periodic = {true, false, false};
    expect_close(fast_rates(s), plain_rates(s), "period of 6 spacings, support radius of 3");
    s.domain.high.x -= 0.01 * s.spacing;
    EXPECT_THROW(fast_rates(s), CaseError);
}

TEST(sweep, counts_every_candidate_whatever_remains_of_the_last_cluster) {
    for (const int count : {1, 2, 3, 4, 5, 6, 7, 9}) {
        Sample s = jittered_lattice(3, {count, 1, 1}, 2.0);
        expect_close(fast_rates(s), plain_rates(s), std::to_string(count));
    }
}

/// Every particle moves with its velocity for a number of steps; `between` is called before each.
std::vector<Rates> run(Sample s, int steps, const std::function<void(int, SweepScratch&)>& between) {
    SweepScratch scratch;
    std::vector<Rates> history;
    for (int step = 0; step < steps; ++step) {
        between(step, scratch);
        history.push_back(fast_rates(s, scratch));
        for (std::size_t i = 0; i < s.size(); ++i) {
            s.position[i] += 2e-4 * s.velocity[i];  // up to 0.035 spacings
        }
    }
    return history;
}

TEST(sweep, gives_the_same_bits_when_its_scratch_is_lost) {
    for (const int dimension : {2, 3}) {
        const Sample s = in_order(jittered_lattice(dimension, {15, 14, 13}, 1.3));
        const auto kept = run(s, 20, [](int, SweepScratch&) {});
        const auto lost = run(s, 20, [](int step, SweepScratch& scratch) {
            if (step % 3 == 1) {
                scratch = SweepScratch();
            }
        });
        EXPECT_TRUE(kept == lost);
    }
}

TEST(sweep, stays_exact_while_particles_move_within_the_skin_and_beyond) {
    Sample s = in_order(jittered_lattice(3, {12, 12, 12}, 1.3));
    SweepScratch scratch;
    for (int step = 0; step < 30; ++step) {
        expect_close(fast_rates(s, scratch), plain_rates(s), std::to_string(step));
        for (std::size_t i = 0; i < s.size(); ++i) {
            s.position[i] += 2e-4 * s.velocity[i];
        }
    }
    EXPECT_GT(scratch.data().list.builds(), 1);   // the skin was left
    EXPECT_LT(scratch.data().list.builds(), 30);  // and lists were kept
}

/// Sums of one pair that take the place of what is there, and the same from zero.
template <class Sweep>
void expect_fresh_as_from_zero(std::size_t count, const Sweep& sweep_into) {
    std::vector<double> from_zero(count, 0.0), fresh_sum(count, 17.0);
    sweep_into(sink(from_zero));
    sweep_into(fresh<1>({sink(fresh_sum)})[0]);
    EXPECT_EQ(fresh_sum, from_zero);
}

TEST(sweep, a_fresh_sum_takes_the_place_of_whatever_is_there) {
    for (const int dimension : {2, 3}) {
        const Sample s = in_order(jittered_lattice(dimension, {29, 17, 15}, 1.3));
        SweepSide<5> few = s.density_side();  // with none of them near most targets, and a cluster that is not full
        few.position = few.position.first(9);
        SweepSide<5> none = few;
        none.position = {};
        const bench::DensityRatePair pair{s.constants};
        SweepScratch within, one_way, to_few, to_none;
        expect_fresh_as_from_zero(
            s.size(), [&](const FieldSink& sum) { exchange_within(pair, s.reach(), s.density_side(), {sum}, within); });
        expect_fresh_as_from_zero(s.size(), [&](const FieldSink& sum) {
            sweep(pair, s.reach(), s.density_side(), s.density_side(), {sum}, one_way);
        });
        expect_fresh_as_from_zero(
            s.size(), [&](const FieldSink& sum) { sweep(pair, s.reach(), s.density_side(), few, {sum}, to_few); });
        expect_fresh_as_from_zero(
            s.size(), [&](const FieldSink& sum) { sweep(pair, s.reach(), s.density_side(), none, {sum}, to_none); });
        expect_fresh_as_from_zero(
            s.size(), [&](const FieldSink& sum) { sweep_plain(pair, s.reach(), s.density_side(), few, {sum}); });
        std::vector<double> of_few(9, 3.0);
        expect_fresh_as_from_zero(s.size(), [&](const FieldSink& sum) {
            exchange(pair, s.reach(), few, s.density_side(), fresh<1>({sink(of_few)}), {sum}, to_few);
        });
    }
}

TEST(sweep, gives_the_same_bits_on_any_number_of_threads) {
    const Sample s = in_order(jittered_lattice(3, {30, 25, 20}, 1.3));
    parallel::set_thread_count(1);
    const Rates one = fast_rates(s);
    for (const int threads : {2, 4}) {
        parallel::set_thread_count(threads);
        EXPECT_TRUE(fast_rates(s) == one);
    }
    parallel::set_thread_count(1);
}

TEST(sweep, in_several_rounds_of_patches_gives_the_same_bits_by_many_threads) {
    const Sample s = in_order(jittered_lattice(2, {600, 500, 1}, 1.2));
    SweepScratch scratch;
    parallel::set_thread_count(1);
    const Rates in_rounds = fast_rates(s, scratch);
    const auto patches = static_cast<std::int64_t>(scratch.data().list.patches().size());
    EXPECT_LT(detail::patches_at_a_time(patches), patches);
    parallel::set_thread_count(16);
    EXPECT_TRUE(fast_rates(s) == in_rounds);
    parallel::set_thread_count(1);
}

/// Water and a wall that lies mostly outside of the domain; neither fills its last cluster.
struct WaterAndWall {
    Sample water = in_order(jittered_lattice(3, {11, 10, 9}, 1.3));
    Sample wall = jittered_lattice(3, {31, 29, 3}, 1.3, {-0.1, -0.1, -0.03}, 11);
    WaterAndWall() { wall.domain = water.domain; }
};

TEST(sweep, between_two_sets_agrees_with_the_plain_one) {
    const WaterAndWall both;
    for (const bool is_wall_target : {false, true}) {
        const Sample& targets = is_wall_target ? both.wall : both.water;
        const Sample& candidates = is_wall_target ? both.water : both.wall;
        SweepScratch scratch;
        Rates fast(targets.size()), plain(targets.size());
        const bench::AccelerationPair pair{both.water.constants};
        sweep(pair, both.water.reach(), targets.force_side(), candidates.force_side(), fast.force_sinks(), scratch);
        sweep_plain(pair, both.water.reach(), targets.force_side(), candidates.force_side(), plain.force_sinks());
        EXPECT_LT(compare(fast, plain).acceleration, 1e-6);
    }
}

TEST(sweep, an_exchange_between_two_sets_is_both_sweeps_at_once) {
    const WaterAndWall both;
    const SweepReach reach = both.water.reach();
    const Sample *a = &both.water, *b = &both.wall;
    for (int turn = 0; turn < 2; ++turn, std::swap(a, b)) {
        SweepScratch scratch;
        Rates fast_a(a->size()), fast_b(b->size()), plain_a(a->size()), plain_b(b->size());
        const bench::DensityRatePair continuity{both.water.constants};
        const bench::AccelerationPair force{both.water.constants};
        exchange(continuity, reach, a->density_side(), b->density_side(), {sink(fast_a.density)},
                 {sink(fast_b.density)}, scratch);
        exchange(force, reach, a->force_side(), b->force_side(), fast_a.force_sinks(), fast_b.force_sinks(), scratch);
        sweep_plain(continuity, reach, a->density_side(), b->density_side(), {sink(plain_a.density)});
        sweep_plain(continuity, reach, b->density_side(), a->density_side(), {sink(plain_b.density)});
        sweep_plain(force, reach, a->force_side(), b->force_side(), plain_a.force_sinks());
        sweep_plain(force, reach, b->force_side(), a->force_side(), plain_b.force_sinks());
        expect_close(fast_a, plain_a, "a");
        expect_close(fast_b, plain_b, "b");
    }
}

TEST(sweep, of_different_sets_may_share_buffers) {
    const WaterAndWall both;
    SweepScratch within, apart, sharing_within, sharing_apart = SweepScratch::sharing_buffers(sharing_within);
    const auto rates = [&](SweepScratch& first, SweepScratch& second) {
        Rates water = fast_rates(both.water, first), wall(both.wall.size());
        exchange(bench::AccelerationPair{both.water.constants}, both.water.reach(), both.water.force_side(),
                 both.wall.force_side(), water.force_sinks(), wall.force_sinks(), second);
        return water;
    };
    for (int turn = 0; turn < 2; ++turn) {
        EXPECT_TRUE(rates(within, apart) == rates(sharing_within, sharing_apart));
    }
    EXPECT_LT(sharing_within.bytes() + sharing_apart.bytes(), within.bytes() + apart.bytes());
}

TEST(sweep, over_sets_that_are_placed_once_for_all_lists_gives_the_same_bits) {
    WaterAndWall both;
    SweepLists lists;
    SweepScratch apart_within, apart_across, apart_back;
    const auto rates = [&](SweepScratch& within, SweepScratch& across, SweepScratch& back) {
        Rates water = fast_rates(both.water, within), wall(both.wall.size());
        const bench::AccelerationPair pair{both.water.constants};
        const auto reach = both.water.reach();
        sweep(pair, reach, both.water.force_side(), both.wall.force_side(), water.force_sinks(), across);
        sweep(pair, reach, both.wall.force_side(), both.water.force_side(), wall.force_sinks(), back);
        water.acceleration.insert(water.acceleration.end(), wall.acceleration.begin(), wall.acceleration.end());
        return water;
    };
    for (int step = 0; step < 12; ++step) {
        const parallel::Blocks blocks(static_cast<std::int64_t>(both.water.size()));
        lists.place(both.water.reach(), blocks, both.water.position, both.wall.position);
        EXPECT_TRUE(rates(lists.fluid_fluid, lists.fluid_walls, lists.walls_fluid) ==
                    rates(apart_within, apart_across, apart_back))
            << step;
        for (std::size_t i = 0; i < both.water.size(); ++i) {
            both.water.position[i] += 2e-4 * both.water.velocity[i];
        }
        for (Vec3& place : both.wall.position) {
            place.x += 3e-4;
        }
        if (step == 5) {
            std::swap(both.water.position.front(), both.water.position.back());  // particles are counted anew
        }
        if (step == 8) {
            both.wall.position.resize(both.wall.size() - 7);
        }
    }
    EXPECT_LT(lists.fluid_fluid.data().list.builds(), 12) << "kept while nothing came near";
    EXPECT_LT(lists.bytes(), apart_within.bytes() + apart_across.bytes() + apart_back.bytes());
}

TEST(sweep, one_way_over_one_set_is_what_the_exchange_gives) {
    const Sample s = in_order(jittered_lattice(3, {19, 17, 15}, 1.5));
    SweepScratch scratch;
    Rates one_way(s.size());
    sweep(bench::AccelerationPair{s.constants}, s.reach(), s.force_side(), s.force_side(), one_way.force_sinks(),
          scratch);
    EXPECT_LT(compare(one_way, fast_rates(s)).acceleration, 1e-6);
    // the same scratch serves both, at the price of new lists
    EXPECT_TRUE(fast_rates(s, scratch) == fast_rates(s));
}

TEST(sweep, pair_forces_are_opposite_to_the_round_off_of_a_float) {
    // places are whole numbers, so both directions of a pair see exactly opposite distances
    for (const int count : {2, 40}) {
        const Sample s = in_order(jittered_lattice(3, {count, count == 2 ? 1 : 20, count == 2 ? 1 : 20}, 1.5));
        const Rates r = fast_rates(s);
        Vec3 total{};
        double size = 0;
        for (const Vec3& a : r.acceleration) {
            total += a;
            size += norm(a);
        }
        EXPECT_LT(norm(total), (count == 2 ? 1e-15 : 1e-8) * size);
    }
}

TEST(sweep, survives_particles_far_away_and_not_finite) {
    Sample s = in_order(jittered_lattice(3, {9, 9, 9}, 1.3));
    const Rates before = fast_rates(s);
    for (const Vec3& far : {Vec3{30, -30, 3}, Vec3{std::nan(""), 0, 0}, Vec3{1e300, 0, 0}}) {
        s.position.push_back(far);
        s.velocity.push_back({});
        s.density.push_back(1000);
        s.excess.push_back(0);
        s.volume.push_back(0);
        s.pressure_term.push_back(0);
    }
    (void)fast_rates(s);
}

}  // namespace
}  // namespace riprap::fluid

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/bench/pile_scene.hpp"
#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/contact/narrowphase/distance_potential.hpp"

namespace riprap::bench {

namespace {

/// Candidate pairs of two cubes as they lie in the settled pile, each with its memory of a separating direction.
struct PairSample {
    geometry::ConvexView cube;
    std::vector<contact::Frame> frames;  ///< per part
    std::vector<contact::PartPair> pairs;
    std::vector<contact::SeparatingCache> caches;  ///< per pair
    std::string kinds;                             ///< in words
};

/// Is one face normal of the cube along `direction`?
bool has_face_along(const contact::Frame& frame, const Vec3& direction) {
    const Vec3 d = transpose_times(frame.axes, direction);
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > 0.999;  // 2.5 degrees
}

/// All candidates of a run's default skin, either those that touch or those that do not.
PairSample sample_pairs(bool touching) {
    const Pile& pile = settled_cubes();
    const auto& parts = pile.model.bodies.parts;
    PairSample sample;
    std::vector<Vec3> centers;
    std::vector<double> radii;
    std::vector<std::int32_t> bodies;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (!pile.model.shapes.is_half_space(parts[p].shape)) {
            const auto body = static_cast<std::size_t>(parts[p].body.value);
            sample.cube = pile.model.shapes.view(parts[p].shape);
            centers.push_back(pile.state.bodies.position[body]);
            radii.push_back(sample.cube.circumradius);
            bodies.push_back(parts[p].body.value);
            sample.frames.push_back(
                contact::to_frame({pile.state.bodies.position[body], pile.state.bodies.orientation[body]}));
        }
    }
    const std::vector<std::uint8_t> mobile(radii.size(), 1);
    contact::PairCache candidates;
    candidates.update({centers, radii, bodies, mobile}, {},
                      {.skin = pile.model.dem()->skin * contact::median_radius(radii)});
    int face_face = 0, with_face = 0, edge_edge = 0;
    for (const contact::PartPair pair : candidates.pairs()) {
        const contact::Frame& a = sample.frames[static_cast<std::size_t>(pair.a)];
        const contact::Frame& b = sample.frames[static_cast<std::size_t>(pair.b)];
        contact::SeparatingCache cache;
        contact::NormalContact contact{};
        if (find_contact(sample.cube, a, 1e6, sample.cube, b, 1e6, {.with_energy = false}, cache, contact) !=
            touching) {
            continue;
        }
        sample.pairs.push_back(pair);
        sample.caches.push_back(cache);
        if (touching) {
            const Vec3 normal = contact.force / norm(contact.force);
            const int faces = (has_face_along(a, normal) ? 1 : 0) + (has_face_along(b, normal) ? 1 : 0);
            ++(faces == 2 ? face_face : faces == 1 ? with_face : edge_edge);
        }
    }
    sample.kinds =
        fmt::format("{} face on face, {} corner or edge on face, {} edge on edge", face_face, with_face, edge_edge);
    return sample;
}

/// Median time of one pair [s], with all pairs of the sample in turn.
Timing time_pairs(PairSample& sample, bool with_energy) {
    const contact::DistancePotentialOptions options{.with_energy = with_energy};
    double sum = 0;
    const auto pass = [&] {
        for (std::size_t p = 0; p < sample.pairs.size(); ++p) {
            contact::NormalContact contact{};
            if (find_contact(sample.cube, sample.frames[static_cast<std::size_t>(sample.pairs[p].a)], 1e6, sample.cube,
                             sample.frames[static_cast<std::size_t>(sample.pairs[p].b)], 1e6, options, sample.caches[p],
                             contact)) {
                sum += contact.depth;
            }
        }
    };
    const Timing timing = time_calls(pass, {15, 0.5});
    volatile double keep = sum;  // the work may not be left out
    (void)keep;
    return each_of(timing, static_cast<double>(sample.pairs.size()));
}

void measure_pairs(const Setting& setting, const char* name, bool touching, bool with_energy,
                   std::vector<Result>& results) {
    const ThreadScope one(1);
    PairSample sample = sample_pairs(touching);
    if (sample.pairs.empty()) {
        return;
    }
    const Timing timing = time_pairs(sample, with_energy);
    const double scaled = 1e6 * timing.median * core_speed(setting.machine);
    results.push_back({name, 1, 1e6 * timing.median, "us",
                       fmt::format("{:.3g} us scaled to the reference core; {} pairs of the settled 735 cubes{}; {}",
                                   scaled, sample.pairs.size(), touching ? ": " + sample.kinds : "", spread(timing))});
}

}  // namespace

void contact_cube_cube(const Setting& setting, std::vector<Result>& results) {
    measure_pairs(setting, "contact.cube_cube", true, false, results);
}
void contact_with_energy(const Setting& setting, std::vector<Result>& results) {
    measure_pairs(setting, "contact.with_energy", true, true, results);
}
void contact_cached_miss(const Setting& setting, std::vector<Result>& results) {
    measure_pairs(setting, "contact.cached_miss", false, false, results);
}

}  // namespace riprap::bench

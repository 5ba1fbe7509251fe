// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sphere_physics.hpp"

#include <algorithm>

#include "riprap/contact/count_pairs.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/find.hpp"
#include "riprap/solid/sphere_dem/load_rows.hpp"
#include "riprap/solid/sphere_dem/place.hpp"
#include "riprap/solid/sphere_dem/respond.hpp"
#include "riprap/solid/sphere_dem/sphere_dem_settings.hpp"
#include "riprap/solid/sphere_dem/walls.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Properties that every contact of a sphere reads.
std::vector<material::PropertyUse> reads_of_spheres(const SphereDemSettings& settings) {
    using material::Property;
    const bool is_hertz = settings.laws.normal == contact::NormalLaw::hertz;
    return {{Property::friction},
            {Property::youngs_modulus, false, is_hertz},
            {Property::poisson_ratio, false, is_hertz},
            {Property::restitution, false, !settings.contact_ratio},
            {Property::kinetic_share},
            {Property::rolling_friction, false, settings.laws.rolling != contact::RollingLaw::none},
            {Property::contact_ratio},
            {Property::spring_stiffness, false, !is_hertz},
            {Property::spring_shear_ratio, false, !is_hertz}};
}

}  // namespace

std::vector<material::PropertyUse> SpheresOnSpheres::reads(const SphereDemSettings& settings) {
    return reads_of_spheres(settings);
}
std::vector<material::PropertyUse> SpheresOnFaces::reads(const SphereDemSettings& settings) {
    std::vector<material::PropertyUse> reads = reads_of_spheres(settings);
    reads.push_back({material::Property::cohesion});
    return reads;
}

void SpheresOnSpheres::find(Meeting& meeting) {
    meeting.lost += find_contacts(meeting.model, meeting.state, meeting.scratch);
}

void SpheresOnSpheres::respond(Meeting& meeting) {
    meeting.sums +=
        sphere_dem::respond(meeting.model, meeting.bodies, meeting.sliding_time, meeting.state, meeting.scratch);
    gather_loads(meeting.model, meeting.bodies, meeting.scratch);
}

std::int64_t SpheresOnSpheres::count(const SphereModel& model, const SphereState& state) {
    if (!model.spheres.has_clusters) {
        return static_cast<std::int64_t>(state.contacts.size());
    }
    const auto body_of = [&](std::int32_t sphere) { return model.spheres.body[at(sphere)]; };
    return contact::count_body_pairs(state.contacts.pair, model.bodies.size(), body_of, body_of);
}

void SpheresOnFaces::find(Meeting& meeting) { find_walls(meeting.model, meeting.scratch); }

void SpheresOnFaces::respond(Meeting& meeting) {
    meeting.sums +=
        respond_to_walls(meeting.model, meeting.bodies, meeting.sliding_time, meeting.state, meeting.scratch);
}

std::int64_t SpheresOnFaces::count(const SphereModel& model, const SphereState& state) {
    // Samples of either body may meet the other one: the pair counts once.
    std::vector<std::uint64_t> pairs;
    for (const std::uint64_t key : state.walls.pair) {
        const std::int32_t a = model.spheres.body[at(static_cast<std::int64_t>(key >> 32))],
                           b = wall_body(model, static_cast<std::int32_t>(key & 0xFFFFFFFF));
        const std::uint64_t pair =
            static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
        if (pairs.empty() || pairs.back() != pair) {
            pairs.push_back(pair);
        }
    }
    std::ranges::sort(pairs);
    return contact::count_pairs(pairs);
}

void FacesAmongSpheres::find(Meeting& meeting) {
    if (meeting.faces != nullptr) {
        meeting.faces->find();
    }
}

void FacesAmongSpheres::respond(Meeting& meeting) {
    if (meeting.faces == nullptr) {
        return;
    }
    body::Loads& loads = meeting.scratch.loads;
    meeting.faces->respond(meeting.scratch.kinematics, meeting.sliding_time, meeting.with_energy);
    const body::Loads& faces = meeting.faces->loads();
    for (std::size_t b = 0; b < loads.force.size(); ++b) {
        loads.force[b] += faces.force[b];
        loads.torque[b] += faces.torque[b];
    }
}

}  // namespace riprap::solid::sphere_dem

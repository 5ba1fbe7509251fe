// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/faces_on_faces.hpp"

#include <algorithm>

#include "riprap/contact/common_plane_physics.hpp"
#include "riprap/contact/count_pairs.hpp"
#include "riprap/contact/distance_potential_physics.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/solid/contact_sums.hpp"
#include "riprap/solid/time_step.hpp"

namespace riprap::solid {

namespace {

std::int64_t count_touching_bodies(const body::BodySet& bodies, std::span<const std::uint64_t> part_pairs) {
    if (bodies.part_count() == bodies.size()) {  // a part is a body
        return contact::count_pairs(part_pairs);
    }
    const auto body_of = [&](std::int32_t part) { return bodies.parts[at(part)].body.value; };
    return contact::count_body_pairs(part_pairs, bodies.size(), body_of, body_of);
}

}  // namespace

std::vector<material::PropertyUse> FacesOnFaces::reads(const DemSettings& settings) {
    using material::Property;
    // The shear stiffness bounds the time step under every law.
    std::vector<material::PropertyUse> uses{
        {Property::normal_stiffness, true}, {Property::shear_stiffness}, {Property::damping_ratio}};
    settings.friction.for_each([&]<class Law>(bool is_chosen) {
        for (const Property property : Law::reads) {
            add_use(uses, {property, false, is_chosen});
        }
    });
    return uses;
}

contact::ContactScene FacesOnFaces::contact_scene() const {
    return {scene_->shapes,         scene_->materials, scene_->bodies,
            settings_->grid_factor, settings_->skin,   scratch_->left_out};
}

StepLimit FacesOnFaces::limit() const {
    if (!scratch_->limit) {
        const DemTimeStep bound =
            time_step_bound(scene_->bodies, scene_->shapes, scene_->materials, scratch_->left_out);
        scratch_->limit = StepLimit{bound.limit, false, bound.reason};
    }
    return *scratch_->limit;
}

bool FacesOnFaces::find() {
    const ScopedTimer timer(scratch_->times.find_pairs);
    scratch_->pipeline.place_parts(contact_scene(), state_.bodies);
    return scratch_->pipeline.find_pairs();
}

void FacesOnFaces::respond(const body::BodyKinematics& kinematics, double sliding_time, bool with_energy) {
    const contact::ContactScene scene = contact_scene();
    const auto find_contacts = [&](const auto& physics) {
        return scratch_->pipeline.find_contacts(physics, scene, state_.bodies, kinematics, sliding_time,
                                                state_.contacts);
    };
    {
        const ScopedTimer timer(scratch_->times.find_contacts);
        if (settings_->pair_contact == PairContact::distance_potential) {
            contact::DistancePotentialPhysics physics{settings_->contact, settings_->friction};
            physics.options.with_energy = with_energy;
            lost_ = find_contacts(physics);
        } else {
            if (scratch_->topologies.empty()) {
                scratch_->topologies = contact::hull_topologies(scene.shapes);
            }
            const bool is_soft = settings_->pair_contact == PairContact::common_plane_soft;
            lost_ = find_contacts(
                contact::CommonPlanePhysics{scratch_->topologies, scene.bodies, settings_->friction,
                                            is_soft ? contact::PlaneLaw::soft : contact::PlaneLaw::penalty});
        }
    }
    const ScopedTimer timer(scratch_->times.contact_loads);
    scratch_->pipeline.gather_loads(scene, state_.bodies, scratch_->loads);
}

Outcome FacesOnFaces::book(const body::BodyKinematics& kinematics, double dt, SolidReport& report) const {
    const ScopedTimer timer(scratch_->times.measure);
    const contact::ContactScene scene = contact_scene();
    const contact::ContactPipeline& contacts = scratch_->pipeline;
    const PolyhedralSums sums = sum_contacts(contacts.rows(), state_.contacts);
    report.damping_loss += contacts.dashpot_loss(scene, state_.bodies, kinematics, dt);
    report.elastic += report.has_stored ? sums.elastic : 0;
    report.shear += sums.shear;
    report.friction_loss = report.friction_loss + sums.friction_loss + lost_;
    report.dt_bound = std::min(report.dt_bound, contacts.stable_step(scene));
    report.max_potential = std::max(report.max_potential, static_cast<double>(sums.potential));
    report.max_depth = std::max(report.max_depth, static_cast<double>(sums.overlap));
    report.contact_count += count_touching_bodies(scene.bodies, state_.contacts.pair);
    report.pair_count += contacts.pair_count();
    return judge_overlap(scene.bodies, settings_->max_potential, sums, contacts.rows(), report.kick_time);
}

}  // namespace riprap::solid

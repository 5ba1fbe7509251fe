// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/pipeline.hpp"

#include <algorithm>
#include <string_view>

#include "riprap/core/parallel.hpp"

namespace riprap::contact {

namespace {
/// Candidates evaluated by one thread at a time. Changes no result.
constexpr std::int64_t chunk_size = 32;
/// Candidates that one thread works through sooner than it wakes another.
constexpr std::int64_t small_wave = 256;

/// Candidates evaluated before their results are moved to their final place: an eighth, so that the intermediate
/// records of a large scene take little memory beside what stays, but enough to keep threads busy. Changes no result.
std::int64_t wave_size(std::int64_t pair_count) {
    constexpr std::int64_t least = 32 * chunk_size;
    return std::max(least, (pair_count / 8 + chunk_size - 1) / chunk_size * chunk_size);
}

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Resizes a buffer whose length changes little from step to step, without the doubling of std::vector.
template <class T>
void resize_closely(std::vector<T>& buffer, std::size_t size) {
    if (size > buffer.capacity()) {
        buffer.reserve(size + size / 8);
    }
    buffer.resize(size);
}

void resize_closely(ContactHistory& history, std::size_t size) {
    ContactHistory::visit_fields(history, [size](std::string_view, auto& field) { resize_closely(field, size); });
}
}  // namespace

void ContactPipeline::describe_parts(const ContactScene& scene) {
    const auto& parts = scene.bodies.parts;
    frames_.resize(parts.size());
    centers_.resize(parts.size());
    radii_.resize(parts.size());
    part_body_.resize(parts.size());
    is_mobile_.resize(parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const auto body = at(parts[p].body.value);
        radii_[p] = scene.shapes.view(parts[p].shape).circumradius;
        part_body_[p] = parts[p].body.value;
        is_mobile_[p] =
            scene.bodies.drive[body] == body::Drive::free || std::isfinite(scene.bodies.release_time[body]) ? 1 : 0;
    }
    cache_settings_ = {.skin = scene.skin * median_radius(radii_), .grid_factor = scene.grid_factor};
    giants_.clear();
    for (const std::int32_t part : choose_giants(radii_)) {
        giants_.push_back({part, scene.shapes.view(parts[at(part)].shape), {}});
    }
}

void ContactPipeline::place_parts(const ContactScene& scene, const body::BodyState& state) {
    const auto& parts = scene.bodies.parts;
    if (frames_.size() != parts.size()) {
        describe_parts(scene);
    }
    parallel::for_each(static_cast<std::int64_t>(parts.size()), [&](std::int64_t index) {
        const body::Part& part = parts[at(index)];
        const auto body = at(part.body.value);
        const Pose body_pose{state.position[body], state.orientation[body]};
        frames_[at(index)] =
            to_frame({to_world(body_pose, part.local.position), body_pose.orientation * part.local.orientation});
        centers_[at(index)] = frames_[at(index)].origin;
    });
    for (Giant& giant : giants_) {
        giant.frame = frames_[at(giant.part)];
    }
}

bool ContactPipeline::find_pairs() {
    const bool is_new = cache_.update({centers_, radii_, part_body_, is_mobile_}, giants_, cache_settings_);
    if (is_new) {
        separating_.assign(cache_.pairs().size(), {});
        contact_of_pair_.clear();
    }
    return is_new;
}

bool ContactPipeline::are_rows_of(const ContactHistory& history) const {
    return rows_.size() == history.size() &&
           parallel::reduce(
               static_cast<std::int64_t>(rows_.size()), true,
               [&](std::int64_t i) { return pair_key(rows_[at(i)].parts) == history.pair[at(i)]; },
               [](bool a, bool b) { return a && b; });
}

void ContactPipeline::map_history(const ContactHistory& history) {
    const auto pairs = cache_.pairs();
    if (contact_of_pair_.size() == pairs.size() && are_rows_of(history)) {
        return;
    }
    contact_of_pair_.resize(pairs.size());
    parallel::for_each(static_cast<std::int64_t>(pairs.size()), [&](std::int64_t p) {
        const std::uint64_t key = pair_key(pairs[at(p)]);
        const auto found = std::lower_bound(history.pair.begin(), history.pair.end(), key);
        contact_of_pair_[at(p)] =
            found != history.pair.end() && *found == key ? static_cast<std::int32_t>(found - history.pair.begin()) : -1;
    });
}

double ContactPipeline::find_contacts(const ContactScene& scene, const body::BodyState& state,
                                      const body::BodyKinematics& kinematics, double sliding_time,
                                      ContactHistory& history) {
    map_history(history);
    is_carried_.assign(history.size(), 0);
    rows_.clear();
    next_.resize(0);
    const std::int64_t count = pair_count(), wave = wave_size(count);
    for (std::int64_t begin = 0; begin < count; begin += wave) {
        const std::int64_t end = std::min(count, begin + wave);
        run_wave(scene, state, kinematics, sliding_time, history, begin, end);
        append_wave(begin, end);
    }
    const double lost = parallel::reduce(
        static_cast<std::int64_t>(history.size()), 0.0,
        [&](std::int64_t i) { return is_carried_[at(i)] != 0 ? 0.0 : history.shear_energy[at(i)]; },
        [](double a, double b) { return a + b; });
    std::swap(history, next_);
    return lost;
}

void ContactPipeline::run_wave(const ContactScene& scene, const body::BodyState& state,
                               const body::BodyKinematics& kinematics, double sliding_time,
                               const ContactHistory& history, std::int64_t begin, std::int64_t end) {
    const auto pairs = cache_.pairs();
    const std::int64_t count = end - begin;
    wave_.resize(std::max(wave_.size(), at(count)));
    wave_count_.assign(at((count + chunk_size - 1) / chunk_size), 0);

    const auto evaluate = [&](std::int64_t p, Record& record) {
        const PartPair parts = pairs[at(p)];
        const auto a = at(parts.a), b = at(parts.b);
        const auto body_a = at(part_body_[a]), body_b = at(part_body_[b]);
        const MaterialId material_a = scene.bodies.material[body_a], material_b = scene.bodies.material[body_b];
        NormalContact contact;
        if (!find_contact(scene.shapes.view(scene.bodies.parts[a].shape), frames_[a],
                          scene.materials[material_a].normal_stiffness, scene.shapes.view(scene.bodies.parts[b].shape),
                          frames_[b], scene.materials[material_b].normal_stiffness, scene.narrowphase,
                          separating_[at(p)], contact)) {
            return false;
        }
        const Vec3 arm_a = contact.point - state.position[body_a], arm_b = contact.point - state.position[body_b];
        const Vec3& spin_a = kinematics.angular_velocity[body_a];
        const Vec3& spin_b = kinematics.angular_velocity[body_b];
        const double force = norm(contact.force);
        const Vec3 n = force > 0 ? -contact.force / force : Vec3{0, 0, 1};
        const Vec3 turn_a = cross(arm_a, n), turn_b = cross(arm_b, n);
        const double inverse_a =
            kinematics.inverse_mass[body_a] + dot(turn_a, kinematics.inverse_inertia[body_a] * turn_a);
        const double inverse_b =
            kinematics.inverse_mass[body_b] + dot(turn_b, kinematics.inverse_inertia[body_b] * turn_b);
        const double inverse = inverse_a + inverse_b;
        const ContactKinematics motion{.relative_velocity = state.velocity[body_a] + cross(spin_a, arm_a) -
                                                            state.velocity[body_b] - cross(spin_b, arm_b),
                                       .mean_spin = 0.5 * (spin_a + spin_b),
                                       .relative_spin = spin_a - spin_b,
                                       .sliding_time = sliding_time,
                                       .effective_mass = inverse > 0 ? 1 / inverse : 0};
        const std::int32_t old = contact_of_pair_[at(p)];
        ShearState before;
        if (old >= 0) {
            before = {history.normal[at(old)], history.shear_force[at(old)], history.torsion[at(old)],
                      history.shear_energy[at(old)]};
        }
        coulomb(contact, scene.materials.pair(material_a, material_b), motion, old >= 0 ? &before : nullptr,
                record.springs, record.row);
        const double coupling = std::sqrt(inverse_a * inverse_b);
        record.row.parts = parts;
        record.row.gershgorin_a = static_cast<float>(contact.stiffness * (inverse_a + coupling));
        record.row.gershgorin_b = static_cast<float>(contact.stiffness * (inverse_b + coupling));
        record.pair = static_cast<std::int32_t>(p);
        record.old_contact = old;
        return true;
    };
    const std::int64_t grain = count <= small_wave ? count : chunk_size;
    parallel::for_ranges(count, grain, [&](std::int64_t first, std::int64_t last) {
        std::int32_t found = 0;
        for (std::int64_t i = first; i < last; ++i) {
            found += evaluate(begin + i, wave_[at(first + found)]) ? 1 : 0;
        }
        wave_count_[at(first / chunk_size)] = found;
    });
}

void ContactPipeline::append_wave(std::int64_t begin, std::int64_t end) {
    std::vector<std::int32_t>& offset = wave_count_;
    const std::size_t base = rows_.size();
    const auto chunk_count = static_cast<std::int64_t>(offset.size());
    const std::int32_t found = parallel::exclusive_scan<std::int32_t>(offset, offset);
    resize_closely(rows_, base + at(found));
    resize_closely(next_, base + at(found));
    std::fill(contact_of_pair_.begin() + begin, contact_of_pair_.begin() + end, -1);
    parallel::for_each_uneven(chunk_count, 8, [&](std::int64_t chunk) {
        const std::int64_t stop = chunk + 1 < chunk_count ? offset[at(chunk + 1)] : found;
        for (std::int64_t i = offset[at(chunk)]; i < stop; ++i) {
            const Record& record = wave_[at(chunk * chunk_size + i - offset[at(chunk)])];
            const std::size_t to = base + at(i);
            rows_[to] = record.row;
            next_.pair[to] = pair_key(record.row.parts);
            next_.feature[to] = 0;
            next_.normal[to] = record.springs.normal;
            next_.shear_force[to] = record.springs.shear_force;
            next_.torsion[to] = record.springs.torsion;
            next_.shear_energy[to] = record.springs.shear_energy;
            contact_of_pair_[at(record.pair)] = static_cast<std::int32_t>(to);
            if (record.old_contact >= 0) {
                is_carried_[at(record.old_contact)] = 1;
            }
        }
    });
}

std::size_t ContactPipeline::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return cache_.bytes() + of(frames_) + of(centers_) + of(radii_) + of(part_body_) + of(is_mobile_) +
           of(separating_) + of(contact_of_pair_) + of(wave_) + of(wave_count_) + of(rows_) + of(is_carried_) +
           of(next_.pair) + of(next_.feature) + of(next_.normal) + of(next_.shear_force) + of(next_.torsion) +
           of(next_.shear_energy);
}

}  // namespace riprap::contact

// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dem.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "riprap/body/drives.hpp"
#include "riprap/body/locks.hpp"
#include "riprap/contact/law/mindlin.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/solid/lanes.hpp"

namespace riprap::solid {

void drift_one(const body::BodySet& bodies, body::BodyState& state, std::int64_t index, double end_time, double dt) {
    const BodyId id{static_cast<std::int32_t>(index)};
    const auto i = at(index);
    // A body released during this drift is still driven: freedom starts with the first kick past its time.
    if (is_free(bodies, id, end_time - dt)) {
        state.position[i] += dt * state.velocity[i];
        state.orientation[i] = turn_body(bodies, i, state.orientation[i], state.angular_momentum[i], dt);
    } else if (bodies.drive[i] == body::Drive::driven) {
        const body::DrivenState driven = driven_state(bodies, id, end_time);
        state.position[i] = driven.pose.position;
        state.orientation[i] = driven.pose.orientation;
        state.velocity[i] = driven.velocity;
        body::advance_correction(state, i, dt);
        if (!state.drive_offset.empty()) {
            state.position[i] += state.drive_offset[i];
            state.velocity[i] += state.drive_rate[i];
        }
        if (bodies.principal_moments[i].x > 0) {
            state.angular_momentum[i] =
                angular_momentum_of(bodies, id, driven.pose.orientation, driven.angular_velocity);
        }
    }
}

void drift(const body::BodySet& bodies, body::BodyState& state, double end_time, double dt) {
    parallel::for_each(bodies.size(), [&](std::int64_t index) { drift_one(bodies, state, index, end_time, dt); });
}

namespace {

/// Terms of free bodies that a kick adds up, of one body or of several side by side: sums of KickReport.
template <class T>
struct FreeTerms {
    T kinetic{}, potential{}, damping_loss{}, external_work{}, mass{};
    Vec3T<T> momentum{}, angular_momentum{}, impulse{}, angular_impulse{}, mass_moment{};

    [[gnu::always_inline]] FreeTerms& operator+=(const FreeTerms& b) {
        kinetic += b.kinetic;
        potential += b.potential;
        damping_loss += b.damping_loss;
        external_work += b.external_work;
        mass += b.mass;
        momentum += b.momentum;
        angular_momentum += b.angular_momentum;
        impulse += b.impulse;
        angular_impulse += b.angular_impulse;
        mass_moment += b.mass_moment;
        return *this;
    }
};
constexpr std::size_t free_terms = 5 + 5 * 3;
static_assert(sizeof(FreeTerms<double>) == free_terms * sizeof(double));

/// All terms of one body.
struct KickTerms {
    FreeTerms<double> free;
    double work_driven{0}, released_energy{0};
    Vec3 released_momentum{}, released_angular_momentum{}, released_mass_moment{};
};
constexpr std::size_t kick_terms = sizeof(KickTerms) / sizeof(double);
static_assert(kick_terms == free_terms + 2 + 3 * 3);

/// Sums over the bodies of a block in their order.
struct KickSums {
    std::array<double, kick_terms> sum{};
    std::array<FreeTerms<Native>, parts> wide{};  ///< of bodies that came eight at a time, lane by lane
    Eight fastest{};                              ///< of them
    double max_speed{0};
    std::int64_t worst_body{-1};

    void add(const KickTerms& terms) {
        const auto numbers = std::bit_cast<std::array<double, kick_terms>>(terms);
        for (std::size_t k = 0; k < kick_terms; ++k) {
            sum[k] += numbers[k];
        }
    }
    /// Adds the lanes to the sums, in their order.
    void fold() {
        for (FreeTerms<Native>& terms : wide) {
            const auto numbers = std::bit_cast<std::array<Native, free_terms>>(terms);
            for (std::size_t k = 0; k < free_terms; ++k) {
                for (std::int64_t lane = 0; lane < lanes_in<Native>; ++lane) {
                    sum[k] += numbers[k][lane];
                }
            }
            terms = {};
        }
        for (std::int64_t lane = 0; lane < lanes; ++lane) {
            max_speed = std::max(max_speed, fastest[lane]);
        }
    }
    void add_speed(std::int64_t body, double speed, bool is_sane) {
        max_speed = std::max(max_speed, speed);
        worst_body = worst_body >= 0 || is_sane ? worst_body : body;
    }
    /// Of blocks that are folded.
    template <class By>
    static void join(KickSums& a, const KickSums& b, const By& by) {
        for (std::size_t k = 0; k < kick_terms; ++k) {
            by.add(a.sum[k], b.sum[k]);
        }
        by.largest(a.max_speed, b.max_speed);
        const bool is_first = b.worst_body >= 0 && (a.worst_body < 0 || b.worst_body < a.worst_body);
        a.worst_body = is_first ? b.worst_body : a.worst_body;
    }
    KickReport report() const {
        const auto t = std::bit_cast<KickTerms>(sum);
        return {.kinetic = t.free.kinetic,
                .potential = t.free.potential,
                .damping_loss = t.free.damping_loss,
                .external_work = t.free.external_work,
                .work_driven = t.work_driven,
                .released_energy = t.released_energy,
                .momentum = t.free.momentum,
                .angular_momentum = t.free.angular_momentum,
                .impulse = t.free.impulse,
                .angular_impulse = t.free.angular_impulse,
                .released_momentum = t.released_momentum,
                .released_angular_momentum = t.released_angular_momentum,
                .mass_moment = t.free.mass_moment,
                .released_mass_moment = t.released_mass_moment,
                .mass = t.free.mass,
                .max_speed = max_speed,
                .worst_body = worst_body};
    }
};

/// -alpha |f| sign(v), component by component.
template <class T>
T local_damping(T alpha, T force, T velocity) {
    using contact::choose, contact::larger;
    const T size = alpha * larger(force, -force), zero(0.0);
    return choose(velocity > zero, -size, choose(velocity < zero, size, zero));
}
template <class T>
Vec3T<T> local_damping(T alpha, const Vec3T<T>& f, const Vec3T<T>& v) {
    return {local_damping(alpha, f.x, v.x), local_damping(alpha, f.y, v.y), local_damping(alpha, f.z, v.z)};
}

/// A symmetric matrix of one body or of eight.
template <class T>
struct Symmetric {
    T xx, yy, zz, xy, xz, yz;
    friend Vec3T<T> operator*(const Symmetric& m, const Vec3T<T>& v) {
        return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
                m.xz * v.x + m.yz * v.y + m.zz * v.z};
    }
};

/// One free body or eight before the kick, and its loads.
template <class T>
struct KickedBody {
    T mass;
    Symmetric<T> inverse_inertia;
    Vec3T<T> position, velocity, angular_momentum, spin;
    Vec3T<T> contact_force, contact_torque, external_force, external_torque;
};

/// Kicks velocity and angular momentum. @returns what is added up but for what a release brings
template <class T>
[[gnu::always_inline]] inline FreeTerms<T> kick_free(const DemSettings& settings, bool is_planar, const Vec3& g,
                                                     double step, KickedBody<T>& body) {
    const T alpha(settings.local_damping), rate(settings.mass_damping), dt(step), half(0.5 * step);
    const Vec3T<T> gravity{T(g.x), T(g.y), T(g.z)};
    const T mass = body.mass;
    Vec3T<T> force = body.contact_force + body.external_force + mass * gravity;
    Vec3T<T> torque = body.contact_torque + body.external_torque;
    const Vec3T<T> damping_force = local_damping(alpha, force, body.velocity) - (rate * mass) * body.velocity;
    const Vec3T<T> damping_torque = local_damping(alpha, torque, body.spin) - rate * body.angular_momentum;
    force += damping_force;
    torque += damping_torque;
    if (is_planar) {
        force.z = T(0.0);
        torque.x = torque.y = T(0.0);
    }
    const Vec3T<T> mid_velocity = body.velocity + (half / mass) * force;
    const Vec3T<T> mid_momentum = body.angular_momentum + half * torque;
    const Vec3T<T> mid_spin = body.inverse_inertia * mid_momentum;
    const Vec3T<T> gained = mid_velocity - body.velocity, gained_spin = mid_spin - body.spin;
    body.velocity += (dt / mass) * force;
    body.angular_momentum += dt * torque;

    FreeTerms<T> terms;
    terms.mass = mass;
    terms.mass_moment = mass * body.position;
    // Energy that leapfrog keeps, m v_old . v_new/2: springs and gravity work along the way between two kicks by the
    // mean of the forces at both, exactly so where they are linear. Half of the work of a load in the step is booked
    // before the kick, where it has done F . gained dt/2 less.
    const Vec3T<T> load = T(2.0) * (body.external_force + damping_force) - force;
    const Vec3T<T> couple = T(2.0) * (body.external_torque + damping_torque) - torque;
    const T early = T(0.25 * step) * (dot(load, gained) + dot(couple, gained_spin));
    terms.kinetic = T(0.5) * (mass * norm_squared(mid_velocity) + dot(mid_momentum, mid_spin)) + early;
    terms.potential = -mass * dot(gravity, body.position);
    terms.damping_loss = -dt * (dot(damping_force, mid_velocity) + dot(damping_torque, mid_spin));
    terms.external_work = dt * (dot(body.external_force, mid_velocity) + dot(body.external_torque, mid_spin));
    terms.momentum = mass * mid_velocity;
    terms.angular_momentum = mass * cross(body.position, mid_velocity) + mid_momentum;
    const Vec3T<T> outside = damping_force + body.external_force + mass * gravity;
    terms.impulse = dt * outside;
    terms.angular_impulse = dt * (cross(body.position, outside) + damping_torque + body.external_torque);
    return terms;
}

/// Lets the guides of a body take what pushes it along its locked axes, as one more load from outside.
void hold(const body::Locks& locks, const Vec3& gravity, KickedBody<double>& body) {
    const Vec3 force = body.contact_force + body.external_force + body.mass * gravity;
    const Vec3 torque = body.contact_torque + body.external_torque;
    body.external_force += locks.free_translation(force) - force;
    body.external_torque += locks.free_rotation(torque) - torque;
}

/// Spin counts with the speed that holds its energy: |omega| times the radius of gyration.
template <class T>
T speed_of(const KickedBody<T>& body) {
    using std::sqrt;
    return sqrt(norm_squared(body.velocity) +
                dot(body.angular_momentum, body.inverse_inertia * body.angular_momentum) / body.mass);
}

/// Everything that a kick reads and changes.
struct Kick {
    const body::BodySet& bodies;
    const DemSettings& settings;
    const body::BodyKinematics& kinematics;
    const body::Loads& loads;
    const body::LoadView& external;
    const Vec3& gravity;
    const KickTimes& times;
    body::BodyState& state;

    /// A support or driver: what it takes, the free bodies gain; its motion works on them.
    KickTerms of_support(std::size_t i) const {
        KickTerms terms;
        terms.free.impulse = -times.dt * loads.force[i];
        terms.free.angular_impulse = -times.dt * (cross(state.position[i], loads.force[i]) + loads.torque[i]);
        terms.work_driven =
            -times.dt * (dot(loads.force[i], state.velocity[i]) + dot(loads.torque[i], kinematics.angular_velocity[i]));
        return terms;
    }

    void one(std::int64_t index, KickSums& sums) const {
        const auto i = at(index);
        if (kinematics.inverse_mass[i] == 0) {
            sums.add(of_support(i));
            return;
        }
        const Sym3& m = kinematics.inverse_inertia[i];
        const bool has_external = !external.force.empty();
        const Vec3 old_velocity = state.velocity[i], old_momentum = state.angular_momentum[i];
        KickedBody<double> body{bodies.mass[i],
                                {m.xx, m.yy, m.zz, m.xy, m.xz, m.yz},
                                state.position[i],
                                old_velocity,
                                old_momentum,
                                kinematics.angular_velocity[i],
                                loads.force[i],
                                loads.torque[i],
                                has_external ? external.force[i] : Vec3{},
                                has_external ? external.torque[i] : Vec3{}};
        const body::Locks locks = locks_of(bodies, i);
        if (locks.any()) {
            hold(locks, gravity, body);
        }
        KickTerms terms{.free = kick_free(settings, bodies.is_planar, gravity, times.dt, body)};
        state.velocity[i] = locks.free_translation(body.velocity);  // what rounding leaves goes
        state.angular_momentum[i] = locks.free_rotation(body.angular_momentum);
        if (!is_free(bodies, BodyId{static_cast<std::int32_t>(index)}, times.previous)) {
            // At the kick, like everything else: half a kick of velocity came without a path to work along.
            terms.released_energy = terms.free.kinetic + terms.free.potential;
            terms.released_momentum = body.mass * old_velocity;
            terms.released_angular_momentum = body.mass * cross(body.position, old_velocity) + old_momentum;
            terms.released_mass_moment = terms.free.mass_moment;
        }
        sums.add(terms);
        const double speed = speed_of(body);
        sums.add_speed(index, speed, speed <= settings.max_speed && is_finite(body.position));
    }

    /// Part `p` of eight free bodies that were free before: the same operations in the same order.
    [[gnu::flatten]] void part(std::int64_t first, std::size_t p, KickSums& sums) const {
        const auto i = at(first);
        RowsOf<Native> rows;
        for (std::int64_t lane = 0; lane < lanes_in<Native>; ++lane) {
            rows.row[lane] = static_cast<std::int32_t>(first + lane);
        }
        const double* m = &kinematics.inverse_inertia[0].xx;
        const FourOf<Native> front = load_four<6>(m, rows), back = load_four<6>(m + 2, rows);
        KickedBody<Native> body{Native::load(&bodies.mass[i]),
                                {front.a, front.b, front.c, front.d, back.c, back.d},
                                load_vectors<Native>(&state.position[i]),
                                load_vectors<Native>(&state.velocity[i]),
                                load_vectors<Native>(&state.angular_momentum[i]),
                                load_vectors<Native>(&kinematics.angular_velocity[i]),
                                load_vectors<Native>(&loads.force[i]),
                                load_vectors<Native>(&loads.torque[i]),
                                {},
                                {}};
        if (!external.force.empty()) {
            body.external_force = load_vectors<Native>(&external.force[i]);
            body.external_torque = load_vectors<Native>(&external.torque[i]);
        }
        sums.wide[p] += kick_free(settings, bodies.is_planar, gravity, times.dt, body);
        store_vectors(body.velocity, &state.velocity[i]);
        store_vectors(body.angular_momentum, &state.angular_momentum[i]);
        const Vec3T<Native>& x = body.position;
        const Native speed = speed_of(body), rest = (x.x - x.x) + (x.y - x.y) + (x.z - x.z);  // 0 where x is finite
        const auto are_sane = (speed <= Native(settings.max_speed)) & (rest == Native(0.0));
        if (bits_below(select(are_sane, Native(1.0), Native(0.0)), Native(0.5)) == 0) {
            sums.fastest.part[p] = riprap::detail::greater(sums.fastest.part[p], speed.part[0]);
            return;
        }
        for (std::int64_t lane = 0; lane < lanes_in<Native>; ++lane) {
            sums.add_speed(first + lane, speed[lane], speed[lane] <= settings.max_speed && rest[lane] == 0);
        }
    }
};

/// A body's kick costs enough that small scenes share it too; part of the definition of the sums.
constexpr std::int64_t kick_block = 256;

}  // namespace

KickReport kick(const body::BodySet& bodies, const DemSettings& settings, const body::BodyKinematics& kinematics,
                const body::Loads& contact_loads, const body::LoadView& external, const Vec3& gravity,
                const KickTimes& times, body::BodyState& state) {
    const Kick kick{bodies, settings, kinematics, contact_loads, external, gravity, times, state};
    std::vector<KickSums> blocks(at((bodies.size() + kick_block - 1) / kick_block));
    parallel::for_ranges(bodies.size(), kick_block, [&](std::int64_t begin, std::int64_t end) {
        KickSums sums;
        for (std::int64_t i = begin; i < end;) {
            if (i + lanes <= end && are_free(bodies, i, lanes)) {
                for (std::int64_t p = 0; p < parts; ++p) {
                    kick.part(i + p * lanes_in<Native>, at(p), sums);
                }
                i += lanes;
            } else {
                kick.one(i++, sums);
            }
        }
        sums.fold();
        blocks[at(begin / kick_block)] = sums;
    });
    return parallel::total_of(blocks).report();
}

}  // namespace riprap::solid

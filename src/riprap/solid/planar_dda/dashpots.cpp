// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/dashpots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/contact/contact_set.hpp"
#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

namespace {

/// An impact is resolved by steps of this phase of its contact: it gives back its speed to 1 %.
constexpr double resolved_phase = 0.2;
/// A contact rests where its speed over its frequency is less than this share of its overlap.
constexpr double rest_share = 1.0 / 3;

/// Acceleration of a gap by a unit force along another gap of the same two blocks, moved as rigid ones [1/kg].
double mobility(const Model& model, const State& state, const Contact& of, const Contact& by) {
    double sum = 0;
    for (const std::int32_t block : {of.a, of.b}) {
        if (model.is_fixed[at(block)] == 0) {
            const Unknowns &p = block == of.a ? of.gap.a : of.gap.b, &q = block == by.a ? by.gap.a : by.gap.b;
            const Spread spread = spread_of(model, state, block);
            sum += (p[0] * q[0] + p[1] * q[1] + p[2] * q[2] / (spread.xx + spread.yy)) / model.mass[at(block)];
        }
    }
    return sum;
}

double rate_of(const State& state, const Contact& c) {
    return dot(c.gap.a, rates_of(state, c.a)) + dot(c.gap.b, rates_of(state, c.b));
}

/// Contacts whose materials have a damping ratio, by their pairs of blocks.
class DampedContacts {
 public:
    DampedContacts(const Model& model, const State& state, double dt, const std::vector<Contact>& contacts)
        : model_(model), state_(state), contacts_(contacts) {
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            const Contact& contact = contacts[k];
            if (contact.joint.damping_ratio > 0) {
                const auto [first, second] = std::minmax(contact.a, contact.b);
                const bool pushes = contact.mode != Mode::open || contact.gap.value + dt * rate_of(state, contact) < 0;
                entries_.push_back({contact::pair_key({first, second}), k, pushes});
            }
        }
        std::ranges::stable_sort(entries_, {}, &Entry::pair);
    }

    /// Calls visit(number of a contact, square of its frequency [1/s^2]). Points of a face share the mass: the square
    /// is sum_j k_j G_ij over the points of the pair that push, at least what the whole masses of both blocks give.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (std::size_t begin = 0, end = 0; begin < entries_.size(); begin = end) {
            while (end < entries_.size() && entries_[end].pair == entries_[begin].pair) {
                ++end;
            }
            for (std::size_t i = begin; i < end; ++i) {
                visit(entries_[i].contact, frequency_squared(begin, end, i));
            }
        }
    }

 private:
    struct Entry {
        std::uint64_t pair;
        std::size_t contact;
        bool pushes;
    };

    double frequency_squared(std::size_t begin, std::size_t end, std::size_t of) const {
        const Contact& point = contacts_[entries_[of].contact];
        double sum = 0, least = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const Contact& other = contacts_[entries_[i].contact];
            sum += i == of || entries_[i].pushes ? other.joint.normal_stiffness * mobility(model_, state_, point, other)
                                                 : 0;
        }
        for (const std::int32_t block : {point.a, point.b}) {
            least += model_.is_fixed[at(block)] != 0 ? 0 : 1 / model_.mass[at(block)];
        }
        return std::max(sum, point.joint.normal_stiffness * least);
    }

    const Model& model_;
    const State& state_;
    const std::vector<Contact>& contacts_;
    std::vector<Entry> entries_;
};

/// Tells an impact from a contact that rests: it is faster than it would ring about the overlap that weight gives it.
bool is_impact(double speed, double gap, double squared, const Vec2& gravity) {
    const double frequency = std::sqrt(squared);
    return std::abs(speed) > frequency * std::max(rest_share * std::max(0.0, -gap), norm(gravity) / squared);
}

}  // namespace

void set_dashpots(const Model& model, const State& state, const Vec2& gravity, double dt,
                  std::vector<Contact>& contacts) {
    DampedContacts(model, state, dt, contacts).for_each([&](std::size_t number, double squared) {
        Contact& contact = contacts[number];
        const double k = contact.joint.normal_stiffness, numerical = 0.5 * k * dt;
        const double wanted = 2 * contact.joint.damping_ratio * k / std::sqrt(squared);
        contact.dashpot = is_impact(rate_of(state, contact), contact.gap.value, squared, gravity)
                              ? wanted - numerical
                              : std::max(0.0, wanted - numerical);
    });
}

std::int64_t find_unresolved_impact(const Model& model, const State& state, const Vec2& gravity, double dt,
                                    const Scratch& scratch) {
    std::int64_t found = -1;
    DampedContacts(model, state, dt, scratch.contacts).for_each([&](std::size_t number, double squared) {
        const Contact& contact = scratch.contacts[number];
        const Trial& trial = scratch.trials[number];
        const double phase = std::sqrt(squared) * dt;
        // Beyond a phase of 1 a contact comes to rest within a step: what counts is its way.
        const double speed = (trial.gap - contact.gap.value) / std::min(dt, dt / phase);
        const bool touches = contact.mode != Mode::open || trial.mode != Mode::open;
        if (touches && phase > resolved_phase && is_impact(speed, contact.gap.value, squared, gravity)) {
            found = static_cast<std::int64_t>(number);
        }
    });
    return found;
}

}  // namespace riprap::solid::planar_dda

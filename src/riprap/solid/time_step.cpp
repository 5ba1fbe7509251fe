// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/time_step.hpp"

#include <algorithm>
#include <limits>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"

namespace riprap::solid {

namespace {

/// The stiffest tangential spring any pair of materials can have: as a share of K_n, or literal [N/m].
struct LargestShear {
    double ratio{0};
    double stiffness{0};
};

LargestShear largest_shear(const material::MaterialSet& materials) {
    LargestShear largest;
    for (const material::PairProperties& pair : materials.pairs) {
        if (pair.friction <= 0 && pair.cohesion <= 0) {
            continue;
        }
        if (pair.shear_stiffness > 0) {
            largest.stiffness = std::max(largest.stiffness, pair.shear_stiffness);
        } else {
            largest.ratio = std::max(largest.ratio, pair.shear_ratio);
        }
    }
    return largest;
}

/// A body as a chain of masses and springs sees it.
struct Stiffness {
    double area;      ///< lambda: stiffest direction of the covered surface [m^2]
    double literal;   ///< tangential springs given in N/m, one on every face [N/m]
    double gradient;  ///< k_n/r of its softest part: pressure per depth [Pa/m]
    double mass;      ///< [kg]
    int face_count{0};
};

Stiffness stiffness_of(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                       const material::MaterialSet& materials, std::int32_t body, const LargestShear& shear) {
    Mat3 covered{};
    int face_count = 0;
    double radius = std::numeric_limits<double>::infinity();
    for (std::int32_t p = bodies.part_begin[at(body)]; p < bodies.part_begin[at(body) + 1]; ++p) {
        const body::Part& part = bodies.parts[at(p)];
        const Mat3 turn = to_matrix(part.local.orientation);
        const Mat3 tensor = turn * shapes.area_tensor(part.shape) * transpose(turn);
        covered = covered + (1 - shear.ratio) * tensor + (shear.ratio * trace(tensor)) * Mat3::identity();
        face_count += shapes.view(part.shape).face_count;
        radius = std::min(radius, shapes.view(part.shape).inscribed_radius);
    }
    const Vec3 eigenvalues = symmetric_eigen(covered).values;
    const double literal = shear.stiffness * face_count;
    return {std::max({eigenvalues.x, eigenvalues.y, eigenvalues.z}), literal,
            materials[bodies.material[at(body)]].normal_stiffness / radius, bodies.mass[at(body)], face_count};
}

/// The largest damping ratios of any pair of materials [-].
struct LargestDamping {
    double ratio{0};           ///< of all pairs
    double ratio_of_rough{0};  ///< of those with friction or cohesion, damped tangentially as well
};

LargestDamping largest_damping(const material::MaterialSet& materials) {
    LargestDamping largest;
    for (const material::PairProperties& pair : materials.pairs) {
        largest.ratio = std::max(largest.ratio, pair.damping_ratio);
        if (pair.friction > 0 || pair.cohesion > 0) {
            largest.ratio_of_rough = std::max(largest.ratio_of_rough, pair.damping_ratio);
        }
    }
    return largest;
}

/// Share of the limit 2/omega that dashpots leave: sqrt(1 + z^2) - z for a dashpot that uses the velocity before the
/// kick, z the modal damping ratio. N equal contacts that work on one mode give z = sqrt(N) xi: two for a body between
/// two neighbours, all its faces where contacts are damped tangentially as well.
double damped_share(const LargestDamping& damping, int face_count) {
    const double modal =
        std::max(std::sqrt(2.0) * damping.ratio, std::sqrt(static_cast<double>(face_count)) * damping.ratio_of_rough);
    return std::sqrt(1 + modal * modal) - modal;
}

double omega_squared(const Stiffness& body, const Stiffness& neighbour) {
    return (body.area * (body.gradient + neighbour.gradient) + body.literal) *
           (1 / body.mass + 1 / std::sqrt(body.mass * neighbour.mass));
}

}  // namespace

DemTimeStep time_step_bound(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                            const material::MaterialSet& materials, std::span<const std::uint8_t> left_out) {
    const LargestShear shear = largest_shear(materials);
    Stiffness lightest{0, 0, 0, std::numeric_limits<double>::infinity()};
    Stiffness steepest{0, 0, 0, std::numeric_limits<double>::infinity()};
    double steepest_support = 0;
    const auto is_left_out = [&](std::int32_t body) { return !left_out.empty() && left_out[at(body)] != 0; };
    for (std::int32_t body = 0; body < bodies.size(); ++body) {
        if (is_left_out(body)) {
            continue;
        }
        const Stiffness own = stiffness_of(bodies, shapes, materials, body, shear);
        if (!may_move(bodies, at(body))) {
            steepest_support = std::max(steepest_support, own.gradient);
            continue;
        }
        if (own.mass < lightest.mass) {
            lightest = own;
        }
        if (own.gradient > steepest.gradient) {
            steepest = own;
        }
    }
    DemTimeStep bound{std::numeric_limits<double>::infinity(), BodyId{}, "no free body"};
    const LargestDamping damping = largest_damping(materials);
    const Stiffness support{0, 0, steepest_support, std::numeric_limits<double>::infinity()};
    for (std::int32_t body = 0; body < bodies.size(); ++body) {
        if (!may_move(bodies, at(body)) || is_left_out(body)) {
            continue;
        }
        const Stiffness own = stiffness_of(bodies, shapes, materials, body, shear);
        const double share = damped_share(damping, own.face_count);
        struct Neighbour {
            const Stiffness* stiffness;
            const char* name;
        };
        for (const Neighbour& other :
             {Neighbour{&own, "bodies like itself"}, Neighbour{&lightest, "the lightest body"},
              Neighbour{&steepest, "the stiffest body"}, Neighbour{&support, "an immovable support"}}) {
            const double limit = share * 2 / std::sqrt(omega_squared(own, *other.stiffness));
            if (limit < bound.limit) {
                bound = {limit, BodyId{body},
                         "contact stiffness of " + bodies.name(BodyId{body}) + " covered by " + other.name};
            }
        }
    }
    return bound;
}

}  // namespace riprap::solid

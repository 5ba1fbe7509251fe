// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dda/critical_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/contact/stability.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/explicit_dda/advance.hpp"

namespace riprap::solid::explicit_dda {

double strain_frequency_squared(const affine::Elasticity& material, double volume, const Mat3& inertia) {
    const Vec3 moments = symmetric_eigen(inertia).values;
    const double stiffest = std::max(3 * material.lame() + 2 * material.shear_modulus(), 2 * material.shear_modulus());
    return volume * stiffest / std::min({moments.x, moments.y, moments.z});
}

double mobility(double mass, const Mat3& inverse_inertia, const Vec3& arm) {
    return 1 / mass + dot(arm, inverse_inertia * arm);
}

double step_of(double frequency_squared, double damping) { return contact::stable_step(frequency_squared, damping); }

double stable_step(const affine::BlockSystem& system, const affine::BlockState& state, int springs) {
    double stiffest = 0, least = std::numeric_limits<double>::infinity();
    for (const affine::Surface& surface : system.surfaces.pairs) {
        stiffest = std::max({stiffest, surface.normal_stiffness, surface.shear_stiffness});
    }
    double lightest = 0;
    std::vector<double> strain(at(system.size()), 0), loose(at(system.size()), 0);
    for (std::int32_t block = 0; block < system.size(); ++block) {
        const auto b = at(block);
        if (system.is_fixed[b] != 0) {
            continue;
        }
        const affine::Shape& shape = system.shape_of(block);
        const Mat3 f = affine::rows_at(state.deformation, b);
        const Mat3 inertia = f * system.inertia[b] * transpose(f);
        strain[b] = strain_frequency_squared(system.elasticity, shape.volume * determinant(f), inertia);
        const Mat3 back = inverse(inertia);
        for (const Vec3& x : shape.vertices) {
            loose[b] = std::max(loose[b], mobility(system.mass[b], back, f * x));
        }
        lightest = std::max(lightest, loose[b]);
    }
    for (std::int32_t block = 0; block < system.size(); ++block) {
        const auto b = at(block);
        if (system.is_fixed[b] == 0) {
            const affine::Shape& shape = system.shape_of(block);
            const double area = system.surface_of(block, block).factor(shape.size * shape.size);
            const double contact = springs * stiffest * area * (loose[b] + std::sqrt(loose[b] * lightest));
            least = std::min(least, step_of(strain[b] + contact, 0));
        }
    }
    return least;
}

}  // namespace riprap::solid::explicit_dda

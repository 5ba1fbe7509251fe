// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/submatrices.hpp"

#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

Elasticity elasticity_of(const affine::Elasticity& rock, PlaneState plane) {
    const double E = rock.youngs_modulus, nu = rock.poisson_ratio;
    const double shear = 0.5 * E / (1 + nu);
    if (plane == PlaneState::stress) {
        const double direct = E / (1 - nu * nu);
        return {direct, nu * direct, shear};
    }
    const double factor = E / ((1 + nu) * (1 - 2 * nu));
    return {(1 - nu) * factor, nu * factor, shear};
}

Stress stress_of(const Elasticity& e, const Unknowns& d) {
    return {e.direct * d[3] + e.cross * d[4], e.cross * d[3] + e.direct * d[4], e.shear * d[5]};
}

double energy_density(const Elasticity& e, const Stress& s) {
    const double mean = 0.5 * (s.x + s.y), half = 0.5 * (s.x - s.y);
    return mean * mean / (e.direct + e.cross) + half * half / (e.direct - e.cross) + 0.5 * s.xy * s.xy / e.shear;
}

Spread spread_of(const Model& model, const State& state, std::int32_t block) {
    const std::size_t b = at(block);
    const Vec2 fx = offset_of(state, block, {1, 0}), fy = offset_of(state, block, {0, 1});  // columns of R U
    const double xx = model.moment_xx[b], yy = model.moment_yy[b], xy = model.moment_xy[b];
    const auto product = [&](double p, double q, double r, double s) {  // (p, q) M (r, s)
        return p * (xx * r + xy * s) + q * (xy * r + yy * s);
    };
    return {product(fx.x, fy.x, fx.x, fy.x), product(fx.y, fy.y, fx.y, fy.y), product(fx.x, fy.x, fx.y, fy.y)};
}

double volume_of(const Model& model, const State& state, std::int32_t block) {
    const std::size_t b = at(block);
    return model.area[b] * (state.stretch_xx[b] * state.stretch_yy[b] - state.stretch_xy[b] * state.stretch_xy[b]);
}

Block6 elastic_block(const Elasticity& e, double volume) {
    Block6 K{};
    K[6 * 3 + 3] = K[6 * 4 + 4] = volume * e.direct;
    K[6 * 3 + 4] = K[6 * 4 + 3] = volume * e.cross;
    K[6 * 5 + 5] = volume * e.shear;
    return K;
}

Block6 mass_block(double mass, const Spread& spread) {
    const double s1 = mass * spread.xx, s2 = mass * spread.yy, s3 = mass * spread.xy;
    Block6 M{};
    const auto set = [&M](std::size_t i, std::size_t j, double value) { M[6 * i + j] = M[6 * j + i] = value; };
    set(0, 0, mass);
    set(1, 1, mass);
    set(2, 2, s1 + s2);
    set(2, 3, -s3);
    set(2, 4, s3);
    set(2, 5, 0.5 * (s1 - s2));
    set(3, 3, s1);
    set(3, 5, 0.5 * s3);
    set(4, 4, s2);
    set(4, 5, 0.5 * s3);
    set(5, 5, 0.25 * (s1 + s2));
    return M;
}

Unknowns stress_force(const Stress& stress, double volume) {
    return {0, 0, 0, -volume * stress.x, -volume * stress.y, -volume * stress.xy};
}

Block6 fixed_point_block(const Vec2& r, double stiffness) {
    Block6 K{};
    const Unknowns along_x = force_at(r, {1, 0}), along_y = force_at(r, {0, 1});
    add_outer(K, stiffness, along_x, along_x);
    add_outer(K, stiffness, along_y, along_y);
    return K;
}

Linear gap_of(const CornerAndEdge& w) {
    const Vec2 p1 = w.corner, p2 = w.end, p3 = w.begin;  // the outside is to the left of p2 -> p3
    const double length = norm(p3 - p2), inverse = 1 / length;
    Linear gap;
    gap.value = cross(p2 - p1, p3 - p1) * inverse;
    gap.a = force_at(p1 - w.corner_center, inverse * Vec2{p2.y - p3.y, p3.x - p2.x});
    gap.b = force_at(p2 - w.edge_center, inverse * Vec2{p3.y - p1.y, p1.x - p3.x});
    add(gap.b, 1, force_at(p3 - w.edge_center, inverse * Vec2{p1.y - p2.y, p2.x - p1.x}));
    return gap;
}

Linear slip_of(const CornerAndEdge& w, double lock) {
    const Vec2 p1 = w.corner, p2 = w.end, p3 = w.begin;
    const double inverse = 1 / norm(p3 - p2);
    const Vec2 along = inverse * (p3 - p2), lock_point = (1 - lock) * p2 + lock * p3;
    Linear slip;
    slip.value = dot(p1 - lock_point, along);
    slip.a = force_at(p1 - w.corner_center, along);
    const Vec2 at_end = inverse * (-p1 + 2 * (1 - lock) * p2 - (1 - 2 * lock) * p3);
    const Vec2 at_begin = inverse * (p1 - (1 - 2 * lock) * p2 - 2 * lock * p3);
    slip.b = force_at(p2 - w.edge_center, at_end);
    add(slip.b, 1, force_at(p3 - w.edge_center, at_begin));
    return slip;
}

double foot_of(const CornerAndEdge& w) {
    const Vec2 edge = w.begin - w.end;
    return dot(w.corner - w.end, edge) / dot(edge, edge);
}

Linear length_of(const Vec2& first, const Vec2& first_center, const Vec2& second, const Vec2& second_center) {
    const Vec2 line = second - first;
    Linear length;
    length.value = norm(line);
    const Vec2 along = (1 / length.value) * line;
    length.a = force_at(first - first_center, -along);
    length.b = force_at(second - second_center, along);
    return length;
}

}  // namespace riprap::solid::planar_dda

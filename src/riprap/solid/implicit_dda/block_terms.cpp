// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/block_terms.hpp"

namespace riprap::solid::implicit_dda {

namespace {

/// Gradients of unit values of the unknowns 4 to 12.
constexpr std::array<Mat3, 9> unit_gradients() {
    const auto symmetric = [](int i, int j) {
        Mat3 m{};
        m(i, j) = m(j, i) = 0.5;
        return m;
    };
    return {affine::cross_matrix({1, 0, 0}),
            affine::cross_matrix({0, 1, 0}),
            affine::cross_matrix({0, 0, 1}),
            Mat3::diagonal({1, 0, 0}),
            Mat3::diagonal({0, 1, 0}),
            Mat3::diagonal({0, 0, 1}),
            symmetric(0, 1),
            symmetric(1, 2),
            symmetric(2, 0)};
}

double contract(const Mat3& a, const Mat3& b) {
    return riprap::dot(a.row[0], b.row[0]) + riprap::dot(a.row[1], b.row[1]) + riprap::dot(a.row[2], b.row[2]);
}

}  // namespace

DisplacementMatrix displacement_matrix(const Vec3& r) {
    return {Vec3{1, 0, 0},
            Vec3{0, 1, 0},
            Vec3{0, 0, 1},
            Vec3{0, -r.z, r.y},
            Vec3{r.z, 0, -r.x},
            Vec3{-r.y, r.x, 0},
            Vec3{r.x, 0, 0},
            Vec3{0, r.y, 0},
            Vec3{0, 0, r.z},
            Vec3{0.5 * r.y, 0.5 * r.x, 0},
            Vec3{0, 0.5 * r.z, 0.5 * r.y},
            Vec3{0.5 * r.z, 0, 0.5 * r.x}};
}

Vec3 displacement(const DisplacementMatrix& t, const double* d) {
    Vec3 u{};
    for (std::size_t i = 0; i < 12; ++i) {
        u += d[i] * t[i];
    }
    return u;
}

void add_force(const DisplacementMatrix& t, const Vec3& f, double* out) {
    for (std::size_t i = 0; i < 12; ++i) {
        out[i] += riprap::dot(t[i], f);
    }
}

Mat3 gradient_of(const double* d) {
    const Vec3 turn{d[3], d[4], d[5]};
    const double xy = 0.5 * d[9], yz = 0.5 * d[10], zx = 0.5 * d[11];
    return affine::cross_matrix(turn) + Mat3{{{d[6], xy, zx}, {xy, d[7], yz}, {zx, yz, d[8]}}};
}

Vector12 unknowns_of(const Vec3& u, const Mat3& g) {
    const Vec3 turn = affine::spin_of(g);
    return {u.x,
            u.y,
            u.z,
            turn.x,
            turn.y,
            turn.z,
            g(0, 0),
            g(1, 1),
            g(2, 2),
            g(0, 1) + g(1, 0),
            g(1, 2) + g(2, 1),
            g(2, 0) + g(0, 2)};
}

Vector12 load_vector(const Vec3& f, const Mat3& m) {
    const Vec3 torque = 2.0 * affine::spin_of(m);
    return {f.x,
            f.y,
            f.z,
            torque.x,
            torque.y,
            torque.z,
            m(0, 0),
            m(1, 1),
            m(2, 2),
            0.5 * (m(0, 1) + m(1, 0)),
            0.5 * (m(1, 2) + m(2, 1)),
            0.5 * (m(2, 0) + m(0, 2))};
}

Matrix12 inertia_matrix(double mass, const Mat3& s) {
    static constexpr std::array<Mat3, 9> gradients = unit_gradients();
    Matrix12 j{};
    j[0] = j[13] = j[26] = mass;
    for (std::size_t k = 0; k < 9; ++k) {
        const Mat3 moved = gradients[k] * s;
        for (std::size_t l = 0; l < 9; ++l) {
            j[(k + 3) * 12 + l + 3] = contract(moved, gradients[l]);
        }
    }
    return j;
}

void add_elastic(const affine::Elasticity& material, double volume, Matrix12& k) {
    const double lame = volume * material.lame(), shear = volume * material.shear_modulus();
    for (std::size_t i = 6; i < 9; ++i) {
        for (std::size_t j = 6; j < 9; ++j) {
            k[j * 12 + i] += lame + (i == j ? 2 * shear : 0);
        }
        k[(i + 3) * 12 + i + 3] += shear;
    }
}

void add_initial_stress(const Mat3& s, double volume, Vector12& out) {
    for (int i = 0; i < 3; ++i) {
        out[static_cast<std::size_t>(6 + i)] -= volume * s(i, i);
        out[static_cast<std::size_t>(9 + i)] -= volume * s(i, (i + 1) % 3);
    }
}

void add_springs(const DisplacementMatrix& a, const DisplacementMatrix& b, const Mat3& stiffness, double factor,
                 double* block) {
    for (std::size_t c = 0; c < 12; ++c) {
        const Vec3 force = factor * (stiffness * b[c]);
        for (std::size_t r = 0; r < 12; ++r) {
            block[c * 12 + r] += riprap::dot(a[r], force);
        }
    }
}

Vector12 times(const Matrix12& a, const Vector12& x) {
    Vector12 y{};
    for (std::size_t c = 0; c < 12; ++c) {
        for (std::size_t r = 0; r < 12; ++r) {
            y[r] += a[c * 12 + r] * x[c];
        }
    }
    return y;
}

}  // namespace riprap::solid::implicit_dda

// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/solid/affine/step_update.hpp"
#include "riprap/solid/implicit_dda/system.hpp"

namespace riprap::solid::implicit_dda {
namespace {

const Vec3 arm_a{0.3, -0.2, 0.5}, arm_b{-0.4, 0.1, -0.3};

Vector12 some_unknowns(double seed) {
    Vector12 d{};
    for (std::size_t i = 0; i < 12; ++i) {
        d[i] = std::sin(seed + 1.7 * static_cast<double>(i));
    }
    return d;
}

TEST(BlockTerms, the_displacement_matrix_is_that_of_the_corrected_source) {
    const double x = 2, y = 3, z = 5;
    const double expected[3][12] = {{1, 0, 0, 0, z, -y, x, 0, 0, y / 2, 0, z / 2},
                                    {0, 1, 0, -z, 0, x, 0, y, 0, x / 2, z / 2, 0},
                                    {0, 0, 1, y, -x, 0, 0, 0, z, 0, y / 2, x / 2}};
    const DisplacementMatrix t = displacement_matrix({x, y, z});
    for (std::size_t i = 0; i < 12; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(t[i][axis], expected[axis][i]);
        }
    }
}

TEST(BlockTerms, unknowns_and_gradient_say_the_same) {
    const Vector12 d = some_unknowns(0.3);
    const Mat3 g = gradient_of(d.data());
    const Vec3 there = displacement(displacement_matrix(arm_a), d.data());
    EXPECT_LT(norm(there - (Vec3{d[0], d[1], d[2]} + g * arm_a)), 1e-15);
    const Vector12 back = unknowns_of({d[0], d[1], d[2]}, g);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(back[i], d[i], 1e-15);
    }
}

TEST(BlockTerms, loads_as_force_and_dipole_are_loads_at_points) {
    const Vec3 f{1, -2, 3};
    Vector12 at_point{};
    add_force(displacement_matrix(arm_a), f, at_point.data());
    const Vector12 given = load_vector(f, outer(f, arm_a));
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(given[i], at_point[i], 1e-15);
    }
}

TEST(BlockTerms, pressure_split_to_the_corners_of_a_face_is_pressure_at_its_places) {
    // A face of 2 x 3 m in the y-z plane, 4 x 5 cells of fluid, bilinear shares of each corner [Ding2021, eq. 7.4]. T
    // is linear in place, so the shares do what the force does where it acts.
    const Vec3 low{0.7, -1.2, -0.9};
    const double width = 2, height = 3;
    Vector12 at_corners{}, at_cells{};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 5; ++j) {
            const double y = (i + 0.5) / 4, z = (j + 0.5) / 5;
            const Vec3 force{-(1000.0 + 300 * i - 170 * j * j), 0, 0};
            add_force(displacement_matrix(low + Vec3{0, width * y, height * z}), force, at_cells.data());
            for (const double a : {0.0, 1.0}) {
                for (const double b : {0.0, 1.0}) {
                    const double share = (a > 0 ? y : 1 - y) * (b > 0 ? z : 1 - z);
                    add_force(displacement_matrix(low + Vec3{0, width * a, height * b}), share * force,
                              at_corners.data());
                }
            }
        }
    }
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(at_corners[i], at_cells[i], 1e-13 * std::abs(at_cells[0])) << i;
    }
}

TEST(BlockTerms, the_inertia_matrix_is_the_integral_of_its_definition) {
    // J = rho sum over a fine lattice of T^T T, and the closed forms of the source.
    const Mat3 s{{{2, 0.3, -0.2}, {0.3, 3, 0.4}, {-0.2, 0.4, 5}}};
    const Matrix12 j = inertia_matrix(7, s);
    const auto at = [&](std::size_t r, std::size_t c) { return j[(c - 1) * 12 + r - 1]; };  // counts from 1
    EXPECT_EQ(at(2, 2), 7);
    EXPECT_NEAR(at(4, 4), 3 + 5, 1e-14);
    EXPECT_NEAR(at(4, 5), -0.3, 1e-14);
    EXPECT_NEAR(at(4, 8), -0.4, 1e-14);
    EXPECT_NEAR(at(4, 9), 0.4, 1e-14);
    EXPECT_NEAR(at(4, 10), -(-0.2) / 2, 1e-14);
    EXPECT_NEAR(at(4, 11), (3.0 - 5.0) / 2, 1e-14);
    EXPECT_NEAR(at(6, 10), (2.0 - 3.0) / 2, 1e-14);
    EXPECT_NEAR(at(7, 7), 2, 1e-14);
    EXPECT_NEAR(at(7, 10), 0.3 / 2, 1e-14);
    EXPECT_NEAR(at(10, 10), (2.0 + 3.0) / 4, 1e-14);
    EXPECT_NEAR(at(10, 11), -0.2 / 4, 1e-14);
    EXPECT_NEAR(at(11, 12), 0.3 / 4, 1e-14);
    // Kinetic energy of a velocity field: 1/2 m v^2 + 1/2 tr(L S L^T).
    const Vector12 v = some_unknowns(1.1);
    const Mat3 l = gradient_of(v.data());
    EXPECT_NEAR(dot(v, times(j, v)), 7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + trace(l * s * transpose(l)),
                1e-12);
}

TEST(BlockTerms, the_elastic_matrix_stores_the_energy_of_hookes_law) {
    const affine::Elasticity rock{3e3, 0.25};
    Matrix12 k{};
    add_elastic(rock, 2, k);
    const Vector12 d = some_unknowns(0.7);
    const Mat3 strain = affine::symmetric_part(gradient_of(d.data()));
    EXPECT_NEAR(0.5 * dot(d, times(k, d)), 2 * elastic_energy(rock, strain), 1e-9);
    // Uniaxial stress s_x = E e_x with nu = 0.25.
    const Mat3 uniaxial = affine::elastic_stress(rock, Mat3::diagonal({1e-3, -0.25e-3, -0.25e-3}));
    EXPECT_NEAR(uniaxial(0, 0), 3, 1e-12);
    EXPECT_NEAR(uniaxial(1, 1), 0, 1e-12);
}

TEST(BlockTerms, initial_stress_does_the_work_of_its_strain) {
    const Mat3 stress{{{2, 0.3, -0.2}, {0.3, 3, 0.4}, {-0.2, 0.4, 5}}};
    Vector12 load{};
    add_initial_stress(stress, 2, load);
    const Vector12 d = some_unknowns(0.2);
    EXPECT_NEAR(dot(load, d), -2 * trace(stress * gradient_of(d.data())), 1e-13);
}

/// One contact between rows 0 and 1 whose system is K D = F.
struct OneContact {
    std::vector<ContactTerm> terms;
    Equations equations;

    explicit OneContact(ContactMode mode) {
        ContactTerm c{};
        c.row_a = 0;
        c.row_b = 1;
        c.arm_a = arm_a;
        c.arm_b = arm_b;
        c.normal = normalized(Vec3{1, 2, -1});
        c.gap = -0.01;
        c.springs = {50, 20, 0.4, 0, 0};
        c.trial.mode = mode;
        c.trial.slip_before = cross(c.normal, Vec3{0.01, 0.02, 0.03});
        c.trial.friction = 0.3;
        c.trial.direction = normalized(cross(c.normal, Vec3{1, 0, 0}));
        c.trial.across = 13;
        terms.push_back(c);
        equations.diagonal.assign(2, Matrix12{});
        equations.given.assign(2, Vector12{});
        link_rows(2, terms, equations);
        assemble(terms, equations);
    }
    /// Energy of the springs, minus the work of friction, at displacements of both blocks.
    double energy(const std::array<double, 24>& d) const {
        const ContactTerm& c = terms[0];
        const Vec3 moved =
            displacement(displacement_matrix(c.arm_a), d.data()) - displacement(displacement_matrix(c.arm_b), &d[12]);
        const double gap = c.gap - dot(c.normal, moved);
        const Vec3 slide = moved - dot(c.normal, moved) * c.normal;
        double energy = c.trial.mode == ContactMode::open ? 0 : 0.5 * c.springs.normal * gap * gap;
        if (c.trial.mode == ContactMode::lock) {
            energy += 0.5 * c.springs.shear * norm_squared(c.trial.slip_before + slide);
        }
        if (c.trial.mode == ContactMode::slide) {
            const double off = dot(cross(c.normal, c.trial.direction), c.trial.slip_before + moved);
            energy += c.trial.friction * dot(c.trial.direction, moved) + 0.5 * c.trial.across * off * off;
        }
        return energy;
    }
};

TEST(ContactTerms, sub_matrices_are_derivatives_of_their_energy) {
    for (const ContactMode mode : {ContactMode::open, ContactMode::slide, ContactMode::lock}) {
        const OneContact one(mode);
        const double h = 1e-3;
        const auto shifted = [&](std::size_t i, double by_i, std::size_t j, double by_j) {
            std::array<double, 24> d{};
            d[i] += by_i;
            d[j] += by_j;
            return one.energy(d);
        };
        for (std::size_t i = 0; i < 24; ++i) {
            const double slope = (shifted(i, h, 0, 0) - shifted(i, -h, 0, 0)) / (2 * h);
            EXPECT_NEAR(one.equations.right[i], -slope, 1e-9);
            for (std::size_t j = 0; j < 24; ++j) {
                const double second =
                    (shifted(i, h, j, h) - shifted(i, h, j, -h) - shifted(i, -h, j, h) + shifted(i, -h, j, -h)) /
                    (4 * h * h);
                const auto& k = one.equations.matrix;
                const auto entry =
                    k.pattern().find(static_cast<std::int64_t>(i / 12), static_cast<std::int64_t>(j / 12));
                EXPECT_NEAR(k.at(entry, static_cast<int>(i % 12), static_cast<int>(j % 12)), second, 1e-7);
            }
        }
    }
}

TEST(ContactTerms, what_one_block_gets_the_other_gives) {
    for (const ContactMode mode : {ContactMode::slide, ContactMode::lock}) {
        const OneContact one(mode);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(one.equations.right[axis] + one.equations.right[12 + axis], 0, 1e-14);
        }
    }
}

TEST(OpenClose, the_modes_follow_the_table) {
    const ContactSprings springs{100, 50, 0.5, 0, 0};
    const auto next = [&](ContactMode mode, double gap, const Vec3& slip, const Vec3& step, const Vec3& direction) {
        ContactTrial trial{mode, false, {}, gap, slip, step, 0, direction, 0, false};
        update_mode(springs, {}, trial);
        return trial.mode;
    };
    using enum affine::ContactMode;
    const Vec3 x{1, 0, 0}, little = 0.005 * x, much = 0.02 * x;  // the limit is 0.01 m at a gap of -0.01 m
    EXPECT_EQ(next(open, 0.01, {}, {}, {}), open);
    EXPECT_EQ(next(open, -0.01, little, little, {}), lock);
    EXPECT_EQ(next(open, -0.01, much, much, {}), slide);
    EXPECT_EQ(next(slide, 0.01, much, much, x), open);
    EXPECT_EQ(next(slide, -0.01, much, much, x), slide);
    EXPECT_EQ(next(slide, -0.01, -much, -much, x), lock);
    EXPECT_EQ(next(slide, -0.01, little, -little, x), lock);
    EXPECT_EQ(next(lock, 0.01, {}, {}, {}), open);
    EXPECT_EQ(next(lock, -0.01, little, little, {}), lock);
    EXPECT_EQ(next(lock, -0.01, much, little, {}), slide);
}

TEST(OpenClose, a_contact_that_slips_by_less_than_the_slide_tolerance_locks_as_in_the_source) {
    const ContactSprings springs{100, 50, 0.5, 0, 0};
    const Vec3 slip{0.02, 0, 0}, little{5e-5, 0, 0}, direction{1, 0, 0};  // the slip lies beyond the limit of 0.01 m
    for (const double tolerance : {1e-4, 1e-5, -1.0}) {
        ContactTrial trial{ContactMode::slide, false, {}, -0.01, slip, little, 0, direction, 0, false};
        update_mode(springs, {.slide_tolerance = tolerance}, trial);
        EXPECT_EQ(trial.mode, tolerance == 1e-4 ? ContactMode::lock : ContactMode::slide);
    }
}

TEST(OpenClose, an_intact_contact_holds_tension_up_to_its_strength) {
    const ContactSprings springs{100, 50, 0.5, 3, 2};
    ContactTrial trial{ContactMode::lock, true, {}, 0.019, {}, {}, 0, {}, 0, false};
    update_mode(springs, {}, trial);
    EXPECT_EQ(trial.mode, ContactMode::lock);
    trial.gap = 0.021;
    update_mode(springs, {}, trial);
    EXPECT_EQ(trial.mode, ContactMode::open);
}

}  // namespace
}  // namespace riprap::solid::implicit_dda

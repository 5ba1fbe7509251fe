// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/flow/flows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace riprap::fluid {
namespace {

const std::vector<Flow>& flows() {
    static const std::vector<Flow> all{
        TaylorGreenFlow{1.3, 2.5},         KovasznayFlow{0.7, 1.2},
        RotationFlow{{0.2, -0.4, 0}, 1.7}, VortexFlow{{-0.3, 0.1, 0}, 1.4, 0.9, 3},
        StrainFlow{{0.1, -0.2, 0}, 1.1},   StandingWaveFlow{{0.1, -0.4, 0}, 0.8, 3.1, 1.2, 1.7}};
    return all;
}

const std::vector<Vec3> places{{0.31, 0.22, 0}, {-0.11, 0.64, 0}, {0.77, 0.48, 0}};

TEST(Flows, TheVelocityIsThatOfTheStreamFunction) {
    constexpr double h = 1e-5, nu = 0.02, t = 0.4;
    for (const Flow& flow : flows()) {
        for (const Vec3& x : places) {
            const auto along = [&](const Vec3& step) {
                return (stream_of(flow, x + step, t, nu) - stream_of(flow, x - step, t, nu)) / (2 * h);
            };
            const Vec3 u = velocity_of(flow, x, t, nu);
            EXPECT_NEAR(u.x, along({0, h, 0}), 1e-8) << flow.index();
            EXPECT_NEAR(u.y, -along({h, 0, 0}), 1e-8) << flow.index();
            EXPECT_GT(norm(u), 0.01) << flow.index();
        }
    }
}

/// d w/dt + u.grad w - nu laplace w, w the vorticity, by differences of the stream function.
double vorticity_residual(const Flow& flow, const Vec3& x, double t, double nu) {
    constexpr double h = 2e-3, dt = 1e-4;
    const auto psi = [&](double i, double j, double time) {
        return stream_of(flow, x + Vec3{i * h, j * h, 0}, time, nu);
    };
    const auto vorticity = [&](double i, double j, double time) {
        return -(psi(i + 1, j, time) + psi(i - 1, j, time) + psi(i, j + 1, time) + psi(i, j - 1, time) -
                 4 * psi(i, j, time)) /
               (h * h);
    };
    const Vec3 u = velocity_of(flow, x, t, nu);
    const double w = vorticity(0, 0, t), right = vorticity(1, 0, t), left = vorticity(-1, 0, t);
    const double above = vorticity(0, 1, t), below = vorticity(0, -1, t);
    return (vorticity(0, 0, t + dt) - vorticity(0, 0, t - dt)) / (2 * dt) +
           (u.x * (right - left) + u.y * (above - below)) / (2 * h) -
           nu * (right + left + above + below - 4 * w) / (h * h);
}

// The vortex is no flow of a fluid: it tells that the residual of the others is small.
TEST(Flows, ViscousFlowsSolveTheEquationOfVorticity) {
    constexpr double nu = 0.02, t = 0.4;
    for (const Vec3& x : places) {
        for (const std::size_t flow : {0U, 1U, 2U, 4U, 5U}) {
            EXPECT_NEAR(vorticity_residual(flows()[flow], x, t, nu), 0, 2e-3) << flow;
        }
        EXPECT_GT(std::abs(vorticity_residual(flows()[3], x, t, nu)), 0.1);
    }
}

TEST(Flows, AVortexTurnsBackAndEndsAsItBegan) {
    const VortexFlow vortex{{}, 1, 1, 8};
    const Vec3 x{0.3, 0.6, 0};
    for (const double t : {0.0, 1.0, 3.5}) {
        EXPECT_NEAR(norm(vortex.velocity(x, t, 0) + vortex.velocity(x, 8 - t, 0)), 0, 1e-12);
    }
    EXPECT_NEAR(norm(vortex.velocity(x, 4, 0)), 0, 1e-12);
    EXPECT_NEAR(vortex.velocity({0.5, 0.25, 0}, 0, 0).x, -1, 1e-12) << "its largest speed";
}

TEST(Flows, AStandingWaveKeepsOffItsBedAndLiftsItsSurfaceAsAsked) {
    const StandingWaveFlow wave{{0.5, -1, 0}, 0.3, 4, 1, 2};
    EXPECT_NEAR(wave.velocity({1.3, -1, 0}, 0, 0).y, 0, 1e-15);
    EXPECT_NEAR(wave.velocity({0.5, 0, 0}, 0, 0).y, 0.3, 1e-15) << "a crest to come";
    EXPECT_NEAR(wave.velocity({2.5, 0, 0}, 0, 0).y, -0.3, 1e-15) << "half a wave away, a trough";
    EXPECT_NEAR(wave.velocity({2.5, 0, 0}, 0.5, 0).y, 0, 1e-15) << "highest after a quarter of a period";
}

TEST(Flows, WaterWithoutViscosityGoesBetweenBarsWithoutDecay) {
    const KovasznayFlow flow{2, 1};
    EXPECT_NEAR(flow.velocity({5, 0.5, 0}, 0, 0).x, 4, 1e-12);
    EXPECT_NEAR(flow.velocity({5, 0.5, 0}, 0, 10).x, 2, 1e-12) << "and with much of it evenly";
}

}  // namespace
}  // namespace riprap::fluid

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "riprap/view/water_stream.hpp"

namespace riprap::view {

/// Water that sloshes and stirs in a box: steady rolls of three sizes under a swaying motion, advected in short steps.
/// Shuffled, as a run writes it: in the order of its cells, not of ids.
class StirredWater {
 public:
    static constexpr double spacing = 0.01;  ///< [m]

    explicit StirredWater(int per_side) {
        for (int i = 0; i < per_side; ++i) {
            for (int j = 0; j < per_side; ++j) {
                for (int k = 0; k < per_side; ++k) {
                    frame_.id.push_back(static_cast<std::int32_t>(frame_.id.size()));
                    frame_.position.push_back(spacing * Vec3{1.0 * i, 1.0 * j, 1.0 * k});
                }
            }
        }
        frame_.pressure.resize(frame_.id.size());
        frame_.speed.resize(frame_.id.size());
    }
    std::size_t count() const { return frame_.id.size(); }

    const WaterFrame& advance(double interval) {
        constexpr int substeps = 4;
        for (int s = 0; s < substeps; ++s) {
            time_ += interval / substeps;
            for (std::size_t i = 0; i < count(); ++i) {
                const Vec3 u = velocity(frame_.position[i]);
                frame_.position[i] += interval / substeps * u;
                frame_.speed[i] = static_cast<float>(norm(u));
                frame_.pressure[i] = static_cast<float>(9810 * (0.4 - frame_.position[i].z) + 300 * jitter_(random_));
            }
        }
        return frame_;
    }
    WaterFrame shuffled() {
        std::vector<std::size_t> order(count());
        std::iota(order.begin(), order.end(), 0U);
        std::shuffle(order.begin(), order.end(), random_);
        WaterFrame out;
        for (const std::size_t i : order) {
            out.id.push_back(frame_.id[i]);
            out.position.push_back(frame_.position[i]);
            out.pressure.push_back(frame_.pressure[i]);
            out.speed.push_back(frame_.speed[i]);
        }
        return out;
    }

 private:
    Vec3 velocity(const Vec3& x) const {
        Vec3 u{0.5 * std::cos(7 * time_), 0, 0};  // [m/s]
        for (const double k : {7.0, 19.0, 53.0}) {
            const double size = 3 / k;
            u += size * Vec3{std::sin(k * x.z) + std::cos(k * x.y + time_),
                             std::sin(k * x.x) + std::cos(k * x.z - time_), std::sin(k * x.y) + std::cos(k * x.x)};
        }
        return u;
    }
    WaterFrame frame_;
    double time_{0};
    std::mt19937 random_{7};
    std::normal_distribution<double> jitter_;
};

}  // namespace riprap::view

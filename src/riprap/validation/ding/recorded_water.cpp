// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/ding/recorded_water.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/solid/planar_dda/pieces.hpp"

namespace riprap::validation::ding {

using geometry::Vec2;

namespace {

constexpr double piece_length = 0.5;  ///< of a side that one pressure acts on [m]

/// Divides a side from a to b; f(midpoint, inward area vector); the block lies left of a -> b.
template <class F>
void for_pieces(const Vec2& a, const Vec2& b, const F& f) {
    const double length = norm(b - a);
    const int count = std::max(1, static_cast<int>(std::ceil(length / piece_length)));
    const Vec2 inward{-(b.y - a.y) / count, (b.x - a.x) / count};
    for (int i = 0; i < count; ++i) {
        f(a + ((i + 0.5) / count) * (b - a), inward);
    }
}

}  // namespace

RecordedWater::RecordedWater(double cell, double first, double last) : first_(first), last_(last) {
    Breakwater breakwater{cell, cell * 0.625, 2, 2, true};
    grid::GridTrial trial = make_breakwater(breakwater);
    const grid::Mesh& mesh = trial.settings().mesh;
    const int from = mesh.cell_at(0, 200), to = mesh.box.cells[0] - 1;
    columns_ = to - from + 1;
    rows_ = mesh.box.cells[1];
    width_ = mesh.h(0, from);
    height_ = mesh.h(1, 0);
    low_x_ = mesh.centre(0, from);
    low_y_ = mesh.centre(1, 0);
    const auto keep = [&] {
        std::vector<float> sample;
        is_open_.clear();
        for (int j = 0; j < rows_; ++j) {
            for (int i = from; i <= to; ++i) {
                const auto c = grid::at(mesh.box.index(i, j, 0));
                const double density = grid::density_of(trial.settings(), trial.state().fraction[c]);
                const double p =
                    trial.state().pressure[c] + density * dot(trial.settings().gravity, mesh.centre(i, j, 0));
                sample.push_back(static_cast<float>(p));
                is_open_.push_back(trial.scratch().room.capacity[c] > 0 ? 1 : 0);
            }
        }
        samples_.push_back(std::move(sample));
    };
    trial.run(first);
    keep();
    const int count = static_cast<int>(std::lround((last - first) / interval));
    for (int k = 1; k <= count; ++k) {
        trial.run(first + k * interval);
        keep();
    }
}

double RecordedWater::value(std::size_t sample, const Vec2& place) const {
    const double x = std::clamp((place.x - low_x_) / width_, 0.0, columns_ - 1.001);
    const double y = std::clamp((place.y - low_y_) / height_, 0.0, rows_ - 1.001);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    double sum = 0, weight = 0;
    for (const int q : {0, 1}) {
        for (const int p : {0, 1}) {
            const auto c = at((j + q) * columns_ + i + p);
            const double share = (p == 0 ? i + 1 - x : x - i) * (q == 0 ? j + 1 - y : y - j) + 1e-9;
            sum += is_open_[c] != 0 ? share * samples_[sample][c] : 0;
            weight += is_open_[c] != 0 ? share : 0;
        }
    }
    return weight > 0 ? sum / weight : 0;
}

double RecordedWater::pressure(const Vec2& place, double time) const {
    const double s = std::clamp((time - first_) / interval, 0.0, static_cast<double>(samples_.size()) - 1.001);
    const auto k = static_cast<std::size_t>(s);
    const double share = s - std::floor(s);
    return (1 - share) * value(k, place) + share * value(k + 1, place);
}

void press_block(PlanarTrial& trial, std::int32_t block, const RecordedWater& water, double time) {
    const auto first = trial.model.corner_begin[at(block)], last = trial.model.corner_begin[at(block + 1)];
    for (auto k = first; k < last; ++k) {
        const Vec2 a = place_of(trial.state, block, trial.model.corner[at(k)]);
        const Vec2 b = place_of(trial.state, block, trial.model.corner[at(k + 1 < last ? k + 1 : first)]);
        for_pieces(a, b, [&](const Vec2& middle, const Vec2& inward) {
            trial.builder().add_load(block, middle, water.pressure(middle, time) * inward);
        });
    }
}

void press_caisson(PlanarTrial& trial, std::int32_t caisson, const RecordedWater& water, double time) {
    const auto first = trial.model.corner_begin[at(caisson)];
    std::array<Vec2, 4> corner{};  // foot of the front, foot of the rear, and above them
    for (std::size_t k = 0; k < 4; ++k) {
        corner[k] = place_of(trial.state, caisson, trial.model.corner[at(first) + k]);
    }
    // Pressures were recorded around a fixed caisson, so each wall reads the column beside its initial position.
    const double front = Breakwater::caisson_front, rear = front + Breakwater::caisson_width;
    const auto wall = [&](double x, double y) { return water.pressure({x, y}, time); };
    for_pieces(corner[1], corner[2], [&](const Vec2& x, const Vec2& inward) {
        trial.builder().add_load(caisson, x, wall(rear + 0.1, x.y) * inward);
    });
    for_pieces(corner[2], corner[3], [&](const Vec2& x, const Vec2& inward) {
        trial.builder().add_load(caisson, x, wall(x.x, Breakwater::caisson_height + 0.1) * inward);
    });
    for_pieces(corner[3], corner[0], [&](const Vec2& x, const Vec2& inward) {
        trial.builder().add_load(caisson, x, wall(front - 0.1, x.y) * inward);
    });
    const double toe = wall(front - 0.1, 0), heel = wall(rear + 0.1, 0);
    for_pieces(corner[0], corner[1], [&](const Vec2& x, const Vec2& inward) {
        const double share = (x.x - corner[0].x) / (corner[1].x - corner[0].x);
        trial.builder().add_load(caisson, x, ((1 - share) * toe + share * heel) * inward);
    });
}

}  // namespace riprap::validation::ding

// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/grid/grid_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace riprap::validation::grid {

void GridTrial::run(double end, const std::function<void(GridTrial&)>& each) {
    const auto record = [&] {
        time_.push_back(state_.time);
        for (const auto& [name, gauge] : gauges_) {
            columns_[name].push_back(gauge(*this));
        }
    };
    if (time_.empty()) {
        record();
    }
    while (state_.time < end * (1 - 1e-12)) {
        double dt = std::min(stable_step(settings_, state_, scratch_), end - state_.time);
        if (dt < end - state_.time && dt > 0.5 * (end - state_.time)) {
            dt = 0.5 * (end - state_.time);  // no sliver of a step at the end
        }
        const GridReport report = advance(settings_, state_, scratch_, dt);
        ++steps_;
        if (steps_ > 1) {  // the first has no pressure to start from and is solved to round-off
            iterations_ += report.pressure_iterations;
            most_iterations_ = std::max(most_iterations_, report.pressure_iterations);
        }
        record();
        if (settings_.has_surface) {
            const double books = state_.water.held, volume = water_volume(settings_, state_, scratch_);
            worst_volume_ = std::max(worst_volume_, std::abs(volume - books) / start_volume_);
            const auto beyond = [&](std::int64_t c, int, int, int) {
                return std::max(-state_.fraction[at(c)], state_.fraction[at(c)] - 1);
            };
            beyond_bounds_ = std::max(beyond_bounds_, reduce_cells(settings_.mesh.box, 0.0, beyond, max_of));
        }
        if (each) {
            each(*this);
        }
    }
}

double GridTrial::at_time(const std::string& name, double t) const { return between_rows(time_, columns_.at(name), t); }

void GridTrial::report_books(CaseReport& report) const {
    if (settings_.has_surface) {
        report.judge_below({"water, largest error of its volume by the books", "-", {}, 0.0, {}, Kind::bookkeeping},
                           worst_volume_, 1e-10);
        report.judge_below({"fraction of water, farthest beyond 0 and 1", "-", {}, 0.0, {}, Kind::bookkeeping},
                           beyond_bounds_, 1e-12);
    }
    report.state({fmt::format("iterations of the pressure a step, mean ({} cells, {} steps, at most {})",
                              settings_.mesh.box.cell_count(), state_.step, most_iterations_)},
                 mean_iterations());
}

GridSettings make_tank(const Vec3& low, const Vec3& high, const std::array<int, 3>& cells) {
    GridSettings settings;
    settings.mesh = Mesh({uniform_edges(low.x, high.x, cells[0]), uniform_edges(low.y, high.y, cells[1]),
                          uniform_edges(low.z, high.z, cells[2])},
                         cells[2] > 1 ? 3 : 2);
    return settings;
}

double between_rows(const std::vector<double>& x, const std::vector<double>& y, double place) {
    if (x.empty()) {
        return std::nan("");
    }
    const auto above = std::upper_bound(x.begin(), x.end(), place) - x.begin();
    if (above == 0) {
        return y.front();
    }
    if (above == static_cast<std::ptrdiff_t>(x.size())) {
        return y.back();
    }
    const std::size_t i = at(above);
    return y[i - 1] + (y[i] - y[i - 1]) * (place - x[i - 1]) / (x[i] - x[i - 1]);
}

}  // namespace riprap::validation::grid

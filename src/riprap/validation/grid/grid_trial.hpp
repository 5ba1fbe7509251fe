// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "riprap/fluid/grid/grid_step.hpp"
#include "riprap/fluid/grid/read.hpp"
#include "riprap/fluid/grid/surface.hpp"
#include "riprap/validation/registry.hpp"

namespace riprap::validation::grid {

using namespace fluid::grid;  // the engine that the cases drive

/// One simulation of the grid fluid, with records of gauges at every step.
class GridTrial {
 public:
    GridTrial(GridSettings settings, GridState state) : settings_(std::move(settings)), state_(std::move(state)) {
        prepare(settings_, state_, scratch_);
        start_volume_ = water_volume(settings_, state_, scratch_);
    }
    using Gauge = std::function<double(const GridTrial&)>;
    /// Adds a record of a quantity.
    void add(const std::string& name, Gauge gauge) { gauges_.emplace_back(name, std::move(gauge)); }
    /// Runs until `end` [s]; `each` is called after every step.
    void run(double end, const std::function<void(GridTrial&)>& each = {});

    const GridSettings& settings() const { return settings_; }
    GridSettings& settings() { return settings_; }
    GridState& state() { return state_; }
    const GridState& state() const { return state_; }
    GridScratch& scratch() { return scratch_; }
    const GridScratch& scratch() const { return scratch_; }
    const std::vector<double>& time() const { return time_; }
    const std::vector<double>& column(const std::string& name) const { return columns_.at(name); }
    double at_time(const std::string& name, double t) const;
    double mean_iterations() const {
        return steps_ > 0 ? static_cast<double>(iterations_) / static_cast<double>(steps_) : 0;
    }
    int most_iterations() const { return most_iterations_; }
    /// Adds the rows that every run has: volume of water and bounds of its fraction, iterations of the pressure.
    void report_books(CaseReport& report) const;

 private:
    GridSettings settings_;
    GridState state_;
    GridScratch scratch_;
    std::vector<std::pair<std::string, Gauge>> gauges_;
    std::vector<double> time_;
    std::map<std::string, std::vector<double>> columns_;
    double start_volume_{0}, worst_volume_{0}, beyond_bounds_{0};
    std::int64_t steps_{0}, iterations_{0};
    int most_iterations_{0};
};

/// A box of equal cells from low to high; one cell along z is a plane flow.
GridSettings make_tank(const Vec3& low, const Vec3& high, const std::array<int, 3>& cells);

/// y at x between rows, linear; x increasing. The end values outside.
double between_rows(const std::vector<double>& x, const std::vector<double>& y, double at);

}  // namespace riprap::validation::grid

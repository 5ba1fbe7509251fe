// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/mellado/mean_surface.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/fluid/gauge/gauge_kinds.hpp"

namespace riprap::validation::mellado {

namespace {

/// Distance across the vertical axis.
double distance_across(const Vec3& a, const Vec3& b, int up) {
    Vec3 d = a - b;
    d[up] = 0;
    return norm(d);
}

/// Largest distance of a body's surface from its centre; of a planar one, a slice of one metre, in its plane.
double reach_of(const sim::Model& model, std::size_t body) {
    const auto radius = [&](const geometry::ConvexView& shape) {
        double most = 0;
        for (int i = 0; i < shape.vertex_count && model.bodies.is_planar; ++i) {
            most = std::max(most, std::hypot(shape.vertex(i).x, shape.vertex(i).y));
        }
        return model.bodies.is_planar ? most : shape.circumradius;
    };
    double reach = 0;
    for (std::int32_t p = model.bodies.part_begin[body]; p < model.bodies.part_begin[body + 1]; ++p) {
        const body::Part& part = model.bodies.parts[static_cast<std::size_t>(p)];
        reach = std::max(reach, norm(part.local.position) + radius(model.shapes.view(part.shape)));
    }
    return reach;
}

bool is_clear(const water::WaterTrial& trial, const Vec3& place, int up, double margin) {
    const sim::Model& model = trial.model();
    for (std::size_t b = 0; b < model.bodies.drive.size(); ++b) {
        const bool is_free = model.bodies.drive[b] == body::Drive::free;
        if (is_free && distance_across(trial.state().bodies.position[b], place, up) < reach_of(model, b) + margin) {
            return false;
        }
    }
    return true;
}

}  // namespace

double mean_surface(const water::WaterTrial& trial, const Vec3& low, const Vec3& high) {
    const fluid::ParticleSettings& settings = trial.model().particles()->settings();
    const double margin = settings.support_radius();
    const bool is_planar = settings.domain.dimension == 2;
    const int up = is_planar ? 1 : 2, rows = is_planar ? 1 : 3, columns = 17;
    double sum = 0;
    int count = 0;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            fluid::Gauge line{.name = "surface", .kind = &fluid::surface_gauge, .point = low, .end = high};
            line.point.x = low.x + margin + (high.x - low.x - 2 * margin) * i / (columns - 1);
            line.point.y = is_planar ? low.y : low.y + margin + (high.y - low.y - 2 * margin) * j / (rows - 1);
            line.end = line.point;
            line.end[up] = high[up];
            if (is_clear(trial, line.point, up, margin)) {
                sum += low[up] + fluid::read_gauge(line, settings, trial.state().fluid)[0];
                ++count;
            }
        }
    }
    return count > 0 ? sum / count : std::nan("");
}

double last_surface(const water::WaterTrial& trial, const std::string& column, double window) {
    const std::vector<double>& surface = trial.column(column);
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
        if (trial.time()[i] >= trial.now() - window && !std::isnan(surface[i])) {
            sum += surface[i];
            ++count;
        }
    }
    return count > 0 ? sum / count : std::nan("");
}

}  // namespace riprap::validation::mellado

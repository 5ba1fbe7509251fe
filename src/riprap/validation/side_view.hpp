// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"
#include "riprap/view/plot_svg.hpp"

namespace riprap::validation {

/// View of a scene: against `depth`, with `right` and `up` in the picture. Unit vectors, right-handed.
struct View {
    Vec3 right{1, 0, 0};
    Vec3 up{0, 0, 1};
};

/// The outlines of all free convex parts at this moment, each the convex hull of its projected vertices, as closed
/// curves [m]. Blocks one behind another are drawn one over another; nothing is hidden.
std::vector<view::Curve> side_view(const sim::Model& model, const sim::State& state, const View& view);

/// The same as a drawing with equal scales. Giants (half-spaces, fixed bodies) are left out.
view::Plot side_view_plot(const sim::Model& model, const sim::State& state, const View& view, const std::string& title);

}  // namespace riprap::validation

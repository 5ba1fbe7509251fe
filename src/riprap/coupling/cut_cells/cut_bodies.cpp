// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/cut_cells/cut_bodies.hpp"

#include <algorithm>

#include "riprap/coupling/cut_cells/cutter.hpp"
#include "riprap/coupling/cut_cells/side_facets.hpp"

namespace riprap::coupling {

using fluid::grid::at;

CutBodies cut_bodies(const fluid::grid::Mesh& mesh, const std::vector<GridBody>& bodies) {
    Cutter cutter(mesh);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        cutter.cut(bodies[b], static_cast<std::int32_t>(b));
    }
    return std::move(cutter).finish(bodies);
}

BodyCutter::BodyCutter(const fluid::grid::Mesh& mesh, const std::vector<GridBody>& bodies,
                       std::vector<std::uint8_t> is_still)
    : is_still_(std::move(is_still)) {
    auto cutter = std::make_unique<Cutter>(mesh);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (is_still_[b] != 0) {
            cutter->cut(bodies[b], static_cast<std::int32_t>(b));
        }
    }
    cutter->find_splits();
    still_ = std::move(cutter);
}
BodyCutter::~BodyCutter() = default;
BodyCutter::BodyCutter(BodyCutter&&) noexcept = default;
BodyCutter& BodyCutter::operator=(BodyCutter&&) noexcept = default;

CutBodies BodyCutter::cut(const std::vector<GridBody>& bodies) const {
    Cutter cutter = *still_;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (is_still_[b] == 0) {
            cutter.cut(bodies[b], static_cast<std::int32_t>(b));
        }
    }
    return std::move(cutter).finish(bodies);
}

bool BodyCutter::moves() const {
    return std::any_of(is_still_.begin(), is_still_.end(), [](std::uint8_t still) { return still == 0; });
}

void find_displacement(const std::vector<CutFacet>& facets, const std::vector<GridBody>& bodies,
                       fluid::grid::OpenShares& open) {
    open.displacement.assign(open.volume.size(), 0.0);
    for (const CutFacet& facet : facets) {
        if (open.volume[at(facet.cell)] > 0 && moves_fluid(facet)) {
            open.displacement[at(facet.cell)] -= dot(bodies[at(facet.body)].velocity_at(facet.place()), facet.area);
        }
    }
}

}  // namespace riprap::coupling

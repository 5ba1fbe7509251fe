// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/fluid/particle/cluster_list.hpp"
#include "riprap/fluid/particle/sweep.hpp"

namespace riprap::fluid {

struct SweepScratchData {
    ClusterList list;
    std::vector<float> fields;  ///< of the candidates: [cluster][field][member]
};

}  // namespace riprap::fluid

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::solid {

/// Seconds that a solid method has spent per stage; what makes no difference between two of them books both as one.
struct SolidTimes {
    double find_pairs{0};     ///< candidates that may touch
    double find_contacts{0};  ///< what touches
    double contact_loads{0};  ///< forces of contacts; the equations of an implicit method
    double move_bodies{0};
    double measure{0};  ///< energies and other reports
};

}  // namespace riprap::solid

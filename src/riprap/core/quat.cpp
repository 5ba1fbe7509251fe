// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/quat.hpp"

namespace riprap {

Quat from_matrix(const Mat3& m) {
    // The largest of the four squared components is computed first: no cancellation.
    const double t = trace(m);
    Quat q;
    if (t > m(0, 0) && t > m(1, 1) && t > m(2, 2)) {
        q = {1 + t, m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
    } else if (m(0, 0) > m(1, 1) && m(0, 0) > m(2, 2)) {
        q = {m(2, 1) - m(1, 2), 1 + 2 * m(0, 0) - t, m(0, 1) + m(1, 0), m(0, 2) + m(2, 0)};
    } else if (m(1, 1) > m(2, 2)) {
        q = {m(0, 2) - m(2, 0), m(0, 1) + m(1, 0), 1 + 2 * m(1, 1) - t, m(1, 2) + m(2, 1)};
    } else {
        q = {m(1, 0) - m(0, 1), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), 1 + 2 * m(2, 2) - t};
    }
    return normalized(q);
}

}  // namespace riprap

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::contact {

/// A direction that separated a pair when last looked at, in the frame of A. Scratch: it may only *reject*, and only
/// where the full computation would find no contact either, so dropping it changes no bit of any result.
struct SeparatingCache {
    float x{0}, y{0}, z{0};  ///< unit direction from A to B; zero = none
};

}  // namespace riprap::contact

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>

#include "riprap/run/drive/signals.hpp"

namespace riprap::view {

/// The user stopped the program in the middle of packing or drawing a run.
class Stopped : public std::exception {
 public:
    explicit Stopped(int signal) : signal_(signal) {}
    const char* what() const noexcept override { return "stopped by a signal"; }
    int signal() const { return signal_; }

 private:
    int signal_;
};

/// @throws Stopped where the user has asked for it
inline void heed(const run::StopRequest* stop) {
    if (stop != nullptr && stop->signal() != 0) {
        throw Stopped(stop->signal());
    }
}

}  // namespace riprap::view

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::run {

/// Turns SIGINT, SIGTERM and SIGHUP into a polite request to stop after the step at hand; a second one ends the
/// process at once with 128 + its number (files are written whole or not at all, so the last checkpoint stays good).
/// One from the parent process and one from elsewhere count as one: the parent passes on what both have received.
/// Restores the previous handlers when destroyed. One at a time.
class StopRequest {
 public:
    StopRequest();
    StopRequest(const StopRequest&) = delete;
    StopRequest& operator=(const StopRequest&) = delete;
    ~StopRequest();

    /// Number of the signal received, 0 = none.
    int signal() const;
};

/// A broken pipe, a closed terminal or a file above the size limit become errors of `write`, with a message, instead
/// of killing the process. For the start of a program.
void ignore_write_signals();

}  // namespace riprap::run

// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/signals.hpp"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction is POSIX
#include <unistd.h>

#include <array>

namespace riprap::run {

namespace {

constexpr std::array stop_signals{SIGINT, SIGTERM, SIGHUP};
// Global because a signal handler has no other way to speak.
volatile sig_atomic_t received = 0;
volatile sig_atomic_t has_parent_asked = 0;
volatile sig_atomic_t has_other_asked = 0;
std::array<struct sigaction, stop_signals.size()> previous;

/// Ctrl-C and queues of clusters signal a whole group of processes, and the one that started this run passes it on: one
/// signal from it and one from elsewhere are the same wish, whichever comes first.
extern "C" void on_stop_signal(int number, siginfo_t* info, void* /*context*/) {
    const bool is_of_parent = info->si_code == SI_USER && info->si_pid == getppid();
    volatile sig_atomic_t& has_asked = is_of_parent ? has_parent_asked : has_other_asked;
    if (has_asked != 0) {
        _exit(128 + number);
    }
    has_asked = 1;
    received = number;
}

}  // namespace

StopRequest::StopRequest() {
    received = 0;
    has_parent_asked = 0;
    has_other_asked = 0;
    struct sigaction action {};
    action.sa_sigaction = on_stop_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART | SA_SIGINFO;
    for (std::size_t i = 0; i < stop_signals.size(); ++i) {
        sigaction(stop_signals[i], nullptr, &previous[i]);
        if (previous[i].sa_handler != SIG_IGN) {  // nohup, or a shell's background, asked to let it pass
            sigaction(stop_signals[i], &action, nullptr);
        }
    }
}

StopRequest::~StopRequest() {
    for (std::size_t i = 0; i < stop_signals.size(); ++i) {
        sigaction(stop_signals[i], &previous[i], nullptr);
    }
}

int StopRequest::signal() const { return received; }

void ignore_write_signals() {
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
}

}  // namespace riprap::run

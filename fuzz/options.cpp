// SPDX-License-Identifier: Apache-2.0

/// Undefined behaviour ends the run like any other crash, so that libFuzzer keeps the input.
extern "C" const char* __ubsan_default_options() { return "halt_on_error=1:print_stacktrace=1"; }  // NOLINT

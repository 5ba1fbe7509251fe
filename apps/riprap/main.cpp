// SPDX-License-Identifier: Apache-2.0
#include "built_in.hpp"

int main(int argument_count, char** arguments) { return riprap::run_program({argument_count, arguments}, {}); }

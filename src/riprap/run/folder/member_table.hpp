// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/io/csv_reader.hpp"
#include "riprap/run/folder/run_folder.hpp"

namespace riprap::run {

/// Reads the probes of one run among several; a run that goes on or was stopped may have a last line that is cut.
/// @throws FileError where the rows of a finished run are cut off, lost, or end before the run did
io::CsvTable read_probes(const RunFolder& folder);

}  // namespace riprap::run

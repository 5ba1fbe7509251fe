// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace riprap::view {

/// Writes index.html beside the sweep.json of a study: one table of all answers, each answer against each key, and
/// the curves of all runs over time, drawn by the code that draws the page of a run. One file, without network.
/// @returns the page; the table of the study where the program carries no page (has_page)
std::filesystem::path write_sweep_page(const std::filesystem::path& folder);

/// Writes index.html beside the ensemble.json and bands.csv of an ensemble: drawn values and answers of all members in
/// one table, and behind the curves of each column the bands from the least to the largest member and from the 10th to
/// the 90th percentile, with median and mean. @returns as write_sweep_page
std::filesystem::path write_ensemble_page(const std::filesystem::path& folder);

/// Writes index.html beside the fos.json of a search for the factor of safety: its trials as the runs of a study, under
/// the factor. @returns as write_sweep_page
std::filesystem::path write_fos_page(const std::filesystem::path& folder);

}  // namespace riprap::view

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/studies/sugandi_study.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Return the results of the box study: as text with aligned columns, as CSV, and as an HTML page.
std::string boxStudyText(const BoxStudy& study);
std::string boxStudyCsv(const BoxStudy& study);
std::string boxStudyHtml(const BoxStudy& study);

/// Returns the results for inexact first boxes as CSV. The last three columns are empty if a method
/// does not report its confidence.
std::string perturbedBoxesCsv(const std::vector<BoxPerturbationRow>& rows);

/// Writes sugandi-rmse.txt, .csv and .html with its images, and tracks.csv into an existing folder.
/// Also writes sloppy-boxes.csv, the results for inexact first boxes, if BoxStudy::perturbedRows is
/// not empty.
Status writeBoxStudy(const BoxStudy& study, const std::filesystem::path& folder);

} // namespace dewpoint::experiment

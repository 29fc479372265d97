// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/studies/sugandi_study.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// The study as text with aligned columns, as CSV, and as a page.
std::string boxStudyText(const BoxStudy& study);
std::string boxStudyCsv(const BoxStudy& study);
std::string boxStudyHtml(const BoxStudy& study);

/// What sloppy first boxes led to, as CSV; without numbers in the last three columns where a method
/// does not say how sure it is.
std::string perturbedBoxesCsv(const std::vector<BoxPerturbationRow>& rows);

/// Writes sugandi-rmse.txt, .csv and .html with its pictures, tracks.csv, and sloppy-boxes.csv
/// where that was studied, into a folder that exists.
Status writeBoxStudy(const BoxStudy& study, const std::filesystem::path& folder);

} // namespace dewpoint::experiment

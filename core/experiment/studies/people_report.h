// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/report/figure_page.h"
#include "core/experiment/studies/people_study.h"

#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Creates the report of a study. The report contains:
/// - a description of the experiment and its table
/// - the result for the paper's figure 4(a)
/// - the requirements, and which of them are missed
/// - results by body height, if some people are small
/// - the images of those trials that have any
/// - the files runs.csv and people.csv
FigurePage peopleReport(const std::string& scenario, const std::vector<PeopleTrial>& trials);

} // namespace dewpoint::experiment

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/studies/people_study.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Runs studyPeople() for `seeds` seeds, from setup.seed on, with each kind of clothes in turn, and
/// returns all trials. `progress` receives the number of finished scenes and the total number of
/// scenes; if it returns false, the study stops and the trials so far are returned.
Result<std::vector<PeopleTrial>>
studyPeopleSeries(PeopleStudySetup setup, const std::vector<PeopleClothes>& clothes, int seeds,
                  const std::function<bool(std::int64_t done, std::int64_t all)>& progress);

/// Writes runs.csv, report.html and its images into a folder, which is created. Returns
/// FileUnwritable if this fails.
Status writePeopleStudy(const std::string& scenario, const std::vector<PeopleTrial>& trials,
                        const std::filesystem::path& folder);

} // namespace dewpoint::experiment

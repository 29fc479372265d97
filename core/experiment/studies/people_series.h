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

/// Studies many seeds, from setup.seed on, with each kind of clothes in turn. `progress` receives
/// the number of finished scenes and of all scenes; if it returns false, the results so far are
/// returned.
Result<std::vector<PeopleTrial>>
studyManyPeople(PeopleStudySetup setup, const std::vector<PeopleClothes>& clothes, int seeds,
                const std::function<bool(std::int64_t done, std::int64_t all)>& progress);

/// Writes runs.csv, report.html and its pictures into a folder, which is created. FileUnwritable.
Status writePeopleStudy(const std::string& scenario, const std::vector<PeopleTrial>& trials,
                        const std::filesystem::path& folder);

} // namespace dewpoint::experiment

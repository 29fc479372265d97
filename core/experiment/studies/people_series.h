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

/// Many seeds from setup.seed on, of each kind of clothes in turn. `progress` receives how many of
/// how many scenes are done; when it returns false what there is comes back.
Result<std::vector<PeopleTrial>>
studyManyPeople(PeopleStudySetup setup, const std::vector<PeopleClothes>& clothes, int seeds,
                const std::function<bool(std::int64_t done, std::int64_t all)>& progress);

/// Writes runs.csv, report.html and its pictures into a folder, which is made. FileUnwritable.
Status writePeopleStudy(const std::string& scenario, const std::vector<PeopleTrial>& trials,
                        const std::filesystem::path& folder);

} // namespace dewpoint::experiment

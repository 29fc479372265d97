// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/people_series.h"

#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/studies/people_report.h"

#include <set>

namespace dewpoint::experiment {

Result<std::vector<PeopleTrial>>
studyPeopleSeries(PeopleStudySetup setup, const std::vector<PeopleClothes>& clothes, int seeds,
                  const std::function<bool(std::int64_t done, std::int64_t all)>& progress) {
  simulation::ViewCache views;
  std::vector<PeopleTrial> trials;
  const std::uint64_t first = setup.seed;
  const std::int64_t all = seeds * static_cast<std::int64_t>(clothes.size());
  std::int64_t done = 0;
  bool goOn = progress(0, all);
  for (const PeopleClothes kind : clothes) {
    setup.clothes = kind;
    for (int k = 0; k < seeds && goOn; ++k) {
      setup.seed = first + static_cast<std::uint64_t>(k);
      setup.drawsPictures = k == 0;
      const auto more = studyPeople(setup, views);
      if (!more) {
        return tl::make_unexpected(more.error());
      }
      trials.insert(trials.end(), more->begin(), more->end());
      goOn = progress(++done, all);
    }
  }
  return trials;
}

Status writePeopleStudy(const std::string& scenario, const std::vector<PeopleTrial>& trials,
                        const std::filesystem::path& folder) {
  std::set<std::uint64_t> seeds;
  for (const PeopleTrial& trial : trials) {
    seeds.insert(trial.seed);
  }
  FigurePage page = peopleReport(scenario, trials);
  page.addParagraph("Seeds " + describeSeeds({seeds.begin(), seeds.end()}) + ".");
  return page.write(folder);
}

} // namespace dewpoint::experiment

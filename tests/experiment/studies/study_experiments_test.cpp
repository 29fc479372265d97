// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/studies/people_series.h"
#include "core/experiment/studies/study_experiments.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace dewpoint::tests {
namespace {

class StudyExperiments : public testing::TestWithParam<FigureExperiment> {
protected:
  StudyExperiments()
      : folder_(std::filesystem::path(testing::TempDir()) /
                (std::string(GetParam().name) + std::to_string(getpid()))) {}
  ~StudyExperiments() override { std::filesystem::remove_all(folder_); }
  const std::filesystem::path folder_;
};

TEST_P(StudyExperiments, AnUnwritableFolderIsSaidAtOnce) {
  std::filesystem::create_directories(folder_);
  ASSERT_TRUE(writeTextFile(folder_ / "taken", "a file"));
  const auto made = GetParam().run({folder_ / "taken", 1, [](double) {
                                      ADD_FAILURE() << "nothing was to be begun";
                                      return false;
                                    }});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::FileUnwritable);
}

TEST_P(StudyExperiments, CanceledBeforeTheFirstSceneNothingIsWritten) {
  const auto made = GetParam().run({folder_, 1, [](double) { return false; }});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::Canceled);
  EXPECT_FALSE(std::filesystem::exists(folder_ / GetParam().reportFile));
}

INSTANTIATE_TEST_SUITE_P(All, StudyExperiments,
                         testing::ValuesIn(boxAndPeopleExperiments().begin(),
                                           boxAndPeopleExperiments().end()),
                         [](const auto& test) {
                           std::string name(test.param.name);
                           std::erase(name, '-');
                           return name;
                         });

TEST(ListedExperiments, HaveEverySceneOfPeopleUnderItsHeading) {
  const auto listed = listedExperiments();
  EXPECT_EQ(listed.size(), figureExperiments().size() + boxAndPeopleExperiments().size());
  EXPECT_TRUE(std::ranges::is_sorted(listed, {}, &FigureExperiment::group));
  for (const std::string& scene : peopleScenarioNames()) {
    const auto found = std::ranges::find(listed, "people-" + scene, &FigureExperiment::name);
    ASSERT_NE(found, listed.end()) << scene;
    EXPECT_EQ((*found)->group,
              isPeopleScenarioOfPaper(scene) ? ExperimentGroup::Mohedano : ExperimentGroup::People);
    EXPECT_TRUE((*found)->hasClothesOption);
  }
}

// One seed, one kind of clothes: a trial per method, and a page.
TEST(StudyManyPeople, TellsHowFarItIsAndIsWritten) {
  PeopleStudySetup setup;
  setup.scenario = "apart";
  setup.methods = {methodNames(TargetSource::Images).front()};
  std::vector<std::int64_t> seen;
  const auto trials = studyPeopleSeries(setup, {PeopleClothes::Different}, 1,
                                        [&](std::int64_t done, std::int64_t all) {
                                          EXPECT_EQ(all, 1);
                                          seen.push_back(done);
                                          return true;
                                        });
  ASSERT_TRUE(trials);
  EXPECT_EQ(trials->size(), 1U);
  EXPECT_EQ(seen, (std::vector<std::int64_t>{0, 1}));
  const auto folder =
      std::filesystem::path(testing::TempDir()) / ("people_study" + std::to_string(getpid()));
  ASSERT_TRUE(writePeopleStudy(setup.scenario, *trials, folder));
  EXPECT_TRUE(readTextFile(folder / "runs.csv"));
  const auto page = readTextFile(folder / "report.html");
  ASSERT_TRUE(page);
  EXPECT_EQ(trials->front().pictures.size(), 3U); // before, when nearest, after
  for (const char* name : {"different-people-1.jpg", "different-people-3.jpg"}) {
    EXPECT_NE(page->find(name), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace dewpoint::tests

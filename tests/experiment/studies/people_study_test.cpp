// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/people_report.h"
#include "core/experiment/studies/people_study.h"
#include "core/experiment/studies/people_summary.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

TEST(PeopleScenario, IsDrawnFromItsSeedAlone) {
  for (const std::string& name : peopleScenarioNames()) {
    EXPECT_FALSE(peopleScenarioDescription(name).empty());
    const auto one = makePeopleScenario(name, PeopleClothes::Different, 5);
    const auto again = makePeopleScenario(name, PeopleClothes::Different, 5);
    ASSERT_TRUE(one) << name;
    EXPECT_EQ(one->scene.people[0].positionAt(3.0), again->scene.people[0].positionAt(3.0));
    const auto other = makePeopleScenario(name, PeopleClothes::Different, 6);
    EXPECT_NE(one->scene.people[0].positionAt(3.0), other->scene.people[0].positionAt(3.0));
  }
  EXPECT_FALSE(makePeopleScenario("dance", PeopleClothes::Similar, 1));
}

TEST(PeopleScenario, CrossingComesAsNearAsItSays) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto scenario = makePeopleScenario("crossing", PeopleClothes::Similar, seed);
    ASSERT_TRUE(scenario);
    double nearest = 10.0;
    for (double time = 1.3; time < 5.5; time += 0.01) {
      nearest = std::min(nearest, (scenario->scene.people[0].positionAt(time) -
                                   scenario->scene.people[1].positionAt(time))
                                      .norm());
    }
    EXPECT_GT(nearest, 0.44);
    EXPECT_LT(nearest, 0.61);
  }
}

TEST(IdentitiesKept, NeedsTheSamePairs) {
  const Eigen::Vector3d left(-1.0, 0.0, 0.0);
  const Eigen::Vector3d right(1.0, 0.0, 0.0);
  const TrackFrame before{0, 0.0, {{0, left}, {1, right}}, {{7, left}, {9, right}}};
  TrackFrame after{9, 1.0, {{0, right}, {1, left}}, {{7, right}, {9, left}}};
  EXPECT_TRUE(areIdentitiesKept(before, after, 0.5));
  std::swap(after.estimates[0].identity, after.estimates[1].identity);
  EXPECT_FALSE(areIdentitiesKept(before, after, 0.5));
  after.estimates.pop_back();
  EXPECT_FALSE(areIdentitiesKept(before, after, 0.5));
}

TEST(PeopleStudy, OursKeepsTwoInSimilarClothesApart) {
  simulation::ViewCache views;
  PeopleStudySetup setup;
  setup.scenario = "crossing";
  setup.clothes = PeopleClothes::Similar;
  setup.methods = {"people"};
  setup.seed = 1;
  const auto trials = studyPeople(setup, views);
  ASSERT_TRUE(trials);
  ASSERT_EQ(trials->size(), 1U);
  const PeopleTrial& trial = trials->front();
  EXPECT_TRUE(trial.hasKeptIdentities);
  EXPECT_GT(trial.mota, 0.85);
  EXPECT_LT(trial.motp, 0.1);                // meters
  EXPECT_LE(trial.longestGhostSeconds, 1.0); // seconds: the bar
  EXPECT_LE(trial.longestMissedSeconds, 1.0);
  // A person of 1.75 m and 75 kg is 0.075 m³; the hull is larger.
  EXPECT_GT(trial.hullVolume, 0.04);
  EXPECT_LT(trial.hullVolume, 0.4);
  // Births take 0.2 s of about 4 s; a hull that is drawn around a body covers most of it.
  EXPECT_GT(trial.allPersonsResult.found, 0.8);
  EXPECT_GT(trial.allPersonsResult.silhouette.recall, 0.5);
  EXPECT_GT(trial.allPersonsResult.silhouette.precision, 0.2);
  EXPECT_LT(trial.allPersonsResult.silhouette.iou, trial.allPersonsResult.silhouette.recall);
  ASSERT_EQ(trial.personResults.size(), 2U);
  EXPECT_GT(trial.personResults[0].height, 1.6);
  EXPECT_LT(trial.personResults[0].heightError, 0.3);
}

// Mohedano et al. 2009, figure 4(a), as far as it comes out: a review measured recalls of 0.44 and
// 0.27 in this scene, with seeds of its own.
TEST(PeopleStudy, MotionAloneCoversMoreThanMotionAndColor) {
  simulation::ViewCache views;
  PeopleStudySetup setup;
  setup.scenario = "apart";
  setup.methods = {"mohedano-ms", "mohedano-msc"};
  setup.seed = 1;
  const auto trials = studyPeople(setup, views);
  ASSERT_TRUE(trials);
  ASSERT_EQ(trials->size(), 2U);
  const double motion = (*trials)[0].allPersonsResult.silhouette.recall;
  const double color = (*trials)[1].allPersonsResult.silhouette.recall;
  EXPECT_GT(motion, color);
  EXPECT_GT(color, 0.1);
  EXPECT_LT(motion, 0.9);
}

TEST(PeopleStudy, MotionAloneLosesTwoWhoWalkTogetherAndColorKeepsThem) {
  // The paper's figure 4 (b) and (c). Measured with side-by-side in different clothes, seeds 1 to
  // 30: MS keeps none, MS+C all of them; seeds that nothing was chosen on: 0 and 12 of 12.
  simulation::ViewCache views;
  PeopleStudySetup setup;
  setup.scenario = "side-by-side";
  setup.clothes = PeopleClothes::Different;
  setup.methods = {"mohedano-ms", "mohedano-msc"};
  setup.seed = 1;
  const auto trials = studyPeople(setup, views);
  ASSERT_TRUE(trials);
  ASSERT_EQ(trials->size(), 2U);
  ASSERT_EQ((*trials)[0].method, "mohedano-ms");
  ASSERT_EQ((*trials)[1].method, "mohedano-msc");
  EXPECT_FALSE((*trials)[0].hasKeptIdentities);
  EXPECT_TRUE((*trials)[1].hasKeptIdentities);
}

TEST(PeopleStudy, RunsInARoomAsItDoesInAnIdealOne) {
  simulation::ViewCache views;
  PeopleStudySetup setup;
  setup.scenario = "apart";
  setup.grade = Grade::Room;
  setup.methods = {"people"};
  setup.seed = 1;
  setup.drawsPictures = true;
  const auto trials = studyPeople(setup, views);
  ASSERT_TRUE(trials);
  const PeopleTrial& trial = trials->front();
  EXPECT_EQ(trial.grade, Grade::Room);
  EXPECT_EQ(trial.personResults.size(), 2U);
  EXPECT_TRUE(std::isfinite(trial.allPersonsResult.found)); // two cameras see somebody at times
  EXPECT_EQ(trial.pictures.size(), 3U);
}

TEST(PeopleStudy, NamesABadParameter) {
  simulation::ViewCache views;
  PeopleStudySetup setup;
  setup.scenario = "apart";
  setup.methods = {"people"};
  setup.parameters = {{"particles", 0.5}};
  const auto trials = studyPeople(setup, views);
  ASSERT_FALSE(trials);
  EXPECT_EQ(trials.error().field, "particles");
}

TEST(PeopleSummary, CountsAndTakesTheWorst) {
  PeopleTrial trial;
  trial.scenario = "crossing";
  trial.method = "people";
  trial.hasKeptIdentities = true;
  trial.mota = 0.8;
  trial.longestGhostSeconds = 0.5;
  PeopleTrial second = trial;
  second.hasKeptIdentities = false;
  second.mota = 0.6;
  second.longestGhostSeconds = 1.5;
  second.motp = std::nan("");
  const auto sums = summarize({trial, second});
  ASSERT_EQ(sums.size(), 1U);
  EXPECT_EQ(sums[0].runCount, 2);
  EXPECT_EQ(sums[0].keptRunCount, 1);
  EXPECT_NEAR(sums[0].mota, 0.7, 1e-12);
  EXPECT_EQ(sums[0].longestGhostSeconds, 1.5);
  EXPECT_EQ(sums[0].motp, 0.0);
  EXPECT_NE(peopleReport("crossing", {trial, second}).html().find("1 of 2"), std::string::npos);
}

TEST(PeopleSummary, AveragesSilhouettesOverTheRunsThatHaveSome) {
  PeopleTrial trial;
  trial.scenario = "apart";
  trial.method = "people";
  trial.allPersonsResult.found = 0.5;
  trial.allPersonsResult.silhouette = {0.8, 0.6, 0.5};
  PeopleTrial second = trial;
  second.allPersonsResult.found = 0.0;
  second.allPersonsResult.silhouette = {};
  const auto sums = summarize({trial, second});
  ASSERT_EQ(sums.size(), 1U);
  EXPECT_DOUBLE_EQ(sums[0].found, 0.25);
  EXPECT_DOUBLE_EQ(sums[0].silhouette.recall, 0.8);
  EXPECT_DOUBLE_EQ(sums[0].silhouette.precision, 0.6);
  EXPECT_DOUBLE_EQ(sums[0].silhouette.iou, 0.5);
  // The last columns of a row.
  EXPECT_NE(peopleTableRow(sums[0]).find("0.250  0.800  0.600  0.500"), std::string::npos);
  EXPECT_NE(peopleTableRow(summarize({second})[0]).find("0.000      -      -      -"),
            std::string::npos);
}

PeopleTrial trialOf(const char* scenario, const char* method, bool kept) {
  PeopleTrial trial;
  trial.scenario = scenario;
  trial.method = method;
  trial.hasKeptIdentities = kept;
  return trial;
}

TEST(PeopleReport, AFewRunsAreNoVerdict) {
  std::vector<PeopleTrial> trials{trialOf("crossing", "mohedano-ms", true),
                                  trialOf("crossing", "mohedano-ms", false)};
  const std::string few = peopleReport("crossing", trials).html();
  EXPECT_NE(few.find("so far yes"), std::string::npos);
  EXPECT_NE(few.find("fewer than 28 of 30 runs (here lost in 1 of 2, kept in 1)"),
            std::string::npos);
  trials.assign(30, trialOf("crossing", "mohedano-ms", true)); // 30 of 30: nothing is lost
  const std::string many = peopleReport("crossing", trials).html();
  EXPECT_EQ(many.find("so far yes"), std::string::npos);
  EXPECT_NE(many.find("chip bad'>no<"), std::string::npos);
}

TEST(PeopleReport, NamesTheGrade) {
  PeopleTrial ideal = trialOf("apart", "people", true);
  PeopleTrial room = trialOf("apart", "people", false);
  room.grade = Grade::Room;
  const auto sums = summarize({ideal, room});
  ASSERT_EQ(sums.size(), 2U); // grades are not mixed
  EXPECT_EQ(sums[0].keptRunCount, 1);
  EXPECT_EQ(sums[1].grade, Grade::Room);
  EXPECT_EQ(sums[1].keptRunCount, 0);
  EXPECT_NE(peopleTableRow(sums[1]).find("room"), std::string::npos);
  const std::string page = peopleReport("apart", {ideal, room}).html();
  EXPECT_NE(page.find("Grade ideal:"), std::string::npos);
  EXPECT_NE(page.find("Grade room:"), std::string::npos);
  EXPECT_EQ(page.find("Grade wild:"), std::string::npos);
  EXPECT_NE(peopleTrialsCsv({room}).find("scenario,grade,clothes,method,seed,kept"),
            std::string::npos);
  EXPECT_NE(peopleTrialsCsv({room}).find("apart,room,different,people,0,0"), std::string::npos);
}

TEST(PeopleReport, RequiresTheSameInARoomAndNothingOfWildRooms) {
  PeopleTrial trial = trialOf("contact", "people", false);
  trial.grade = Grade::Room;
  EXPECT_NE(peopleReport("contact", {trial}).html().find("contact, grade room, different clothes"),
            std::string::npos);
  trial.grade = Grade::Wild;
  EXPECT_EQ(peopleReport("contact", {trial}).html().find("of 30 runs"), std::string::npos);
}

TEST(PeopleReport, IdentitiesOfThoseWhoComeAndGoAreJudgedToo) {
  const std::string page =
      peopleReport("enter-leave", {trialOf("enter-leave", "people", false)}).html();
  EXPECT_NE(page.find("keeps identities in at least 28 of 30 runs (here in 0 of 1)"),
            std::string::npos);
  EXPECT_NE(page.find("no ghost and nobody missed"), std::string::npos);
}

// Figure 4(a): from a recall of 0.8 on we call a body covered.
TEST(PeopleReport, SaysWhatMotionAloneCovers) {
  std::vector<PeopleTrial> trials{trialOf("apart", "mohedano-ms", true),
                                  trialOf("apart", "mohedano-msc", true)};
  trials[0].allPersonsResult.silhouette.recall = 0.44;
  trials[1].allPersonsResult.silhouette.recall = 0.27;
  const std::string part = peopleReport("apart", trials).html();
  EXPECT_NE(part.find("chip part'>reproduced in part"), std::string::npos);
  EXPECT_NE(part.find("MS covers 0.44"), std::string::npos);
  trials[0].allPersonsResult.silhouette.recall = 0.85;
  EXPECT_NE(peopleReport("apart", trials).html().find("chip good'>reproduced<"), std::string::npos);
  trials[1].allPersonsResult.silhouette.recall = 0.9;
  EXPECT_NE(peopleReport("apart", trials).html().find("chip bad'>not reproduced"),
            std::string::npos);
}

TEST(PeopleReport, GroupsPeopleByHeightWhereSomeAreSmall) {
  PeopleTrial trial = trialOf("heights", "people", false);
  EXPECT_EQ(peopleReport("heights", {trial}).html().find("By height"), std::string::npos);
  trial.personResults = {{1.1, 0.0, {}, std::nan("")}, {1.9, 0.75, {0.8, 0.7, 0.6}, 0.02}};
  const std::string page = peopleReport("heights", {trial}).html();
  EXPECT_NE(page.find("By height"), std::string::npos);
  EXPECT_NE(page.find("below 1.3 m"), std::string::npos);
  const std::string table = peoplePersonsCsv({trial});
  EXPECT_NE(table.find("heights,ideal,different,people,0,1,1.1,0,nan"), std::string::npos);
  EXPECT_NE(table.find("heights,ideal,different,people,0,2,1.9,0.75,0.8,0.7,0.6,0.02"),
            std::string::npos);
}

// What people also do is asked of our own method alone.
TEST(PeopleReport, EverydayScenesHaveBarsToo) {
  const std::string ours = peopleReport("contact", {trialOf("contact", "people", false)}).html();
  EXPECT_NE(ours.find("keeps identities in at least 28 of 30 runs (here in 0 of 1)"),
            std::string::npos);
  const std::string papers =
      peopleReport("contact", {trialOf("contact", "mohedano-ms", false)}).html();
  EXPECT_EQ(papers.find("of 30 runs"), std::string::npos);
}

TEST(PeoplePictures, ShowTheMeetingAndBothSidesOfIt) {
  const auto crossing = makePeopleScenario("crossing", PeopleClothes::Different, 1);
  ASSERT_TRUE(crossing);
  const auto moments = chooseInstantsToShow(*crossing);
  ASSERT_EQ(moments.size(), 3U);
  EXPECT_LT(moments[0].frame, moments[1].frame);
  EXPECT_LT(moments[1].frame, moments[2].frame);
  const double time = crossing->scene.timeOf(moments[1].frame);
  const auto& people = crossing->scene.people;
  EXPECT_LT((people[0].positionAt(time) - people[1].positionAt(time)).norm(),
            0.7); // 0.45 to 0.6 m is aimed at
  const auto visit = makePeopleScenario("enter-leave", PeopleClothes::Different, 1);
  ASSERT_TRUE(visit);
  EXPECT_EQ(chooseInstantsToShow(*visit).size(), 1U);
}

TEST(PeopleStudy, AParameterThatNoMethodHasIsSaid) {
  PeopleStudySetup setup;
  setup.methods = {"people", "mohedano-ms"};
  setup.parameters = {{"body_points", 200.0}}; // of people alone
  EXPECT_TRUE(checkPeopleParameters(setup));
  setup.parameters = {{"foo", 1.0}};
  const auto checked = checkPeopleParameters(setup);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, ErrorCode::UnknownKey);
  EXPECT_EQ(checked.error().field, "foo");
}

} // namespace
} // namespace dewpoint::tests

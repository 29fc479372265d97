// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios that cannot make a run for some seed: the suite says so and goes on.
#include "core/base/text_file.h"
#include "core/experiment/scenarios/draft/scenario_draft.h"
#include "core/experiment/suite/skipped_runs.h"
#include "core/experiment/suite/suite_report.h"
#include "core/experiment/suite/suite_runner.h"
#include "core/simulation/scene/scene.h"
#include "tests/capture/temporary_folder.h"
#include "tests/experiment/suite/suite_results.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <memory>

namespace dewpoint::tests {
namespace {

const SkippedRun kSome{"S13-one-camera", Grade::Wild, 1005003, "no position, \"at all\""};
const auto kNever = [] { return false; };

/// One set of black images.
FrameSetPtr blackImages(std::int64_t frame) {
  FrameSet set{frame, timeStamp(0.0), {}};
  for (const Camera& camera : demoScene().cameras) {
    const cv::Mat image(camera.intrinsics.height, camera.intrinsics.width, CV_8UC3, cv::Scalar());
    set.frames.push_back(std::make_shared<const Frame>(Frame{frame, set.time, image}));
  }
  return std::make_shared<const FrameSet>(std::move(set));
}

/// A run of one frame in which nothing is to be seen.
Result<ScenarioRun> emptyRun(const std::string& name, std::uint64_t seed, Grade grade) {
  ScenarioRun run;
  run.scenario = name;
  run.grade = grade;
  run.seed = seed;
  run.rig = run.trueRig = demoScene().cameras;
  run.targets.push_back({"ball", 0.035, ColorRange{}});
  run.frameCount = 1;
  run.frames = blackImages;
  return run;
}

/// "S0-some" has no run for seed 2, "S1-none" has none at all.
std::vector<ScenarioDeclaration> catalogWithGaps() {
  const auto without = [](const std::string& name, auto isMissing) {
    ScenarioDeclaration scenario;
    scenario.name = name;
    scenario.family = name.substr(0, 2);
    scenario.seedCount = 3;
    scenario.make = [=](std::uint64_t seed, Grade grade) -> Result<ScenarioRun> {
      if (isMissing(seed)) {
        return failure(ErrorCode::Undetermined, "", name, "no position");
      }
      return emptyRun(name, seed, grade);
    };
    return scenario;
  };
  return {without("S0-some", [](std::uint64_t seed) { return seed == 2; }),
          without("S1-none", [](std::uint64_t) { return true; })};
}

SuiteRequest wildRequest(const std::vector<ScenarioDeclaration>& catalog) {
  SuiteRequest request;
  request.scenarios = *selectScenarios(catalog, {});
  request.methods = *selectMethods({"triangulation"});
  request.grades = {Grade::Wild};
  request.firstSeed = 1;
  return request;
}

/// Runs all that is to do into a folder.
Status runInto(SuiteStore& store, const SuiteRequest& request) {
  const auto sink = [&](const SuiteResult& result) { return store.append(result); };
  const auto skip = [&](const SuiteJob&, const SkippedRun& run) { return store.append(run); };
  return runSuite(planSuite(request, store.results(), store.skippedRuns()), 2, sink, kNever, skip);
}

std::set<RunKey> keysOf(const SuiteResults& results) {
  std::set<RunKey> keys;
  for (const auto& [key, result] : results) {
    keys.insert(key);
  }
  return keys;
}

TEST(SkippedRuns, AreReadBackAsTheyWereWritten) {
  EXPECT_EQ(skippedCsvLine(kSome), "S13-one-camera,wild,1005003,\"no position, \"\"at all\"\"\"");
  EXPECT_EQ(parseSkippedRun(skippedCsvLine(kSome)), kSome);
  for (const char* const broken :
       {"", "S13,wild,1", "S13,wild,1,no", "S13,wild,1,\"no", "S13,wild,x,\"no\"",
        "S13,mild,1,\"no\"", ",wild,1,\"no\"", "S13,wild,1,\"a\"b\""}) {
    EXPECT_FALSE(parseSkippedRun(broken).has_value()) << broken;
  }
}

TEST(SkippedRuns, AreFoundByScenarioGradeAndSeed) {
  const SkippedRuns runs{kSome};
  EXPECT_TRUE(isSkipped(runs, "S13-one-camera", Grade::Wild, 1005003));
  EXPECT_FALSE(isSkipped(runs, "S13-one-camera", Grade::Wild, 1005002));
  EXPECT_FALSE(isSkipped(runs, "S13-one-camera", Grade::Room, 1005003));
  EXPECT_FALSE(isSkipped(runs, "S13", Grade::Wild, 1005003));
}

TEST(SkippedRuns, DoNotStopTheOthers) {
  const test::TemporaryFolder folder;
  const auto catalog = catalogWithGaps();
  const SuiteRequest request = wildRequest(catalog);
  auto store = SuiteStore::open(folder / "out");
  ASSERT_TRUE(store.has_value());
  ASSERT_TRUE(runInto(*store, request).has_value());
  EXPECT_EQ(store->results().size(), 2U) << "seeds 1 and 3 of S0-some";
  const SkippedRuns expected{{"S0-some", Grade::Wild, 2, "no position"},
                             {"S1-none", Grade::Wild, 1, "no position"},
                             {"S1-none", Grade::Wild, 2, "no position"},
                             {"S1-none", Grade::Wild, 3, "no position"}};
  EXPECT_EQ(store->skippedRuns(), expected);
  EXPECT_TRUE(planSuite(request, store->results(), store->skippedRuns()).empty()) << "all is done";
  EXPECT_EQ(planSuite(request, store->results()).size(), 4U);

  const auto nothing = scenariosWithoutRuns(store->skippedRuns(), keysOf(store->results()));
  ASSERT_EQ(nothing.size(), 1U);
  EXPECT_EQ(nothing[0].scenario, "S1-none");
  EXPECT_EQ(nothing[0].grade, Grade::Wild);

  // Another program that opens the folder knows them; a merged folder has them, too.
  const auto again = SuiteStore::open(folder / "out");
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->skippedRuns(), expected);
  auto merged = SuiteStore::open(folder / "merged");
  ASSERT_TRUE(merged.has_value());
  merged->merge(*SuiteStore::readSkipped(folder / "out"));
  ASSERT_TRUE(merged->rewrite({}).has_value());
  EXPECT_EQ(*SuiteStore::readSkipped(folder / "merged"), expected);
  EXPECT_TRUE(SuiteStore::readSkipped(folder / "nowhere")->empty());
}

TEST(SkippedRuns, AreErrorsWhereNobodyTakesThem) {
  const auto catalog = catalogWithGaps();
  const auto jobs = planSuite(wildRequest(catalog), {});
  const auto sink = [](const SuiteResult&) { return Status(); };
  const auto run = runSuite(jobs, 1, sink, kNever);
  ASSERT_FALSE(run.has_value());
  EXPECT_EQ(run.error().code, ErrorCode::Undetermined);
}

TEST(SkippedRuns, AreNotWhatOtherErrorsAndRecordingsGive) {
  auto catalog = catalogWithGaps();
  const auto skip = [](const SuiteJob&, const SkippedRun&) { return Status(); };
  const auto sink = [](const SuiteResult&) { return Status(); };
  SuiteRequest request = wildRequest(catalog);
  catalog[0].make = [](std::uint64_t, Grade) -> Result<ScenarioRun> {
    return failure(ErrorCode::FileMissing, "a.png", "", "");
  };
  auto run = runSuite(planSuite(request, {}), 1, sink, kNever, skip);
  ASSERT_FALSE(run.has_value());
  EXPECT_EQ(run.error().code, ErrorCode::FileMissing);
  catalog[1].isRecorded = true;
  request.grades = {Grade::Real};
  run = runSuite(planSuite(request, {}), 1, sink, kNever, skip);
  ASSERT_FALSE(run.has_value()) << "a recording has nothing that is drawn";
}

TEST(SkippedRuns, AreWhatAScenarioSaysThatFindsNoPosition) {
  scenarios::ScenarioRecipe recipe{"S0-never", "Nothing fits.", {}};
  recipe.complete = [](scenarios::ScenarioDraft&) { return false; };
  const auto declaration =
      scenarios::declareScenario(recipe, std::make_shared<simulation::ViewCache>());
  const auto run = declaration.make(7, Grade::Ideal);
  ASSERT_FALSE(run.has_value());
  EXPECT_EQ(run.error().code, ErrorCode::Undetermined);
  EXPECT_NE(run.error().detail.find("no position was found"), std::string::npos);
}

TEST(SkippedRuns, RefuseABrokenFile) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "skipped.csv") << skippedCsvHeader() << "\nnonsense\n"
                                        << skippedCsvLine(kSome) << "\n";
  EXPECT_EQ(SuiteStore::open(folder / "").error().code, ErrorCode::NotParsed);
  std::ofstream(folder / "skipped.csv", std::ios::trunc) << "scenario,other\n";
  EXPECT_EQ(SuiteStore::open(folder / "").error().code, ErrorCode::Mismatch);
}

TEST(SkippedRuns, StandInTheReport) {
  const test::TemporaryFolder folder;
  MadeResults made;
  made.add(resultOf("S0-slow", Grade::Wild, "dewpoint"));
  ASSERT_TRUE(writeSuiteReport(folder / "", made.results, made.order, {}, {}, {kSome}));
  const std::string page = *readTextFile(folder / "report.html");
  EXPECT_NE(page.find("Skipped runs: 1."), std::string::npos);
  EXPECT_NE(page.find("S13-one-camera, grade wild, seed 1005003 is skipped: no position"),
            std::string::npos);
  const auto json = nlohmann::json::parse(*readTextFile(folder / "report.json"));
  ASSERT_EQ(json["skipped"].size(), 1U);
  EXPECT_EQ(json["skipped"][0]["scenario"], "S13-one-camera");
  EXPECT_EQ(json["skipped"][0]["grade"], "wild");
  EXPECT_EQ(json["skipped"][0]["seed"], 1005003);
  EXPECT_EQ(json["skipped"][0]["reason"], kSome.reason);
}

} // namespace
} // namespace dewpoint::tests

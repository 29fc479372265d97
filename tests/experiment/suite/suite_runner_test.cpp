// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_report.h"
#include "core/experiment/suite/suite_runner.h"
#include "core/geometry/projector.h"
#include "core/simulation/scene/scene.h"
#include "tests/capture/temporary_folder.h"
#include "tests/experiment/suite/suite_results.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <fstream>

namespace dewpoint::tests {
namespace {

/// The ball as a disk on gray, wider by up to 3 px by the seed.
cv::Mat pictureOf(const Scene& scene, const Camera& camera, std::int64_t frame) {
  const SceneBall& ball = scene.balls.front();
  const auto pixel = Projector(camera).project(ballPosition(scene, 0, frameTime(scene, frame)));
  cv::Mat image(camera.intrinsics.height, camera.intrinsics.width, CV_8UC3, cv::Scalar::all(90));
  cv::circle(image, cv::Point(cvRound(pixel->x()), cvRound(pixel->y())),
             24 + static_cast<int>(scene.seed % 4),
             cv::Scalar(ball.color[0], ball.color[1], ball.color[2]), cv::FILLED);
  return image;
}

/// The demo, eight frames of it, as a scenario.
Result<ScenarioRun> makeRun(const std::string& name, std::uint64_t seed, Grade grade) {
  Scene scene = demoScene();
  scene.seed = seed;
  scene.frameCount = 8;
  const SceneBall& ball = scene.balls.front();
  ScenarioRun run;
  run.scenario = name;
  run.grade = grade;
  run.seed = seed;
  run.rig = run.trueRig = scene.cameras;
  run.targets = {{ball.name, ball.radius,
                  ColorRange{ball.hueMin, ball.hueMax, ball.saturationMin, ball.saturationMax,
                             ball.intensityMin, ball.intensityMax}}};
  run.startCenter = ball.position;
  run.startHalfSize = {0.05, 0.05, 0.05};
  run.framesPerSecond = scene.framesPerSecond;
  run.frameCount = scene.frameCount;
  for (std::int64_t frame = 0; frame < scene.frameCount; ++frame) {
    TrajectorySample sample;
    sample.frame = frame;
    sample.target = ball.name;
    sample.position = ballPosition(scene, 0, frameTime(scene, frame));
    run.truth.samples.push_back(sample);
  }
  run.frames = [scene](std::int64_t frame) {
    FrameSet set{frame, timeStamp(frameTime(scene, frame)), {}};
    for (const Camera& camera : scene.cameras) {
      set.frames.push_back(
          std::make_shared<const Frame>(Frame{frame, set.time, pictureOf(scene, camera, frame)}));
    }
    return std::make_shared<const FrameSet>(std::move(set));
  };
  return run;
}

std::vector<ScenarioDeclaration> smallCatalog() {
  std::vector<ScenarioDeclaration> catalog;
  for (const std::string name : {"S0-slow", "S0-fast", "S1-still-1"}) {
    catalog.push_back(
        {name, name.substr(0, 2), "For a test.", 2,
         [name](std::uint64_t seed, Grade grade) { return makeRun(name, seed, grade); }});
  }
  return catalog;
}

SuiteRequest idealRequest(const std::vector<ScenarioDeclaration>& catalog) {
  SuiteRequest request;
  request.scenarios = *selectScenarios(catalog, {});
  request.methods = *selectMethods({"triangulation", "barrera"});
  request.grades = {Grade::Ideal};
  request.firstSeed = 1;
  return request;
}

/// Everything but the measured time.
std::string withoutTime(SuiteRow row) {
  row.usPerFrame.reset();
  return rowText(row);
}

const auto kGoOn = [] { return false; };

TEST(SuiteRunner, SelectsByFamilyAndName) {
  const auto catalog = smallCatalog();
  const auto names = [&](const std::vector<std::string>& wanted) {
    std::string text;
    const auto selected = selectScenarios(catalog, wanted).value();
    for (const auto* scenario : selected) {
      text += scenario->name + " ";
    }
    return text;
  };
  EXPECT_EQ(names({}), "S0-slow S0-fast S1-still-1 ");
  EXPECT_EQ(names({"S1", "S0-fast", "S1-still-1"}), "S0-fast S1-still-1 ");
  EXPECT_EQ(selectScenarios(catalog, {"S7"}).error().code, ErrorCode::NotFound);
  EXPECT_EQ(selectMethods({"magic"}).error().code, ErrorCode::NotFound);
  EXPECT_EQ(*selectMethods({"camshift", "barrera"}),
            (std::vector<std::string>{"barrera", "camshift"}));
}

TEST(SuiteRunner, PlansWhatIsNotDone) {
  const auto catalog = smallCatalog();
  SuiteRequest request = idealRequest(catalog);
  EXPECT_EQ(runCount(planSuite(request, {})), 3 * 2 * 2); // scenarios, seeds, methods
  SuiteResults done;
  done[{"S0-fast", Grade::Ideal, "barrera", 2}] = {};
  const auto jobs = planSuite(request, done);
  EXPECT_EQ(runCount(jobs), 11);
  EXPECT_EQ(jobs[3].scenario->name, "S0-fast");
  EXPECT_EQ(jobs[3].methods, std::vector<std::string>{"triangulation"});
  request.seedCount = 5;
  EXPECT_EQ(runCount(planSuite(request, done)), 3 * 5 * 2 - 1);
}

TEST(SuiteRunner, GivesTheSameForAnyNumberOfThreads) {
  const auto catalog = smallCatalog();
  const auto jobs = planSuite(idealRequest(catalog), {});
  const auto rowsWith = [&](int threads) {
    std::map<RunKey, std::string> rows;
    const auto sink = [&](const SuiteResult& result) -> Status {
      rows[result.row.key] = withoutTime(result.row) + traceText(result.trace);
      return {};
    };
    EXPECT_TRUE(runSuite(jobs, threads, sink, kGoOn).has_value());
    return rows;
  };
  const auto one = rowsWith(1);
  EXPECT_EQ(one.size(), 12U);
  EXPECT_EQ(one, rowsWith(3));
}

TEST(SuiteRunner, StopsCleanlyAndPassesErrorsOn) {
  const auto catalog = smallCatalog();
  const auto jobs = planSuite(idealRequest(catalog), {});
  int results = 0;
  const auto count = [&](const SuiteResult&) -> Status {
    ++results;
    return {};
  };
  EXPECT_TRUE(runSuite(jobs, 1, count, [&] { return results >= 4; }).has_value());
  EXPECT_EQ(results, 4); // two methods per job: after two jobs
  const auto refuse = [](const SuiteResult&) -> Status {
    return failure(ErrorCode::FileUnwritable, "runs.csv", "", "full");
  };
  EXPECT_EQ(runSuite(jobs, 2, refuse, kGoOn).error().code, ErrorCode::FileUnwritable);
}

TEST(SuiteStore, GoesOnAfterATruncatedLine) {
  const test::TemporaryFolder folder;
  const auto catalog = smallCatalog();
  const auto request = idealRequest(catalog);
  {
    auto store = SuiteStore::open(folder / "out");
    ASSERT_TRUE(store.has_value());
    int results = 0;
    const auto sink = [&](const SuiteResult& result) {
      ++results;
      return store->append(result);
    };
    ASSERT_TRUE(runSuite(planSuite(request, {}), 1, sink, [&] { return results >= 4; }));
  }
  const auto file = std::filesystem::path(folder / "out/runs.csv");
  const std::string whole = contents(file);
  std::ofstream(file, std::ios::trunc) << whole.substr(0, whole.size() - 5);

  auto store = SuiteStore::open(folder / "out");
  ASSERT_TRUE(store.has_value());
  EXPECT_EQ(store->results().size(), 3U) << "the fourth was cut";
  const auto left = planSuite(request, store->results());
  EXPECT_EQ(runCount(left), 9);
  const auto sink = [&](const SuiteResult& result) { return store->append(result); };
  ASSERT_TRUE(runSuite(left, 2, sink, kGoOn).has_value());
  const auto order = reportOrder(store->results(), catalog);
  ASSERT_TRUE(store->rewrite(order).has_value());
  ASSERT_EQ(order.size(), 12U);
  EXPECT_EQ(order.front(), (RunKey{"S0-slow", Grade::Ideal, "barrera", 1}));
  EXPECT_EQ(order.back(), (RunKey{"S1-still-1", Grade::Ideal, "triangulation", 2}));
  EXPECT_TRUE(contents(file).starts_with(rowHeader() + "\nS0-slow,ideal,barrera,1,"));
}

TEST(SuiteStore, TakesTheResultsOfOtherFolders) {
  const test::TemporaryFolder folder;
  const auto catalog = smallCatalog();
  auto request = idealRequest(catalog);
  request.seedCount = 1;
  for (const std::uint64_t seed : {1U, 2U}) {
    request.firstSeed = seed;
    auto store = SuiteStore::open(folder / std::to_string(seed));
    ASSERT_TRUE(store.has_value());
    const auto sink = [&](const SuiteResult& result) { return store->append(result); };
    ASSERT_TRUE(runSuite(planSuite(request, {}), 1, sink, kGoOn));
  }
  const std::string before = contents(folder / "1/runs.csv");
  auto merged = SuiteStore::open(folder / "merged");
  ASSERT_TRUE(merged.has_value());
  for (const char* name : {"1", "2", "1"}) { // the same once more changes nothing
    const auto results = SuiteStore::read(folder / name);
    ASSERT_TRUE(results.has_value());
    EXPECT_EQ(results->size(), 6U) << "three scenarios, two methods";
    merged->merge(*results);
  }
  ASSERT_TRUE(merged->rewrite(reportOrder(merged->results(), catalog)));
  EXPECT_EQ(SuiteStore::read(folder / "merged")->size(), 12U);
  EXPECT_EQ(contents(folder / "1/runs.csv"), before);
  const auto missing = SuiteStore::read(folder / "nowhere");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().code, ErrorCode::FileMissing);
  EXPECT_FALSE(std::filesystem::exists(folder / "nowhere"));
}

TEST(SuiteStore, RefusesFilesOfAnotherVersion) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "runs.csv") << "scenario,other\n1,2\n";
  const auto store = SuiteStore::open(folder / "");
  ASSERT_FALSE(store.has_value());
  EXPECT_EQ(store.error().code, ErrorCode::Mismatch);
}

TEST(SuiteStore, RefusesRunsWithoutTheFiguresOfBelief) {
  // Runs of an earlier version would be taken for done, and their figures missing in the report.
  const test::TemporaryFolder folder;
  std::string header = rowHeader();
  const std::string added = ",coverage50_percent,sure_and_wrong_percent,wrong_percent,"
                            "wrong_when_sure_percent";
  ASSERT_NE(header.find(added), std::string::npos);
  header.erase(header.find(added), added.size());
  std::ofstream(folder / "runs.csv") << header << "\n";
  const auto store = SuiteStore::open(folder / "");
  ASSERT_FALSE(store.has_value());
  EXPECT_EQ(store.error().code, ErrorCode::Mismatch);
  EXPECT_TRUE(store.error().file.ends_with("runs.csv"));
  EXPECT_NE(store.error().detail.find("another version"), std::string::npos);
}

TEST(SuiteStore, RefusesABrokenLineInTheMiddle) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "runs.csv") << rowHeader() << "\nnonsense\nnonsense\n";
  const auto store = SuiteStore::open(folder / "");
  ASSERT_FALSE(store.has_value());
  EXPECT_EQ(store.error().code, ErrorCode::NotParsed);
  EXPECT_EQ(store.error().field, "line 2");
}

} // namespace
} // namespace dewpoint::tests

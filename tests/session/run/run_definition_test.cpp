// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/session/run/frame_loop.h"
#include "core/session/run/run_definition.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/start_parameters.h"
#include "tests/session/drawn_recording.h"
#include "tests/session/whole_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using test::drawnInputs;
using test::DrawnRecording;
using test::eventually;
using test::playedToTheEnd;
using test::reaches;
using test::sameBits;

constexpr std::int64_t kDefinedFrames = 40;

/// What the cameras of the recording show without the ball.
std::vector<cv::Mat> backgroundImages() {
  std::vector<cv::Mat> rooms;
  const FrameSetPtr frames = drawn::framesOf(DrawnRecording::rig(), {}, 0);
  for (const FramePtr& frame : frames->frames) {
    rooms.push_back(frame->image);
  }
  return rooms;
}

RunDefinition drawnDefinition() {
  return RunDefinition::fromProject(drawnInputs("dewpoint", 1).project, backgroundImages());
}

/// Tracks again from this frame, to the end.
void rerunToTheEnd(Session& session, std::int64_t from) {
  ASSERT_NO_FATAL_FAILURE(test::beginRerun(session, from));
  ASSERT_TRUE(eventually([&] {
    const auto shown = session.newest();
    return !shown->rerun && shown->state == PlayState::Ended &&
           session.trajectory().samples.size() == kDefinedFrames;
  }));
}

TEST(RunDefinition, IsComparedAsAWhole) {
  const RunDefinition one = drawnDefinition();
  EXPECT_TRUE(one == drawnDefinition()); // other images in memory with the same pixels
  const std::vector<std::function<void(RunDefinition&)>> changes{
      [](RunDefinition& other) { other.method = "barrera"; },
      [](RunDefinition& other) { (void)other.parameters.set("start_x", 0.61); },
      [](RunDefinition& other) { other.targets[0].radius *= 1.1; },
      [](RunDefinition& other) { other.targets.clear(); },
      [](RunDefinition& other) {
        CameraRig rig = *other.rig;
        rig[1].intrinsics.focalX += 1e-6;
        other.rig = std::make_shared<const CameraRig>(rig);
      },
      [](RunDefinition& other) {
        other.backgroundImages[1] = other.backgroundImages[1].clone();
        other.backgroundImages[1].at<cv::Vec3b>(3, 4)[2] ^= 1;
      },
      [](RunDefinition& other) { other.backgroundImages.clear(); },
      [](RunDefinition& other) { other.backgroundImageFiles[0] = "room.png"; },
      [](RunDefinition& other) {
        other.volumeOfInterest = WorldBox{{0, 0, 0}, {1, 1, 1}};
      },
      [](RunDefinition& other) { other.corrections.emplace_back(); },
      [](RunDefinition& other) { ++other.seed; }};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    RunDefinition other = one;
    changes[k](other);
    EXPECT_FALSE(one == other) << k;
  }
}

TEST(RunDefinition, GoesIntoAProjectAndBack) {
  const Project project = drawnInputs("dewpoint", 1).project;
  RunDefinition other = drawnDefinition();
  other.seed = 7;
  other.targets[0].name = "another ball";
  other.backgroundImageFiles[1] = "/rooms/two.png";
  other.volumeOfInterest = WorldBox{{0, 0, 0}, {1, 1, 1}};
  other.corrections.emplace_back().frame = 12;
  const Project changed = other.appliedTo(project);
  EXPECT_EQ(changed.name, project.name);
  EXPECT_EQ(changed.cameras[1].backgroundImageFile, "/rooms/two.png");
  EXPECT_TRUE(RunDefinition::fromProject(changed, backgroundImages()) == other);
}

TEST(RunDefinition, SaysWhatIsOtherwise) {
  const RunDefinition before = drawnDefinition();
  EXPECT_EQ(differences(before, before), "");
  RunDefinition after = before;
  ASSERT_TRUE(after.parameters.set("start_x", 0.61));
  after.backgroundImageFiles[1] = "room.png";
  EXPECT_EQ(differences(before, after),
            "start_x = 0.61; " + (*before.rig)[1].name + " = another background image");
  after = before;
  after.targets[0].color.hueMax = 10.0;
  EXPECT_TRUE(differences(before, after).starts_with(before.targets[0].name + " = hue "));
  after = before;
  after.volumeOfInterest = WorldBox{{0, 0.5, 0}, {1, 2, 3}};
  EXPECT_EQ(differences(before, after), "volume_of_interest = 0 0.5 0 to 1 2 3 m");
  EXPECT_EQ(differences(after, before), "volume_of_interest = none");
  after = before;
  after.method = "barrera";
  after.parameters = ParameterValues(methodParameters("barrera"));
  EXPECT_TRUE(differences(before, after).starts_with("method = barrera; "));
}

TEST(RunDefinition, TakesFromTheCamerasWhatNobodyGave) {
  Project project = drawnInputs("barrera", 1).project;
  EXPECT_EQ(RunDefinition::fromProject(project).parameters,
            project.parameters); // its start was given
  project.parameters = ParameterValues(methodParameters("barrera"));
  RunDefinition run = RunDefinition::fromProject(project);
  EXPECT_EQ(run.parameters, effectiveParameters(project));
  const StartVolume start = startVolumeOf(run.parameters);
  EXPECT_TRUE((WorldBox{start.center - start.halfSize, start.center + start.halfSize}.contains(
      drawn::kMiddle)));
  EXPECT_GT(start.halfSize.minCoeff(), 0.2); // the cameras are a meter away
  EXPECT_LT(start.halfSize.maxCoeff(), 1.6);
  // What is written of the run says it, and a project goes on leaving it to the cameras.
  const Project applied = run.appliedTo(project);
  EXPECT_EQ(applied.parameters.at("start_x"), run.parameters.at("start_x"));
  EXPECT_FALSE(applied.parameters.isGiven("start_x"));
  run.volumeOfInterest = WorldBox{{0.4, 0.4, 0.1}, {0.6, 0.6, 0.3}};
  run.adaptParametersToCameras();
  EXPECT_NEAR(run.parameters.at("start_half_x"), 0.1, 0.0101);
}

// The copy that a run goes back to was made before the background images were known.
TEST(BackgroundImagesOfARun, ArePartOfWhatGoesOnFromAnEarlierFrame) {
  Session without(drawnInputs("dewpoint", kDefinedFrames));
  const Trajectory unknown = playedToTheEnd(without);
  SessionInputs known = drawnInputs("dewpoint", kDefinedFrames);
  known.backgroundImages = backgroundImages();
  Session with(std::move(known));
  const Trajectory expected = playedToTheEnd(with);
  ASSERT_FALSE(sameBits(unknown, expected)) << "the rooms must matter";

  Session session(drawnInputs("dewpoint", kDefinedFrames));
  playedToTheEnd(session);
  session.setBackgroundImages({"left.png", "right.png"}, backgroundImages());
  rerunToTheEnd(session, 20);
  session.restart();
  ASSERT_TRUE(reaches(session, PlayState::Paused));
  EXPECT_TRUE(sameBits(playedToTheEnd(session), expected));
}

TEST(BackgroundImagesOfARun, AreSaidWhereTheyChange) {
  Session session(drawnInputs("dewpoint", kDefinedFrames));
  playedToTheEnd(session);
  session.setBackgroundImages({"left.png", "right.png"}, backgroundImages());
  session.rerunFrom(20);
  ASSERT_TRUE(eventually([&] {
    const auto entries = session.trajectory().header.entries;
    return !entries.empty() && entries.back().first == "changed_at_frame_20";
  }));
  const std::string said = session.trajectory().header.entries.back().second;
  EXPECT_NE(said.find("another background image"), std::string::npos) << said;
}

class FilterThreads : public testing::TestWithParam<const char*> {};

TEST_P(FilterThreads, AnyNumberGivesTheSameBits) {
  std::vector<Trajectory> found;
  for (const int threads : {1, 2, 5}) {
    SessionInputs inputs = drawnInputs(GetParam(), kDefinedFrames);
    inputs.threadCount = threads;
    Session session(std::move(inputs));
    playedToTheEnd(session);
    rerunToTheEnd(session, 11); // from a copy, too
    found.push_back(session.trajectory());
    const auto folder = std::filesystem::path(testing::TempDir()) / "filter_threads" / GetParam();
    ASSERT_TRUE(session.saveRun(folder));
    const auto report = readTextFile(folder / "run.json");
    ASSERT_TRUE(report);
    EXPECT_NE(report->find("\"threads\": " + std::to_string(threads) + ","), std::string::npos);
  }
  EXPECT_TRUE(sameBits(found[0], found[1]));
  EXPECT_TRUE(sameBits(found[0], found[2]));
}

/// The number of threads in the report of a run.
std::string reportedThreads(const Session& session) {
  // Not that of another method, which is tested at the same time.
  const auto folder =
      std::filesystem::path(testing::TempDir()) / "filter_threads" /
      (std::string("changed_") + testing::WithParamInterface<const char*>::GetParam());
  const auto report = session.saveRun(folder)
                          ? readTextFile(folder / "run.json")
                          : Result<std::string>(failure(ErrorCode::FileUnwritable, "", "", ""));
  const std::string key = "\"threads\": ";
  const auto begin = report ? report->find(key) : std::string::npos;
  return begin == std::string::npos
             ? std::string()
             : report->substr(begin + key.size(), report->find(',', begin) - begin - key.size());
}

// While the run plays, and before a rerun from a copy that another number of threads has made.
TEST_P(FilterThreads, AnotherNumberTakesOverInTheMiddleOfARun) {
  SessionInputs inputs = drawnInputs(GetParam(), kDefinedFrames);
  inputs.threadCount = 1;
  Session plain(std::move(inputs));
  const Trajectory expected = playedToTheEnd(plain);
  inputs = drawnInputs(GetParam(), kDefinedFrames);
  inputs.threadCount = 1;
  Session session(std::move(inputs));
  for (int k = 0; k < 15; ++k) {
    session.stepFrame();
  }
  ASSERT_TRUE(eventually([&] { return session.newest()->history.newestTrackedFrame == 14; }));
  EXPECT_EQ(reportedThreads(session), "1");
  session.setFilterThreadCount(3);
  ASSERT_TRUE(eventually([&] { return reportedThreads(session) == "3"; }));
  EXPECT_TRUE(sameBits(playedToTheEnd(session), expected));
  session.setFilterThreadCount(2);
  rerunToTheEnd(session, 11);
  EXPECT_EQ(reportedThreads(session), "2");
  EXPECT_TRUE(sameBits(session.trajectory(), expected));
  session.restart();
  ASSERT_TRUE(reaches(session, PlayState::Paused));
  EXPECT_EQ(reportedThreads(session), "2"); // also of the next run
}

INSTANTIATE_TEST_SUITE_P(Methods, FilterThreads, testing::Values("dewpoint", "barrera"));

/// Notes what it is told.
class Notes final : public FrameObserver {
public:
  void onFrameTaken(const FrameSet& frames) override { text += "t" + std::to_string(frames.index); }
  void onIteration(const TrackingRun& /*run*/, double /*microseconds*/) override { text += "i"; }
  Status onFrameTracked(const TrackingRun& run) override {
    text += "d ";
    if (run.frames()->index == fails) {
      return failure(ErrorCode::FileUnwritable, "", "", "");
    }
    return {};
  }
  std::string text;
  std::int64_t fails = -1;
};

TEST(FrameLoop, TellsOfEveryFrameInOrder) {
  SessionInputs inputs = drawnInputs("barrera", 6);
  ASSERT_TRUE(inputs.project.parameters.set("iterations_per_frame", 2));
  auto run = TrackingRun::create(inputs.project, 1).value();
  Notes notes;
  const std::array<FrameObserver*, 1> observers{&notes};
  const auto always = [] { return true; };
  EXPECT_EQ((FrameRange{2, 5}.countIn(*inputs.source)), 3);
  EXPECT_TRUE(trackFrames(*inputs.source, {2, 5}, run, observers, always));
  EXPECT_EQ(notes.text, "t2iid t3iid t4iid ");
  notes.text.clear();
  EXPECT_TRUE(trackFrames(*inputs.source, {4, std::nullopt}, run, observers, always));
  EXPECT_EQ(notes.text, "t4iid t5iid ");
  notes.text.clear();
  notes.fails = 3;
  EXPECT_FALSE(trackFrames(*inputs.source, {2, 6}, run, observers, always)); // nobody hears of 4
  EXPECT_EQ(notes.text, "t2iid t3iid ");
  notes.text.clear();
  EXPECT_TRUE(trackFrames(*inputs.source, {1, 6}, run, observers,
                          [&notes] { return notes.text.size() < 12; }));
  EXPECT_EQ(notes.text, "t1iid t2iid ");
}

TEST(FrameLoop, GivesTheBitsOfASession) {
  Session session(drawnInputs("dewpoint", kDefinedFrames));
  const Trajectory expected = playedToTheEnd(session);
  class Samples final : public FrameObserver {
  public:
    Status onFrameTracked(const TrackingRun& run) override {
      std::ranges::copy(run.samples(), std::back_inserter(trajectory.samples));
      return {};
    }
    Trajectory trajectory;
  } samples;
  SessionInputs inputs = drawnInputs("dewpoint", kDefinedFrames);
  auto run = TrackingRun::create(inputs.project, 3).value();
  const std::array<FrameObserver*, 1> observers{&samples};
  ASSERT_TRUE(trackFrames(*inputs.source, {}, run, observers, [] { return true; }));
  EXPECT_TRUE(sameBits(samples.trajectory, expected));
}

} // namespace
} // namespace dewpoint::tests

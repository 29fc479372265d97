// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/open_live.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "core/session/take/take_folder.h"
#include "core/session/take/take_recorder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <thread>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Two live cameras with a calibration, and a target with a color.
Project liveProject(const std::string& right) {
  Project project;
  project.name = "desk";
  project.parameters = ParameterValues(methodParameters(project.method));
  for (const auto& [name, location] :
       {std::pair<std::string, std::string>{"left / top", "test:ball"}, {"right", right}}) {
    ProjectCamera camera;
    camera.camera.name = name;
    camera.camera.intrinsics.width = 640;
    camera.camera.intrinsics.height = 480;
    camera.camera.intrinsics.focalX = camera.camera.intrinsics.focalY = 500;
    camera.camera.intrinsics.centerX = 320;
    camera.camera.intrinsics.centerY = 240;
    camera.source = SourceKind::Stream;
    camera.location = location;
    camera.delay = 0.02;
    project.cameras.push_back(camera);
  }
  Target target;
  target.name = "ball";
  target.radius = 0.031;
  target.color = ColorRange{0.1, 0.2, 0.3, 0.9, 0.2, 1.0};
  project.targets.push_back(target);
  project.markers.push_back({3, "start"});
  return project;
}

struct LiveRig {
  explicit LiveRig(const Project& project) {
    std::vector<LiveCamera> cameras;
    for (const ProjectCamera& camera : project.cameras) {
      LiveCamera live;
      live.name = camera.camera.name;
      live.location = camera.location;
      cameras.push_back(live);
      feeds.push_back(std::make_shared<EncodedFeed>());
    }
    auto opened = openLive(cameras, feeds);
    EXPECT_TRUE(opened);
    source = std::move(*opened);
  }

  std::vector<EncodedFeedPtr> feeds;
  std::unique_ptr<FrameSetSource> source;
};

class TakeRecorderTest : public testing::Test {
protected:
  TakeRecorderTest() {
    std::string pattern = (fs::temp_directory_path() / "dewpoint-take-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~TakeRecorderTest() override { fs::remove_all(folder_); }

  static void waitForImages(const TakeRecorder& take, std::int64_t count) {
    const auto deadline = std::chrono::steady_clock::now() + 20s;
    while (take.status().cameras[0].counts.imageCount < count &&
           std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(20ms);
    }
  }

  fs::path folder_;
};

TEST_F(TakeRecorderTest, OpensAsARecordedProject) {
  const Project project = liveProject("test:smpte?encoding=mjpeg");
  LiveRig rig(project);
  auto take = TakeRecorder::start(project, rig.feeds, folder_, {.notes = "two \"words\""});
  ASSERT_TRUE(take) << errorSentence(take.error());
  waitForImages(**take, 20);
  ASSERT_TRUE((*take)->stop());
  const TakeStatus status = (*take)->status();
  EXPECT_EQ(status.takeNumber, 1);
  EXPECT_EQ(status.folder, folder_ / "take-001");
  const auto loaded = loadProject(status.folder / "project.toml");
  ASSERT_TRUE(loaded) << errorSentence(loaded.error());
  ASSERT_EQ(loaded->cameras.size(), 2U);
  EXPECT_EQ(loaded->cameras[0].source, SourceKind::Video);
  EXPECT_EQ(loaded->cameras[0].location, (status.folder / "left---top.mkv").string());
  EXPECT_EQ(loaded->cameras[0].captureTimeFile, (status.folder / "left---top.csv").string());
  EXPECT_EQ(loaded->cameras[0].delay, 0.02);
  EXPECT_EQ(loaded->cameras[1].camera.intrinsics.width, 640);
  EXPECT_EQ(loaded->targets.at(0).radius, 0.031);
  EXPECT_EQ(loaded->targets.at(0).color, project.targets[0].color);
  EXPECT_TRUE(loaded->markers.empty()); // of frames of another recording
  std::ifstream stream(status.folder / "take.json");
  const auto notes = nlohmann::json::parse(stream);
  EXPECT_EQ(notes["notes"], "two \"words\"");
  EXPECT_EQ(notes["finished"], true);
  EXPECT_EQ(notes["cameras"][1]["images"], status.cameras[1].counts.imageCount);
}

TEST_F(TakeRecorderTest, NumbersTakesAndStopsFast) {
  const Project project = liveProject("test:snow");
  LiveRig rig(project);
  fs::create_directories(folder_ / "take-007");
  for (const int number : {8, 9}) {
    auto take = TakeRecorder::start(project, rig.feeds, folder_, {});
    ASSERT_TRUE(take) << errorSentence(take.error());
    EXPECT_EQ((*take)->status().takeNumber, number);
    waitForImages(**take, 5);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE((*take)->stop());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 1500ms);
  }
}

TEST_F(TakeRecorderTest, HasTheNumberAndTheNotesThatTheUserGives) {
  const auto notesOf = [](const fs::path& folder) {
    std::ifstream stream(folder / "take.json");
    return nlohmann::json::parse(stream)["notes"].get<std::string>();
  };
  const Project project = liveProject("test:snow");
  LiveRig rig(project);
  auto take = TakeRecorder::start(project, rig.feeds, folder_, {.notes = "before", .number = 20});
  ASSERT_TRUE(take) << errorSentence(take.error());
  const fs::path folder = (*take)->status().folder;
  EXPECT_EQ(folder, folder_ / "take-020");
  EXPECT_EQ(notesOf(folder), "before");
  ASSERT_TRUE((*take)->setNotes("while"));
  EXPECT_EQ(notesOf(folder), "while");
  EXPECT_TRUE((*take)->stop());
  EXPECT_EQ(notesOf(folder), "while");
  ASSERT_TRUE((*take)->setNotes("after"));
  EXPECT_EQ(notesOf(folder), "after");
  std::ifstream stream(folder / "take.json");
  const auto json = nlohmann::json::parse(stream);
  EXPECT_EQ(json["take"], 20);
  EXPECT_EQ(json["finished"], true); // the rest stays
  const auto again = TakeRecorder::start(project, rig.feeds, folder_, {.number = 20});
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::BadValue);
  EXPECT_EQ(makeTakeFolder(folder_)->takeNumber, 21); // it counts up from there
  EXPECT_EQ(makeTakeFolder(folder_, 0).error().code, ErrorCode::BadValue);
}

TEST_F(TakeRecorderTest, ASilentCameraIsLeftOut) {
  const Project project = liveProject("/dev/video987");
  LiveRig rig(project);
  auto take = TakeRecorder::start(project, rig.feeds, folder_, {});
  ASSERT_TRUE(take) << errorSentence(take.error());
  waitForImages(**take, 20);
  // Also while it is being recorded.
  EXPECT_TRUE(loadProject(folder_ / "take-001" / "project.toml"));
  EXPECT_TRUE((*take)->stop());
  EXPECT_EQ((*take)->status().cameras[1].counts.imageCount, 0);
  const auto loaded = loadProject(folder_ / "take-001" / "project.toml");
  ASSERT_TRUE(loaded) << errorSentence(loaded.error());
  EXPECT_EQ(loaded->cameras.size(), 1U);
}

TEST_F(TakeRecorderTest, RefusesRecordingsAndPlacesItCannotWrite) {
  Project project = liveProject("test:ball");
  std::vector<EncodedFeedPtr> feeds(2, std::make_shared<EncodedFeed>());
  EXPECT_EQ(TakeRecorder::start(project, feeds, "/proc/none", {}).error().code,
            ErrorCode::FileUnwritable);
  project.cameras[1].source = SourceKind::Video;
  EXPECT_EQ(TakeRecorder::start(project, feeds, folder_, {}).error().code, ErrorCode::Mismatch);
}

} // namespace
} // namespace dewpoint::tests

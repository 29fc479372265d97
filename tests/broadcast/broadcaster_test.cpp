// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/broadcast/broadcaster.h"
#include "tests/broadcast/test_socket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

namespace dewpoint::tests {
namespace {

using broadcast::Broadcaster;
using broadcast::BroadcastInputs;
using broadcast::RateLimit;

std::shared_ptr<TrackSnapshot> trackedFrame(std::int64_t frame) {
  static const auto kRig = [] {
    CameraRig rig(1);
    rig[0].name = "only";
    rig[0].intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
    return std::make_shared<const CameraRig>(rig);
  }();
  auto snapshot = std::make_shared<TrackSnapshot>();
  snapshot->rig = kRig;
  auto frames = std::make_shared<FrameSet>();
  frames->frames.resize(1);
  frames->time = timeStamp(0.1 * static_cast<double>(frame));
  snapshot->frames = frames;
  snapshot->frame = frame;
  snapshot->iterationCount = frame + 1;
  snapshot->isTracked = true;
  TargetSnapshot& target = snapshot->targets.emplace_back();
  target.target.name = "ball";
  SphereEstimate sphere;
  sphere.isValid = true;
  sphere.mean = {0.0, 0.0, 0.25 * static_cast<double>(frame)};
  target.estimate = sphere;
  return snapshot;
}

BroadcastInputs csvInputs(const std::string& name) {
  BroadcastInputs inputs;
  inputs.folder = testing::TempDir();
  inputs.settings.csvFile = name;
  inputs.settings.framesPerSecond = 0.0;
  return inputs;
}

std::string fileText(const std::string& name) {
  return readTextFile(std::filesystem::path(testing::TempDir()) / name).value_or("");
}

TEST(Broadcaster, SendsEachNewFrameOnce) {
  const BroadcastInputs inputs = csvInputs("broadcaster_once.csv");
  {
    auto broadcaster = Broadcaster::open(inputs);
    ASSERT_TRUE(broadcaster);
    auto untracked = trackedFrame(0);
    untracked->isTracked = false;
    auto past = trackedFrame(0);
    past->isPast = true;
    (*broadcaster)->enqueue(nullptr);
    (*broadcaster)->enqueue(std::make_shared<TrackSnapshot>()); // before the first frame
    (*broadcaster)->enqueue(untracked);
    (*broadcaster)->enqueue(past);
    (*broadcaster)->enqueue(trackedFrame(1));
    (*broadcaster)->enqueue(trackedFrame(1)); // published again
    (*broadcaster)->enqueue(trackedFrame(2));
    EXPECT_TRUE(becomesTrue([&] { return (*broadcaster)->sentFrameCount() == 2; }));
  }
  const std::string text = fileText("broadcaster_once.csv");
  EXPECT_TRUE(text.starts_with("time_s,frame,")) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_NE(text.find("0.1,1,1,ball,"), std::string::npos) << text;
  EXPECT_NE(text.find("0.2,2,1,ball,"), std::string::npos) << text;
}

TEST(Broadcaster, NeverWaitsAndCountsWhatIsDropped) {
  const BroadcastInputs inputs = csvInputs("broadcaster_many.csv");
  auto broadcaster = Broadcaster::open(inputs);
  ASSERT_TRUE(broadcaster);
  constexpr std::int64_t kFrames = 20'000;
  for (std::int64_t frame = 1; frame <= kFrames; ++frame) {
    (*broadcaster)->enqueue(trackedFrame(frame));
  }
  EXPECT_TRUE(becomesTrue([&] {
    return (*broadcaster)->sentFrameCount() + (*broadcaster)->droppedFrameCount() == kFrames;
  }));
}

TEST(Broadcaster, OpensEverythingOfTheSettings) {
  TestSocket osc = TestSocket::receiver();
  TestSocket tuio = TestSocket::receiver();
  BroadcastInputs inputs = csvInputs("broadcaster_all.csv");
  inputs.settings.tcpPort = 0;
  inputs.settings.webSocketPort = 0;
  inputs.settings.oscReceiver = "127.0.0.1:" + std::to_string(osc.port());
  inputs.settings.tuioReceiver = "127.0.0.1:" + std::to_string(tuio.port());
  auto broadcaster = Broadcaster::open(inputs);
  ASSERT_TRUE(broadcaster) << errorSentence(broadcaster.error());
  const auto reports = (*broadcaster)->reports();
  ASSERT_EQ(reports.size(), 5U);
  const std::string place = reports[0].address;
  const auto port = static_cast<std::uint16_t>(std::stoi(place.substr(place.rfind(':') + 1)));
  TestSocket client = TestSocket::connectedTo(port);
  ASSERT_TRUE(becomesTrue([&] { return (*broadcaster)->reports()[0].clientCount == 1; }));
  (*broadcaster)->enqueue(trackedFrame(3));
  const std::string lines = client.readUntil("\"frame\":3");
  EXPECT_TRUE(lines.starts_with(R"({"type":"rig","axes":"z-up")")) << lines;
  EXPECT_NE(osc.readUntil("/dewpoint/target").find("/dewpoint/frame"), std::string::npos);
  EXPECT_NE(tuio.readUntil("alive").find("/tuio/3Dcur"), std::string::npos);
}

TEST(Broadcaster, NamesTheKeyThatIsWrong) {
  const auto fieldOf = [](const OutputSettings& settings) {
    const auto broadcaster = Broadcaster::open({settings});
    return broadcaster ? std::string("none") : broadcaster.error().field;
  };
  OutputSettings settings;
  EXPECT_EQ(fieldOf(settings), "none");
  settings.csvFile = "/nowhere/at/all.csv";
  EXPECT_EQ(fieldOf(settings), "output.csv");
  settings = {};
  settings.tcpPort = 0;
  settings.listenAddress = "192.0.2.1"; // an address that is nobody's (RFC 5737)
  EXPECT_EQ(fieldOf(settings), "output.tcp");
  settings = {};
  settings.token = "${DEWPOINT_NO_SUCH_VARIABLE}";
  EXPECT_EQ(fieldOf(settings), "output.token");
  ::setenv("DEWPOINT_SHORT_TOKEN", "abc", 1);
  settings.token = "${DEWPOINT_SHORT_TOKEN}";
  EXPECT_EQ(fieldOf(settings), "output.token");
}

TEST(RateLimit, LetsTheChosenNumberOfFramesPass) {
  const auto passed = [](double rate, double framesPerSecond) {
    RateLimit limit(rate);
    const RateLimit::Clock::time_point begin{std::chrono::hours(1)};
    int count = 0;
    for (int k = 0; k < 10 * framesPerSecond; ++k) {
      count += limit.isDue(
          begin + std::chrono::microseconds(static_cast<std::int64_t>(1e6 * k / framesPerSecond)));
    }
    return count;
  };
  EXPECT_EQ(passed(0.0, 200.0), 2000);
  EXPECT_EQ(passed(30.0, 30.0), 300);
  EXPECT_EQ(passed(30.0, 15.0), 150);
  EXPECT_NEAR(passed(30.0, 100.0), 300, 2);
  EXPECT_NEAR(passed(10.0, 30.0), 100, 1);
}

} // namespace
} // namespace dewpoint::tests

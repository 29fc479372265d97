// SPDX-License-Identifier: GPL-3.0-or-later
// Live cameras to which everything happens that can happen, tracked by the same session as the
// window's. bench/disturbance_bench.cpp does the same in the window, for longer.
#include "app/wiring/open_project.h"
#include "core/session/session.h"
#include "tests/capture/mjpeg_server.h"
#include "tests/integration/disturbed_cameras.h"
#include "tests/integration/image_tag.h"
#include "tests/integration/kept_track.h"
#include "tests/integration/process_usage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;

/// Random events of the test with devices, which take some seconds. The environment variable
/// DEWPOINT_LIVE_EVENTS asks for another number.
constexpr int kUsualEvents = 60;
constexpr auto kBetweenEvents = 100ms;
constexpr std::uint64_t kEventSeed = 3;
/// Sets with good images of two cameras after which the target must be tracked: those that it takes
/// to find a target again.
constexpr int kSteadySets = 5;
constexpr double kOffTarget = 0.03; ///< meters: the paper's bound
constexpr std::size_t kShortHistory = std::size_t{16} << 20;
/// More than what allocators keep, but less than 300 images: three per event.
constexpr std::int64_t kMostGrowth = std::int64_t{64} << 20;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMemoryIsItsOwn = false; // a sanitizer keeps what was freed
#else
constexpr bool kMemoryIsItsOwn = true;
#endif

int eventsWanted() {
  const char* wanted = std::getenv("DEWPOINT_LIVE_EVENTS");
  return wanted != nullptr ? std::atoi(wanted) : kUsualEvents;
}

/// Waits until all cameras deliver good images. If they do not, the test's time limit strikes.
void waitForAll(const SetRecord& record) {
  while (record.completeSets() < 3) {
    std::this_thread::sleep_for(10ms);
  }
}

std::string inLines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  return text;
}

/// Checks that each image was that of its camera, and that the target was tracked whenever two
/// cameras showed it.
void checkTrack(const SetRecord& record, const Trajectory& trajectory,
                const std::function<Eigen::Vector3d(std::int64_t)>& truth) {
  EXPECT_EQ(inLines(record.faults()), "");
  const KeptTrack kept = keptTrack(record.sets(), trajectory, truth, kSteadySets, kOffTarget);
  EXPECT_GT(kept.due, 0);
  EXPECT_EQ(inLines(kept.lost), "");
}

TEST(LiveDisturbance, DevicesKeepTheirIdentityAndTheTarget) {
  DisturbedCameras cameras(kEventSeed);
  const auto record = std::make_shared<SetRecord>(FakeDesk::kWidth, FakeDesk::kHeight);
  SessionInputs inputs;
  inputs.project = cameras.project();
  inputs.maxHistoryBytes = kShortHistory;
  auto source = cameras.open();
  ASSERT_TRUE(source) << errorSentence(source.error());
  inputs.source = std::make_unique<WatchedSource>(std::move(*source), record);
  auto session = std::make_unique<Session>(std::move(inputs));
  session->play();
  waitForAll(*record);
  const ProcessUsage before = processUsage();
  std::vector<std::string> log;
  for (int event = eventsWanted(); event > 0; --event) {
    log.push_back(cameras.disturb());
    std::this_thread::sleep_for(kBetweenEvents);
  }
  cameras.mend();
  std::ofstream("live-disturbance-events.txt") << inLines(log);
  SCOPED_TRACE(inLines(log));
  waitForAll(*record);
  EXPECT_EQ(cameras.connections(), FakeDesk::kCameras);
  const ProcessUsage after = processUsage();
  EXPECT_LE(after.handles, before.handles);
  if (kMemoryIsItsOwn) {
    EXPECT_LE(after.bytes - before.bytes, kMostGrowth);
  }
  checkTrack(*record, session->trajectory(),
             [&](std::int64_t tick) { return cameras.truth(tick); });
  session.reset();
  EXPECT_EQ(cameras.connections(), 0);
}

/// A network camera of the fake desk, whose server stops, comes back, and sends rubbish.
class LoopbackCamera {
public:
  LoopbackCamera(const FakeDesk& desk, int camera) : desk_(desk), camera_(camera) { start(); }

  std::string address() const { return address_; }
  bool isOn() const { return server_ != nullptr; }
  void stop() { server_.reset(); }
  void start() {
    server_ = std::make_unique<test::MjpegServer>(
        [this](std::int64_t) { return picture(); }, port_,
        [this](std::vector<unsigned char>& jpeg) { spoil(jpeg); });
    port_ = server_->port();
    address_ = server_->address();
  }
  void resize(int images) { resized_ = images; }
  void corrupt(int images) { corrupt_ = images; }

private:
  cv::Mat picture() {
    const std::int64_t tick = desk_.now();
    cv::Mat image = desk_
                        .film[static_cast<std::size_t>(camera_)]
                             [static_cast<std::size_t>(tick % FakeDesk::kRoundTicks)]
                        .clone();
    const bool isResized = resized_ > 0 && resized_-- > 0;
    if (isResized) {
      cv::resize(image, image, {}, 2.0, 2.0);
    }
    drawTag(image, {camera_, tick, !isResized && corrupt_ <= 0});
    return image;
  }
  /// Zeros the second half of the bytes: decoders make what they can of it.
  void spoil(std::vector<unsigned char>& jpeg) {
    if (corrupt_ > 0 && corrupt_-- > 0) {
      std::fill(jpeg.begin() + std::ssize(jpeg) / 2, jpeg.end(), std::uint8_t{0});
    }
  }

  const FakeDesk& desk_;
  int camera_;
  std::atomic<int> resized_ = 0;
  std::atomic<int> corrupt_ = 0;
  std::uint16_t port_ = 0;
  std::string address_;
  std::unique_ptr<test::MjpegServer> server_;
};

/// Makes something happen to a camera, and returns it in words.
std::string disturb(LoopbackCamera& camera, std::uint64_t random) {
  if (!camera.isOn()) {
    camera.start();
    return "starts";
  }
  switch (random % 3) {
  case 0:
    camera.stop();
    return "stops";
  case 1:
    camera.resize(5);
    return "sends five images of another size";
  default:
    camera.corrupt(5);
    return "sends five broken images";
  }
}

TEST(LiveDisturbance, StreamsKeepTheirIdentityAndTheTarget) {
  constexpr int kStreams = 3;
  constexpr int kStreamEvents = 24;
  const FakeDesk desk;
  std::vector<std::unique_ptr<LoopbackCamera>> cameras;
  Project project = makeSceneProject(desk.scene, "");
  project.cameras.resize(kStreams);
  for (int k = 0; k < kStreams; ++k) {
    cameras.push_back(std::make_unique<LoopbackCamera>(desk, k));
    project.cameras[static_cast<std::size_t>(k)].source = SourceKind::Stream;
    project.cameras[static_cast<std::size_t>(k)].location = cameras.back()->address();
  }
  auto inputs = openInputs(project);
  ASSERT_TRUE(inputs) << errorSentence(inputs.error());
  const auto record = std::make_shared<SetRecord>(FakeDesk::kWidth, FakeDesk::kHeight);
  inputs->source = std::make_unique<WatchedSource>(std::move(inputs->source), record);
  inputs->maxHistoryBytes = kShortHistory;
  Session session(std::move(*inputs));
  session.play();
  waitForAll(*record);
  const int handles = processUsage().handles;
  std::mt19937_64 random(kEventSeed);
  std::vector<std::string> log;
  for (int event = 0; event < kStreamEvents; ++event) {
    const std::size_t k = random() % kStreams;
    log.push_back(
        fmt::format("tick {}, camera {} {}", desk.now(), k + 1, disturb(*cameras[k], random())));
    std::this_thread::sleep_for(2 * kBetweenEvents);
  }
  for (const auto& camera : cameras) {
    camera->resize(0);
    camera->corrupt(0);
    if (!camera->isOn()) {
      camera->start();
    }
  }
  SCOPED_TRACE(inLines(log));
  waitForAll(*record);
  // A server closes a connection only when its next image is not taken.
  for (int wait = 0; wait < 1000 && processUsage().handles > handles; ++wait) {
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_LE(processUsage().handles, handles);
  checkTrack(*record, session.trajectory(), [&](std::int64_t tick) { return desk.ballAt(tick); });
}

} // namespace
} // namespace dewpoint::tests

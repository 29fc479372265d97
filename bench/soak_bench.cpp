// SPDX-License-Identifier: GPL-3.0-or-later
//
// A live session of many hours, as fast as it goes: two cameras of the demo's rig at 30 images per
// second of simulated time. Prints memory, handles and threads after each simulated hour, and how
// often the target was tracked. What a run keeps of each frame grows with its results, so their
// number and size are printed, too.
//
//     soak_bench [HOURS [METHOD]]
#include "app/wiring/open_project.h"
#include "app/wiring/quiet_libraries.h"
#include "core/session/session.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/integration/process_usage.h"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr std::int64_t kRate = 30; ///< images per second
constexpr std::int64_t kFramesPerHour = 3600 * kRate;
constexpr std::size_t kHistoryBytes = std::size_t{64} << 20;
constexpr std::int64_t kUnlooked = 100; ///< frames after which somebody has to look

Scene soakScene() {
  Scene scene = demoScene();
  scene.balls.front().stillSeconds = 0.0;
  return scene;
}

/// Cameras that have their next images whenever somebody asks.
class TirelessCameras final : public FrameSetSource {
public:
  explicit TirelessCameras(const Scene& scene) : images_(scene.cameras.size()) {
    round_ = static_cast<std::int64_t>(scene.balls.front().period * static_cast<double>(kRate));
    Scene longer = scene;
    longer.frameCount = 2 * round_;
    const SceneRenderer renderer(longer);
    for (std::size_t k = 0; k < images_.size(); ++k) {
      for (std::int64_t frame = round_; frame < 2 * round_; ++frame) { // the ball starts slowly
        images_[k].push_back(renderer.render(static_cast<int>(k), frame));
      }
    }
  }

  std::optional<std::int64_t> frameCount() const override { return std::nullopt; }
  double framesPerSecond() const override { return static_cast<double>(kRate); }
  Result<FrameSetPtr> next() override {
    auto set = std::make_shared<FrameSet>();
    set->index = index_++;
    set->time = TimeStamp(set->index * std::chrono::nanoseconds(std::chrono::seconds(1)) / kRate);
    for (const auto& images : images_) {
      Frame frame;
      frame.index = set->index;
      frame.captureTime = set->time;
      frame.image = images[static_cast<std::size_t>(set->index % round_)].clone();
      frame.origin = TimeOrigin::Driver;
      frame.instants.capturedAt = frame.instants.arrivedAt = frame.instants.decodedAt =
          std::chrono::steady_clock::now();
      frame.instants.imageId = set->index;
      set->frames.push_back(std::make_shared<const Frame>(std::move(frame)));
    }
    return set;
  }
  Status seek(std::int64_t) override { return {}; }

private:
  std::int64_t index_ = 0;
  std::int64_t round_ = 0;
  std::vector<std::vector<cv::Mat>> images_; ///< of each camera, one round of the ball
};

/// Waits for a number of frames.
class FrameCounter {
public:
  void set(std::int64_t count) {
    if (count % kUnlooked == 0) {
      std::scoped_lock lock(mutex_);
      count_ = count;
      changed_.notify_all();
    }
  }
  void waitFor(std::int64_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return count_ >= count; });
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::int64_t count_ = 0;
};

int soak(int hours, const std::string& method) {
  using Clock = std::chrono::steady_clock;
  const Scene scene = soakScene();
  SessionInputs inputs;
  inputs.project = makeSceneProject(scene, "");
  if (!method.empty()) {
    inputs.project.method = method;
    inputs.project.parameters = ParameterValues(methodParameters(method));
  }
  inputs.source = std::make_unique<TirelessCameras>(scene);
  inputs.maxHistoryBytes = kHistoryBytes;
  FrameCounter counter;
  Session session(std::move(inputs));
  session.setFrameTap([&](const FrameSetPtr& set) { counter.set(set->index + 1); });
  session.play();
  fmt::print("{:>5} {:>8} {:>8} {:>8} {:>10} {:>11} {:>9} {:>9}\n", "hour", "MB", "handles",
             "threads", "samples", "samples MB", "tracked", "seconds");
  const auto begin = Clock::now();
  for (int hour = 0; hour <= hours; ++hour) {
    counter.waitFor(hour == 0 ? kFramesPerHour / 60 : hour * kFramesPerHour);
    const tests::ProcessUsage usage = tests::processUsage();
    std::uint64_t generation = 0;
    std::size_t position = 0;
    std::int64_t tracked = 0;
    std::size_t samples = 0;
    {
      const auto update = session.samplesSince(generation, position);
      samples = update.records.size();
      for (const TrajectorySample& sample : update.records) {
        tracked += sample.isValid ? 1 : 0;
      }
    }
    fmt::print("{:>5} {:>8} {:>8} {:>8} {:>10} {:>11} {:>8.2f}% {:>9.0f}\n", hour,
               usage.bytes >> 20, usage.handles, usage.threads, samples,
               (samples * sizeof(TrajectorySample)) >> 20,
               100.0 * static_cast<double>(tracked) / static_cast<double>(samples),
               std::chrono::duration<double>(Clock::now() - begin).count());
    std::fflush(stdout);
  }
  session.setFrameTap({});
  return 0;
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  dewpoint::app::silenceLibraries();
  return dewpoint::bench::soak(argc > 1 ? std::atoi(argv[1]) : 24, argc > 2 ? argv[2] : "");
}

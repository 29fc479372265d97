// SPDX-License-Identifier: GPL-3.0-or-later
//
// One frame of method dewpoint, beside one of method B as published: 200 particles each, two
// cameras at QVGA, on frames of the product's demo, in which a ball moves over a desk.
#include "app/wiring/open_project.h"
#include "bench/ratios.h"
#include "core/session/run/tracking_run.h"
#include "core/tracking/catalog/method_catalog.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr int kParticles = 200;
constexpr int kFrames = 16; ///< few enough to stay near the processor, as a frame does that has
                            ///< just come; then back again: the ball does not jump
constexpr double kFrameSeconds = 1.0 / 30.0;

/// Frames kept in memory, played to and fro without an end.
class Replay {
public:
  explicit Replay(FrameSetSource& source) {
    for (int k = 0; k < kFrames; ++k) {
      sets_.push_back(source.next().value());
    }
  }
  FrameSetPtr next() {
    const std::int64_t phase = index_ % (2 * kFrames - 2);
    auto set = std::make_shared<FrameSet>(
        *sets_[std::size_t(phase < kFrames ? phase : 2 * kFrames - 2 - phase)]);
    set->index = index_;
    set->time = timeStamp(double(index_) * kFrameSeconds);
    for (FramePtr& frame : set->frames) {
      auto copy = std::make_shared<Frame>(*frame);
      copy->captureTime = set->time;
      frame = std::move(copy);
    }
    ++index_;
    return set;
  }

private:
  std::vector<FrameSetPtr> sets_;
  std::int64_t index_ = 0;
};

void follow(benchmark::State& state, const std::string& method) {
  auto inputs = openProject("demo").value();
  inputs.project.method = method;
  inputs.project.parameters = ParameterValues(methodParameters(method));
  inputs.project.parameters.markAllAsGiven();
  for (const char* key : {"particles", "fewest_particles"}) { // barrera has no second
    static_cast<void>(inputs.project.parameters.set(key, kParticles));
  }
  auto run = TrackingRun::create(inputs.project, 1).value();
  Replay replay(*inputs.source);
  const auto step = [&] {
    run.beginFrame(replay.next());
    run.iterateTimed();
  };
  for (int k = 0; k < 16 * kFrames; ++k) {
    step();
  }
  for ([[maybe_unused]] auto _ : state) {
    step();
  }
  if (!isConfirmed(run.estimate(0))) {
    state.SkipWithError("the ball was lost");
  }
}
BENCHMARK_CAPTURE(follow, dewpoint, "dewpoint")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(follow, barrera, "barrera")->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  return dewpoint::bench::runBenchmarks(
      argc, argv,
      {{"method dewpoint, 200 particles, 2 x QVGA, a frame", "follow/dewpoint"},
       {"method barrera, the same", "follow/barrera"}},
      {{"method barrera takes so much of dewpoint's time", "follow/barrera", "follow/dewpoint",
        0.5}});
}

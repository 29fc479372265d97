// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole iterations with 10^3 to 10^6 particles and 2, 4 or 8 cameras at VGA: time per particle,
// with one thread and with two, beside the naive version that looks at the pixels for every
// particle. What a new frame costs, whatever the number of particles, is measured by itself.
#include "bench/ball_scene.h"
#include "bench/ratios.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace dewpoint::bench {
namespace {

/// The cloud has its typical size from the second iteration on.
void warmUp(BallScene& scene) {
  for (int i = 0; i < 3; ++i) {
    scene.iterateColorWindow();
  }
}

/// Arguments: particles, cameras, threads. All iterations are on one frame, already counted.
void iteration(benchmark::State& state) {
  BallScene scene(vgaRig(int(state.range(1))), state.range(0), int(state.range(2)));
  scene.showFrame(1000);
  warmUp(scene);
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(scene.iterateColorWindow());
  }
}
BENCHMARK(iteration)
    ->ArgsProduct({{1000, 10000, 100000, 1000000}, {2}, {1}})
    ->Args({1000000, 4, 1})
    ->Args({1000000, 8, 1})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(iteration)->Args({1000000, 2, 2})->UseRealTime()->Unit(benchmark::kMicrosecond);

/// One iteration on every frame: the frame is part of it. Arguments: particles, cameras.
void iterationOnNewFrame(benchmark::State& state) {
  BallScene scene(vgaRig(int(state.range(1))), state.range(0));
  warmUp(scene);
  for ([[maybe_unused]] auto _ : state) {
    scene.showFrame();
    benchmark::DoNotOptimize(scene.iterateColorWindow());
  }
}
BENCHMARK(iterationOnNewFrame)
    ->ArgsProduct({{1000, 10000, 100000, 1000000}, {2}})
    ->Unit(benchmark::kMicrosecond);

void naiveIteration(benchmark::State& state) {
  BallScene scene(vgaRig(int(state.range(1))), state.range(0));
  warmUp(scene);
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(scene.iterateNaive());
  }
}
BENCHMARK(naiveIteration)->Args({100000, 2})->Unit(benchmark::kMicrosecond);

/// Arguments: particles, cameras.
void newFrame(benchmark::State& state) {
  BallScene scene(vgaRig(int(state.range(1))), state.range(0));
  for ([[maybe_unused]] auto _ : state) {
    scene.showFrame();
  }
}
BENCHMARK(newFrame)->Args({1000000, 2})->Unit(benchmark::kMicrosecond);

std::string nameOf(int particles, int cameras) {
  return fmt::format("iteration/{}/{}/1", particles, cameras);
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint::bench;
  constexpr double kMillion = 1e6;
  std::vector<Cost> costs;
  for (const int particles : {1000, 10000, 100000, 1000000}) {
    costs.push_back({fmt::format("{} particles, 2 cameras, per particle", particles),
                     nameOf(particles, 2), double(particles), particles == 1000000 ? 14.0 : 0.0});
  }
  for (const int particles : {1000, 10000, 100000, 1000000}) {
    costs.push_back({fmt::format("the same with a new frame each time, {} particles", particles),
                     fmt::format("iterationOnNewFrame/{}/2", particles), double(particles)});
  }
  for (const int cameras : {4, 8}) {
    costs.push_back({fmt::format("1000000 particles, {} cameras, per particle", cameras),
                     nameOf(1000000, cameras), kMillion});
  }
  costs.push_back({"a new frame of 2 cameras at VGA", "newFrame/1000000/2"});
  const std::string million = nameOf(1000000, 2);
  return runBenchmarks(argc, argv, costs,
                       {{"10^6 particles against naive, per particle", "naiveIteration/100000/2",
                         million, 8.0, 1e5, kMillion},
                        {"two threads against one, wall clock", million,
                         "iteration/1000000/2/2/real_time", 1.7, 1.0, 1.0, true}});
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a set of frames of the accuracy suite costs to render, by grade: two cameras at QVGA, one
// ball, one thread. Rendering is no part of what the suite reports of a method, but most of what a
// run of it takes.
#include "core/experiment/scenarios/catalog/catalog.h"
#include "core/experiment/scenarios/scenario.h"

#include <benchmark/benchmark.h>
#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cstdint>

namespace dewpoint::bench {
namespace {

void renderSets(benchmark::State& state, Grade grade) {
  cv::setNumThreads(1);
  const auto scenario = std::ranges::find(scenarioCatalog(), "S0-slow", &ScenarioDeclaration::name);
  const auto run = scenario->make(1, grade);
  if (!run) {
    state.SkipWithError("no run");
    return;
  }
  std::int64_t frame = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(run->frames(frame));
    frame = (frame + 1) % run->frameCount;
  }
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint::bench;
  const auto add = [](const char* name, Grade grade) {
    benchmark::RegisterBenchmark(name, [grade](benchmark::State& state) {
      renderSets(state, grade);
    })->Unit(benchmark::kMillisecond);
  };
  add("ideal", Grade::Ideal);
  add("room", Grade::Room);
  add("wild", Grade::Wild);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

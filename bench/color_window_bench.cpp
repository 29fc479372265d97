// SPDX-License-Identifier: GPL-3.0-or-later
//
// One iteration of method B exactly as published (Barrera et al. 2005: 200 particles, two cameras
// at QVGA, 5x5 windows, sigma 0.03 m): the product beside a naive version that converts every
// pixel it looks at to HSI with an arc cosine. The paper's own figure is 5 ms on a 2.7 GHz
// Pentium IV. Every iteration has a new frame, as in the paper.
#include "bench/ball_scene.h"
#include "bench/ratios.h"
#include "core/base/instruction_set.h"

#include <benchmark/benchmark.h>

namespace dewpoint::bench {
namespace {

constexpr int kPaperParticles = 200;

void naiveAcosIteration(benchmark::State& state) {
  BallScene scene(paperRig(), kPaperParticles);
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(scene.iterateNaive());
  }
}
BENCHMARK(naiveAcosIteration)->Unit(benchmark::kMicrosecond);

/// Argument: 0 the baseline instructions, 1 AVX2, 2 AVX-512.
void productIteration(benchmark::State& state) {
  const InstructionSetLimit limit(static_cast<InstructionSet>(state.range(0)));
  if (state.range(0) != static_cast<int>(instructionSet())) {
    state.SkipWithError("this processor has no such instructions");
    return;
  }
  if (!versionsAgree(paperRig(), kPaperParticles, 20)) {
    state.SkipWithError("the product's estimates differ from the naive version's");
    return;
  }
  BallScene scene(paperRig(), kPaperParticles);
  for ([[maybe_unused]] auto _ : state) {
    scene.showFrame();
    benchmark::DoNotOptimize(scene.iterateColorWindow());
  }
}
BENCHMARK(productIteration)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  return dewpoint::bench::runBenchmarks(
      argc, argv,
      {{"200 particles, 2 x QVGA, one iteration, whole", "productIteration/2"},
       {"the naive version", "naiveAcosIteration"}},
      {{"200 particles, 2 x QVGA, against naive, baseline", "naiveAcosIteration",
        "productIteration/0", 10.0},
       {"200 particles, 2 x QVGA, against naive, AVX2", "naiveAcosIteration", "productIteration/1",
        10.0},
       {"200 particles, 2 x QVGA, against naive, AVX-512", "naiveAcosIteration",
        "productIteration/2", 10.0}});
}

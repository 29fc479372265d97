// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which pixels of an image have the target color: the product beside OpenCV's own way (convert to
// HSV, then inRange), one thread each, and beside the arc cosine of the book; and log ratios of
// color by a table beside it.
#include "bench/ratios.h"
#include "core/base/instruction_set.h"
#include "core/color/hsi.h"
#include "core/color/likelihood/target_color_model.h"
#include "core/color/match_image.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::bench {
namespace {

const ColorRange kPink{300.0, 350.0, 0.2, 1.0, 0.15, 0.9};

/// Soft patches of every color, with noise.
cv::Mat testImage(const benchmark::State& state) {
  cv::Mat image(int(state.range(1)), int(state.range(0)), CV_8UC3);
  cv::RNG random(20050601);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(image, image, {5, 5}, 0.0);
  return image;
}

void countPixels(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(1));
}

void openCvHsvInRange(benchmark::State& state) {
  cv::setNumThreads(1);
  const cv::Mat image = testImage(state);
  cv::Mat hsv;
  cv::Mat match;
  for ([[maybe_unused]] auto _ : state) {
    cv::cvtColor(image, hsv, cv::COLOR_BGR2HSV);
    cv::inRange(hsv, cv::Scalar(150, 51, 38), cv::Scalar(175, 255, 230), match);
    benchmark::DoNotOptimize(match.data);
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

void product(benchmark::State& state) {
  const cv::Mat image = testImage(state);
  const ColorClassifier classifier(kPink);
  const InstructionSetLimit limit(static_cast<InstructionSet>(state.range(2)));
  if (state.range(2) != static_cast<int>(instructionSet())) {
    state.SkipWithError("this processor has no such instructions");
    return;
  }
  cv::Mat match(image.size(), CV_8UC1);
  for ([[maybe_unused]] auto _ : state) {
    matchImage(image, classifier, match);
    benchmark::DoNotOptimize(match.data);
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

/// Patches of one color each, 40 pixels wide, with noise: as scenes have them.
cv::Mat patchImage(const benchmark::State& state) {
  constexpr int kPatch = 40;
  cv::RNG random(20050601);
  cv::Mat colors(int(state.range(1)) / kPatch, int(state.range(0)) / kPatch, CV_8UC3);
  random.fill(colors, cv::RNG::UNIFORM, 20, 236);
  cv::Mat image;
  cv::resize(colors, image, {int(state.range(0)), int(state.range(1))}, 0.0, 0.0,
             cv::INTER_NEAREST);
  cv::Mat noise(image.size(), CV_16SC3);
  random.fill(noise, cv::RNG::NORMAL, 0.0, 3.0);
  cv::add(image, noise, image, cv::noArray(), CV_8U);
  return image;
}

/// Log ratios of pink before the colors of the image, within the limits of a range.
void lookUp(benchmark::State& state, const cv::Mat& image) {
  const InstructionSetLimit limit(static_cast<InstructionSet>(state.range(2)));
  if (state.range(2) != static_cast<int>(instructionSet())) {
    state.SkipWithError("this processor has no such instructions");
    return;
  }
  HsiCounts rest;
  rest.add(image, cv::Mat());
  TargetColorModel model(kPink);
  model.add({{hsiFromBgr(150, 80, 220), 1000.0}});
  const ColorLikelihood likelihood = model.likelihoodForCamera({}, rest.colors());
  cv::Mat ratios(image.size(), CV_8SC1);
  for ([[maybe_unused]] auto _ : state) {
    likelihood.computeLogRatioRow(image.ptr<std::uint8_t>(),
                                  static_cast<std::int64_t>(image.total()),
                                  ratios.ptr<std::int8_t>());
    benchmark::DoNotOptimize(ratios.data);
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

/// Colors in reach of the table everywhere.
void table(benchmark::State& state) {
  lookUp(state, testImage(state));
}

void tableOfPatches(benchmark::State& state) {
  lookUp(state, patchImage(state));
}

void arcCosine(benchmark::State& state) {
  const cv::Mat image = testImage(state);
  std::vector<std::uint8_t> match(image.total());
  for ([[maybe_unused]] auto _ : state) {
    const std::uint8_t* pixel = image.ptr<std::uint8_t>();
    for (std::uint8_t& out : match) {
      out = matches(hsiFromBgr(pixel[0], pixel[1], pixel[2]), kPink) ? 255 : 0;
      pixel += 3;
    }
    benchmark::ClobberMemory();
  }
  countPixels(state);
}

BENCHMARK(openCvHsvInRange)->Args({640, 480})->Args({1920, 1080})->Unit(benchmark::kMicrosecond);
BENCHMARK(arcCosine)->Args({640, 480})->Unit(benchmark::kMicrosecond);
/// Third argument: 0 the baseline instructions, 1 AVX2, 2 AVX-512.
BENCHMARK(product)
    ->ArgsProduct({{640}, {480}, {0, 1, 2}})
    ->ArgsProduct({{1920}, {1080}, {0, 1, 2}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(table)->ArgsProduct({{640}, {480}, {0, 1, 2}})->Unit(benchmark::kMicrosecond);
BENCHMARK(tableOfPatches)->ArgsProduct({{640}, {480}, {0, 1, 2}})->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint::bench;
  std::vector<Ratio> ratios;
  for (const std::string size : {"/640/480", "/1920/1080"}) {
    for (const std::string set : {"/0", "/1", "/2"}) {
      const char* name = set == "/0" ? "baseline" : set == "/1" ? "AVX2" : "AVX-512";
      const double bar = set == "/0" ? 0.0 : 8.0;
      ratios.push_back(
          {fmt::format("color match against OpenCV HSV + inRange, {}, {}", size.substr(1), name),
           fmt::format("openCvHsvInRange{}", size), fmt::format("product{}{}", size, set), bar});
    }
  }
  for (const std::string set : {"/0", "/1", "/2"}) {
    const char* name = set == "/0" ? "baseline" : set == "/1" ? "AVX2" : "AVX-512";
    const std::string range = fmt::format("product/640/480{}", set);
    ratios.push_back({fmt::format("color by table against by range, patches, {}", name), range,
                      fmt::format("tableOfPatches/640/480{}", set), 1.0});
    ratios.push_back({fmt::format("the same, the target's color in every row, {}", name), range,
                      fmt::format("table/640/480{}", set), 0.0});
  }
  return runBenchmarks(argc, argv, {}, ratios);
}

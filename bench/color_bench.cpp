// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which pixels of an image have the target color: the product beside OpenCV's own way (convert to
// HSV, then inRange), one thread each, and beside the arc cosine of the book.
#include "bench/ratios.h"
#include "core/base/instruction_set.h"
#include "core/color/hsi.h"
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
  return runBenchmarks(argc, argv, {}, ratios);
}

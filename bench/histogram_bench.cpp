// SPDX-License-Identifier: GPL-3.0-or-later
//
// The weights of 100 and of 300 particles on one new 320 x 240 image, boxes of 30 x 30 pixels
// (Sugandi et al. 2009): the product's similarity, with all that it prepares per image, beside the
// paper's equations written down as they stand.
#include "bench/ratios.h"
#include "core/base/random.h"
#include "core/color/rgb_bins.h"
#include "core/observation/boxes/histogram_similarity.h"
#include "tests/observation/naive_histogram.h"
#include "tests/tracking/moving_patch.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace dewpoint::bench {
namespace {

using tests::MovingPatch;
using tests::naiveHistogram;
using tests::naiveSimilarity;

constexpr int kSide = 30;

/// One image, and particles about the target (10 px per axis, the method's default).
struct Scene {
  cv::Mat image;
  std::vector<cv::Point> corners;
  cv::Rect region;
  std::array<double, 512> reference{};

  explicit Scene(int particles) {
    const MovingPatch patch;
    image = patch.image(0);
    const ImageBox box = patch.box(0);
    const cv::Point corner(int(std::lround(box.x)), int(std::lround(box.y)));
    reference = naiveHistogram(image, {corner, cv::Size(kSide, kSide)});
    const RandomStream stream(1, 0, 0, RandomPurpose::Motion);
    for (int i = 0; i < particles; ++i) {
      const auto noise = stream.normal4(std::uint32_t(i));
      corners.emplace_back(corner.x + int(std::lround(10.0 * noise[0])),
                           corner.y + int(std::lround(10.0 * noise[1])));
    }
    region = cv::boundingRect(corners);
    region.width += kSide;
    region.height += kSide;
    region &= cv::Rect({0, 0}, image.size());
  }

  double naive(const cv::Point& corner) const {
    return naiveSimilarity(naiveHistogram(image, {corner, cv::Size(kSide, kSide)}), reference);
  }
};

HistogramSimilarity similarityOf(const Scene& scene) {
  return {{scene.reference.begin(), scene.reference.end()}, BoxKernel(kSide, kSide)};
}

double productAt(const HistogramSimilarity& similarity, const cv::Point& corner) {
  return similarity.at(corner.x + 0.5 * kSide, corner.y + 0.5 * kSide);
}

bool agree(const Scene& scene) {
  HistogramSimilarity similarity = similarityOf(scene);
  similarity.loadColors(scene.image, scene.region);
  return std::all_of(scene.corners.begin(), scene.corners.end(), [&](const cv::Point& corner) {
    return std::abs(productAt(similarity, corner) - scene.naive(corner)) < 1e-5;
  });
}

void naiveParticles(benchmark::State& state) {
  const Scene scene(int(state.range(0)));
  for ([[maybe_unused]] auto _ : state) {
    double sum = 0.0;
    for (const cv::Point& corner : scene.corners) {
      sum += scene.naive(corner);
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(naiveParticles)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);

void productParticles(benchmark::State& state) {
  const Scene scene(int(state.range(0)));
  if (!agree(scene)) {
    state.SkipWithError("the similarities differ from the naive version's");
    return;
  }
  HistogramSimilarity similarity = similarityOf(scene);
  for ([[maybe_unused]] auto _ : state) {
    similarity.loadColors(scene.image, scene.region);
    double sum = 0.0;
    for (const cv::Point& corner : scene.corners) {
      sum += productAt(similarity, corner);
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(productParticles)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  return dewpoint::bench::runBenchmarks(
      argc, argv,
      {{"300 particles, 30 x 30 px, whole", "productParticles/300"},
       {"the naive version", "naiveParticles/300"}},
      {{"100 particles, against naive", "naiveParticles/100", "productParticles/100", 12.0},
       {"300 particles, against naive", "naiveParticles/300", "productParticles/300", 12.0}});
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// One iteration of method B exactly as published (Barrera et al. 2005: 200 particles, two cameras
// at QVGA, 5x5 windows, sigma 0.03 m): the product beside a naive version that converts every
// pixel it looks at to HSI with an arc cosine. The paper's own figure is 5 ms on a 2.7 GHz
// Pentium IV. Build with CMAKE_BUILD_TYPE=Release and run build/bench/color_window_bench.
#include "core/color/color_classifier.h"
#include "core/color/hsi.h"
#include "core/color/match_image.h"
#include "core/filter/isotropic_motion.h"
#include "core/filter/models.h"
#include "core/filter/multinomial_resampling.h"
#include "core/filter/particle_filter.h"
#include "core/geometry/camera.h"
#include "core/observation/color_window.h"

#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace dewpoint {
namespace {

constexpr int kPaperParticles = 200;
const Eigen::Vector3d kBall(0.35, 0.45, 0.15);
const ColorRange kPink{300.0, 350.0, 0.2, 1.0, 0.15, 0.9};

/// The paper's two webcams; the second is turned by 90 degrees, so its image is upright.
CameraRig paperRig() {
  CameraRig rig(2);
  rig[0].intrinsics = {320, 240, 400.0, 400.0, 159.5, 119.5};
  rig[0].cameraFromWorld = lookAt({0.5, 0.0, 0.195}, kBall);
  rig[1].intrinsics = {240, 320, 400.0, 400.0, 119.5, 159.5};
  rig[1].cameraFromWorld = lookAt({0.07, 0.485, 0.085}, kBall);
  return rig;
}

/// A desk full of colors, with noise, and the ball (radius 2 cm) where the camera sees it.
cv::Mat paperImage(const Camera& camera) {
  cv::Mat image(camera.intrinsics.height, camera.intrinsics.width, CV_8UC3);
  cv::RNG random(20050601);
  random.fill(image, cv::RNG::UNIFORM, 20, 230);
  cv::GaussianBlur(image, image, {5, 5}, 0.0);
  const auto center = Projector(camera).project(kBall).value();
  const double distance = (camera.center() - kBall).norm();
  cv::circle(image, {int(std::lround(center.x())), int(std::lround(center.y()))},
             int(std::lround(camera.intrinsics.focalX * 0.02 / distance)), cv::Scalar(150, 60, 220),
             cv::FILLED);
  return image;
}

/// The same rule as ColorWindow, written straight from the paper.
struct NaiveColorWindow {
  std::vector<Projector> projectors;
  std::vector<cv::Mat> images;
  ColorRange range;

  int matchCount(const cv::Mat& image, int column, int row) const {
    int count = 0;
    for (int y = std::max(row - 2, 0); y <= std::min(row + 2, image.rows - 1); ++y) {
      for (int x = std::max(column - 2, 0); x <= std::min(column + 2, image.cols - 1); ++x) {
        const auto& pixel = image.at<cv::Vec3b>(y, x);
        count += matches(hsiFromBgr(pixel[0], pixel[1], pixel[2]), range) ? 1 : 0;
      }
    }
    return count;
  }

  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      for (std::size_t c = 0; c < images.size(); ++c) {
        const auto pixel = projectors[c].project({rows(i, 0), rows(i, 1), rows(i, 2)});
        const double column = pixel ? std::floor(pixel->x() + 0.5) : -1.0;
        const double row = pixel ? std::floor(pixel->y() + 0.5) : -1.0;
        const bool inside =
            column >= 0.0 && column < images[c].cols && row >= 0.0 && row < images[c].rows;
        const int count = inside ? matchCount(images[c], int(column), int(row)) : 0;
        logLikelihood[i] += std::log(std::max(count, 1) / 25.0);
      }
    }
  }
};

/// A filter that has been following the still ball, with everything an iteration needs.
struct Scene {
  CameraRig rig = paperRig();
  std::vector<cv::Mat> images{paperImage(rig[0]), paperImage(rig[1])};
  ColorWindow product{rig, ColorClassifier(kPink)};
  NaiveColorWindow naive{{Projector(rig[0]), Projector(rig[1])}, images, kPink};
  MotionProposal<IsotropicMotion> proposal{};
  MultinomialResampling resampling;
  ParticleFilter filter;
  ThreadTeam team{1};
  RandomKey key{1, 0, 0};
  Eigen::Index count;

  explicit Scene(Eigen::Index particles) : count(particles) {
    filter.start(kBall.transpose().array().replicate(count, 1));
  }

  StateEstimate iterateProduct() {
    for (std::size_t c = 0; c < images.size(); ++c) {
      product.setImage(c, images[c]); // a new frame for every iteration, as in the paper
    }
    product.prepare(count);
    ++key.frame;
    return filter.iterate(proposal, product, resampling, count, key, team);
  }

  StateEstimate iterateNaive() {
    ++key.frame;
    return filter.iterate(proposal, naive, resampling, count, key, team);
  }
};

/// Both versions must have the same outcome, or comparing their times means nothing.
bool versionsAgree(Eigen::Index particles) {
  Scene product(particles);
  Scene naive(particles);
  for (int i = 0; i < 20; ++i) {
    if ((product.iterateProduct().mean - naive.iterateNaive().mean).norm() > 1e-12) {
      return false;
    }
  }
  return true;
}

void naiveAcosIteration(benchmark::State& state) {
  Scene scene(state.range(0));
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(scene.iterateNaive());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(naiveAcosIteration)->Arg(kPaperParticles)->Arg(10000)->Unit(benchmark::kMicrosecond);

void productIteration(benchmark::State& state) {
  if (!versionsAgree(state.range(0))) {
    state.SkipWithError("the product's estimates differ from the naive version's");
    return;
  }
  Scene scene(state.range(0));
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(scene.iterateProduct());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(productIteration)->Arg(kPaperParticles)->Arg(10000)->Unit(benchmark::kMicrosecond);

void naiveAcosImage(benchmark::State& state) {
  const cv::Mat image = paperImage(paperRig()[0]);
  cv::Mat match(image.size(), CV_8UC1);
  for ([[maybe_unused]] auto _ : state) {
    for (int row = 0; row < image.rows; ++row) {
      for (int column = 0; column < image.cols; ++column) {
        const auto& pixel = image.at<cv::Vec3b>(row, column);
        match.at<std::uint8_t>(row, column) =
            matches(hsiFromBgr(pixel[0], pixel[1], pixel[2]), kPink) ? 255 : 0;
      }
    }
    benchmark::DoNotOptimize(match.data);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(naiveAcosImage)->Unit(benchmark::kMicrosecond);

void productMatchImage(benchmark::State& state) {
  const cv::Mat image = paperImage(paperRig()[0]);
  const ColorClassifier classifier(kPink);
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(matchImage(image, classifier).data);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(productMatchImage)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace dewpoint

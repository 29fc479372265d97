// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/ball_scene.h"

#include "core/color/hsi.h"
#include "core/geometry/projector.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dewpoint::bench {
namespace {

const Eigen::Vector3d kBall(0.35, 0.45, 0.15);
const ColorRange kPink{300.0, 350.0, 0.2, 1.0, 0.15, 0.9};

/// A desk full of colors, with noise, and the ball where the camera sees it.
cv::Mat deskImage(const Camera& camera) {
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

std::vector<cv::Mat> deskImages(const CameraRig& rig) {
  std::vector<cv::Mat> images;
  std::transform(rig.begin(), rig.end(), std::back_inserter(images), deskImage);
  return images;
}

} // namespace

int NaiveColorWindow::matchCount(const cv::Mat& image, int column, int row) const {
  int count = 0;
  for (int y = std::max(row - 2, 0); y <= std::min(row + 2, image.rows - 1); ++y) {
    for (int x = std::max(column - 2, 0); x <= std::min(column + 2, image.cols - 1); ++x) {
      const auto& pixel = image.at<cv::Vec3b>(y, x);
      count += matches(hsiFromBgr(pixel[0], pixel[1], pixel[2]), range) ? 1 : 0;
    }
  }
  return count;
}

void NaiveColorWindow::addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
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

CameraRig paperRig() {
  CameraRig rig(2);
  rig[0].intrinsics = {320, 240, 400.0, 400.0, 159.5, 119.5};
  rig[0].cameraFromWorld = lookAt({0.5, 0.0, 0.195}, kBall);
  rig[1].intrinsics = {240, 320, 400.0, 400.0, 119.5, 159.5};
  rig[1].cameraFromWorld = lookAt({0.07, 0.485, 0.085}, kBall);
  return rig;
}

CameraRig vgaRig(int cameraCount) {
  CameraRig rig(static_cast<std::size_t>(cameraCount));
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * double(i) / double(rig.size()) + 0.3;
    rig[i].intrinsics = {640, 480, 640.0, 640.0, 319.5, 239.5};
    rig[i].cameraFromWorld =
        lookAt(kBall + Eigen::Vector3d(0.9 * std::cos(angle), 0.9 * std::sin(angle), 0.3), kBall);
  }
  return rig;
}

BallScene::BallScene(const CameraRig& cameras, Eigen::Index particles, int threads)
    : rig(cameras), images(deskImages(rig)),
      product(rig, ColorClassifier(kPink)), naive{{rig.begin(), rig.end()}, images, kPink},
      team(threads), count(particles) {
  filter.start(kBall.transpose().array().replicate(count, 1));
  showFrame();
}

void BallScene::showFrame(int iterations) {
  for (std::size_t c = 0; c < images.size(); ++c) {
    product.setImage(c, images[c]);
  }
  product.prepare(count * iterations);
}

StateEstimate BallScene::iterateColorWindow() {
  ++key.frame;
  return filter.iterate(proposal, product, resampling, count, key, team);
}

StateEstimate BallScene::iterateNaive() {
  ++key.frame;
  return filter.iterate(proposal, naive, resampling, count, key, team);
}

bool versionsAgree(const CameraRig& rig, Eigen::Index particles, int iterations) {
  BallScene fast(rig, particles);
  BallScene slow(rig, particles);
  for (int i = 0; i < iterations; ++i) {
    fast.showFrame();
    if ((fast.iterateColorWindow().mean - slow.iterateNaive().mean).norm() > 1e-12) {
      return false;
    }
  }
  return true;
}

} // namespace dewpoint::bench

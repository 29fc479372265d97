// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/stage.h"

#include "core/simulation/sensor.h"

namespace dewpoint::simulation {
namespace {

/// Puts the parts of a body of parts into the world, around the body's center.
void addParts(const StageBody& body, double time, Body& result) {
  result.parts = body.partsAt(time);
  for (MovingPart& part : result.parts) {
    part.center += result.center;
  }
}

std::vector<Body> bodiesAt(const Stage& stage, double time) {
  std::vector<Body> bodies;
  bodies.reserve(stage.bodies.size());
  for (const StageBody& body : stage.bodies) {
    bodies.push_back({body.box, body.path(time).cast<float>(), static_cast<float>(body.bound()),
                      body.color.cast<float>(), body.halfSize.cast<float>(),
                      body.axes.cast<float>(), body.presentAt(time)});
    addParts(body, time, bodies.back());
  }
  return bodies;
}

const CameraView& viewAt(const Stage& stage, std::size_t camera, double time) {
  for (const MovedCamera& move : stage.moves) {
    if (move.camera == camera && time >= move.since) {
      return *move.view;
    }
  }
  return *stage.views.at(camera);
}

/// The light at the sensor, before noise.
cv::Mat exposed(const Stage& stage, std::size_t camera, double time) {
  const CameraView& view = viewAt(stage, camera, time);
  const Light light = stage.light ? stage.light(camera, time) : Light{};
  if (light.dark) {
    return cv::Mat::zeros(view.height, view.width, CV_32FC3);
  }
  cv::Mat image = view.background.clone();
  paintBodies(
      view, [&](double instant) { return bodiesAt(stage, instant); }, {time, stage.exposureSeconds},
      image);
  if (light.gain != Eigen::Vector3d::Ones()) {
    const cv::Scalar gain(light.gain[0], light.gain[1], light.gain[2], 0.0);
    cv::multiply(image, gain, image);
  }
  if (!stage.unevenness.empty()) {
    cv::multiply(image, stage.unevenness.at(camera), image);
  }
  return image;
}

} // namespace

std::vector<MovingPart> StageBody::partsAt(double time) const {
  if (!parts) {
    return {};
  }
  std::vector<MovingPart> result = parts(time);
  if (radius != partsRadius) {
    const auto scale = static_cast<float>(radius / partsRadius);
    for (MovingPart& part : result) {
      part.center *= scale;
      part.size *= scale;
    }
  }
  return result;
}

cv::Mat renderStage(const Stage& stage, std::size_t camera, double time, std::int64_t frame) {
  const RandomStream noise(stage.seed, static_cast<std::uint32_t>(frame),
                           static_cast<std::uint32_t>(camera), RandomPurpose::Simulation);
  const cv::Mat image = develop(exposed(stage, camera, time), stage.noiseSigma, noise);
  return stage.jpegQuality > 0 ? throughJpeg(image, stage.jpegQuality) : image;
}

} // namespace dewpoint::simulation

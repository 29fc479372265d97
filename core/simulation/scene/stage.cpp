// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene/stage.h"

#include "core/simulation/people/people_exposure.h"
#include "core/simulation/people/people_painter.h"
#include "core/simulation/sensor/sensor.h"
#include "core/simulation/sensor/tone_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::simulation {
namespace {

/// Puts the parts of a body of parts into the world, around the body's center.
void addParts(const StageBody& body, double time, Body& result) {
  result.parts = body.partsAt(time);
  for (MovingPart& part : result.parts) {
    part.center += result.center;
  }
}

/// The bodies as a camera that has rotated by `rotation` about `eye` sees them. (So small a
/// rotation moves where a body is; how it is turned does not change visibly.)
std::vector<Body> bodiesAt(const Stage& stage, double time, const Eigen::Vector3d& eye,
                           const Eigen::Matrix3d& rotation, const LightField* light) {
  const bool rotated = rotation != Eigen::Matrix3d::Identity();
  std::vector<Body> bodies;
  bodies.reserve(stage.bodies.size());
  for (const StageBody& body : stage.bodies) {
    const Eigen::Vector3d center = body.path(time);
    bodies.push_back(
        {body.isBox, (rotated ? rotatedAbout(eye, rotation, center) : center).cast<float>(),
         static_cast<float>(body.boundingRadius()), body.color.cast<float>(),
         body.halfSize.cast<float>(), body.axes.cast<float>(), body.isPresentAt(time)});
    bodies.back().light = light;
    addParts(body, time, bodies.back());
  }
  return bodies;
}

std::shared_ptr<const RoomView> viewAt(const Stage& stage, std::size_t camera, double time) {
  for (const MovedCamera& move : stage.movedCameras) {
    if (move.camera == camera && time >= move.moveTimeSeconds) {
      return move.view;
    }
  }
  return stage.views.at(camera);
}

const RelitView* relitOf(const Stage& stage, const RoomView& view) {
  const auto found = std::ranges::find_if(
      stage.relitViews, [&](const RelitView& relitView) { return relitView.view.get() == &view; });
  return found != stage.relitViews.end() ? &*found : nullptr;
}

/// The people of the stage at a time, and what they move, by their parts.
std::vector<std::vector<BodyPart>> peopleAt(const Stage& stage, double time) {
  std::vector<std::vector<BodyPart>> people;
  for (const MovableFurniture& piece : stage.furniture) {
    people.push_back(furnitureParts(piece, time));
  }
  for (const Walker& walker : stage.people) {
    if (!walker.isPresentAt(time)) {
      continue;
    }
    people.push_back(bodyParts(walker, time));
  }
  for (std::vector<BodyPart>& parts : people) {
    for (BodyPart& part : parts) {
      part.center.z() += stage.floorHeight;
    }
  }
  return people;
}

/// The room as a camera that has rotated sees it, without the bodies.
cv::Mat roomAt(const Stage& stage, const RoomView& view, double time,
               const Eigen::Matrix3d& rotation, const Shutter& shutter) {
  const RelitView* other = relitOf(stage, view);
  cv::Mat image = other != nullptr ? backgroundAt(view, other->background, stage.illumination, time)
                                   : view.background.clone();
  if (stage.arePeopleMainSubject && other != nullptr) {
    const PeopleLight light{{&stage.illumination, time}, &other->background};
    paintPeopleThroughShutter(
        view, [&](double instant) { return peopleAt(stage, instant); }, light, shutter, image);
  } else {
    paintPeople(view, peopleAt(stage, time), stage.illumination.lampPosition, image);
  }
  return rotation == Eigen::Matrix3d::Identity() ? image : rotatedImage(view, image, rotation);
}

/// The light at the sensor, before noise.
cv::Mat exposed(const Stage& stage, std::size_t camera, double time, const SensorModel& sensor) {
  const auto shown = viewAt(stage, camera, time);
  const RoomView& view = *shown;
  const Light light = stage.light ? stage.light(camera, time) : Light{};
  if (light.isDark) {
    return cv::Mat::zeros(view.height, view.width, CV_32FC3);
  }
  const Eigen::Matrix3d rotation = rotationAt(sensor.drift, time);
  cv::Mat image = roomAt(stage, view, time, rotation, sensor.shutter);
  const LightField field{&stage.illumination, time};
  const LightField* own = stage.illumination.isDefault() ? nullptr : &field;
  const Eigen::Vector3d eye = view.center.cast<double>();
  const auto bodies = [&](double instant) { return bodiesAt(stage, instant, eye, rotation, own); };
  for (const RowBand& band : rowBands(sensor.shutter, view.height)) {
    paintBodies(
        view, bodies,
        {time + band.centerTime, sensor.shutter.exposureSeconds, band.firstRow, band.endRow},
        image);
  }
  if (light.gain != Eigen::Vector3d::Ones()) {
    const cv::Scalar gain(light.gain[0], light.gain[1], light.gain[2], 0.0);
    cv::multiply(image, gain, image);
  }
  if (!stage.illuminationGains.empty()) {
    cv::multiply(image, stage.illuminationGains.at(camera), image);
  }
  return image;
}

/// How much lighter other light makes a background on average, per channel (BGR).
Eigen::Vector3d meanGain(const RoomView& view, const RelitBackground& background) {
  const cv::Scalar before = cv::mean(view.background);
  const cv::Scalar after = cv::mean(background.ambientLight) + cv::mean(background.directLight);
  Eigen::Vector3d gain;
  for (int channel = 0; channel < 3; ++channel) {
    gain[channel] = after[channel] / std::max(1.0, before[channel]);
  }
  return gain;
}

} // namespace

void prepareLight(Stage& stage) {
  stage.relitViews.clear();
  if (stage.illumination.isDefault()) {
    return;
  }
  const auto add = [&](const std::shared_ptr<const RoomView>& view) {
    RelitBackground background = relightBackground(*view, stage.illumination);
    const Eigen::Vector3d gain = meanGain(*view, background);
    stage.relitViews.push_back({view, std::move(background), gain});
  };
  std::ranges::for_each(stage.views, add);
  std::ranges::for_each(stage.movedCameras, add, &MovedCamera::view);
}

Eigen::Vector3d meteredBrightnessStops(const Stage& stage, std::size_t camera, double time) {
  /// Stops of linear light per stop of gray level: the inverse of the tone curve's power.
  constexpr double kStopsPerLevelStop = 1.0 / kToneCurveExponent;
  const Light light = stage.light ? stage.light(camera, time) : Light{};
  if (light.isDark) {
    return Eigen::Vector3d::Constant(kDarkStops);
  }
  constexpr double kLeastGain = 1e-3; // of levels: has a logarithm
  Eigen::Vector3d gain = light.gain;
  if (const RelitView* other = relitOf(stage, *viewAt(stage, camera, time))) {
    gain = gain.cwiseProduct(other->meanGain);
  }
  return kStopsPerLevelStop * gain.array().max(kLeastGain).log2().matrix();
}

std::vector<MovingPart> StageBody::partsAt(double time) const {
  if (!parts) {
    return {};
  }
  std::vector<MovingPart> result = parts(time);
  if (radius != nominalRadius) {
    const auto scale = static_cast<float>(radius / nominalRadius);
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
  SensorModel ideal;
  ideal.shutter.exposureSeconds = stage.exposureSeconds;
  ideal.jpegQuality = stage.jpegQuality;
  const SensorModel& sensor = stage.sensors.empty() ? ideal : stage.sensors.at(camera);
  return sensorImage(exposed(stage, camera, time, sensor), sensor, time, stage.noiseSigma, noise);
}

} // namespace dewpoint::simulation

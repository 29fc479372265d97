// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene/scene_file.h"

#include "core/base/angle.h"
#include "core/base/limits.h"
#include "core/base/table_reader.h"
#include "core/base/units.h"
#include "core/geometry/camera_name.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace dewpoint::simulation {
namespace {

constexpr std::array<std::pair<Motion, const char*>, 4> kMotionNames{{{Motion::Still, "still"},
                                                                      {Motion::Smooth, "smooth"},
                                                                      {Motion::Fast, "fast"},
                                                                      {Motion::Jump, "jump"}}};
/// Larger pictures than this are a typing error, and would fill the memory.
constexpr std::int64_t kMaxSide = 8192;

/// HSI hue (degrees) and saturation of a BGR color (Gonzalez & Woods).
std::array<double, 2> hueAndSaturation(const Eigen::Vector3d& bgr) {
  const double b = bgr[0];
  const double g = bgr[1];
  const double r = bgr[2];
  const double cosine =
      0.5 * ((r - g) + (r - b)) / std::max(1e-9, std::sqrt((r - g) * (r - g) + (r - b) * (g - b)));
  const double angle = inDegrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
  return {b <= g ? angle : 360.0 - angle, 1.0 - 3.0 * bgr.minCoeff() / std::max(1e-9, bgr.sum())};
}

/// A ball of another color than the default's needs other ranges: the same margins around it.
void rangesFromColor(SceneBall& ball) {
  const auto [hue, saturation] = hueAndSaturation(ball.color);
  ball.hueMin = std::fmod(hue + 344.0, 360.0);
  ball.hueMax = std::fmod(hue + 16.0, 360.0);
  ball.saturationMin = std::max(0.0, saturation - 0.2);
  ball.saturationMax = std::min(1.0, saturation + 0.2);
}

void readRange(TableReader& reader, const char* key, double& low, double& high, double limit) {
  std::array<double, 2> range{low, high};
  if (reader.readNumbers(key, range.data(), 2, 0.0, limit)) {
    low = range[0];
    high = range[1];
  }
}

Result<SceneBall> readBall(const toml::table& table, const std::string& file, std::size_t index) {
  TableReader reader(table, file, fmt::format("ball {}.", index + 1));
  SceneBall ball;
  reader.readText("name", ball.name);
  reader.readNumber("radius", ball.radius, 0.001, 10.0);
  Eigen::Vector3d rgb = ball.color.reverse();
  if (reader.readNumbers("color", rgb.data(), 3, 0.0, 255.0)) {
    ball.color = rgb.reverse();
    rangesFromColor(ball);
  }
  std::string motion = "smooth";
  reader.readText("motion", motion);
  const auto* known =
      std::ranges::find_if(kMotionNames, [&](const auto& entry) { return motion == entry.second; });
  if (known == kMotionNames.end()) {
    reader.fail(ErrorCode::BadValue, "motion",
                fmt::format("\"{}\" is not one of still, smooth, fast, jump", motion));
  } else {
    ball.motion = known->first;
  }
  reader.readNumbers("position", ball.position.data(), 3);
  reader.readNumbers("extent", ball.pathHalfSize.data(), 3);
  reader.readNumber("period", ball.period, 1e-3, 1e6);
  reader.readNumber("still_seconds", ball.stillSeconds, 0.0, 1e6);
  readRange(reader, "hue", ball.hueMin, ball.hueMax, 360.0);
  readRange(reader, "saturation", ball.saturationMin, ball.saturationMax, 1.0);
  readRange(reader, "intensity", ball.intensityMin, ball.intensityMax, 1.0);
  if (auto error = reader.finish()) {
    return tl::make_unexpected(std::move(*error));
  }
  return ball;
}

Result<SceneLight> readLight(const toml::table& table, const std::string& file, std::size_t index) {
  TableReader reader(table, file, fmt::format("light {}.", index + 1));
  SceneLight light;
  reader.readNumber("time", light.time, 0.0, 1e9);
  reader.readNumber("brightness", light.brightness, 0.01, 100.0);
  reader.readNumber("kelvin", light.colorTemperature, 1000.0, 40000.0);
  if (auto error = reader.finish()) {
    return tl::make_unexpected(std::move(*error));
  }
  return light;
}

/// The pose: `position` with either `rotation` (the camera's axes in the world, row by row) or
/// `target` and, if wanted, `roll` in degrees.
void readPose(TableReader& reader, Camera& camera) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  reader.require("position");
  reader.readNumbers("position", position.data(), 3);
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation;
  Eigen::Vector3d target;
  double roll = 0.0;
  reader.readNumber("roll", roll, -360.0, 360.0);
  const bool aimed = reader.readNumbers("target", target.data(), 3);
  if (reader.readNumbers("rotation", rotation.data(), 9)) {
    if (aimed || reader.has("roll")) {
      reader.fail(ErrorCode::BadValue, "rotation",
                  "rotation cannot be used together with target or roll");
    } else if (!rotation.isUnitary(1e-6) || rotation.determinant() < 0.0) {
      reader.fail(ErrorCode::BadValue, "rotation", "not a rotation matrix");
    }
    camera.cameraFromWorld.linear() = rotation;
    camera.cameraFromWorld.translation() = -(rotation * position);
  } else if (aimed && (target - position).norm() > 1e-9) {
    // A camera that looks straight up or down has no "up" of the world in its image: take Y.
    const bool steep = (target - position).head<2>().norm() < 1e-6;
    camera.cameraFromWorld =
        lookAt(position, target, steep ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ(),
               roll * kDegree);
  } else {
    reader.fail(aimed ? ErrorCode::BadValue : ErrorCode::MissingKey, "target",
                aimed ? "is the position itself" : "or rotation");
  }
}

Result<Camera> readCamera(const toml::table& table, const std::string& file, std::size_t index) {
  TableReader reader(table, file, fmt::format("camera {}.", index + 1));
  Camera camera;
  camera.name = defaultCameraName(index);
  Intrinsics& lens = camera.intrinsics;
  reader.readText("name", camera.name);
  for (const char* key : {"width", "height", "focal"}) {
    reader.require(key);
  }
  reader.readInteger("width", lens.width, 1, kMaxSide);
  reader.readInteger("height", lens.height, 1, kMaxSide);
  std::array<double, 2> focal{};
  if (reader.readNumbers("focal", focal.data(), 2, 1e-3, 1e6)) {
    lens.focalX = focal[0];
    lens.focalY = focal[1];
  }
  std::array<double, 2> center{(lens.width - 1) / 2.0, (lens.height - 1) / 2.0};
  reader.readNumbers("center", center.data(), 2);
  lens.centerX = center[0];
  lens.centerY = center[1];
  reader.readNumbers("distortion", camera.distortion.data(), camera.distortion.size());
  bool fisheye = false;
  reader.readBoolean("fisheye", fisheye);
  camera.lens = fisheye ? LensModel::Fisheye : LensModel::Pinhole;
  readPose(reader, camera);
  if (auto error = reader.finish()) {
    return tl::make_unexpected(std::move(*error));
  }
  return camera;
}

/// Reads every table of `tables` with `read` into `items`, unless there are none.
template <class Item, class Read>
Status readAll(const std::vector<const toml::table*>& tables, const std::string& file,
               std::vector<Item>& items, Read read) {
  if (tables.empty()) {
    return {};
  }
  items.clear();
  for (const toml::table* table : tables) {
    auto item = read(*table, file, items.size());
    if (!item) {
      return tl::make_unexpected(std::move(item.error()));
    }
    items.push_back(std::move(*item));
  }
  return {};
}

/// All images of one instant are rendered and kept at the same time.
Status checkPixels(const CameraRig& cameras, const std::string& file) {
  std::int64_t pixels = 0;
  for (const Camera& camera : cameras) {
    pixels += std::int64_t{camera.intrinsics.width} * camera.intrinsics.height;
  }
  return pixels <= limits::kMaxImagePixels
             ? Status()
             : failure(ErrorCode::BadValue, file, "camera",
                       fmt::format("{} pixels in all images together; at most {} are possible",
                                   pixels, limits::kMaxImagePixels));
}

Result<Scene> readScene(const toml::table& table, const std::string& file) {
  TableReader reader(table, file, "");
  Scene scene = demoScene();
  reader.readText("name", scene.name);
  reader.readNumber("frames_per_second", scene.framesPerSecond, 1e-3, 1e5);
  reader.readInteger("frame_count", scene.frameCount, 1, 100'000'000);
  reader.readInteger("seed", scene.seed, std::numeric_limits<std::int64_t>::min(),
                     std::numeric_limits<std::int64_t>::max());
  reader.readInteger("look_alikes", scene.distractorCount, 0, kMaxDistractors);
  reader.readBoolean("occluder", scene.hasOccluder);
  reader.readBoolean("clutter", scene.hasClutter);
  reader.readNumber("noise_sigma", scene.noiseSigma, 0.0, 100.0);
  reader.readNumber("exposure_seconds", scene.exposureSeconds, 0.0, 10.0);
  const auto balls = reader.findTables("ball", limits::kMaxTargets);
  const auto cameras = reader.findTables("camera", limits::kMaxCameras);
  const auto lights = reader.findTables("light", limits::kMaxTargets);
  if (auto error = reader.finish()) {
    return tl::make_unexpected(std::move(*error));
  }
  Status status = readAll(balls, file, scene.balls, readBall);
  if (status) {
    status = readAll(cameras, file, scene.cameras, readCamera);
  }
  if (status) {
    status = readAll(lights, file, scene.lights, readLight);
    std::ranges::stable_sort(scene.lights, {}, &SceneLight::time);
  }
  if (status) {
    status = checkPixels(scene.cameras, file);
  }
  if (!status) {
    return tl::make_unexpected(std::move(status.error()));
  }
  return scene;
}

template <class Vector> toml::array arrayOf(const Vector& values) {
  toml::array array;
  for (const double value : values) {
    array.push_back(value);
  }
  return array;
}

toml::table ballTable(const SceneBall& ball) {
  const auto* motion = std::ranges::find_if(
      kMotionNames, [&](const auto& entry) { return ball.motion == entry.first; });
  return toml::table{
      {"name", ball.name},
      {"radius", ball.radius},
      {"color", toml::array{ball.color[2], ball.color[1], ball.color[0]}},
      {"motion", motion->second},
      {"position", arrayOf(ball.position)},
      {"extent", arrayOf(ball.pathHalfSize)},
      {"period", ball.period},
      {"still_seconds", ball.stillSeconds},
      {"hue", toml::array{ball.hueMin, ball.hueMax}},
      {"saturation", toml::array{ball.saturationMin, ball.saturationMax}},
      {"intensity", toml::array{ball.intensityMin, ball.intensityMax}},
  };
}

toml::table cameraTable(const Camera& camera) {
  const Intrinsics& lens = camera.intrinsics;
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation = camera.cameraFromWorld.linear();
  return toml::table{
      {"name", camera.name},
      {"width", lens.width},
      {"height", lens.height},
      {"focal", toml::array{lens.focalX, lens.focalY}},
      {"center", toml::array{lens.centerX, lens.centerY}},
      {"distortion", arrayOf(camera.distortion)},
      {"fisheye", camera.lens == LensModel::Fisheye},
      {"position", arrayOf(camera.center())},
      {"rotation", arrayOf(rotation.reshaped<Eigen::RowMajor>())},
  };
}

} // namespace

Result<Scene> parseScene(const std::string& text, const std::string& file) {
  return parseToml(text, file).and_then([&](const toml::table& table) {
    return readScene(table, file);
  });
}

std::string sceneToml(const Scene& scene) {
  toml::array balls;
  for (const SceneBall& ball : scene.balls) {
    balls.push_back(ballTable(ball));
  }
  toml::array cameras;
  for (const Camera& camera : scene.cameras) {
    cameras.push_back(cameraTable(camera));
  }
  toml::array lights;
  for (const SceneLight& light : scene.lights) {
    lights.push_back(toml::table{{"time", light.time},
                                 {"brightness", light.brightness},
                                 {"kelvin", light.colorTemperature}});
  }
  toml::table table{
      {"name", scene.name},
      {"frames_per_second", scene.framesPerSecond},
      {"frame_count", scene.frameCount},
      {"seed", static_cast<std::int64_t>(scene.seed)},
      {"look_alikes", scene.distractorCount},
      {"occluder", scene.hasOccluder},
      {"clutter", scene.hasClutter},
      {"noise_sigma", scene.noiseSigma},
      {"exposure_seconds", scene.exposureSeconds},
      {"ball", balls},
      {"camera", cameras},
  };
  if (!lights.empty()) {
    table.insert("light", lights);
  }
  std::ostringstream stream;
  stream << table << '\n';
  return stream.str();
}

} // namespace dewpoint::simulation

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/camera_calibration.h"

#include "core/base/limits.h"
#include "core/base/table_reader.h"
#include "core/geometry/rotation_check.h"
#include "core/geometry/rotation_vector.h"

#include <cmath>

namespace dewpoint::calibration {
namespace {

/// Limit of a coefficient or unit: larger ones are mistakes.
constexpr double kLargest = 1e9;

/// A 3x3 array of numbers under `key`.
bool readMatrix(TableReader& reader, const char* key, Eigen::Matrix3d& matrix) {
  const toml::node* node = reader.findNode(key);
  const toml::array* rows = node != nullptr ? node->as_array() : nullptr;
  bool good = rows != nullptr && rows->size() == 3;
  for (std::size_t row = 0; good && row < 3; ++row) {
    const toml::array* columns = (*rows)[row].as_array();
    good = columns != nullptr && columns->size() == 3;
    for (std::size_t column = 0; good && column < 3; ++column) {
      const auto value = tomlNumber((*columns)[column]);
      good = value.has_value();
      matrix(static_cast<int>(row), static_cast<int>(column)) = value.value_or(0.0);
    }
  }
  if (!good) {
    reader.fail(node != nullptr ? ErrorCode::WrongType : ErrorCode::MissingKey, key,
                "three rows of three numbers are expected");
  } else if (!matrix.allFinite()) {
    reader.fail(ErrorCode::BadValue, key, "a number is not finite");
    good = false;
  } else if (matrix.cwiseAbs().maxCoeff() > kLargest) {
    reader.fail(ErrorCode::BadValue, key, fmt::format("a number is larger than {}", kLargest));
    good = false;
  }
  return good;
}

void readIntrinsics(TableReader& reader, Intrinsics& intrinsics) {
  double size[2] = {};
  reader.require("size");
  if (reader.readNumbers("size", size, 2, 1, limits::kMaxImageSide)) {
    intrinsics.width = static_cast<int>(size[0]);
    intrinsics.height = static_cast<int>(size[1]);
    if (intrinsics.width != size[0] || intrinsics.height != size[1]) {
      reader.fail(ErrorCode::BadValue, "size", "whole pixels are expected");
    } else if (!limits::isImageSize(intrinsics.width, intrinsics.height)) {
      reader.fail(ErrorCode::BadValue, "size",
                  fmt::format("{} x {} pixels are more than {}", intrinsics.width,
                              intrinsics.height, limits::kMaxImagePixels));
    }
  }
  Eigen::Matrix3d matrix;
  if (!readMatrix(reader, "matrix", matrix)) {
    return;
  }
  if (matrix(0, 0) <= 0.0 || matrix(1, 1) <= 0.0) {
    reader.fail(ErrorCode::BadValue, "matrix",
                fmt::format("the focal length must be positive, found {} and {}", matrix(0, 0),
                            matrix(1, 1)));
  } else if (matrix(0, 1) != 0.0 || matrix(1, 0) != 0.0 || matrix(2, 0) != 0.0 ||
             matrix(2, 1) != 0.0 || matrix(2, 2) != 1.0) {
    reader.fail(ErrorCode::BadValue, "matrix",
                "expected [[fx, 0, cx], [0, fy, cy], [0, 0, 1]] without skew");
  }
  intrinsics.focalX = matrix(0, 0);
  intrinsics.focalY = matrix(1, 1);
  intrinsics.centerX = matrix(0, 2);
  intrinsics.centerY = matrix(1, 2);
}

void readDistortion(TableReader& reader, bool fisheye, std::array<double, 8>& distortion) {
  const toml::node* node = reader.findNode("distortions");
  if (node == nullptr) {
    return;
  }
  const toml::array* array = node->as_array();
  const std::size_t count = array != nullptr ? array->size() : 1;
  if (count != 0 && count != 4 && count != 5 && count != 8) {
    reader.fail(ErrorCode::WrongType, "distortions", "0, 4, 5 or 8 numbers are expected");
    return;
  }
  if (fisheye && count > 4) {
    reader.fail(ErrorCode::BadValue, "distortions", "a fisheye has four coefficients");
  } else if (count > 0) {
    reader.readNumbers("distortions", distortion.data(), count, -kLargest, kLargest);
  }
}

void readRotation(TableReader& reader, Camera& camera) {
  const toml::node* node = reader.findNode("rotation");
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  if (array != nullptr && array->size() == 3 && (*array)[0].is_array()) {
    Eigen::Matrix3d matrix;
    if (readMatrix(reader, "rotation", matrix)) {
      if (const auto rotation = checkedRotation(matrix)) {
        camera.cameraFromWorld.linear() = *rotation;
      } else {
        reader.fail(ErrorCode::BadValue, "rotation", rotation.error());
      }
    }
    return;
  }
  reader.require("rotation");
  Eigen::Vector3d vector;
  if (reader.readNumbers("rotation", vector.data(), 3, -100, 100)) {
    camera.cameraFromWorld.linear() = rotationFromVector(vector);
  }
}

} // namespace

Result<Camera> cameraFromToml(const toml::table& table, const std::string& file,
                              const std::string& prefix,
                              std::initializer_list<const char*> ignoredKeys) {
  Camera camera;
  TableReader reader(table, file, prefix);
  for (const char* key : ignoredKeys) {
    reader.findNode(key);
  }
  reader.readText("name", camera.name);
  readIntrinsics(reader, camera.intrinsics);
  bool fisheye = false;
  reader.readBoolean("fisheye", fisheye);
  camera.lens = fisheye ? LensModel::Fisheye : LensModel::Pinhole;
  readDistortion(reader, fisheye, camera.distortion);
  readRotation(reader, camera);
  double unit = 1.0;
  reader.readNumber("unit", unit, 1e-9, kLargest);
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  reader.require("translation");
  reader.readNumbers("translation", translation.data(), 3, -kLargest, kLargest);
  camera.cameraFromWorld.translation() = unit * translation;
  if (!(camera.cameraFromWorld.translation().cwiseAbs().maxCoeff() <= kLargest)) {
    reader.fail(ErrorCode::BadValue, "translation", fmt::format("more than {} m", kLargest));
  }
  if (auto error = reader.finish()) {
    return tl::make_unexpected(std::move(*error));
  }
  return camera;
}

namespace {

std::string rotationText(const Eigen::Matrix3d& rotation, RotationForm form) {
  const auto row = [](const auto& values) {
    return fmt::format("[{}, {}, {}]", values(0), values(1), values(2));
  };
  if (form == RotationForm::Vector) {
    return row(vectorFromRotation(rotation));
  }
  return fmt::format("[{}, {}, {}]", row(rotation.row(0)), row(rotation.row(1)),
                     row(rotation.row(2)));
}

} // namespace

std::string cameraToToml(const Camera& camera, RotationForm form) {
  const auto& in = camera.intrinsics;
  const auto& d = camera.distortion;
  const bool rational = d[5] != 0.0 || d[6] != 0.0 || d[7] != 0.0;
  const bool fisheye = camera.lens == LensModel::Fisheye;
  const int coefficients = fisheye ? 4 : rational ? 8 : 5;
  const Eigen::Vector3d translation = camera.cameraFromWorld.translation();
  return fmt::format("size = [{}, {}]\n"
                     "matrix = [[{}, 0.0, {}], [0.0, {}, {}], [0.0, 0.0, 1.0]]\n"
                     "distortions = [{}]\n{}"
                     "rotation = {}\n"
                     "translation = [{}, {}, {}]\n",
                     in.width, in.height, in.focalX, in.centerX, in.focalY, in.centerY,
                     fmt::join(d.begin(), d.begin() + coefficients, ", "),
                     fisheye ? "fisheye = true\n" : "",
                     rotationText(camera.cameraFromWorld.linear(), form), translation.x(),
                     translation.y(), translation.z());
}

} // namespace dewpoint::calibration

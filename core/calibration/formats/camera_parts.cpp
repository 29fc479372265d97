// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/camera_parts.h"

#include "core/base/limits.h"
#include "core/geometry/rotation_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

/// As in our own files, so that what was read can be written.
constexpr double kLargestNumber = 1e9;

std::string sizeFault(const CameraParts& parts) {
  const auto whole = [](double value) {
    return value >= 1.0 && value <= limits::kMaxImageSide && value == std::floor(value);
  };
  if (!whole(parts.width) || !whole(parts.height)) {
    return fmt::format("the image size must be whole pixels, 1 to {}, found {} x {}",
                       limits::kMaxImageSide, parts.width, parts.height);
  }
  return limits::isImageSize(std::int64_t(parts.width), std::int64_t(parts.height))
             ? ""
             : fmt::format("{} x {} pixels are more than {}", parts.width, parts.height,
                           limits::kMaxImagePixels);
}

std::string matrixFault(const Eigen::Matrix3d& matrix) {
  if (!matrix.allFinite()) {
    return "a number is not finite";
  }
  if (matrix.cwiseAbs().maxCoeff() > kLargestNumber) {
    return fmt::format("a number is larger than {}", kLargestNumber);
  }
  if (matrix(0, 0) <= 0.0 || matrix(1, 1) <= 0.0) {
    return fmt::format("the focal length must be positive, found {} and {}", matrix(0, 0),
                       matrix(1, 1));
  }
  if (matrix(0, 1) != 0.0 || matrix(1, 0) != 0.0 || matrix(2, 0) != 0.0 || matrix(2, 1) != 0.0 ||
      matrix(2, 2) != 1.0) {
    return "expected [[fx, 0, cx], [0, fy, cy], [0, 0, 1]] without skew";
  }
  return "";
}

std::string distortionFault(const CameraParts& parts) {
  const auto& values = parts.distortion;
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
    return "a number is not finite";
  }
  if (std::ranges::any_of(values, [](double value) { return std::abs(value) > kLargestNumber; })) {
    return fmt::format("a number is larger than {}", kLargestNumber);
  }
  if (parts.lens == LensModel::Fisheye) {
    return values.size() == 4 ? "" : "a fisheye has four coefficients";
  }
  if (values.size() > 8 &&
      std::any_of(values.begin() + 8, values.end(), [](double value) { return value != 0.0; })) {
    return "thin prism or tilted sensor terms are not supported, only k1 k2 p1 p2 k3 k4 k5 k6";
  }
  const std::size_t count = values.size();
  return count == 0 || count == 2 || count == 4 || count == 5 || count >= 8
             ? ""
             : fmt::format("4, 5 or 8 coefficients are expected, found {}", count);
}

} // namespace

Result<Camera> checkedCamera(const CameraParts& parts, const std::string& file,
                             const CameraFieldNames& fields) {
  const auto fault = [&](const std::string& field, std::string detail) {
    return failure(ErrorCode::BadValue, file, field, std::move(detail));
  };
  if (auto text = sizeFault(parts); !text.empty()) {
    return fault(fields.size, std::move(text));
  }
  if (auto text = matrixFault(parts.matrix); !text.empty()) {
    return fault(fields.matrix, std::move(text));
  }
  if (auto text = distortionFault(parts); !text.empty()) {
    return fault(fields.distortion, std::move(text));
  }
  const auto rotation = checkedRotation(parts.rotation);
  if (!rotation) {
    return fault(fields.rotation, rotation.error());
  }
  if (!parts.translation.allFinite()) {
    return fault(fields.translation, "a number is not finite");
  }
  Camera camera;
  camera.name = parts.name;
  camera.intrinsics = {int(parts.width),   int(parts.height),  parts.matrix(0, 0),
                       parts.matrix(1, 1), parts.matrix(0, 2), parts.matrix(1, 2)};
  camera.lens = parts.lens;
  std::copy_n(parts.distortion.begin(), std::min<std::size_t>(parts.distortion.size(), 8),
              camera.distortion.begin());
  camera.cameraFromWorld.linear() = *rotation;
  camera.cameraFromWorld.translation() = parts.translation;
  return camera;
}

Eigen::Matrix3d matrixOf(double focalX, double focalY, double centerX, double centerY) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(0, 0) = focalX;
  matrix(1, 1) = focalY;
  matrix(0, 2) = centerX;
  matrix(1, 2) = centerY;
  return matrix;
}

Eigen::Matrix3d matrixOf(const Intrinsics& in) {
  return matrixOf(in.focalX, in.focalY, in.centerX, in.centerY);
}

std::vector<double> trimmedDistortion(const Camera& camera, int fewest) {
  const auto& d = camera.distortion;
  std::size_t count = 4;
  if (camera.lens == LensModel::Pinhole) {
    count = d[5] != 0.0 || d[6] != 0.0 || d[7] != 0.0 ? 8 : d[4] != 0.0 ? 5 : 4;
    count = std::max(count, std::size_t(fewest));
  }
  return {d.begin(), d.begin() + std::ptrdiff_t(count)};
}

} // namespace dewpoint::calibration

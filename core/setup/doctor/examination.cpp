// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/examination.h"

#include "core/capture/image_shape.h"
#include "core/geometry/camera_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::setup {

bool Examination::hasFinding(FindingKind kind) const {
  return std::ranges::find(findings, kind, &Finding::kind) != findings.end();
}

std::string Examination::nameOf(std::size_t camera) const {
  return quotedCameraName(geometry::nameOrNumber(project.cameras[camera].camera, camera));
}

std::string cameraKey(std::size_t camera, const char* key) {
  return fmt::format("camera {}.{}", camera + 1, key);
}

std::string messageWithoutFile(const Error& error) {
  return error.detail.empty() ? std::string(errorPhrase(error.code)) : error.detail;
}

} // namespace dewpoint::setup

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/examination.h"

#include "core/capture/picture.h"
#include "core/geometry/camera_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::setup {

bool Examination::has(FindingKind kind) const {
  return std::ranges::find(findings, kind, &Finding::kind) != findings.end();
}

std::string Examination::nameOf(std::size_t camera) const {
  const std::string& name = project.cameras[camera].camera.name;
  return cameraField(name.empty() ? geometry::defaultCameraName(camera) : name);
}

std::string cameraKey(std::size_t camera, const char* key) {
  return fmt::format("camera {}.{}", camera + 1, key);
}

std::string withoutFile(const Error& error) {
  return error.detail.empty() ? std::string(phrase(error.code)) : error.detail;
}

} // namespace dewpoint::setup

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_adaptation.h"

#include "core/geometry/image_symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace dewpoint::calibration {
namespace {

constexpr std::pair<const char*, SizeFit> kFits[] = {{"crop", SizeFit::Crop},
                                                     {"trim", SizeFit::Trim},
                                                     {"scale", SizeFit::Scale},
                                                     {"rotate-90", SizeFit::Rotate90},
                                                     {"rotate-270", SizeFit::Rotate270}};

std::string imageSizeText(const Intrinsics& in) {
  return fmt::format("{} x {}", in.width, in.height);
}

Intrinsics scaled(const Intrinsics& in, int width, int height) {
  const double x = double(width) / in.width;
  const double y = double(height) / in.height;
  return {width,
          height,
          x * in.focalX,
          y * in.focalY,
          x * (in.centerX + 0.5) - 0.5,
          y * (in.centerY + 0.5) - 0.5};
}

const char* participle(SizeFit fit) {
  switch (fit) {
  case SizeFit::Crop:
  case SizeFit::Trim:
    return "cropped";
  case SizeFit::Scale:
    return "scaled";
  case SizeFit::Rotate90:
  case SizeFit::Rotate270:
    break;
  }
  return "rotated";
}

} // namespace

std::optional<SizeFit> parseSizeFit(const std::string& text) {
  const auto found = std::ranges::find(kFits, text, &std::pair<const char*, SizeFit>::first);
  return found == std::end(kFits) ? std::nullopt : std::optional(found->second);
}

Result<Camera> fittedToSize(const Camera& camera, int width, int height, SizeFit fit) {
  Camera result = camera;
  Intrinsics& in = result.intrinsics;
  switch (fit) {
  case SizeFit::Crop:
    in.centerX -= 0.5 * (in.width - width);
    in.centerY -= 0.5 * (in.height - height);
    in.width = width;
    in.height = height;
    break;
  case SizeFit::Trim:
    in.width = width;
    in.height = height;
    break;
  case SizeFit::Scale:
    in = scaled(in, width, height);
    break;
  case SizeFit::Rotate90:
  case SizeFit::Rotate270:
    result = transformed({fit == SizeFit::Rotate90 ? 90 : 270, false}, camera);
    break;
  }
  if (in.width != width || in.height != height) {
    return failure(ErrorCode::Mismatch, "", camera.name,
                   fmt::format("a rotated calibration is for images of {} pixels, not {} x {}",
                               imageSizeText(in), width, height));
  }
  if (in.centerX < 0.0 || in.centerY < 0.0 || in.centerX > width || in.centerY > height) {
    return failure(ErrorCode::Mismatch, "", camera.name,
                   fmt::format("its principal point {:.1f}, {:.1f} would lie outside the image of "
                               "{} x {} pixels",
                               in.centerX, in.centerY, width, height));
  }
  return result;
}

std::string sizeFitSentence(const Camera& before, const Camera& after, SizeFit fit) {
  return fmt::format("{}: {} from {} to {} pixels.", after.name, participle(fit),
                     imageSizeText(before.intrinsics), imageSizeText(after.intrinsics));
}

Result<CameraRenaming> parseCameraRenaming(const std::vector<std::string>& texts) {
  CameraRenaming names;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
      return failure(ErrorCode::BadValue, "", "--map",
                     fmt::format("'{}' is not of the form NAME=NAME IN THE FILE", text));
    }
    if (!names.emplace(text.substr(0, equals), text.substr(equals + 1)).second) {
      return failure(ErrorCode::BadValue, "", "--map",
                     fmt::format("'{}' appears twice", text.substr(0, equals)));
    }
  }
  return names;
}

Status renameCameras(CameraRig& rig, const CameraRenaming& names, const std::string& file) {
  std::vector<std::pair<std::size_t, std::string>> changes;
  for (const auto& [name, inFile] : names) {
    const auto found = std::ranges::find(rig, inFile, &Camera::name);
    if (found == rig.end()) {
      return failure(ErrorCode::NotFound, file, inFile,
                     fmt::format("the file has the cameras {}", quotedNames(rig)));
    }
    changes.emplace_back(found - rig.begin(), name);
  }
  for (const auto& [camera, name] : changes) {
    rig[camera].name = name;
  }
  std::set<std::string> seen;
  for (const Camera& camera : rig) {
    if (!changes.empty() && !seen.insert(camera.name).second) {
      return failure(ErrorCode::BadValue, file, camera.name,
                     "two cameras would have this name after the renaming");
    }
  }
  return {};
}

std::string quotedNames(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "'" : ", '") + name + "'";
  }
  return text;
}

std::string quotedNames(const CameraRig& rig) {
  std::vector<std::string> names;
  std::ranges::transform(rig, std::back_inserter(names), &Camera::name);
  return quotedNames(names);
}

} // namespace dewpoint::calibration

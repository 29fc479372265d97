// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/experiment/clips/clip_sources.h"
#include "core/experiment/clips/clip_table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace dewpoint::experiment {
namespace {

using BandJson = nlohmann::json;

constexpr double kBandRate = 30.0; // frames per second, of the recording's notes
/// The cameras are eight baselines away from the man: half a pixel is 4 cm of depth there.
constexpr double kBandStartHalf = 0.3; // meters; chosen
// Pixels, of the recording.
constexpr int kBandImageWidth = 640;
constexpr int kBandImageHeight = 480;

/// A band and the click on it in the first frame of the left camera, pixels.
struct Band {
  const char* name;
  double x;
  double y;
};
constexpr std::array<Band, 3> kBands{
    {{"yellow", 314.0, 325.0}, {"blue", 369.0, 353.0}, {"pink", 245.0, 303.0}}};

Eigen::Matrix3d matrixOf(const BandJson& rows) {
  Eigen::Matrix3d matrix;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          rows.at(row).at(column).get<double>();
    }
  }
  return matrix;
}

Camera bandCamera(const std::string& name, const BandJson& matrix, const BandJson& distortion) {
  const Eigen::Matrix3d k = matrixOf(matrix);
  Camera camera;
  camera.name = name;
  camera.intrinsics = {kBandImageWidth, kBandImageHeight, k(0, 0), k(1, 1), k(0, 2), k(1, 2)};
  for (std::size_t item = 0; item < std::min(distortion.size(), camera.distortion.size()); ++item) {
    camera.distortion[item] = distortion.at(item).get<double>();
  }
  return camera;
}

/// World: the left camera's center, x to its right, y along its optical axis, z up in its image.
Result<CameraRig> bandRig(const std::filesystem::path& file) {
  const auto text = readTextFile(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  try {
    const BandJson pair = BandJson::parse(*text).at("videos_18h");
    Camera left = bandCamera("left", pair.at("K_left"), pair.at("dist_left"));
    Camera right = bandCamera("right", pair.at("K_right"), pair.at("dist_right"));
    Eigen::Matrix3d leftFromWorld;
    leftFromWorld << 1.0, 0.0, 0.0, //
        0.0, 0.0, -1.0,             //
        0.0, 1.0, 0.0;
    left.cameraFromWorld.linear() = leftFromWorld;
    right.cameraFromWorld.linear() = matrixOf(pair.at("R")) * leftFromWorld;
    const BandJson& direction = pair.at("T_unit");
    right.cameraFromWorld.translation() =
        kBandBaseline * Eigen::Vector3d(direction.at(0).get<double>(),
                                        direction.at(1).get<double>(),
                                        direction.at(2).get<double>());
    return CameraRig{std::move(left), std::move(right)};
  } catch (const BandJson::exception& problem) {
    return failure(ErrorCode::NotParsed, file.string(), "videos_18h", problem.what());
  }
}

} // namespace

Result<CalibratedClip> bandsClip(const ClipFolders& folders) {
  const auto folder = folders.recordings / "tapes2_limbs";
  auto rig = bandRig(folder / "calib_scout.json");
  if (!rig) {
    return tl::make_unexpected(rig.error());
  }
  const auto table = readClipTable(folder / "tapes_180349_scout.csv",
                                   {"frame", "left_u", "left_v", "right_u", "right_v"}, "color");
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  if (const Status whole = checkFrameColumns(*table, {"frame"}, folder / "tapes_180349_scout.csv");
      !whole) {
    return tl::make_unexpected(whole.error());
  }
  CalibratedClip clip;
  clip.name = "R1-bands";
  clip.rig = std::move(*rig);
  clip.cameraPaths = {folder / "leftCam_20251015_180349.avi",
                      folder / "rightCam_20251015_180349.avi"};
  clip.framesPerSecond = kBandRate;
  clip.startMargin = kBandStartHalf;
  std::int64_t last = 0;
  for (std::size_t band = 0; band < kBands.size(); ++band) {
    ColorSample click;
    click.x = kBands[band].x;
    click.y = kBands[band].y;
    clip.targets.push_back({std::string(kBands[band].name) + " band", click});
    for (std::size_t row = 0; row < table->rows.size(); ++row) {
      if (table->wordCells[row] == kBands[band].name) {
        const auto& cells = table->rows[row];
        const auto frame = static_cast<std::int64_t>(cells[0]);
        clip.markedCenters.push_back({frame, band, 0, {cells[1], cells[2]}});
        clip.markedCenters.push_back({frame, band, 1, {cells[3], cells[4]}});
        last = std::max(last, frame);
      }
    }
    const auto start = triangulateMarks(clip.rig, clip.markedCenters, 0, band);
    if (!start) {
      return failure(ErrorCode::Undetermined, (folder / "tapes_180349_scout.csv").string(),
                     kBands[band].name, "its marks in the first frame do not meet");
    }
    clip.startPositions.push_back(*start);
  }
  clip.instants = simultaneousInstants(0, last + 1, clip.cameraPaths.size(), kBandRate);
  return clip;
}

} // namespace dewpoint::experiment

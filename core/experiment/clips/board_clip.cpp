// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"
#include "core/experiment/clips/clip_sources.h"
#include "core/experiment/clips/clip_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace dewpoint::experiment {
namespace {

// Of the recording charuco4 and its notes.
constexpr std::size_t kBoardCameras = 4;
constexpr std::size_t kBoardCorners = 12; // 3 x 4, row by row: corner k is opposite to 11 - k
constexpr double kBoardRate = 6.0;        // instants per second; their own times are used
/// One click in camera 1, in a white square near the center of the board, at the first instant.
constexpr double kBoardClickX = 656.0;
constexpr double kBoardClickY = 164.0;
/// What 30 mm, the suite's gate, are in these images: 640 to 900 pixels of focal length, 1 m away.
constexpr double kBoardGatePx = 25.0;

using Corners = std::array<std::optional<Eigen::Vector3d>, kBoardCorners>;

/// The mean of the pairs of opposite corners that are known; nothing without one.
std::optional<Eigen::Vector3d> boardCenter(const Corners& corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int pairs = 0;
  for (std::size_t corner = 0; corner < kBoardCorners / 2; ++corner) {
    const auto& opposite = corners[kBoardCorners - 1 - corner];
    if (corners[corner] && opposite) {
      sum += 0.5 * (*corners[corner] + *opposite);
      ++pairs;
    }
  }
  return pairs > 0 ? std::optional<Eigen::Vector3d>(sum / pairs) : std::nullopt;
}

/// The instants by their numbers in the files: of each camera, its k-th row is its frame k.
Result<std::map<std::int64_t, ClipInstant>> boardInstants(const std::filesystem::path& file) {
  const auto table = readClipTable(file, {"sync_index", "cam_id", "frame_time"});
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  if (const Status whole = checkFrameColumns(*table, {"sync_index", "cam_id"}, file); !whole) {
    return tl::make_unexpected(whole.error());
  }
  std::array<std::int64_t, kBoardCameras> next{};
  std::map<std::int64_t, ClipInstant> instants;
  for (const auto& row : table->rows) {
    if (row[1] >= static_cast<double>(kBoardCameras)) {
      return failure(ErrorCode::NotParsed, file.string(), "cam_id", "0 to 3 are expected");
    }
    const auto camera = static_cast<std::size_t>(row[1]);
    ClipInstant& instant = instants[static_cast<std::int64_t>(row[0])];
    instant.frames.resize(kBoardCameras, -1);
    instant.times.resize(kBoardCameras, 0.0);
    instant.frames[camera] = next[camera]++;
    instant.times[camera] = row[2];
  }
  for (auto& [number, instant] : instants) {
    if (std::ranges::find(instant.frames, -1) != instant.frames.end()) {
      return failure(ErrorCode::NotParsed, file.string(), fmt::format("sync_index {}", number),
                     "a frame of each camera is expected");
    }
    instant.time = std::accumulate(instant.times.begin(), instant.times.end(), 0.0) /
                   static_cast<double>(kBoardCameras);
  }
  return instants;
}

Result<std::map<std::int64_t, Corners>> boardCorners(const std::filesystem::path& file) {
  const auto table =
      readClipTable(file, {"sync_index", "keypoint_id", "x_coord", "y_coord", "z_coord"});
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  if (const Status whole = checkFrameColumns(*table, {"sync_index", "keypoint_id"}, file); !whole) {
    return tl::make_unexpected(whole.error());
  }
  std::map<std::int64_t, Corners> corners;
  for (const auto& row : table->rows) {
    if (row[1] >= static_cast<double>(kBoardCorners)) {
      return failure(ErrorCode::NotParsed, file.string(), "keypoint_id", "0 to 11 are expected");
    }
    corners[static_cast<std::int64_t>(row[0])][static_cast<std::size_t>(row[1])] =
        Eigen::Vector3d(row[2], row[3], row[4]);
  }
  return corners;
}

} // namespace

Result<CalibratedClip> boardClip(const ClipFolders& folders) {
  const auto folder = folders.recordings / "charuco4";
  auto rig = loadCalibration(folder / "camera_array.toml");
  if (!rig) {
    return tl::make_unexpected(rig.error());
  }
  if (rig->size() != kBoardCameras) {
    return failure(ErrorCode::Mismatch, (folder / "camera_array.toml").string(), "cameras",
                   fmt::format("{}; {} are expected", rig->size(), kBoardCameras));
  }
  const auto instants = boardInstants(folder / "timestamps.csv");
  if (!instants) {
    return tl::make_unexpected(instants.error());
  }
  const auto corners = boardCorners(folder / "CHARUCO_xyz_CHARUCO.csv");
  if (!corners) {
    return tl::make_unexpected(corners.error());
  }
  CalibratedClip clip;
  clip.name = "R1-board";
  clip.rig = std::move(*rig);
  for (std::size_t camera = 0; camera < kBoardCameras; ++camera) {
    clip.cameraPaths.push_back(folder / fmt::format("cam_{}.mp4", camera));
  }
  clip.framesPerSecond = kBoardRate;
  clip.markGatePx = kBoardGatePx;
  ColorSample click;
  click.x = kBoardClickX;
  click.y = kBoardClickY;
  clip.targets = {{"board", click}};
  for (const auto& [number, instant] : *instants) {
    const auto seen = corners->find(number);
    if (const auto center = seen != corners->end() ? boardCenter(seen->second) : std::nullopt) {
      clip.positions.push_back({static_cast<std::int64_t>(clip.instants.size()), 0, *center});
    }
    clip.instants.push_back(instant);
  }
  return clip;
}

} // namespace dewpoint::experiment

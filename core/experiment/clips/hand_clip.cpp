// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"
#include "core/experiment/clips/clip_sources.h"
#include "core/experiment/clips/clip_table.h"

#include <opencv2/core/types.hpp>

#include <algorithm>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr double kHandRate = 30.0; // frames per second, of the recording's notes
/// One click in camera 1, at the center of the hand in frame 21: the first marked frame in which
/// the hand is not blurred.
constexpr std::int64_t kHandClickFrame = 21;
constexpr double kHandClickX = 515.0;
constexpr double kHandClickY = 234.0;
/// A box around the hand in the same image, from the wrist to the tip of the finger, drawn by eye.
const cv::Rect2d kHandBox(445.0, 165.0, 150.0, 225.0);
/// What 30 mm, the suite's gate, are in these images: a pixel is about 0.5 mm at the hand.
constexpr double kHandGatePx = 60.0;

/// Columns of hand2_desk.csv, as they are read.
struct HandColumn {
  static constexpr std::size_t kFrame = 0;
  static constexpr std::size_t kLeft = 1;  ///< u0, v0
  static constexpr std::size_t kRight = 3; ///< u1, v1
  static constexpr std::size_t kPosition = 5;
};

Eigen::Vector2d pixelAt(const std::vector<double>& row, std::size_t column) {
  return {row[column], row[column + 1]};
}

} // namespace

Result<CalibratedClip> handClip(const ClipFolders& folders) {
  auto rig = loadCalibration(folders.truth / "hand2_desk_cameras.toml");
  if (!rig) {
    return tl::make_unexpected(rig.error());
  }
  const auto table = readClipTable(folders.truth / "hand2_desk.csv",
                                   {"frame", "u0", "v0", "u1", "v1", "x", "y", "z"});
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  if (const Status whole = checkFrameColumns(*table, {"frame"}, folders.truth / "hand2_desk.csv");
      !whole) {
    return tl::make_unexpected(whole.error());
  }
  if (table->rows.empty() || !std::ranges::is_sorted(table->rows, {}, [](const auto& row) {
        return row[HandColumn::kFrame];
      })) {
    return failure(ErrorCode::NotParsed, (folders.truth / "hand2_desk.csv").string(), "frame",
                   "rows in the order of their frames are expected");
  }
  const auto first = static_cast<std::int64_t>(table->rows.front()[HandColumn::kFrame]);
  const auto last = static_cast<std::int64_t>(table->rows.back()[HandColumn::kFrame]);
  CalibratedClip clip;
  clip.name = "R1-hand";
  clip.rig = std::move(*rig);
  clip.cameraPaths = {folders.recordings / "hand2_desk" / "cam0.mp4",
                      folders.recordings / "hand2_desk" / "cam1.mp4"};
  clip.framesPerSecond = kHandRate;
  clip.instants = simultaneousInstants(first, last + 1, clip.cameraPaths.size(), kHandRate);
  ColorSample click;
  click.frame = kHandClickFrame - first;
  click.x = kHandClickX;
  click.y = kHandClickY;
  clip.targets = {{"hand", click}};
  clip.markGatePx = kHandGatePx;
  for (const auto& row : table->rows) {
    const std::int64_t instant = static_cast<std::int64_t>(row[HandColumn::kFrame]) - first;
    constexpr std::size_t kPosition = HandColumn::kPosition;
    clip.positions.push_back(
        {instant, 0, {row[kPosition], row[kPosition + 1], row[kPosition + 2]}});
    clip.markedCenters.push_back({instant, 0, 0, pixelAt(row, HandColumn::kLeft)});
    clip.markedCenters.push_back({instant, 0, 1, pixelAt(row, HandColumn::kRight)});
  }
  return clip;
}

Result<CalibratedClip> boxedHandClip(const ClipFolders& folders) {
  return handClip(folders).map([](CalibratedClip clip) {
    clip.name = "R1-hand-boxed";
    ColorSample& box = clip.targets.front().click;
    box.x = kHandBox.x;
    box.y = kHandBox.y;
    box.width = kHandBox.width;
    box.height = kHandBox.height;
    return clip;
  });
}

} // namespace dewpoint::experiment

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/floor_from_board.h"

#include "core/calibration/board/board_in_rig.h"
#include "core/geometry/rotation_vector.h"
#include "core/project/project_rig.h"
#include "core/setup/calibration/frame_picker.h"
#include "core/setup/calibration/moved_world.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

namespace dewpoint::setup {

Result<FloorFromBoard> withFloorFromBoard(const Project& project, const BoardDescription& board,
                                          const FrameSet& frames) {
  const CameraRig rig = rigOf(project);
  const BoardDetector detector(board);
  std::vector<std::optional<BoardDetection>> seen(rig.size());
  for (std::size_t k = 0; k < rig.size() && k < frames.frames.size(); ++k) {
    if (frames.frames[k] == nullptr) {
      continue;
    }
    const cv::Mat& image = frames.frames[k]->image;
    const Intrinsics& lens = rig[k].intrinsics;
    if (image.cols != lens.width || image.rows != lens.height) {
      return failure(ErrorCode::Mismatch, project.file.string(), rig[k].name,
                     fmt::format("its images have {} x {} pixels, its calibration {} x {}",
                                 image.cols, image.rows, lens.width, lens.height));
    }
    seen[k] = detector.detect(image, DetectionEffort::Exact);
  }
  return locateBoardInRig(board, rig, seen).map([&](const BoardInRig& found) {
    const Eigen::Isometry3d motion = worldFromFlatBoard() * found.worldFromBoard.inverse();
    const Similarity change{1.0, motion.linear(), motion.translation()};
    FloorFromBoard result{withMovedWorld(project, change),
                          vectorFromRotation(change.rotation).norm(), found.rmsPx,
                          found.cameras.size()};
    result.project.worldRecord.floorOrigin = CalibrationOrigin::Board;
    return result;
  });
}

Result<FloorFromBoard> withFloorFromBoard(const Project& project, const BoardDescription& board,
                                          FrameSetSource& source, std::int64_t frame) {
  const auto total = source.frameCount();
  if (!total || frame < 0 || frame >= *total) {
    return failure(ErrorCode::BadValue, project.file.string(), "frame",
                   total ? fmt::format("the recording has only {} frames", *total)
                         : "the cameras are live, but a recording is needed");
  }
  return FramePicker(source).read(frame).and_then(
      [&](const FrameSetPtr& set) -> Result<FloorFromBoard> {
        if (set == nullptr) {
          return failure(ErrorCode::BadValue, project.file.string(), "frame",
                         "the recording ends before it");
        }
        return withFloorFromBoard(project, board, *set);
      });
}

} // namespace dewpoint::setup

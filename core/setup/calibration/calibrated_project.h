// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/board/intrinsics_from_board.h"
#include "core/calibration/manual/measured_points.h"
#include "core/geometry/image_margins.h"
#include "core/geometry/image_symmetry.h"
#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::setup {

/// Sets the calibration of a project's camera. Use this function for changes by the user. If it
/// changes the calibration of a simulated camera, it sets ProjectCamera::hasOwnCalibration, so that
/// this calibration is used instead of the scene's. (RunDefinition::appliedTo(), which inserts the
/// cameras of a run into a project, does not set `adjusted`.)
void setCalibration(ProjectCamera& camera, const Camera& calibration);

/// Returns the project with the calibration of the cameras in `rig`, which has one entry per camera
/// of the project, in the same order.
Project withCameras(Project project, const CameraRig& rig);

/// Returns the project with its cameras' delays changed by the time offsets found in their images
/// (WandResult::timeOffsets, seconds; negative for cameras that are delayed more than the project
/// states). Simulated cameras are unchanged.
Project withTimeOffsets(Project project, const std::vector<double>& offsets);

/// Returns the project with the images of camera `camera` rotated and mirrored by `symmetry`, in
/// addition to the rotation and mirroring that the project already contains. The calibration of the
/// camera, its margins and its clicks on measured points are converted accordingly.
Project withImageSymmetry(Project project, int camera, const ImageSymmetry& symmetry);

/// Returns the project with another orientation of a camera's images: they are rotated clockwise by
/// `rotateDegrees` (0, 90, 180 or 270) from how the camera delivers them, and then mirrored if
/// `mirrored` is true. This replaces the orientation in the project. The calibration of the camera
/// and its clicks on measured points are converted as by withImageSymmetry(); a calibration that
/// was only guessed by the program is guessed again.
Project withImageOrientation(Project project, std::size_t camera, int rotateDegrees, bool mirrored);

/// Returns the project with the images of a camera cropped by `crop`, which replaces the margins in
/// the project. The calibration of the camera and everything that was clicked in its images are
/// moved accordingly. Color samples and boxes outside the cropped image are removed. A calibration
/// that was only guessed is guessed again. Errors: BadValue for a simulated camera or a negative
/// margin; Mismatch if the cropped image would be narrower or lower than kSmallestCrop.
Result<Project> withImageCrop(Project project, std::size_t camera, const ImageMargins& crop);

/// Least width and height of a cropped image, in pixels. Chosen by judgment.
inline constexpr int kSmallestCrop = 16;

/// Returns whether withImageSymmetry() can rotate and mirror the images of a camera. This is false
/// for simulated cameras.
bool canSetImageSymmetry(const ProjectCamera& camera);

/// Returns the project with the images of each camera rotated and mirrored as
/// CameraFromPoints::proposal proposes; see withImageSymmetry(). Cameras without a proposal and
/// simulated cameras are unchanged.
Project withProposedSymmetries(Project project, const std::vector<CameraFromPoints>& cameras);

/// Returns the project with the cameras computed from measured points. `focal` is true if the focal
/// lengths were computed as well.
Project withPointSolution(Project project, const PointSolution& solution, bool focal);

/// Returns the project with these intrinsics. `results` has one entry per camera; a camera whose
/// entry is empty keeps its intrinsics. Poses are unchanged.
Project withIntrinsics(Project project,
                       const std::vector<std::optional<IntrinsicsResult>>& results);

} // namespace dewpoint::setup

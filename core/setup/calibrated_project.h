// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"
#include "core/calibration/manual/measured_points.h"
#include "core/geometry/image_symmetry.h"
#include "core/project/project.h"

#include <optional>
#include <vector>

namespace dewpoint::setup {

/// Gives a camera of a project another calibration. One of a simulated camera that differs from
/// what its scene says is kept from then on (`adjusted`). What edits a project does it here;
/// RunDefinition::appliedTo() only puts in the cameras of a run, and leaves `adjusted` as it is.
void setCalibration(ProjectCamera& camera, const Camera& calibration);

/// The project with these cameras' calibration, in the same order.
Project withCameras(Project project, const CameraRig& rig);

/// The project whose cameras have these seconds more delay than so far, as found in its images
/// (WandResult::offsets: those are negative for cameras that are late); simulated ones stay.
Project withTimeOffsets(Project project, const std::vector<double>& offsets);

/// The project whose camera `camera` delivers its pictures rotated and mirrored so, after what is
/// done to them already: how they are rotated, its calibration and the clicks on measured points in
/// it all change together.
Project withImageSymmetry(Project project, int camera, const ImageSymmetry& symmetry);

/// Whether the images of a camera may be rotated and mirrored by a setting: those of a simulated
/// one are made as they are.
bool canSetImageSymmetry(const ProjectCamera& camera);

/// The project with the image symmetry that was proposed for each camera, where it can be set.
Project withProposedSymmetries(Project project, const std::vector<CameraFromPoints>& cameras);

/// The project with these lenses, in the order of its cameras, which keep theirs where there is
/// none; poses stay.
Project withIntrinsics(Project project,
                       const std::vector<std::optional<IntrinsicsResult>>& results);

} // namespace dewpoint::setup

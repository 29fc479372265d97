// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/camera_report.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/tracked_objects.h"
#include "core/tracking/track_estimate.h"
#include "core/tracking/tracker_diagnostics.h"

#include <cstddef>
#include <vector>

// Reports of the `dewpoint` method about a target that supplement its estimate. The reports do not
// affect tracking.
namespace dewpoint::tracking {

/// Returns for each camera whether the camera confirms a target, and the reason if not; see
/// CameraReporting::cameraReports().
std::vector<CameraReport> cameraReportsOf(const TrackedObjects& objects, const FrameImages& images,
                                          const SphereEstimate& estimate, std::size_t target);

/// Returns the hypotheses of a target, and the positions of other objects of its color; see
/// CandidateReporting::positionCandidates().
std::vector<CandidatePosition> candidatePositions(const TrackedObjects& objects,
                                                  std::size_t target);

/// Returns one map per camera of the log likelihood ratio (SphereEvidence) with the target's
/// outline moved to each pixel. The map extends up to `reach` pixels in each direction from the
/// estimate; see LikelihoodMapping::likelihoodMaps().
std::vector<LikelihoodMap> likelihoodMapsOf(const TrackedObjects& objects,
                                            const FrameImages& images,
                                            const SphereEstimate& estimate, std::size_t target,
                                            int reach);

} // namespace dewpoint::tracking

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/camera_report.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/tracked_objects.h"
#include "core/tracking/track_estimate.h"
#include "core/tracking/tracker_diagnostics.h"

#include <cstddef>
#include <vector>

// What method `dewpoint` reports about a target beside its estimate. Nothing here changes what is
// tracked next.
namespace dewpoint::tracking {

/// Why each camera does, or does not, confirm a target: as CameraExplaining::explain().
std::vector<CameraReport> explainCameras(const TrackedObjects& objects, const FrameImages& images,
                                         const SphereEstimate& estimate, std::size_t target);

/// The hypotheses of a target, and the positions of other objects of its color: as
/// PositionProposing::proposals().
std::vector<CandidatePosition> candidatePositions(const TrackedObjects& objects,
                                                  std::size_t target);

/// The log likelihood ratio of SphereEvidence for a target's outline moved to each pixel around the
/// estimate, up to `reach` pixels in each direction: as LikelihoodMapping::likelihoodMaps().
std::vector<LikelihoodMap> likelihoodMapsOf(const TrackedObjects& objects,
                                            const FrameImages& images,
                                            const SphereEstimate& estimate, std::size_t target,
                                            int reach);

} // namespace dewpoint::tracking

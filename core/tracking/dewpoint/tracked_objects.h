// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/tracked_object.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace dewpoint::tracking {

/// All objects that the `dewpoint` method tracks in one run: the targets in the order of the
/// project, then the distractors (other objects that look like a target). No two objects can be at
/// one position, and a pixel counts as evidence for only one object.
class TrackedObjects {
public:
  TrackedObjects(const std::vector<Target>& targets, const CameraRig& rig);
  /// Creates a copy without images and without searches in progress. Images must be passed to the
  /// copy again.
  TrackedObjects(const TrackedObjects& other);
  TrackedObjects& operator=(const TrackedObjects&) = delete;
  ~TrackedObjects() = default;

  std::size_t size() const { return objects_.size(); }
  std::size_t targetCount() const { return targetCount_; }
  std::size_t distractorCount() const { return objects_.size() - targetCount_; }
  TrackedObject& operator[](std::size_t index) { return objects_.at(index); }
  const TrackedObject& operator[](std::size_t index) const { return objects_.at(index); }
  auto begin() { return objects_.begin(); }
  auto begin() const { return objects_.begin(); }
  auto end() { return objects_.end(); }
  auto end() const { return objects_.end(); }

  /// Cancels all searches and replaces all observations by new observations without images. The
  /// number of cameras must be the same; the tracks are kept.
  void setCameras(const CameraRig& rig);
  SphereObservation makeObservation() const { return SphereObservation(rig_); }
  /// Returns a new object with the color of a target and an empty track that creates no hypotheses
  /// by itself. The object is not tracked until it is passed to addDistractor().
  TrackedObject makeDistractorProbe(std::size_t target,
                                    const BernoulliTrackSettings& settings) const;
  TrackedObject& addDistractor(TrackedObject distractor);
  void removeDistractor(std::size_t index);
  void removeDistractors();
  /// Removes the distractors with the color of a target.
  void removeDistractorsOf(std::size_t target);

  /// Returns the indices of all objects, the most probable first.
  std::vector<std::size_t> indicesByProbability() const;
  /// Returns the spheres occupied by confident tracks of objects other than `index`. If `index` is
  /// not below size(), the spheres of all confident tracks are returned.
  std::vector<OccupiedSphere> spheresOfOthers(std::size_t index) const;
  /// Returns the spheres occupied by confident tracks of targets other than `index`, without
  /// distractors.
  std::vector<OccupiedSphere> spheresOfOtherTargets(std::size_t index) const;
  /// Returns whether no earlier target in the list has the same color as this target.
  bool isFirstOfItsColor(std::size_t target) const;
  /// Returns whether other objects of a target's color may be searched for. This is the case if all
  /// targets of this color are balls. Otherwise a part of a larger target could be mistaken for a
  /// distractor.
  bool mayHaveDistractors(std::size_t target) const;
  /// Returns whether the position of every target is nearly certain and every target is mostly
  /// visible.
  bool areAllTargetsVisible() const;

  /// Marks pixels of other objects as explained in the labels of an observation, so that they are
  /// not evidence for `own`. Only objects that are mostly visible and have the color of `own` are
  /// considered. `own` need not be tracked yet.
  void markPixelsOfOthers(SphereObservation& observation, const TrackedObject& own) const;
  /// Marks pixels of other targets as explained, like markPixelsOfOthers(), in the images from
  /// which the shape of a target is learned. Distractors are not considered, because a supposed
  /// distractor may be a part of this target.
  void markPixelsOfOtherTargets(std::size_t target);
  /// Starts a search for an object in the images of this frame; the work is spread over several
  /// frames. Pixels of other objects are first marked as explained. The object need not be tracked
  /// yet.
  std::unique_ptr<SlicedSearch> startSearch(const TrackedObject& own,
                                            const FrameImages& images) const;
  /// Makes a distractor's position improbable if the distractor has moved onto a target that was
  /// clearly visible in the last update, because the supposed distractor is then the target itself.
  void suppressIfAtTarget(std::size_t distractor);
  /// Removes distractors and hypotheses of other targets at the position of a target, if the
  /// outline of the target was found where the user has placed the target. Returns the indices of
  /// the other targets that were changed.
  std::vector<std::size_t> removeOthersAtPositionOf(std::size_t target);
  /// If two objects are at one position, makes this position improbable for the object with the
  /// smaller log likelihood ratio.
  void resolveConflicts();
  /// Removes the hypotheses of targets at positions that other objects occupy. If the images cannot
  /// distinguish several hypotheses of a target, keeps only one of them.
  void resolveIdentities();

private:
  /// Returns whether another target has the same color and radius.
  bool hasIdenticalTarget(std::size_t target) const;

  CameraRig rig_;
  std::size_t targetCount_ = 0;
  std::vector<TrackedObject> objects_;
};

} // namespace dewpoint::tracking

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/tracked_object.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace dewpoint::tracking {

/// All objects that method `dewpoint` tracks in one run: the targets first, in the order of the
/// project, then the distractors. No two of them can be at one position, and a pixel is evidence
/// for one of them only.
class TrackedObjects {
public:
  TrackedObjects(const std::vector<Target>& targets, const CameraRig& rig);
  /// A copy has no images and no searches under way: images are shown again, searches begin again.
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

  /// Cancels all searches and replaces all observations by new ones, without images. The same
  /// number of cameras; the tracks stay.
  void setCameras(const CameraRig& rig);
  SphereObservation makeObservation() const { return SphereObservation(rig_); }
  /// A copy of an object's target and color without a track, for which no hypotheses are created.
  /// Not yet tracked: see addDistractor().
  TrackedObject makeDistractorProbe(std::size_t target,
                                    const BernoulliTrackSettings& settings) const;
  TrackedObject& addDistractor(TrackedObject distractor);
  void removeDistractor(std::size_t index);
  void removeDistractors();
  /// Those of the color of a target.
  void removeDistractorsOf(std::size_t target);

  /// Indices of all objects, the most probable ones first.
  std::vector<std::size_t> byProbability() const;
  /// The spheres that confident tracks of others than object `index` occupy. An index that is not
  /// below size() stands for an object that is not tracked yet.
  std::vector<OccupiedSphere> occupiedByOthers(std::size_t index) const;
  /// The same, without distractors.
  std::vector<OccupiedSphere> occupiedByOtherTargets(std::size_t index) const;
  /// Whether a target is the first one of its color.
  bool isFirstOfItsColor(std::size_t target) const;
  /// Whether further objects of the color of a target may be searched for: if it is a ball, and so
  /// are all others of its color. A part of something larger would be found where it is.
  bool mayHaveDistractors(std::size_t target) const;
  /// Whether all targets are certain and mostly visible.
  bool allTargetsVisible() const;

  /// Marks the pixels of other objects of the color of `own`, which are mostly visible, as
  /// explained in the labels of an observation: they are no evidence for `own`, which need not be
  /// tracked yet.
  void explainOthers(SphereObservation& observation, const TrackedObject& own) const;
  /// The same in the images in which the shape of a target is learned, for other targets only: what
  /// looks like a distractor there may be a part of it.
  void explainOtherTargets(std::size_t target);
  /// A search for an object that goes on over several frames, on the images of this frame, with the
  /// others explained. The object need not be tracked yet.
  std::unique_ptr<SlicedSearch> startSearch(const TrackedObject& own,
                                            const FrameImages& images) const;
  /// Suppresses a distractor's position where it has moved onto a target that was clearly visible
  /// in the last update: it was the target itself.
  void suppressAtTargets(std::size_t distractor);
  /// Makes room for a target whose outline was found where the user said it is: removes distractors
  /// there, and hypotheses of other targets. Returns the indices of these targets.
  std::vector<std::size_t> makeRoomFor(std::size_t target);
  /// Suppresses, of any two objects at one position, the one with less evidence.
  void resolveConflicts();
  /// Removes the hypotheses of targets at occupied positions, and decides between those that no
  /// image will tell apart.
  void resolveIdentities();

private:
  /// Whether another target has the same color and radius.
  bool hasIdenticalTarget(std::size_t target) const;

  CameraRig rig_;
  std::size_t targetCount_ = 0;
  std::vector<TrackedObject> objects_;
};

} // namespace dewpoint::tracking

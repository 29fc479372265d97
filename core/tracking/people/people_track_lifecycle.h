// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/particle_filter.h"
#include "core/tracking/people/people_cameras.h"
#include "core/tracking/people/people_track_initiation.h"
#include "core/tracking/tracker_capabilities.h"

#include <map>
#include <vector>

namespace dewpoint::tracking {

/// Base class of all methods for people. It handles motion masks, creation and removal of tracks,
/// visibility, and identities. A derived class adds the belief about each person, such as a
/// particle filter. The person with identity N is track N - 1; after this track was removed, it has
/// no estimate (AbsentEstimate). There is one iteration per frame; further iterations have no
/// effect. A change of the background model takes effect at the next restart.
class PeopleTrackLifecycle : public Tracker,
                             public Configurable,
                             public RigConfigurable,
                             public BackgroundImageConfigurable,
                             public ParticleCloud,
                             public PeopleFinding,
                             public MotionMapping,
                             public PersonEditing,
                             public Copyable {
public:
  PeopleTrackLifecycle(const ParameterValues& parameters, const CameraRig& rig);

  void configure(const ParameterValues& parameters) override;
  void setCameras(const CameraRig& rig) override;
  void setBackgroundImages(const std::vector<cv::Mat>& images) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override { return 1; }
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) final;
  std::size_t trackCount() const override { return peopleAsTargets_.size(); }
  TrackEstimate estimate(std::size_t track) const override;
  void copyParticles(std::size_t track, int limit, Eigen::ArrayXXd& positions,
                     Eigen::ArrayXd& weights) const override;
  const std::vector<Target>& peopleAsTargets() const override { return peopleAsTargets_; }
  const std::vector<PersonEstimate>& people() const override { return people_; }
  const std::vector<PeopleCameraState>& cameraStates() const override {
    return cameras_.cameraStates();
  }
  cv::Mat foregroundMask(std::size_t camera) const override {
    return cameras_.foregroundMask(camera);
  }
  std::vector<LikelihoodMap> motionLikelihoodMaps() const override;
  int addPerson(const Eigen::Vector3d& center) override;
  void removePerson(int identity) override;
  bool canBeCopied() const override { return cameras_.canBeCopied(); }
  std::size_t memoryBytes() const override;

protected:
  /// Copies the tracker; used by clone().
  PeopleTrackLifecycle(const PeopleTrackLifecycle&) = default;

  /// Parameters of the motion likelihood of Mohedano et al. 2009: the width of the Gaussian g that
  /// smooths the motion mask, and the smallest likelihood p_B.
  struct MotionSmoothing {
    double sigma = 4.0; ///< standard deviation of the Gaussian, pixels of the mask
    double minLikelihood = 0.2;
  };
  /// Visibility of a person in a camera.
  struct Visibility {
    bool isInView = false;
    double foregroundFraction = 0.0; ///< fraction of the visible part that is foreground, 0 to 1
    double uncoveredFraction = 0.0;  ///< fraction of the silhouette that no other person covers
  };

  /// Creates the method's belief (such as a particle filter) about a new person, who is the last of
  /// `people_`.
  virtual void createBelief(const PersonEstimate& person, const RandomKey& key) = 0;
  /// Removes the method's belief (such as a particle filter) about people_[index]. The caller then
  /// removes the person.
  virtual void removeBelief(std::size_t index) = 0;
  virtual void removeAllBeliefs() = 0;
  /// Returns the approximate size of a copy of a belief in bytes.
  virtual std::size_t beliefMemoryBytes() const = 0;
  /// Processes new images: moves and weights all particles, and fills in `people_`.
  virtual void updateBeliefs(ThreadTeam& team) = 0;
  virtual MotionSmoothing motionSmoothing() const { return {}; }
  /// Returns whether foreground pixels that other people cover are ignored when deciding whether a
  /// person is visible.
  virtual bool ignoresForegroundOfKnownPeople() const = 0;

  RandomKey randomKeyOf(int identity) const;
  Eigen::Vector2d floorPosition(const PersonEstimate& person) const {
    return person.position.head<2>();
  }
  double heightOf(const PersonEstimate& person) const {
    return person.height > 0.0 ? person.height : usualHeight_;
  }
  BodySilhouette silhouetteOf(const PersonEstimate& person, std::size_t camera) const;
  const PeopleSettings& settings() const { return settings_; }
  const PeopleCameras& cameras() const { return cameras_; }
  const SilhouetteProjector& silhouetteProjector(std::size_t camera) const {
    return makers_[camera];
  }

  std::vector<PersonEstimate> people_;

private:
  void apply(const ParameterValues& parameters);
  void step(const FrameSet& frames, ThreadTeam& team);
  int createTrack(const Eigen::Vector3d& center);
  void removeTrack(int identity);
  /// Assigns tracks to all people who are present.
  void assignTracks();
  void prepare();
  Visibility visibilityOf(std::size_t person, std::size_t camera) const;
  void updateVisibility();
  void terminateTracks();
  void initiateTracks();
  std::vector<cv::Mat> silhouettesOfAll(double wider) const;
  std::size_t indexOf(int identity) const;

  PeopleSettings settings_;
  CameraRig rig_;
  PeopleCameras cameras_;
  PeopleTrackInitiation initiation_;
  std::vector<SilhouetteProjector> makers_;
  std::vector<double> unseen_; ///< seconds, one per person
  double usualHeight_ = 1.72;
  std::uint64_t seed_ = 0;
  int nextIdentity_ = 1;
  FrameSetPtr frames_;
  bool stepped_ = false; ///< the frame was processed
  std::vector<Target> peopleAsTargets_;
  mutable std::map<int, BodyCloud> bodies_; ///< bodies in this frame; only those requested
};

} // namespace dewpoint::tracking

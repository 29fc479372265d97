// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/boxes/box_tracker.h"
#include "core/tracking/multi_tracker.h"

#include <string>

namespace dewpoint::tracking {

/// The methods of family Boxes in a run of several cameras and targets: one BoxTracker per target,
/// on the images of the camera of its box. A target is followed from the frame of its box on: from
/// when a run passes it, or at once where the box is of the frame the run stands at. One step per
/// image. Nothing is known in 3D: of the estimates only `valid` (seen, neither hidden nor out of
/// the image), `existence` (the similarity), the effective sample size and `gone` (before the frame
/// of its box) are set, and there are no particles in space.
class BoxTargets final : public MultiTracker {
public:
  /// `method` of boxMethodNames() with its parameters (asserted).
  BoxTargets(std::string method, const ParameterValues& parameters,
             const std::vector<Target>& targets);
  BoxTargets(const BoxTargets& other);
  BoxTargets& operator=(const BoxTargets&) = delete;
  ~BoxTargets() override = default;

  void configure(const ParameterValues& parameters) override;
  /// Another number of targets, too: those of a name that was there before go on. A target with
  /// another box than before forgets the old one.
  void setTargets(const std::vector<Target>& targets) override;
  bool takesAnyNumber() const override { return true; }
  void setCameras(const CameraRig& /*rig*/) override {}
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override { return 1; }
  /// A target whose box is of this frame has it at once, before any iteration.
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) override;
  const std::vector<TargetEstimate>& estimates() const override { return estimates_; }
  void particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                 Eigen::ArrayXd& weights) const override;
  std::optional<BoxBelief> box(std::size_t target, int particleLimit) const override;
  std::vector<CameraReport> explain(std::size_t target) const override;
  std::unique_ptr<MultiTracker> clone() const override;
  std::size_t memoryBytes() const override;

private:
  struct Followed {
    std::string name;
    std::optional<TargetBox> box;
    std::unique_ptr<BoxTracker> tracker; ///< null before the frame of the box
    std::int64_t startedAt = -1;
    BoxEstimate estimate;
  };

  const cv::Mat* imageOf(const TargetBox& box) const;
  void start(std::size_t target);
  void step(Followed& followed, ThreadTeam& team) const;
  void showEstimate(std::size_t target);
  void showEstimates();

  std::string method_;
  ParameterValues parameters_;
  std::uint64_t seed_ = 0;
  std::vector<Followed> followed_;
  std::vector<TargetEstimate> estimates_;
  FrameSetPtr frames_;
};

} // namespace dewpoint::tracking

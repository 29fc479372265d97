// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/bundle/bundle_cost.h"
#include "core/calibration/bundle/bundle_start.h"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <map>
#include <memory>
#include <vector>

namespace dewpoint::calibration {

/// Bundle problem in the form used by the solver: its parameters, and the costs computed
/// from them. An object must not be moved, because the solver keeps pointers into it.
class BundleModel {
public:
  /// Parameter blocks of a camera, as required by PixelCost.
  struct CameraBlocks {
    Eigen::Matrix3d
        referenceRotation; ///< fixed rotation to which the rotation vector in `pose` is relative
    std::array<double, kPoseSize> pose{};
    std::array<double, kLensSize> lens{};
    double timeOffset = 0.0;
  };
  /// Parameters of a state: a point, both ends of a stick, or the rotation and position of a board.
  struct StateBlock {
    Eigen::Matrix3d referenceRotation = Eigen::Matrix3d::Identity();
    std::array<double, 6> values{};
  };

  BundleModel(const BundleProblem& given, BundleStart start);
  BundleModel(const BundleModel&) = delete;
  BundleModel& operator=(const BundleModel&) = delete;

  /// Returns the parameter blocks of an observation, in the order required by PixelCost.
  std::vector<double*> blocksOf(std::size_t observation);
  bool isInProblem(const double* block) const { return ceresProblem.HasParameterBlock(block); }
  bool isVariable(const double* block) const {
    return isInProblem(block) && !ceresProblem.IsParameterBlockConstant(block);
  }
  /// Returns the indices of the entries in a camera's lens block that are held fixed, ascending.
  static std::vector<int> fixedLensEntries(const BundleCamera& camera);

  const BundleProblem& problem;
  BundleStart start;
  std::vector<CameraBlocks> cameras;
  std::vector<StateBlock> states;
  /// Cost function of each observation; null if the observation is not used.
  std::vector<ceres::CostFunction*> costFunctions;
  std::size_t usedObservationCount = 0; ///< number of observations used
  /// Loss functions, one for each value of BundleObservation::sigma.
  std::map<double, std::unique_ptr<ceres::LossFunction>> lossesBySigma;
  ceres::Problem ceresProblem;

private:
  void makeBlocks();
  void addObservations();
  void addSticks();
  void addPriors();
  void fixKnownParameters();
  PixelCostSetup setupOf(std::size_t observation) const;
  ceres::LossFunction* lossFor(double sigma);
};

} // namespace dewpoint::calibration

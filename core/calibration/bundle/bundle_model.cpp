// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle/bundle_model.h"

#include <ceres/manifold.h>
#include <utility>

namespace dewpoint::calibration {
namespace {

using Kind = BundleBody::Kind;

int stateBlockSize(Kind kind) {
  return kind == Kind::Point ? 3 : 6;
}

ceres::Problem::Options problemOptions() {
  ceres::Problem::Options options;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

} // namespace

BundleModel::BundleModel(const BundleProblem& given, BundleStart usable)
    : problem(given), start(std::move(usable)), ceresProblem(problemOptions()) {
  makeBlocks();
  addObservations();
  addSticks();
  addPriors();
  fixKnownParameters();
}

std::vector<int> BundleModel::fixedLensEntries(const BundleCamera& camera) {
  std::vector<int> held;
  for (int i = 0; i < kLensSize; ++i) {
    const bool isFree = i == 0   ? camera.isFocalFree
                        : i == 1 ? camera.isAspectFree
                        : i < 4  ? camera.isPrincipalPointFree
                                 : camera.isDistortionFree[std::size_t(i - 4)];
    if (!isFree) {
      held.push_back(i);
    }
  }
  return held;
}

void BundleModel::makeBlocks() {
  for (const BundleCamera& wanted : problem.cameras) {
    CameraBlocks blocks;
    blocks.referenceRotation = wanted.camera.cameraFromWorld.linear();
    Eigen::Map<Eigen::Vector3d>(blocks.pose.data() + 3) = wanted.camera.center();
    blocks.lens = lensBlock(wanted.camera);
    blocks.timeOffset = wanted.timeOffset;
    cameras.push_back(blocks);
  }
  for (const BundleState& wanted : start.states) {
    StateBlock block;
    Eigen::Map<Eigen::Vector3d> first(block.values.data());
    Eigen::Map<Eigen::Vector3d> second(block.values.data() + 3);
    if (problem.bodies[wanted.body].kind == Kind::Board) {
      block.referenceRotation = wanted.worldFromBoard.linear();
      second = wanted.worldFromBoard.translation();
    } else {
      first = wanted.ends[0];
      second = wanted.ends[1];
    }
    states.push_back(block);
  }
}

ceres::LossFunction* BundleModel::lossFor(double sigma) {
  if (problem.loss == RobustLoss::None) {
    return nullptr;
  }
  auto& loss = lossesBySigma[sigma];
  if (!loss) {
    const double width = problem.lossWidth / sigma;
    switch (problem.loss) {
    case RobustLoss::Huber:
      loss = std::make_unique<ceres::HuberLoss>(width);
      break;
    case RobustLoss::SoftL1:
      loss = std::make_unique<ceres::SoftLOneLoss>(width);
      break;
    default:
      loss = std::make_unique<ceres::CauchyLoss>(width);
    }
  }
  return loss.get();
}

void BundleModel::addObservations() {
  costFunctions.resize(problem.observations.size(), nullptr);
  for (std::size_t i = 0; i < problem.observations.size(); ++i) {
    if (!start.isObservationUsed[i]) {
      continue;
    }
    auto cost = std::make_unique<PixelCost>(setupOf(i));
    std::vector<double*> blocks = blocksOf(i);
    std::array<double, 2> residual{};
    if (!cost->Evaluate(blocks.data(), residual.data(), nullptr)) {
      start.isObservationUsed[i] = false; // behind the camera
      continue;
    }
    ceresProblem.AddResidualBlock(cost.get(), lossFor(problem.observations[i].sigma), blocks);
    costFunctions[i] = cost.release(); // the solver owns it
    ++usedObservationCount;
  }
}

PixelCostSetup BundleModel::setupOf(std::size_t i) const {
  const BundleObservation& seen = problem.observations[i];
  const BundleState& state = start.states[seen.state];
  const BundleBody& body = problem.bodies[state.body];
  PixelCostSetup setup;
  setup.lens = problem.cameras[seen.camera].camera.lens;
  setup.cameraRotation = cameras[seen.camera].referenceRotation;
  setup.pixel = seen.pixel;
  setup.sigma = seen.sigma;
  setup.outlineShift = seen.outlineShift;
  setup.stateBlockSize = stateBlockSize(body.kind);
  setup.imageTime = state.time + seen.timeAfterState;
  if (body.kind == Kind::Board) {
    setup.boardRotation = states[seen.state].referenceRotation;
    setup.boardPoint = body.points[seen.point];
  } else {
    setup.pointOffset = 3 * static_cast<int>(seen.point);
  }
  for (const std::size_t knot : start.interpolationStates[i]) {
    setup.knotTimes.push_back(start.states[knot].time);
  }
  return setup;
}

std::vector<double*> BundleModel::blocksOf(std::size_t i) {
  const BundleObservation& seen = problem.observations[i];
  CameraBlocks& camera = cameras[seen.camera];
  std::vector<double*> blocks{camera.pose.data(), camera.lens.data(), &camera.timeOffset};
  for (const std::size_t knot : start.interpolationStates[i]) {
    blocks.push_back(states[knot].values.data());
  }
  if (start.interpolationStates[i].empty()) {
    blocks.push_back(states[seen.state].values.data());
  }
  return blocks;
}

void BundleModel::addSticks() {
  for (std::size_t s = 0; s < states.size(); ++s) {
    const BundleBody& body = problem.bodies[start.states[s].body];
    if (body.kind == Kind::Stick && ceresProblem.HasParameterBlock(states[s].values.data())) {
      ceresProblem.AddResidualBlock(new StickCost(body.length, body.lengthSigma), nullptr,
                                    states[s].values.data());
    }
  }
}

void BundleModel::addPriors() {
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const BundleCamera& wanted = problem.cameras[c];
    CameraBlocks& blocks = cameras[c];
    if (wanted.posePrior && ceresProblem.HasParameterBlock(blocks.pose.data())) {
      const double rotationSigma = wanted.posePrior->rotationSigma;
      const double centerSigma = wanted.posePrior->centerSigma;
      ceresProblem.AddResidualBlock(new PriorCost({blocks.pose.begin(), blocks.pose.end()},
                                                  {rotationSigma, rotationSigma, rotationSigma,
                                                   centerSigma, centerSigma, centerSigma}),
                                    nullptr, blocks.pose.data());
    }
    if (wanted.focalPriorSigma > 0.0 && wanted.isFocalFree &&
        ceresProblem.HasParameterBlock(blocks.lens.data())) {
      std::vector<double> sigmas(kLensSize, 0.0);
      sigmas[0] = wanted.focalPriorSigma * blocks.lens[0];
      ceresProblem.AddResidualBlock(new PriorCost({blocks.lens.begin(), blocks.lens.end()}, sigmas),
                                    nullptr, blocks.lens.data());
    }
  }
}

void BundleModel::fixKnownParameters() {
  const auto hold = [&](double* block, bool held) {
    if (held && ceresProblem.HasParameterBlock(block)) {
      ceresProblem.SetParameterBlockConstant(block);
    }
  };
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const BundleCamera& wanted = problem.cameras[c];
    const std::vector<int> held = fixedLensEntries(wanted);
    double* lens = cameras[c].lens.data();
    hold(cameras[c].pose.data(), wanted.isPoseFixed);
    hold(lens, held.size() == kLensSize);
    hold(&cameras[c].timeOffset, !wanted.isTimeOffsetFree);
    if (!held.empty() && held.size() < kLensSize && ceresProblem.HasParameterBlock(lens)) {
      ceresProblem.SetManifold(lens, new ceres::SubsetManifold(kLensSize, held));
    }
  }
  for (std::size_t s = 0; s < states.size(); ++s) {
    hold(states[s].values.data(), start.states[s].isFixed);
  }
}

} // namespace dewpoint::calibration

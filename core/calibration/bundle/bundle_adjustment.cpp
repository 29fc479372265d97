// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle/bundle_adjustment.h"

#include "core/calibration/bundle/bundle_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <ceres/ceres.h>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace dewpoint::calibration {
namespace {

using Kind = BundleBody::Kind;

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Relative change of the cost at which the solver ends, ...
constexpr double kFunctionTolerance = 1e-10;
/// ... and of the parameters.
constexpr double kParameterTolerance = 1e-10;
/// The former where a draft is enough (BundleProblem::isDraft).
constexpr double kDraftTolerance = 1e-5;
/// Steps are damped by at least the inverse, in units of each parameter's own precision: where the
/// world is not tied down, its normal equations are singular without.
constexpr double kLargestTrust = 1e8;

class StopOnRequest final : public ceres::IterationCallback {
public:
  StopOnRequest(const BundleCallback& callback, std::size_t observations)
      : callback_(callback), observations_(observations) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    const double rms = std::sqrt(2.0 * summary.cost / static_cast<double>(observations_));
    return !callback_ || callback_({summary.iteration, rms}) ? ceres::SOLVER_CONTINUE
                                                             : ceres::SOLVER_ABORT;
  }

private:
  const BundleCallback& callback_;
  std::size_t observations_;
};

/// A bundle problem in the solver's terms.
class Adjustment {
public:
  Adjustment(const BundleProblem& problem, BundleStart start) : model_(problem, std::move(start)) {}

  Result<BundleResult> run(const BundleCallback& callback) {
    ceres::Solver::Options options = solverOptions();
    StopOnRequest stop(callback, std::max<std::size_t>(model_.usedObservationCount, 1));
    options.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    const auto begin = std::chrono::steady_clock::now();
    ceres::Solve(options, &model_.ceresProblem, &summary);
    if (summary.termination_type == ceres::USER_FAILURE) {
      return failure(ErrorCode::Canceled, "", "", "");
    }
    if (summary.termination_type == ceres::FAILURE) {
      return failure(ErrorCode::Undetermined, "", "", "the optimization failed numerically");
    }
    if (summary.termination_type == ceres::NO_CONVERGENCE && !model_.problem.isDraft) {
      return failure(ErrorCode::Undetermined, "", "",
                     fmt::format("the optimization did not converge within {} iterations",
                                 model_.problem.maxIterations));
    }
    BundleResult result = solution();
    result.iterationCount = static_cast<int>(summary.iterations.size());
    if (auto known = model_.problem.isDraft ? Status() : addCovariance(result); !known) {
      return tl::make_unexpected(known.error());
    }
    result.computationSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  }

private:
  ceres::Solver::Options solverOptions() {
    ceres::Solver::Options options;
    options.num_threads = 1; // sums in one order: the same bits every time
    options.max_num_iterations = model_.problem.maxIterations;
    options.function_tolerance = model_.problem.isDraft ? kDraftTolerance : kFunctionTolerance;
    options.max_trust_region_radius = kLargestTrust;
    options.parameter_tolerance = kParameterTolerance;
    options.logging_type = ceres::SILENT;
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    if (model_.start.hasInterpolation) { // neighboring instants meet in one residual: nothing to
                                         // eliminate at once
      options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
      return options;
    }
    options.linear_solver_type = ceres::DENSE_SCHUR;
    auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    for (std::size_t s = 0; s < model_.states.size(); ++s) {
      if (model_.isInProblem(model_.states[s].values.data())) {
        ordering->AddElementToGroup(model_.states[s].values.data(), 0);
      }
    }
    for (BundleModel::CameraBlocks& camera : model_.cameras) {
      for (double* block : {camera.pose.data(), camera.lens.data(), &camera.timeOffset}) {
        if (model_.isInProblem(block)) {
          ordering->AddElementToGroup(block, 1);
        }
      }
    }
    options.linear_solver_ordering = ordering;
    return options;
  }

  bool isAnyCameraVariable() const {
    return std::any_of(model_.cameras.begin(), model_.cameras.end(), [&](const auto& camera) {
      return model_.isVariable(camera.pose.data()) || model_.isVariable(camera.lens.data()) ||
             model_.isVariable(&camera.timeOffset);
    });
  }

  BundleResult solution() {
    BundleResult result;
    for (std::size_t c = 0; c < model_.cameras.size(); ++c) {
      Camera camera = model_.problem.cameras[c].camera;
      const BundleModel::CameraBlocks& blocks = model_.cameras[c];
      if (model_.isVariable(model_.cameras[c].pose.data())) {
        const Eigen::Map<const Eigen::Vector3d> turn(blocks.pose.data());
        const Eigen::Map<const Eigen::Vector3d> center(blocks.pose.data() + 3);
        const Eigen::Quaterniond rotation(
            Eigen::Matrix3d(rotationExponential(turn) * blocks.referenceRotation));
        camera.cameraFromWorld.linear() = rotation.normalized().toRotationMatrix();
        camera.cameraFromWorld.translation() = -camera.cameraFromWorld.linear() * center;
      }
      if (model_.isVariable(model_.cameras[c].lens.data())) {
        setLens(blocks.lens, camera);
      }
      result.cameras.push_back(camera);
      result.timeOffsets.push_back(blocks.timeOffset);
    }
    result.states = model_.start.states;
    for (std::size_t s = 0; s < model_.states.size(); ++s) {
      takeState(s, result.states[s]);
    }
    takeResiduals(result);
    return result;
  }

  void takeState(std::size_t s, BundleState& state) {
    const Eigen::Map<const Eigen::Vector3d> first(model_.states[s].values.data());
    const Eigen::Map<const Eigen::Vector3d> second(model_.states[s].values.data() + 3);
    state.isPositionKnown =
        model_.start.isStateUsed[s] && model_.isInProblem(model_.states[s].values.data());
    if (model_.problem.bodies[state.body].kind == Kind::Board) {
      state.worldFromBoard.linear() =
          rotationExponential(first) * model_.states[s].referenceRotation;
      state.worldFromBoard.translation() = second;
    } else {
      state.ends = {first, second};
    }
  }

  void takeResiduals(BundleResult& result) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    result.residuals.assign(model_.costFunctions.size(), Eigen::Vector2d(none, none));
    std::vector<double> sums(model_.cameras.size(), 0.0);
    std::vector<std::size_t> counts(model_.cameras.size(), 0);
    double sum = 0.0;
    for (std::size_t i = 0; i < model_.costFunctions.size(); ++i) {
      if (model_.costFunctions[i] == nullptr) {
        continue;
      }
      const std::vector<double*> blocks = model_.blocksOf(i);
      model_.costFunctions[i]->Evaluate(blocks.data(), result.residuals[i].data(), nullptr);
      result.residuals[i] *= model_.problem.observations[i].sigma;
      const double squares = result.residuals[i].squaredNorm();
      sums[model_.problem.observations[i].camera] += squares;
      ++counts[model_.problem.observations[i].camera];
      sum += squares;
    }
    result.usedObservationCount = model_.usedObservationCount;
    result.rmsPx =
        std::sqrt(sum / static_cast<double>(std::max<std::size_t>(model_.usedObservationCount, 1)));
    for (std::size_t c = 0; c < sums.size(); ++c) {
      result.cameraRmsPx.push_back(
          counts[c] == 0 ? none : std::sqrt(sums[c] / static_cast<double>(counts[c])));
    }
  }

  /// The world's freedoms that nothing in the problem ties down.
  int gaugeFreedomCount() const {
    std::size_t anchors = 0;
    for (const BundleCamera& camera : model_.problem.cameras) {
      anchors += camera.isPoseFixed || camera.posePrior ? 1 : 0;
    }
    bool sized = anchors > 1;
    for (std::size_t s = 0; s < model_.states.size(); ++s) {
      if (!model_.start.isStateUsed[s]) {
        continue;
      }
      const Kind kind = model_.problem.bodies[model_.start.states[s].body].kind;
      sized = sized || kind != Kind::Point;
      anchors += model_.start.states[s].isFixed ? (kind == Kind::Board ? 1 : 0) : 0;
    }
    return (anchors > 0 ? 0 : 6) + (sized ? 0 : 1);
  }

  /// Columns of the cameras that vary, their blocks, then those of the bodies.
  std::vector<double*> varyingBlocks(std::vector<CameraParameterColumn>& columns) {
    std::vector<double*> blocks;
    const auto add = [&](double* block, std::size_t camera, CameraQuantity first, int size,
                         const std::vector<int>& held) {
      if (!model_.isVariable(block)) {
        return;
      }
      blocks.push_back(block);
      for (int i = 0; i < size; ++i) {
        if (!std::binary_search(held.begin(), held.end(), i)) {
          columns.push_back({camera, static_cast<CameraQuantity>(static_cast<int>(first) + i)});
        }
      }
    };
    for (std::size_t c = 0; c < model_.cameras.size(); ++c) {
      add(model_.cameras[c].pose.data(), c, CameraQuantity::TurnX, kPoseSize, {});
      add(model_.cameras[c].lens.data(), c, CameraQuantity::Focal, kLensSize,
          BundleModel::fixedLensEntries(model_.problem.cameras[c]));
      add(&model_.cameras[c].timeOffset, c, CameraQuantity::TimeOffset, 1, {});
    }
    for (BundleModel::StateBlock& state : model_.states) {
      if (model_.isVariable(state.values.data())) {
        blocks.push_back(state.values.data());
      }
    }
    return blocks;
  }

  Status addCovariance(BundleResult& result) {
    BundleCovariance& covariance = result.covariance;
    covariance.gaugeFreedomCount = gaugeFreedomCount();
    ceres::Problem::EvaluateOptions options;
    options.num_threads = 1;
    options.parameter_blocks = varyingBlocks(covariance.columns);
    if (options.parameter_blocks.empty()) {
      return {};
    }
    double cost = 0.0;
    ceres::CRSMatrix rows;
    if (!model_.ceresProblem.Evaluate(options, &cost, nullptr, nullptr, &rows)) {
      return failure(ErrorCode::Undetermined, "", "", "the optimization failed numerically");
    }
    using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    const Eigen::SparseMatrix<double> jacobian = Eigen::Map<const RowMatrix>(
        rows.num_rows, rows.num_cols, static_cast<int>(rows.values.size()), rows.rows.data(),
        rows.cols.data(), rows.values.data());
    const double freedoms =
        static_cast<double>(rows.num_rows - rows.num_cols + covariance.gaugeFreedomCount);
    result.residualToSigmaRatio = freedoms > 0.0 ? std::sqrt(2.0 * cost / freedoms) : 0.0;
    const auto cameraColumns = static_cast<Eigen::Index>(covariance.columns.size());
    if (cameraColumns == 0) {
      return {};
    }
    auto matrix = reducedCovariance(jacobian, cameraColumns, covariance.gaugeFreedomCount);
    if (freedoms <= 0.0 || !matrix) {
      return failure(ErrorCode::Undetermined, "", "",
                     "the observed positions and directions do not determine the cameras");
    }
    covariance.matrix = rotatedIntoWorld(std::move(*matrix), covariance.columns);
    return {};
  }

  /// Turns are parameters of a rotation vector against a fixed rotation; what is reported is a turn
  /// of the result.
  Eigen::MatrixXd rotatedIntoWorld(Eigen::MatrixXd matrix,
                                   const std::vector<CameraParameterColumn>& columns) const {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].quantity != CameraQuantity::TurnX) {
        continue;
      }
      const Eigen::Map<const Eigen::Vector3d> turn(model_.cameras[columns[i].camera].pose.data());
      Eigen::Matrix3d left; // columns: d(exp(turn) y)/d turn = -[y]x left, read off for y = e_k
      const Eigen::Matrix3d z = rotationExponentialDerivative(turn, Eigen::Vector3d::UnitZ());
      const Eigen::Matrix3d x = rotationExponentialDerivative(turn, Eigen::Vector3d::UnitX());
      left.row(0) = -z.row(1);
      left.row(1) = z.row(0);
      left.row(2) = x.row(1);
      const auto at = static_cast<Eigen::Index>(i);
      matrix.middleRows<3>(at) = (left * matrix.middleRows<3>(at)).eval();
      matrix.middleCols<3>(at) = (matrix.middleCols<3>(at) * left.transpose()).eval();
    }
    return matrix;
  }

  BundleModel model_;
};

} // namespace

Result<BundleResult> adjustBundle(const BundleProblem& problem, const BundleCallback& callback) {
  auto start = initializeBundle(problem);
  if (!start) {
    return tl::make_unexpected(start.error());
  }
  try {
    return Adjustment(problem, std::move(*start)).run(callback);
  } catch (const std::exception& error) {
    return failure(ErrorCode::Undetermined, "", "", error.what());
  }
}

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/convergence_csv.h"

#include "core/base/units.h"
#include "core/trajectory/csv_text.h"

#include <fmt/format.h>

namespace dewpoint::experiment {
namespace {

std::string cellsOf(const Eigen::Vector3d& point) {
  return fmt::format("{:g},{:g},{:g}", point.x(), point.y(), point.z());
}

} // namespace

std::string convergenceCsv(const std::vector<ConvergenceResult>& results) {
  std::string text = "case,ball_x_m,ball_y_m,ball_z_m,start_x_m,start_y_m,start_z_m,half_x_m,"
                     "half_y_m,half_z_m,first_seed,runs,converged,within,median_iterations,"
                     "rmse_mm,depth_bias_mm\n";
  for (const ConvergenceResult& result : results) {
    const ConvergenceCase& setup = result.setup;
    text += fmt::format("{},{},{},{},{},{},{},{}", csvCell(setup.name), cellsOf(setup.ballPosition),
                        cellsOf(setup.startPosition), cellsOf(setup.startHalfSize), setup.firstSeed,
                        setup.runCount, result.convergedRunCount, result.accurateRunCount);
    text += result.convergedRunCount > 0
                ? fmt::format(",{:g},{:.6g},{:.6g}\n", result.medianIterations,
                              inMillimeters(result.rmse), inMillimeters(result.depthBias))
                : std::string(",,,\n");
  }
  return text;
}

std::string driftCsv(const std::vector<DriftResult>& results) {
  std::string text = "first_seed,runs,iterations,mm_per_iteration\n";
  for (const DriftResult& result : results) {
    text += fmt::format("{},{},{},{:.6g}\n", result.firstSeed, result.runCount,
                        result.iterationCount, inMillimeters(result.metersPerIteration));
  }
  return text;
}

} // namespace dewpoint::experiment

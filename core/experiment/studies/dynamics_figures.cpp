// SPDX-License-Identifier: GPL-3.0-or-later
// Barrera et al. 2005, section III-C: figures 6, 7 and 8.
#include "core/experiment/studies/dynamics_figures.h"

#include "core/experiment/report/figure_page.h"
#include "core/experiment/report/figure_parts.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/studies/dynamics_study.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dewpoint::experiment {
namespace {

constexpr double kConverged = 0.1;     // meters: the sigma of the observation
constexpr double kPaperSigma = 0.03;   // meters, as stated
constexpr double kFittingSigma = 0.06; // meters: with which the paper's iterations come out

/// What was chosen where the paper is silent; `start` says where the cloud starts.
std::string chosen(const std::string& start) {
  return fmt::format("The paper states neither the sigma of its observation nor where the cloud "
                     "starts. Here the observation has a sigma of 0.1 m, in logarithms (at 2 m a "
                     "likelihood would be exp(-200)); the cloud starts {}; converged means an "
                     "error below 0.1 m for good. 200 particles.",
                     start);
}

constexpr const char* kStartsBeside = "0.6 m from the object";

std::string iterationsText(int iterations) {
  return iterations < 0 ? "not before the end" : fmt::format("{} iterations", iterations);
}

Plot errorPlot(const std::vector<std::pair<std::string, std::vector<double>>>& curves) {
  Plot plot;
  plot.title = "Position error over iterations";
  plot.x = {"iteration", 0.0, double(curves.front().second.size()), false};
  plot.y = {"error, m", 0.0, 2.2, false};
  for (const auto& [style, errors] : curves) {
    plot.series.push_back(lineSeries(style, errors));
  }
  return plot;
}

/// How many iterations it takes to find the object first, and after its jump.
struct Convergence {
  int first, again;
};

Convergence convergenceOf(const std::vector<double>& errors, const DynamicsSetup& setup) {
  return {iterationsUntilErrorBelow(errors, 0, setup.jumpIteration, kConverged),
          iterationsUntilErrorBelow(errors, setup.jumpIteration, int(errors.size()), kConverged)};
}

/// Errors as gray, black 2 m, white 0; a row per sigma, the smallest at the bottom.
cv::Mat errorImage(const std::vector<std::vector<double>>& rows) {
  constexpr double kBlack = 2.0; // meters; chosen
  cv::Mat image(int(rows.size()), int(rows.front().size()), CV_8UC1);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double error = rows[std::size_t(image.rows - 1 - y)][std::size_t(x)];
      image.at<std::uint8_t>(y, x) =
          cv::saturate_cast<std::uint8_t>(255.0 * (1.0 - std::min(error, kBlack) / kBlack));
    }
  }
  return image;
}

/// Frame, axes and their numbers around the image of errors.
cv::Mat framed(const cv::Mat& errors, double lowest, double highest) {
  // Pixels.
  constexpr int kScaleX = 8;
  constexpr int kScaleY = 4;
  constexpr int kLeft = 64;
  constexpr int kBottom = 48;
  cv::Mat large;
  cv::resize(errors, large, {}, kScaleX, kScaleY, cv::INTER_NEAREST);
  cv::Mat page;
  cv::copyMakeBorder(large, page, 16, kBottom, kLeft, 24, cv::BORDER_CONSTANT, 255);
  const auto write = [&](const std::string& text, cv::Point at) {
    cv::putText(page, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.42, 0, 1, cv::LINE_AA);
  };
  cv::rectangle(page, {kLeft - 1, 15, large.cols + 2, large.rows + 2}, 0);
  for (int iteration = 0; iteration <= errors.cols; iteration += 10) {
    write(fmt::format("{}", iteration), {kLeft + iteration * kScaleX - 6, 16 + large.rows + 18});
  }
  write("iteration", {kLeft + large.cols / 2 - 30, 16 + large.rows + 38});
  constexpr int kMarks = 6; // numbers along an axis
  for (int mark = 0; mark <= kMarks; ++mark) {
    const double sigma = lowest + (highest - lowest) * mark / kMarks;
    write(fmt::format("{:.3f}", sigma), {8, 20 + large.rows - large.rows * mark / kMarks});
  }
  return page;
}

Plot cloudPlot(const DynamicsRun& run) {
  Plot plot;
  plot.title = "Particles at six instants, along and across the jump";
  plot.x.label = "along the jump, m";
  plot.y.label = "across, m";
  for (std::size_t k = 0; k < run.particleClouds.size(); ++k) {
    plot.series.push_back(pointSeries(fmt::format("m{}", k), run.particleClouds[k], 0, 1));
  }
  return plot;
}

/// A row per sigma and iteration: the numbers of the image.
std::string errorImageCsv(const std::vector<double>& sigmas,
                          const std::vector<std::vector<double>>& errors) {
  std::string text = "motion_sigma_m,iteration,error_m\n";
  for (std::size_t row = 0; row < sigmas.size(); ++row) {
    for (std::size_t k = 0; k < errors[row].size(); ++k) {
      text += fmt::format("{},{},{}\n", sigmas[row], k, errors[row][k]);
    }
  }
  return text;
}

/// The particles that are drawn, as CSV.
std::string cloudsCsv(std::span<const double> sigmas, std::span<const DynamicsRun> runs,
                      const std::vector<int>& instants) {
  std::string text = "motion_sigma_m,iteration,particle,x_m,y_m,z_m\n";
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (std::size_t k = 0; k < instants.size(); ++k) {
      const Eigen::ArrayXXd& cloud = runs[run].particleClouds[k];
      for (Eigen::Index i = 0; i < cloud.rows(); ++i) {
        text += fmt::format("{},{},{},{},{},{}\n", sigmas[run], instants[k], i, cloud(i, 0),
                            cloud(i, 1), cloud(i, 2));
      }
    }
  }
  return text;
}

/// Error and spreads after every iteration, as CSV.
std::string spreadsCsv(std::span<const double> sigmas, std::span<const DynamicsRun> runs) {
  std::string text = "motion_sigma_m,iteration,error_m,cloud_spread_m,belief_spread_m\n";
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (std::size_t k = 0; k < runs[run].errors.size(); ++k) {
      text += fmt::format("{},{},{},{},{}\n", sigmas[run], k, runs[run].errors[k],
                          runs[run].cloudSpreads[k], runs[run].beliefSpreads[k]);
    }
  }
  return text;
}

} // namespace

Status writeDynamicsFigure6(const ExperimentOptions& options) {
  const int runs = options.runCount;
  FigurePage page("Error after a jump of the object (figure 6)", chosen(kStartsBeside));
  std::vector<std::vector<double>> columns(1);
  std::vector<std::pair<std::string, std::vector<double>>> curves;
  std::vector<std::vector<std::string>> rows;
  std::vector<Convergence> found;
  const std::array sigmas{kPaperSigma, kFittingSigma, 0.1};
  PlotLegend legend;
  for (std::size_t k = 0; k < sigmas.size(); ++k) {
    DynamicsSetup setup;
    setup.motionSigma = sigmas[k];
    const auto errors = measureMeanErrors(setup, runs, options.firstSeed);
    const Convergence one = found.emplace_back(convergenceOf(errors, setup));
    const double limit = findMaxTrackableSpeed(setup, 10, options.firstSeed);
    const double most = distanceAdvancedTowardFarObject(setup, 10, options.firstSeed);
    rows.push_back({fmt::format("{:.2f} m", sigmas[k]), iterationsText(one.first),
                    fmt::format("{:.2f} m", errors[std::size_t(setup.jumpIteration)]),
                    iterationsText(one.again),
                    fmt::format("{:.3f} m, {:.2f} sigma_m", limit, limit / sigmas[k]),
                    fmt::format("{:.3f} m, {:.2f} sigma_m", most, most / sigmas[k])});
    curves.emplace_back(fmt::format("m{}", k), errors);
    legend.emplace_back(fmt::format("m{}", k), fmt::format("sigma_m {:.2f} m", sigmas[k]));
    columns.push_back(errors);
    if (!reportProgress(options, double(k + 1) / double(sigmas.size()))) {
      return stoppedExperimentError();
    }
  }
  for (std::size_t k = 0; k < columns[1].size(); ++k) {
    columns[0].push_back(double(k));
  }
  page.addPlots({{fmt::format("Mean of {} runs", runs), errorPlot(curves)}}, legend);
  page.addParagraph("Seeds " + describeSeeds(options.firstSeed, runs) + ".");
  page.addTable({"motion sigma", "first found after", "error at iteration 30", "found again after",
                 "fastest it follows, per iteration", "its way toward a far object, per iteration"},
                rows);
  page.addHeading("What the paper says");
  page.addClaim(
      "Converged after about 5 iterations.", std::abs(found[0].first - 5) <= 3,
      fmt::format("Here after {} with the stated sigma_m of 0.03 m, after {} with 0.06 m.",
                  iterationsText(found[0].first), iterationsText(found[1].first)));
  page.addClaim("The error is 2 m at iteration 30.", std::abs(columns[1][30] - 2.0) < 0.2,
                fmt::format("Here {:.2f} m.", columns[1][30]));
  page.addClaim(
      "About 15 more iterations to converge again.", std::abs(found[0].again - 15) <= 3,
      fmt::format("Here {} with 0.03 m, {} with 0.06 m: a cloud of 200 particles moves at "
                  "most about 2.75 sigma_m per iteration, so that 2 m in 15 iterations "
                  "need about 0.05 m or more.",
                  iterationsText(found[0].again), iterationsText(found[1].again)));
  page.addDataFile("errors.csv", numbersAsCsv({"iteration", "error_sigma_0.03_m",
                                               "error_sigma_0.06_m", "error_sigma_0.10_m"},
                                              columns));
  return page.write(options.outputFolder);
}

Status writeDynamicsFigure7(const ExperimentOptions& options) {
  // Meters: the range of the paper's figure, in as many steps.
  constexpr int kSigmas = 100;
  constexpr double kLowest = 0.001;
  constexpr double kHighest = 0.3;
  std::vector<std::vector<double>> errors;
  std::vector<std::vector<double>> columns(3);
  for (int k = 0; k < kSigmas; ++k) {
    DynamicsSetup setup;
    setup.startPosition = setup.positionBeforeJump; // found already, whatever the sigma
    setup.motionSigma = kLowest + (kHighest - kLowest) * k / (kSigmas - 1);
    errors.push_back(measureMeanErrors(setup, options.runCount, options.firstSeed));
    columns[0].push_back(setup.motionSigma);
    columns[1].push_back(convergenceOf(errors.back(), setup).again);
    columns[2].push_back(errors.back()[69]);
    if (!reportProgress(options, double(k + 1) / kSigmas)) {
      return stoppedExperimentError();
    }
  }
  FigurePage page("Error after each iteration, for different motion sigmas (figure 7)",
                  chosen("on the object, so that a small sigma_m has found it, too"));
  page.addPngImage(
      "figure7",
      fmt::format("Mean error of {} runs: black 2 m, white 0. Across: iterations; upwards: "
                  "sigma_m from 0.001 to 0.3 m",
                  options.runCount),
      framed(errorImage(errors), kLowest, kHighest));
  page.addParagraph("Seeds " + describeSeeds(options.firstSeed, options.runCount) + ".");
  const auto at = [&](double sigma) {
    return std::size_t(std::lround((sigma - kLowest) / (kHighest - kLowest) * (kSigmas - 1)));
  };
  std::vector<std::vector<std::string>> rows;
  for (const double sigma : {0.01, 0.02, 0.03, 0.06, 0.1, 0.15, 0.2, 0.3}) {
    rows.push_back({fmt::format("{:.2f} m", columns[0][at(sigma)]),
                    iterationsText(int(columns[1][at(sigma)])),
                    fmt::format("{:.3f} m", columns[2][at(sigma)])});
  }
  page.addTable({"motion sigma", "found again after", "error at iteration 70"}, rows);
  page.addHeading("What the paper says");
  const double slow = columns[1][at(0.05)];
  const double middle = columns[1][at(0.1)];
  const double fast = columns[1][at(0.2)];
  page.addClaim("A larger sigma_m finds the new place sooner, with diminishing gain.",
                slow > middle && middle >= fast && slow - middle > middle - fast,
                fmt::format("Here {:.0f}, {:.0f} and {:.0f} iterations at 0.05, 0.1 and 0.2 m.",
                            slow, middle, fast));
  page.addClaim(
      "For very low sigma_m the new place is not found before iteration 70.",
      columns[2][at(0.01)] > kConverged,
      fmt::format("Here the error at iteration 70 is {:.2f} m with 0.01 m.", columns[2][at(0.01)]));
  page.addDataFile(
      "again.csv",
      numbersAsCsv({"motion_sigma_m", "iterations_to_find_again", "error_at_70_m"}, columns));
  page.addDataFile("errors.csv", errorImageCsv(columns[0], errors));
  return page.write(options.outputFolder);
}

Status writeDynamicsFigure8(const ExperimentOptions& options) {
  const std::vector<int> instants{29, 32, 36, 42, 50, 69};
  FigurePage page("The particle cloud over time (figure 8)",
                  "Particles at iterations 29, 32, 36, 42, 50 and 69; the object jumps by 2 m "
                  "before iteration 30. Projected to the plane of the jump.");
  page.addParagraph(chosen(kStartsBeside));
  page.addParagraph("Seeds " + describeSeeds(options.firstSeed, 1) + ".");
  std::array<DynamicsRun, 2> runs;
  std::array<Plot, 2> clouds;
  constexpr std::array kSigmas{0.03, 0.15}; // meters: the paper's, and five times that
  for (std::size_t k = 0; k < kSigmas.size(); ++k) {
    DynamicsSetup setup;
    setup.motionSigma = kSigmas[k];
    runs[k] = runDynamics(setup, options.firstSeed, instants);
    clouds[k] = cloudPlot(runs[k]);
    if (!reportProgress(options, double(k + 1) / double(kSigmas.size()))) {
      return stoppedExperimentError();
    }
  }
  setCommonAxes({&clouds[0], &clouds[1]});
  PlotLegend legend;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    legend.emplace_back(fmt::format("m{}", i), fmt::format("iteration {}", instants[i]));
    const auto at = std::size_t(instants[i]);
    std::vector<std::string>& row = rows.emplace_back();
    row.push_back(std::to_string(instants[i]));
    for (const DynamicsRun& run : runs) {
      for (const double value : {run.errors[at], run.cloudSpreads[at], run.beliefSpreads[at]}) {
        row.push_back(fmt::format("{:.2f} m", value));
      }
    }
  }
  page.addPlots({{"sigma_m 0.03 m", clouds[0]}, {"sigma_m 0.15 m", clouds[1]}}, legend);
  page.addTable({"iteration", "error, 0.03 m", "spread of the cloud, 0.03 m",
                 "of the belief, 0.03 m", "error, 0.15 m", "spread of the cloud, 0.15 m",
                 "of the belief, 0.15 m"},
                rows);
  page.addParagraph(
      "Drawn are all particles after the prediction, all alike: that is the cloud, and "
      "its spread is their root mean square distance to their mean. The belief is the "
      "same particles weighted by the measurement. While the object is far away, the "
      "few nearest have all the weight, so that the belief is much narrower than what "
      "is drawn.");
  page.addHeading("What the paper says");
  page.addClaim("A small sigma_m approaches slowly and stays compact.",
                runs[0].cloudSpreads[69] < runs[1].cloudSpreads[69],
                fmt::format("Spread of the cloud at iteration 69: {:.2f} m against {:.2f} m.",
                            runs[0].cloudSpreads[69], runs[1].cloudSpreads[69]));
  page.addClaim("A large sigma_m arrives sooner, but spread over a wide area.",
                runs[1].errors[36] < runs[0].errors[36],
                fmt::format("Error at iteration 36: {:.2f} m against {:.2f} m.", runs[1].errors[36],
                            runs[0].errors[36]));
  page.addDataFile("spreads.csv", spreadsCsv(kSigmas, runs));
  page.addDataFile("clouds.csv", cloudsCsv(kSigmas, runs, instants));
  return page.write(options.outputFolder);
}

} // namespace dewpoint::experiment

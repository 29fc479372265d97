// SPDX-License-Identifier: GPL-3.0-or-later
// Barrera et al. 2005, section III-B: figure 5, the drift and the starts.
#include "core/experiment/studies/drift_figures.h"

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/experiment/report/figure_page.h"
#include "core/experiment/report/figure_parts.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/studies/convergence_study.h"
#include "core/simulation/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace dewpoint::experiment {
namespace {

const Eigen::Vector3d kBall = simulation::kDeskCenter; ///< on camera 1's optical axis
constexpr double kMotionSigma = 0.03; ///< meters per axis and iteration, the paper's
constexpr double kHalfWindow = 2.5;   ///< pixels: a window of 5 x 5 reaches so far

// ---- figure 5

constexpr std::array kConeInstants{1, 10, 40};      ///< iterations of which the clouds are drawn
constexpr std::array kConeDepths{0.25, 0.5, 1.0};   ///< meters from the camera; chosen
constexpr double kLongestStep = 2.0 * kMotionSigma; ///< meters
constexpr int kStepCount = 25;                      ///< steps along the axis, both ends included

/// The slope of the cone in which camera 1 finds the ball's color in some pixel of a window: the
/// ball's outline, widened by half a window.
double coneSlope(const Camera& camera) {
  const double distance = (kBall - camera.center()).norm();
  const double radius = demoScene().balls.front().radius;
  return std::tan(std::asin(radius / distance)) + kHalfWindow / camera.intrinsics.focalX;
}

/// The cloud of a run with camera 1 alone that starts on the ball, after some iterations.
Result<std::map<int, Eigen::ArrayXXd>> cloudsOfOneCamera(const ConvergenceCase& setup,
                                                         std::uint64_t seed) {
  std::map<int, Eigen::ArrayXXd> clouds;
  return watchConvergence(
             setup, seed,
             [&](int iteration, const TrackingRun& run, const SphereEstimate& estimate) {
               if (std::ranges::find(kConeInstants, iteration) != kConeInstants.end()) {
                 Eigen::ArrayXd weights;
                 run.copyParticles(0, estimate.particleCount, clouds[iteration], weights);
               }
             })
      .map([&] { return clouds; });
}

/// The cone's two edges seen from above, from the camera's center to `length` meters along its
/// optical axis.
SvgSeries coneEdges(const Camera& camera, double length, const std::string& style) {
  const Eigen::Vector2d apex = camera.center().head<2>();
  const Eigen::Vector2d forward = camera.opticalAxis().head<2>();
  const Eigen::Vector2d side = coneSlope(camera) * Eigen::Vector2d(-forward.y(), forward.x());
  const Eigen::Vector2d left = apex + length * (forward + side);
  const Eigen::Vector2d right = apex + length * (forward - side);
  SvgSeries series;
  series.style = style;
  series.points = {{left.x(), left.y()}, {apex.x(), apex.y()}, {right.x(), right.y()}};
  return series;
}

Plot conePlot(const Camera& camera, const std::map<int, Eigen::ArrayXXd>& clouds,
              PlotLegend& legend) {
  Plot plot;
  plot.title = "The cone of camera 1 and the particles in it, from above";
  plot.x.label = "x, m";
  plot.y.label = "y, m";
  double length = (kBall - camera.center()).norm();
  for (const auto& [iteration, cloud] : clouds) {
    const std::string style = fmt::format("m{}", legend.size());
    plot.series.push_back(pointSeries(style, cloud, 0, 1));
    legend.emplace_back(style, fmt::format("iteration {}", iteration));
    const Eigen::VectorXd depths =
        (cloud.matrix().rowwise() - camera.center().transpose()) * camera.opticalAxis();
    length = std::max(length, depths.maxCoeff());
  }
  Eigen::ArrayXXd positions(2, 3);
  positions << kBall.transpose().array(), camera.center().transpose().array();
  plot.series.push_back(pointSeries("m4", positions, 0, 1, 60.0));
  legend.emplace_back("m4", "the ball and camera 1");
  plot.series.push_back(coneEdges(camera, length, "m5"));
  legend.emplace_back("m5", "where camera 1 finds the ball's color");
  setCommonAxes({&plot});
  return plot;
}

/// The chance to stay in the cone at each step, one curve per depth.
struct StayCurves {
  std::vector<double> steps; ///< meters along the optical axis, away from the camera
  std::vector<std::vector<double>> shares;
};

StayCurves stayCurves(double slope) {
  StayCurves curves;
  for (int k = 0; k < kStepCount; ++k) {
    curves.steps.push_back(kLongestStep * (2.0 * k / (kStepCount - 1) - 1.0));
  }
  for (const double depth : kConeDepths) {
    curves.shares.push_back(fractionStayingInCone(slope, depth, kMotionSigma, curves.steps));
  }
  return curves;
}

Plot stayPlot(const StayCurves& curves, PlotLegend& legend) {
  Plot plot;
  plot.title = "Chance to stay in the cone";
  plot.x = {"step away from the camera, m", -kLongestStep, kLongestStep, false};
  plot.y = {"chance to stay in the cone", 0.0, 1.0, false};
  const double spacing = curves.steps[1] - curves.steps[0];
  for (std::size_t k = 0; k < kConeDepths.size(); ++k) {
    const std::string style = fmt::format("m{}", k);
    plot.series.push_back(lineSeries(style, curves.shares[k], -kLongestStep, spacing));
    legend.emplace_back(style, fmt::format("{} m from the camera", kConeDepths.at(k)));
  }
  return plot;
}

void assessCone(const StayCurves& curves, FigurePage& page) {
  // One sigma of motion is half the longest step: a quarter of the way from either end.
  const std::size_t toward = kStepCount / 4;
  const std::size_t away = kStepCount - 1 - toward;
  std::string here;
  bool isAlways = true;
  for (std::size_t k = 0; k < kConeDepths.size(); ++k) {
    const std::vector<double>& shares = curves.shares[k];
    isAlways = isAlways && shares[away] > shares[toward];
    here += fmt::format("{}{:.0f} % against {:.0f} % at {} m", k == 0 ? "" : ", ",
                        inPercent(shares[toward]), inPercent(shares[away]), kConeDepths.at(k));
  }
  page.addHeading("What the paper says");
  page.addClaim(
      "A particle that falls closer to the camera is less likely to project on the ball, and "
      "less likely to survive, than one that falls further.",
      isAlways,
      fmt::format("Here, of particles moved by {} m toward the camera against away from it, "
                  "that many stay in the cone: {}.",
                  kMotionSigma, here));
}

} // namespace

std::vector<double> fractionStayingInCone(double slope, double depth, double motionSigma,
                                          const std::vector<double>& steps) {
  constexpr int kDraws = 20000; // the standard error of a share is at most 0.4 %
  const RandomStream stream(1, 0, 0, RandomPurpose::Simulation);
  std::vector<double> radii; // from the axis, meters, after the sideways part of a step
  radii.reserve(kDraws);
  for (std::uint32_t k = 0; k < kDraws; ++k) {
    const double before = slope * depth * std::sqrt(stream.uniform(k)); // evenly over the disk
    const auto normal = stream.normal4(k, 1);
    radii.push_back(std::hypot(before + motionSigma * normal[0], motionSigma * normal[1]));
  }
  std::ranges::sort(radii);
  std::vector<double> shares;
  shares.reserve(steps.size());
  for (const double step : steps) {
    const auto end = std::ranges::upper_bound(radii, slope * (depth + step));
    shares.push_back(double(end - radii.begin()) / kDraws);
  }
  return shares;
}

Status writeBarreraFigure5(const ExperimentOptions& options) {
  ConvergenceCase setup;
  setup.ballPosition = kBall;
  setup.startPosition = kBall;
  setup.iterationCount = kConeInstants.back();
  setup.cameras.resize(1);
  const auto clouds = cloudsOfOneCamera(setup, options.firstSeed);
  if (!clouds) {
    return tl::make_unexpected(clouds.error());
  }
  const Camera& camera = setup.cameras.front();
  const StayCurves curves = stayCurves(coneSlope(camera));
  FigurePage page(
      "Where a single camera finds the color (figure 5)",
      "Where one camera alone finds the ball's color is a cone: the ball's outline, "
      "widened by half a window of 5 x 5 pixels. The cloud starts on the ball, at (0.5, "
      "0.5, 0.15), and only camera 1 of the simulated demo looks.");
  PlotLegend cloudLegend;
  const Plot cone = conePlot(camera, *clouds, cloudLegend);
  page.addPlots({{"From above: the clouds of one run spread along the cone", cone}}, cloudLegend);
  PlotLegend stayLegend;
  const Plot stay = stayPlot(curves, stayLegend);
  page.addPlots(
      {{"A particle somewhere in the cone is moved by a step along the axis, and sideways as "
        "the motion model draws it: the chance that it is still in the cone",
        stay}},
      stayLegend);
  page.addParagraph("Seeds of the clouds: " + describeSeeds(options.firstSeed, 1) + ".");
  assessCone(curves, page);
  std::vector<std::vector<double>> columns{curves.steps};
  columns.insert(columns.end(), curves.shares.begin(), curves.shares.end());
  page.addDataFile(
      "cone.csv",
      numbersAsCsv({"step_m", "stay_at_0.25_m", "stay_at_0.5_m", "stay_at_1_m"}, columns));
  return page.write(options.outputFolder);
}

Status writeBarreraDrift(const ExperimentOptions& options) {
  constexpr int kIterations = 60; // of the curve; chosen
  const auto moved = measureDriftCurve(options.runCount, kIterations, options.firstSeed);
  if (!moved) {
    return tl::make_unexpected(moved.error());
  }
  FigurePage page("Drift of the estimate along the optical axis",
                  fmt::format("Only camera 1 looks, and the cloud starts on the ball. How far its "
                              "mean has moved away from the camera; mean of {} runs.",
                              options.runCount));
  Plot plot;
  plot.title = "Movement away from the camera";
  plot.x = {"iteration", 0.0, kIterations, false};
  plot.y = {"moved away, m", 0.0, 1.1 * std::max(0.01, std::ranges::max(*moved)), false};
  plot.series.push_back(lineSeries("m0", *moved, 1.0));
  page.addPlots({{"Movement away from camera 1", plot}});
  page.addParagraph("Seeds " + describeSeeds(options.firstSeed, options.runCount) + ".");
  page.addHeading("What the paper says");
  page.addClaim(
      "The particles move away from the camera along its optical axis, systematically.",
      moved->back() > 0.05,
      fmt::format("Here {:.1f} mm per iteration over the first 5, {:.1f} over 40: the drift "
                  "grows with the cloud.",
                  inMillimeters((*moved)[4]) / 5.0, inMillimeters((*moved)[39]) / 40.0));
  std::vector<double> iterations(moved->size());
  std::iota(iterations.begin(), iterations.end(), 1.0);
  page.addDataFile("drift.csv", numbersAsCsv({"iteration", "moved_m"}, {iterations, *moved}));
  return page.write(options.outputFolder);
}

namespace {

/// The shares of runs that converge, per start, and of those that are then within 3 cm.
struct StartShares {
  std::vector<double> converged;
  std::vector<double> within;
};

/// Canceled when it was stopped.
Result<StartShares> sharesOf(const std::vector<ConvergenceCase>& cases,
                             const ExperimentOptions& options, double from, double to) {
  StartShares shares;
  for (const ConvergenceCase& setup : cases) {
    const auto result = studyConvergence(setup);
    if (!result) {
      return tl::make_unexpected(result.error());
    }
    shares.converged.push_back(double(result->convergedRunCount) / setup.runCount);
    shares.within.push_back(double(result->accurateRunCount) / setup.runCount);
    const double part = double(shares.converged.size()) / double(cases.size());
    if (!reportProgress(options, from + (to - from) * part)) {
      return tl::make_unexpected(stoppedExperimentError().error());
    }
  }
  return shares;
}

SvgSeries shareCurve(const std::string& style, const std::vector<double>& at,
                     const std::vector<double>& shares, double area) {
  SvgSeries series;
  series.style = style;
  for (std::size_t k = 0; k < at.size(); ++k) {
    series.points.push_back({at[k], shares[k]});
    series.diskAreas.push_back(area);
  }
  return series;
}

Plot sharePlot(const std::string& what, const std::vector<double>& at, const StartShares& shares) {
  Plot plot;
  plot.title = "Share of runs that converge";
  plot.x = {what, 0.0, 1.05 * at.back(), false};
  plot.y = {"share that converges", 0.0, 1.0, false};
  plot.series.push_back(shareCurve("m0", at, shares.converged, 60.0));
  plot.series.push_back(shareCurve("m1", at, shares.within, 20.0));
  return plot;
}

} // namespace

Status writeBarreraStarts(const ExperimentOptions& options) {
  const std::vector<double> halves{0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0};
  const std::vector<double> beyond{0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 1.0};
  std::vector<ConvergenceCase> boxes;
  boxes.reserve(halves.size());
  for (const double half : halves) {
    boxes.push_back({"box", kBall, kBall, Eigen::Vector3d::Constant(half), options.runCount, 150});
    boxes.back().firstSeed = options.firstSeed;
  }
  std::vector<ConvergenceCase> points;
  points.reserve(beyond.size());
  for (const double y : beyond) {
    points.push_back(
        {"point", kBall, {0.5, y, 0.15}, Eigen::Vector3d::Zero(), options.runCount, 150});
    points.back().firstSeed = options.firstSeed;
  }
  const auto boxShares = sharesOf(boxes, options, 0.0, 0.5);
  if (!boxShares) {
    return tl::make_unexpected(boxShares.error());
  }
  const auto pointShares = sharesOf(points, options, 0.5, 1.0);
  if (!pointShares) {
    return tl::make_unexpected(pointShares.error());
  }
  FigurePage page("From which starting positions the particles still find the target",
                  fmt::format("The ball lies at (0.5, 0.5, 0.15); {} runs per start, 150 "
                              "iterations. A run converges when the spread of its cloud falls "
                              "below {:.0f} mm for good: by that much one step of motion alone "
                              "scatters a point.",
                              options.runCount, inMillimeters(std::sqrt(3.0) * kMotionSigma)));
  page.addPlots({{"Evenly spread in a cube around the ball",
                  sharePlot("half its edge, m", halves, *boxShares)},
                 {"From one point (0.5, y, 0.15), at and beyond the ball",
                  sharePlot("y, m", beyond, *pointShares)}},
                {{"m0", "the cloud has converged"}, {"m1", "and is within 3 cm of the ball"}});
  page.addParagraph("Seeds " + describeSeeds(options.firstSeed, options.runCount) + ".");
  page.addHeading("What the paper says");
  page.addClaim(
      "From random starts it does not converge at all.",
      outcomeOfNoConvergenceClaim(boxShares->converged),
      fmt::format("It depends on the volume, which the paper does not state: here {:.0f} % "
                  "converge from a cube of 0.4 m, {:.0f} % from one of 1 m, {:.0f} % from "
                  "one of 4 m.",
                  inPercent(boxShares->converged[2]), inPercent(boxShares->converged[4]),
                  inPercent(boxShares->converged.back())));
  page.addClaim("From a start farther than the ball it does not converge at all.",
                outcomeOfNoConvergenceClaim(
                    {pointShares->converged.begin() + 1, pointShares->converged.end()}),
                fmt::format("It depends on how far: here {:.0f} % converge from 0.1 m beyond the "
                            "ball, {:.0f} % from 0.3 m, {:.0f} % from 0.5 m.",
                            inPercent(pointShares->converged[2]),
                            inPercent(pointShares->converged[6]),
                            inPercent(pointShares->converged.back())));
  page.addParagraph(
      "Reproduced: fewer than 10 % converge from every start that was tried; in part: "
      "from some of them.");
  page.addDataFile("boxes.csv", numbersAsCsv({"half_edge_m", "share", "share_within_3_cm"},
                                             {halves, boxShares->converged, boxShares->within}));
  page.addDataFile("points.csv",
                   numbersAsCsv({"y_m", "share", "share_within_3_cm"},
                                {beyond, pointShares->converged, pointShares->within}));
  return page.write(options.outputFolder);
}

} // namespace dewpoint::experiment

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/dewpoint_parameters.h"

#include "core/tracking/start_parameters.h"

#include <vector>

namespace dewpoint::tracking {
namespace {

std::vector<ParameterDeclaration> declare() {
  std::vector<ParameterDeclaration> all{
      {"particles", ParameterKind::Integer, "Particles", "", 10.0, 100000.0, 10.0, 500.0,
       "Largest number of particles of each target.", true},
      {"fewest_particles", ParameterKind::Integer, "Minimum particles", "", 10.0, 100000.0, 10.0,
       100.0,
       "Smallest number of particles of each target; used when all its particles are close "
       "together.",
       true, false, ParameterGroup::Expert, "particles"},
      {"kld_error", ParameterKind::Real, "KLD error", "", 0.0, 1.0, 0.01, 0.1,
       "How far the particles may deviate from the distribution that they represent "
       "(Kullback-Leibler divergence). A smaller value uses more particles when the cloud is "
       "spread out; 0 always uses the largest number.",
       false},
      {"time_budget", ParameterKind::Real, "Time budget", "ms", 0.0, 1000.0, 0.5, 0.0,
       "How long one iteration may take. To meet this limit, fewer particles are used and searches "
       "are spread over several frames. 0 sets no limit. With a limit, a run depends on the speed "
       "of the computer and cannot be repeated exactly.",
       false},
      {"iterations_per_frame", ParameterKind::Integer, "Iterations per frame", "", 1.0, 500.0, 1.0,
       1.0, "How many filter iterations run on each frame.", false},
      {"acceleration_sigma", ParameterKind::Real, "Acceleration sigma", "m/s²", 0.1, 200.0, 0.1,
       20.0,
       "How strongly targets accelerate, brake and turn: larger values follow abrupt motion, "
       "smaller values bridge gaps better.",
       true},
      {"survival_time", ParameterKind::Real, "Survival time", "s", 0.1, 60.0, 0.1, 5.0,
       "How long a target still counts as present when no camera can see its expected position.",
       true},
      {kSearchSizeKey, ParameterKind::Real, "Search size", "m", 0.1, 1000.0, 0.1, 4.0,
       "Edge length of the space in which a target may appear: with larger values, a track is "
       "created only at a higher likelihood.",
       true, true},
      {"color_adaptation", ParameterKind::Real, "Color adaptation", "s", 0.0, 600.0, 0.5, 0.0,
       "Time constant with which a target's color range follows slow changes of light, in each "
       "camera separately and only while the target is clearly visible. 0 keeps the range as it "
       "is; 2 is a good value in a room with daylight.",
       false},
  };
  // Origins: a calibration by hand is off by 0.2 degrees (grade `room` of the suite), and the drift
  // of its cameras adds to it; a webcam's unknown delay is up to half a frame, whose standard
  // deviation over all of it is a quarter of a frame at 30 Hz.
  all.push_back({"calibration_error", ParameterKind::Real, "Calibration error", "degrees", 0.0,
                 10.0, 0.01, 0.25,
                 "Error of the directions in which the cameras see objects. It is part of the "
                 "reported uncertainty of a position. 0.25 suits a calibration by hand.",
                 false});
  all.push_back({"time_error", ParameterKind::Real, "Time error", "ms", 0.0, 1000.0, 1.0, 8.0,
                 "Error of the times at which the images were taken. It is part of the reported "
                 "uncertainty of a moving target. 8 suits webcams.",
                 false});
  all.push_back(
      {"delay_spread", ParameterKind::Real, "Delay spread", "ms", 0.0, 1000.0, 1.0, 10.0,
       "How much the delays of the cameras may differ (standard deviation). While a target "
       "moves, the delays are estimated and corrected. 0 if all time stamps are exact: "
       "then no delay is estimated.",
       false});
  const auto start = startParameters({{0.5, 0.5, 0.25}, {0.5, 0.5, 0.25}});
  all.insert(all.end(), start.begin(), start.end());
  putInGroup(ParameterGroup::Measurement,
             {"color_adaptation", "calibration_error", "time_error", "delay_spread"}, all);
  putInGroup(ParameterGroup::Start, {kSearchSizeKey}, all);
  putInGroup(ParameterGroup::Expert, {"kld_error", "time_budget", "iterations_per_frame"}, all);
  return all;
}

} // namespace

std::span<const ParameterDeclaration> dewpointParameters() {
  static const std::vector<ParameterDeclaration> declarations = declare();
  return declarations;
}

} // namespace dewpoint::tracking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/dewpoint_parameters.h"

#include "core/tracking/start_parameters.h"

#include <vector>

namespace dewpoint::tracking {
namespace {

std::vector<ParameterDeclaration> declare() {
  std::vector<ParameterDeclaration> all{
      {"particles", ParameterKind::Integer, "Particles", "", 10.0, 100000.0, 10.0, 500.0,
       "How many particles each target uses at most.", true},
      {"fewest_particles", ParameterKind::Integer, "Fewest particles", "", 10.0, 100000.0, 10.0,
       100.0, "How many particles each target uses at least, when they all agree.", true, false,
       ParameterGroup::Expert, "particles"},
      {"kld_error", ParameterKind::Real, "Sampling error", "", 0.0, 1.0, 0.01, 0.1,
       "How far the particles may be from the distribution they stand for (Kullback-Leibler "
       "distance): smaller takes more particles where they disagree; 0 always takes all of them.",
       false},
      {"time_budget", ParameterKind::Real, "Time budget", "ms", 0.0, 1000.0, 0.5, 0.0,
       "How long one iteration may take: fewer particles are used, and searches are spread over "
       "several frames, to keep to it. 0 sets no limit; with a limit a run depends on the speed of "
       "the machine and cannot be repeated bit by bit.",
       false},
      {"iterations_per_frame", ParameterKind::Integer, "Iterations per frame", "", 1.0, 500.0, 1.0,
       1.0, "How many filter iterations run on each frame.", false},
      {"acceleration_sigma", ParameterKind::Real, "Acceleration sigma", "m/s²", 0.1, 200.0, 0.1,
       20.0,
       "How strongly targets speed up, slow down and turn: larger follows abrupt motion, smaller "
       "bridges gaps better.",
       true},
      {"survival_time", ParameterKind::Real, "Survival time", "s", 0.1, 60.0, 0.1, 5.0,
       "How long a target that no camera can judge is believed to be still there.", true},
      {kSearchSizeKey, ParameterKind::Real, "Search size", "m", 0.1, 1000.0, 0.1, 4.0,
       "Edge of the room in which a target may appear: larger asks for more evidence before a "
       "target is believed.",
       true, true},
      {"color_adaptation", ParameterKind::Real, "Color adaptation", "s", 0.0, 600.0, 0.5, 0.0,
       "How fast a target's color range follows slow changes of light, as a time constant; only "
       "while the target is surely there, and in each camera by itself. 0 keeps the range as it "
       "is; "
       "2 is a good value in a room with daylight.",
       false},
  };
  // Origins: a calibration by hand is off by 0.2 degrees (grade `room` of the suite), and the drift
  // of its cameras adds to it; a webcam's unknown delay is up to half a frame, whose standard
  // deviation over all of it is a quarter of a frame at 30 Hz.
  all.push_back({"calibration_error", ParameterKind::Real, "Calibration error", "degrees", 0.0,
                 10.0, 0.01, 0.25,
                 "How far off the directions are in which the cameras see things. The stated "
                 "uncertainty of a position includes it. 0.25 suits a calibration by hand.",
                 false});
  all.push_back({"time_error", ParameterKind::Real, "Time error", "ms", 0.0, 1000.0, 1.0, 8.0,
                 "How far off the times of the images are. The stated uncertainty of a moving "
                 "target includes it. 8 suits webcams.",
                 false});
  const auto start = startParameters({{0.5, 0.5, 0.25}, {0.5, 0.5, 0.25}});
  all.insert(all.end(), start.begin(), start.end());
  putInGroup(ParameterGroup::Measurement, {"color_adaptation", "calibration_error", "time_error"},
             all);
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

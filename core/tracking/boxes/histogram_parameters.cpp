// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/histogram_parameters.h"

#include <vector>

namespace dewpoint::tracking {
namespace {

std::vector<ParameterDeclaration> declareHistogram() {
  std::vector<ParameterDeclaration> all{
      {"particles", ParameterKind::Integer, "Particles", "", 10.0, 100000.0, 10.0, 300.0,
       "Number of particles of the filter: more particles track more reliably, but take more time.",
       true},
      {"position_sigma", ParameterKind::Real, "Position sigma", "sizes", 0.01, 5.0, 0.01, 0.12,
       "How far particles move at random along each axis between images, in multiples of the "
       "target size, in addition to their constant velocity.",
       true},
      {"scale_sigma", ParameterKind::Real, "Scale sigma", "", 0.0, 0.5, 0.005, 0.01,
       "How much the size of the box may change between images, as the standard deviation of its "
       "logarithm; 0 keeps the initial size.",
       false},
      {"aspect_sigma", ParameterKind::Real, "Aspect sigma", "", 0.0, 0.5, 0.005, 0.01,
       "How much the ratio of width to height may change between images, as the standard deviation "
       "of its logarithm; 0 keeps the initial ratio.",
       false},
      {"jump_share", ParameterKind::Real, "Jump share", "", 0.0, 1.0, 0.05, 0.1,
       "Share of the particles that jump to other positions at which the target's colors are "
       "found.",
       false},
      {"jump_reach", ParameterKind::Real, "Jump reach", "sizes", 0.1, 20.0, 0.1, 0.7,
       "How far the target may be from its predicted position, in multiples of the target size. "
       "Positions that are farther away count as unlikely.",
       true},
      {"sharpness", ParameterKind::Real, "Sharpness", "", 1.0, 500.0, 1.0, 60.0,
       "How strongly positions with more of the target's colors are preferred.", true},
      {"adaptation", ParameterKind::Real, "Adaptation", "", 0.0, 1.0, 0.01, 0.1,
       "How much of the box's current colors is blended into the reference colors after each "
       "image; 0 keeps the colors of the first image.",
       false},
      {"hidden_below", ParameterKind::Real, "Min. color share", "", 0.0, 1.0, 0.05, 0.45,
       "The target counts as hidden and keeps its position if less than this share of its usual "
       "colors is found.",
       false},
  };
  putInGroup(ParameterGroup::Motion, {"scale_sigma", "aspect_sigma", "jump_share", "jump_reach"},
             all);
  putInGroup(ParameterGroup::Measurement, {"sharpness", "hidden_below"}, all);
  return all;
}

} // namespace

std::span<const ParameterDeclaration> histogramParameters() {
  static const std::vector<ParameterDeclaration> declarations = declareHistogram();
  return declarations;
}

} // namespace dewpoint::tracking

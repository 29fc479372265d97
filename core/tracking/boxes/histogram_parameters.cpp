// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/histogram_parameters.h"

#include <vector>

namespace dewpoint::tracking {
namespace {

std::vector<ParameterDeclaration> declare() {
  std::vector<ParameterDeclaration> all{
      {"particles", ParameterKind::Integer, "Particles", "", 10.0, 100000.0, 10.0, 300.0,
       "How many particles the filter uses: more follow more surely and cost more time.", true},
      {"position_sigma", ParameterKind::Real, "Position sigma", "sizes", 0.01, 5.0, 0.01, 0.12,
       "How far particles move at random along each axis from image to image, beside going on as "
       "before, in sizes of the target.",
       true},
      {"scale_sigma", ParameterKind::Real, "Scale sigma", "", 0.0, 0.5, 0.005, 0.01,
       "How much the size of the box may change from image to image (logarithm); 0 keeps it as it "
       "was given.",
       false},
      {"aspect_sigma", ParameterKind::Real, "Aspect sigma", "", 0.0, 0.5, 0.005, 0.01,
       "How much the proportion of width to height may change from image to image (logarithm); 0 "
       "keeps it as it was given.",
       false},
      {"jump_share", ParameterKind::Real, "Jump share", "", 0.0, 1.0, 0.05, 0.1,
       "Share of the particles that are tried at other places with the target's colors.", false},
      {"jump_reach", ParameterKind::Real, "Jump reach", "sizes", 0.1, 20.0, 0.1, 0.7,
       "How far the target may be from where it was expected, in sizes of the target, before that "
       "counts strongly against a place.",
       true},
      {"sharpness", ParameterKind::Real, "Sharpness", "", 1.0, 500.0, 1.0, 60.0,
       "How much better a place with more of the target's colors is held to be.", true},
      {"adaptation", ParameterKind::Real, "Adaptation", "", 0.0, 1.0, 0.01, 0.1,
       "Share by which the reference colors follow those of the box from image to image; 0 keeps "
       "those of the first image.",
       false},
      {"hidden_below", ParameterKind::Real, "Hidden below", "", 0.0, 1.0, 0.05, 0.45,
       "The target counts as hidden, and is held, where less than this share of its usual colors "
       "is "
       "found.",
       false},
  };
  putInGroup(ParameterGroup::Motion, {"scale_sigma", "aspect_sigma", "jump_share", "jump_reach"},
             all);
  putInGroup(ParameterGroup::Measurement, {"sharpness", "hidden_below"}, all);
  return all;
}

} // namespace

std::span<const ParameterDeclaration> histogramParameters() {
  static const std::vector<ParameterDeclaration> declarations = declare();
  return declarations;
}

} // namespace dewpoint::tracking

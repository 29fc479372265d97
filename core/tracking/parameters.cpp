// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/parameters.h"

#include "core/tracking/barrera/barrera_parameters.h"
#include "core/tracking/barrera/dynamics_parameters.h"
#include "core/tracking/boxes/box_tracker.h"
#include "core/tracking/boxes/histogram_parameters.h"
#include "core/tracking/boxes/sugandi_parameters.h"
#include "core/tracking/dewpoint/dewpoint_parameters.h"
#include "core/tracking/people/people_tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>

namespace dewpoint::tracking {
namespace {

const ParameterDeclaration* find(std::span<const ParameterDeclaration> declarations,
                                 std::string_view key) {
  const auto found = std::ranges::find(declarations, key, &ParameterDeclaration::key);
  return found == declarations.end() ? nullptr : &*found;
}

std::string rangeText(const ParameterDeclaration& declaration) {
  return fmt::format("a {}number from {} to {}{}{}",
                     declaration.kind == ParameterKind::Integer ? "whole " : "",
                     declaration.minimum, declaration.maximum, declaration.unit.empty() ? "" : " ",
                     declaration.unit);
}

Error unknownKey(std::span<const ParameterDeclaration> declarations, std::string_view key) {
  std::string known;
  for (const auto& declaration : declarations) {
    known += (known.empty() ? "known are " : ", ") + declaration.key;
  }
  return {ErrorCode::UnknownKey, "", std::string(key), known};
}

} // namespace

ParameterValues::ParameterValues(std::span<const ParameterDeclaration> declarations)
    : declarations_(declarations) {
  for (const auto& declaration : declarations) {
    values_.emplace(declaration.key, declaration.defaultValue);
  }
}

double ParameterValues::at(std::string_view key) const {
  const auto found = values_.find(key);
  assert(found != values_.end());
  return found->second;
}

Status ParameterValues::set(std::string_view key, double value) {
  const ParameterDeclaration* declaration = find(declarations_, key);
  if (declaration == nullptr) {
    return tl::make_unexpected(unknownKey(declarations_, key));
  }
  const bool inRange = value >= declaration->minimum && value <= declaration->maximum;
  const bool whole = declaration->kind == ParameterKind::Real || value == std::floor(value);
  if (!std::isfinite(value) || !inRange || !whole) {
    return failure(ErrorCode::BadValue, "", declaration->key,
                   fmt::format("{} is not {}", value, rangeText(*declaration)));
  }
  values_.find(key)->second = value;
  return {};
}

Status ParameterValues::setText(std::string_view key, std::string_view text) {
  const ParameterDeclaration* declaration = find(declarations_, key);
  if (declaration == nullptr) {
    return tl::make_unexpected(unknownKey(declarations_, key));
  }
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  if (parsed.ec != std::errc() || parsed.ptr != end) {
    return failure(ErrorCode::BadValue, "", declaration->key,
                   fmt::format("\"{}\" is not {}", text, rangeText(*declaration)));
  }
  return set(key, value);
}

std::vector<std::string> methodNames() {
  return {"dewpoint", "barrera", "dynamics"};
}

std::vector<std::string> projectMethodNames() {
  std::vector<std::string> names = methodNames();
  std::ranges::move(boxMethodNames(), std::back_inserter(names));
  std::ranges::move(peopleMethodNames(), std::back_inserter(names));
  return names;
}

MethodFamily methodFamily(std::string_view method) {
  if (std::ranges::count(boxMethodNames(), method) > 0) {
    return MethodFamily::Boxes;
  }
  return std::ranges::count(peopleMethodNames(), method) > 0 ? MethodFamily::People
                                                             : MethodFamily::Targets;
}

std::string_view methodSentence(std::string_view method) {
  if (method == "dewpoint") {
    return "The surest and most accurate: for all that moves, any number of cameras and targets.";
  }
  if (method == "barrera") {
    return "The color particle filter of Barrera et al. (2005): for teaching and comparison.";
  }
  if (method == "dynamics") {
    return "The filter over triangulated positions of Barrera et al. (2005), section III-C: to "
           "study "
           "how a particle filter moves.";
  }
  if (method == "histogram") {
    return "Follows a box in one camera's images by the colors of its parts: finds it again after "
           "it "
           "was hidden, and follows its size.";
  }
  if (method == "sugandi") {
    return "The color histogram filter of Sugandi et al. (2009), for a box in one camera's images: "
           "for teaching and comparison.";
  }
  return peopleMethodSentence(method);
}

std::span<const ParameterDeclaration> methodParameters(std::string_view method) {
  if (method == "barrera") {
    return barreraParameters();
  }
  if (method == "dewpoint") {
    return dewpointParameters();
  }
  if (method == "dynamics") {
    return dynamicsParameters();
  }
  if (method == "histogram") {
    return histogramParameters();
  }
  if (method == "sugandi") {
    return sugandiParameters();
  }
  return peopleMethodParameters(method);
}

ParameterValues carriedOver(const ParameterValues& previous, std::string_view method) {
  ParameterValues values(methodParameters(method));
  for (const auto& declaration : previous.declarations()) {
    const double value = previous.at(declaration.key);
    if (value != declaration.defaultValue) {
      (void)values.set(declaration.key, value); // or its own default stays
    }
  }
  return values;
}

Status checkParameters(std::string_view method, const ParameterValues& parameters) {
  for (const auto& needed : methodParameters(method)) {
    if (find(parameters.declarations(), needed.key) == nullptr) {
      return failure(ErrorCode::MissingKey, "", needed.key,
                     fmt::format("method {} needs it", method));
    }
  }
  return {};
}

} // namespace dewpoint::tracking

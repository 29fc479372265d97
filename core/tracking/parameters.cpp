// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/parameters.h"

#include "core/base/text_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

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

std::string_view parameterGroupTitle(ParameterGroup group) {
  switch (group) {
  case ParameterGroup::Essential:
    return "Essential";
  case ParameterGroup::Motion:
    return "Motion";
  case ParameterGroup::Measurement:
    return "Measurement";
  case ParameterGroup::Area:
    return "Area and people";
  case ParameterGroup::Start:
    return "Search and start";
  case ParameterGroup::Expert:
    break;
  }
  return "Expert";
}

void putInGroup(ParameterGroup group, std::initializer_list<std::string_view> keys,
                std::vector<ParameterDeclaration>& declarations) {
  for (const std::string_view key : keys) {
    const auto found = std::ranges::find(declarations, key, &ParameterDeclaration::key);
    assert(found != declarations.end());
    found->group = group;
  }
}

bool exceedsUpperLimit(const ParameterValues& values, const ParameterDeclaration& declaration) {
  return !declaration.upperLimitKey.empty() &&
         values.at(declaration.key) > values.at(declaration.upperLimitKey);
}

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
  markAsGiven(key);
  return {};
}

Status ParameterValues::setFromText(std::string_view key, std::string_view text) {
  const ParameterDeclaration* declaration = find(declarations_, key);
  if (declaration == nullptr) {
    return tl::make_unexpected(unknownKey(declarations_, key));
  }
  const auto value = toNumber<double>(text);
  if (!value) {
    return failure(ErrorCode::BadValue, "", declaration->key,
                   fmt::format("\"{}\" is not {}", text, rangeText(*declaration)));
  }
  return set(key, *value);
}

bool ParameterValues::isGiven(std::string_view key) const {
  const ParameterDeclaration* declaration = find(declarations_, key);
  return declaration == nullptr || !declaration->isDerivedFromCameras || given_.contains(key);
}

void ParameterValues::markAsGiven(std::string_view key) {
  if (!isGiven(key)) {
    given_.emplace(key);
  }
}

void ParameterValues::markAllAsGiven() {
  for (const auto& declaration : declarations_) {
    markAsGiven(declaration.key);
  }
}

void ParameterValues::resetDerivableValues() {
  given_.clear();
  setDerivedValues({});
}

void ParameterValues::setDerivedValues(const ValuesByKey& values) {
  for (const auto& declaration : declarations_) {
    if (!isGiven(declaration.key)) {
      const auto found = values.find(declaration.key);
      values_.find(declaration.key)->second =
          found == values.end()
              ? declaration.defaultValue
              : std::clamp(found->second, declaration.minimum, declaration.maximum);
    }
  }
}

} // namespace dewpoint::tracking

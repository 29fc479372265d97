// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tracking {

enum class ParameterKind { Integer, Real };

/// A parameter, declared once: editors, tooltips, validation, project file, command line and the
/// reference page come from here.
struct ParameterDeclaration {
  std::string key; ///< "motion_sigma"
  ParameterKind kind = ParameterKind::Real;
  std::string label;    ///< "Motion sigma"
  std::string unit;     ///< "m", "" for a count
  double minimum = 0.0; ///< inclusive
  double maximum = 0.0; ///< inclusive
  double step = 0.0;    ///< of an editor
  double defaultValue = 0.0;
  std::string sentence;     ///< what it does, for a tooltip
  bool logarithmic = false; ///< sliders move by factors
  /// Unless given, the value comes from the cameras (parametersInUse()); the default stands where
  /// they tell none.
  bool fromCameras = false;
};

/// The declared parameters of a method with their values, each always within its declaration.
/// An immutable value by custom: a change is a new value.
class ParameterValues {
public:
  using ByKey = std::map<std::string, double, std::less<>>;

  ParameterValues() = default;
  explicit ParameterValues(std::span<const ParameterDeclaration> declarations);
  std::span<const ParameterDeclaration> declarations() const { return declarations_; }
  /// Value of a declared key (asserted).
  double at(std::string_view key) const;
  /// UnknownKey or BadValue (not finite, out of range, not whole) leave everything as it was.
  Status set(std::string_view key, double value);
  /// As set(), from text as on the command line.
  Status setText(std::string_view key, std::string_view text);
  /// False for a key whose value comes from the cameras and was not set.
  bool isGiven(std::string_view key) const;
  /// As if the key had been set to the value that it has; does nothing for an unknown key.
  void give(std::string_view key);
  void giveAll();
  /// Replaces the values that are not given by these, as far as their ranges allow; by the defaults
  /// where there are none.
  void suggest(const ByKey& values);
  /// Also what is given is compared.
  bool operator==(const ParameterValues& other) const {
    return values_ == other.values_ && given_ == other.given_;
  }

private:
  std::span<const ParameterDeclaration> declarations_;
  ByKey values_;
  std::set<std::string, std::less<>> given_; ///< of the keys whose values come from the cameras
};

} // namespace dewpoint::tracking

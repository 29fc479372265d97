// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
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
};

/// The declared parameters of a method with their values, each always within its declaration.
/// An immutable value by custom: a change is a new value.
class ParameterValues {
public:
  ParameterValues() = default;
  explicit ParameterValues(std::span<const ParameterDeclaration> declarations);
  std::span<const ParameterDeclaration> declarations() const { return declarations_; }
  /// Value of a declared key (asserted).
  double at(std::string_view key) const;
  /// UnknownKey or BadValue (not finite, out of range, not whole) leave everything as it was.
  Status set(std::string_view key, double value);
  /// As set(), from text as on the command line.
  Status setText(std::string_view key, std::string_view text);
  bool operator==(const ParameterValues& other) const { return values_ == other.values_; }

private:
  std::span<const ParameterDeclaration> declarations_;
  std::map<std::string, double, std::less<>> values_;
};

/// What a method follows, and so what it needs to know and what can be shown of it.
enum class MethodFamily {
  Targets, ///< colored targets in 3D, by calibrated cameras
  Boxes,   ///< a box in the images of one camera, per target; no calibration
  People,  ///< people who come and go in 3D, by calibrated cameras; no targets are named
};

/// Names of the methods that track colored targets in 3D, the default first: "dewpoint", "barrera",
/// "dynamics".
std::vector<std::string> methodNames();
/// Names of all methods a project may choose: methodNames(), boxMethodNames(),
/// peopleMethodNames().
std::vector<std::string> projectMethodNames();
/// Targets for an unknown method.
MethodFamily methodFamily(std::string_view method);
/// One sentence on what a method of any family is for; empty for an unknown one.
std::string_view methodSentence(std::string_view method);
/// Declarations of one method's parameters; empty for an unknown method. Lives for ever.
std::span<const ParameterDeclaration> methodParameters(std::string_view method);
/// The defaults of a method, but with the values under the same keys that were changed from their
/// defaults in `previous`, as far as they are allowed.
ParameterValues carriedOver(const ParameterValues& previous, std::string_view method);
/// MissingKey when the method has a parameter that `parameters` do not declare.
Status checkParameters(std::string_view method, const ParameterValues& parameters);

} // namespace dewpoint::tracking

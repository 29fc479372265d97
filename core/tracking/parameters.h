// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tracking {

/// Type of a parameter's value.
enum class ParameterKind { Integer, Real };

/// Subject of a parameter. Editors group parameters by it, in this order.
enum class ParameterGroup {
  Essential, ///< the most important parameters, always visible; all of them if the method has only
             ///< a few
  Motion,
  Measurement, ///< evaluation of the images and their assumed reliability
  Area,        ///< where people can be, and when they count as present
  Start,       ///< where targets are first searched for
  Expert       ///< computing effort and timing of a run
};

/// Returns the title of a group, as shown to the user.
std::string_view parameterGroupTitle(ParameterGroup group);

/// Declaration of a parameter. It is used by editors, tooltips, validation, project files, the
/// command line and the reference page.
struct ParameterDeclaration {
  std::string key; ///< "motion_sigma"
  ParameterKind kind = ParameterKind::Real;
  std::string label;    ///< "Motion sigma"
  std::string unit;     ///< "m", "" for a count
  double minimum = 0.0; ///< inclusive
  double maximum = 0.0; ///< inclusive
  double step = 0.0;    ///< step size in editors
  double defaultValue = 0.0;
  std::string sentence;     ///< description for a tooltip
  bool logarithmic = false; ///< sliders have a logarithmic scale
  /// If true and no value is given, the value is derived from the cameras (effectiveParameters()).
  /// If that is not possible, the default is used.
  bool fromCameras = false;
  ParameterGroup group = ParameterGroup::Essential;
  /// Key of another parameter of the method whose value is an upper limit for this one. If this
  /// value is larger, the limit is used instead. Empty if there is no such limit.
  std::string bound = {};
};

/// Moves the declarations with these keys, which must exist (asserted), to a group.
void putInGroup(ParameterGroup group, std::initializer_list<std::string_view> keys,
                std::vector<ParameterDeclaration>& declarations);

/// Declared parameters of a method with their values, each within its declared range. Treated as
/// immutable by convention: a change creates a new object.
class ParameterValues {
public:
  using ByKey = std::map<std::string, double, std::less<>>;

  ParameterValues() = default;
  explicit ParameterValues(std::span<const ParameterDeclaration> declarations);
  std::span<const ParameterDeclaration> declarations() const { return declarations_; }
  /// Returns the value of a key, which must be declared (asserted).
  double at(std::string_view key) const;
  /// Sets a value. Returns UnknownKey, or BadValue if the value is not finite, is out of range, or
  /// is not an integer where one is required. Nothing changes on an error.
  Status set(std::string_view key, double value);
  /// Like set(), but parses the value from text, as on the command line.
  Status setText(std::string_view key, std::string_view text);
  /// Returns false only if the value of this key may come from the cameras
  /// (ParameterDeclaration::fromCameras) and nobody has set it. Returns true for all other keys.
  bool isGiven(std::string_view key) const;
  /// Marks the current value of a key as given; does nothing for an unknown key.
  void markGiven(std::string_view key);
  /// Marks the current values of all keys as given.
  void markAllGiven();
  /// Resets all given values of keys that can be derived from the cameras. They have their defaults
  /// until setDerived() is called.
  void resetDerivable();
  /// Replaces the values that are not given. The new values come from `values`, limited to their
  /// ranges, or from the defaults for keys that are not in `values`.
  void setDerived(const ByKey& values);
  /// Compares the values and which of them are given.
  bool operator==(const ParameterValues& other) const {
    return values_ == other.values_ && given_ == other.given_;
  }

private:
  std::span<const ParameterDeclaration> declarations_;
  ByKey values_;
  /// Given keys whose values can be derived from the cameras.
  std::set<std::string, std::less<>> given_;
};

/// Returns whether the value of a declared key exceeds the value of the parameter that limits it.
/// The limit is then used instead.
bool exceedsBound(const ParameterValues& values, const ParameterDeclaration& declaration);

} // namespace dewpoint::tracking

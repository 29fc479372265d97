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

/// Group of parameters with the same subject. Editors show the groups in this order.
enum class ParameterGroup {
  /// The most important parameters, which are always visible. If a method has only a few
  /// parameters, all of them are in this group.
  Essential,
  Motion,
  Measurement, ///< evaluation of the images and their assumed reliability
  Area,        ///< where people can be, and when they count as present
  Start,       ///< where targets are first searched for
  Expert       ///< computing effort and timing of a run
};

/// Returns the title of a group, as shown to the user.
std::string_view parameterGroupTitle(ParameterGroup group);

/// Declaration of a parameter, for editors, tooltips, validation, project files, the command line
/// and the reference page.
struct ParameterDeclaration {
  std::string key; ///< name in files and on the command line, such as "motion_sigma"
  ParameterKind kind = ParameterKind::Real;
  std::string label;     ///< name shown to the user, such as "Motion sigma"
  std::string unit;      ///< unit of the value, such as "m"; "" for a count
  double minimum = 0.0;  ///< smallest allowed value
  double maximum = 0.0;  ///< largest allowed value
  double stepSize = 0.0; ///< step size in editors
  double defaultValue = 0.0;
  std::string description;           ///< explanation for tooltips and the reference page
  bool hasLogarithmicSlider = false; ///< sliders have a logarithmic scale
  /// If true and the user gives no value, the value is derived from the cameras
  /// (effectiveParameters()), or is the default if the cameras do not determine it.
  bool isDerivedFromCameras = false;
  ParameterGroup group = ParameterGroup::Essential;
  /// Key of another parameter of the method, whose value is an upper limit for the value of this
  /// parameter. A larger value is replaced by the limit. Empty if there is no such limit.
  std::string upperLimitKey = {};
};

/// Assigns the declarations with these keys to a group. All keys must exist (asserted).
void putInGroup(ParameterGroup group, std::initializer_list<std::string_view> keys,
                std::vector<ParameterDeclaration>& declarations);

/// Declared parameters of a method with their values, each within its declared range. A value is
/// "given" if somebody has set it; other values may be derived from the cameras
/// (ParameterDeclaration::isDerivedFromCameras).
class ParameterValues {
public:
  using ValuesByKey = std::map<std::string, double, std::less<>>;

  ParameterValues() = default;
  explicit ParameterValues(std::span<const ParameterDeclaration> declarations);
  std::span<const ParameterDeclaration> declarations() const { return declarations_; }
  /// Returns the value of a key. The key must be declared (asserted).
  double at(std::string_view key) const;
  /// Sets a value. Error: UnknownKey, or BadValue if the value is not finite, is out of range, or
  /// is not an integer although the parameter requires one. Nothing changes on an error.
  Status set(std::string_view key, double value);
  /// Sets a value from its text, as on the command line. Errors are those of set().
  Status setFromText(std::string_view key, std::string_view text);
  /// Returns whether the value of a key is given, which means that the value is not derived from
  /// the cameras. The result is false only for a key with
  /// ParameterDeclaration::isDerivedFromCameras that nobody has set.
  bool isGiven(std::string_view key) const;
  /// Marks the current value of a key as given (isGiven()). Does nothing for an unknown key.
  void markAsGiven(std::string_view key);
  /// Marks the current values of all keys as given (isGiven()).
  void markAllAsGiven();
  /// Resets all values that can be derived from the cameras to their defaults, and marks them as
  /// not given. setDerivedValues() then replaces them.
  void resetDerivableValues();
  /// Replaces the values that are not given (isGiven()). The new values come from `values`, limited
  /// to their ranges. Keys that are not in `values` get their defaults.
  void setDerivedValues(const ValuesByKey& values);
  /// Returns whether both objects have the same values, and the same values are given (isGiven()).
  bool operator==(const ParameterValues& other) const {
    return values_ == other.values_ && given_ == other.given_;
  }

private:
  std::span<const ParameterDeclaration> declarations_;
  ValuesByKey values_;
  /// Given keys whose values can be derived from the cameras.
  std::set<std::string, std::less<>> given_;
};

/// Returns whether the value of a declared parameter exceeds the limit set by another parameter
/// (ParameterDeclaration::upperLimitKey). The limit is then used instead.
bool exceedsUpperLimit(const ParameterValues& values, const ParameterDeclaration& declaration);

} // namespace dewpoint::tracking

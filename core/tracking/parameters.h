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

enum class ParameterKind { Integer, Real };

/// What parameters are about. Editors show those of a group together, the groups in this order.
enum class ParameterGroup {
  Essential, ///< the few that matter, always in sight; of a method with few parameters all
  Motion,
  Measurement, ///< what images say, and how far they are trusted
  Area,        ///< where people are, and when they count as there
  Start,       ///< where targets are searched for at first
  Expert       ///< what a run costs, and how often it does what
};

/// The title of a group, for people's eyes.
std::string_view parameterGroupTitle(ParameterGroup group);

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
  ParameterGroup group = ParameterGroup::Essential;
  /// Key of another parameter of the method; of a larger value than that one has, that one's is
  /// used. Empty: there is none.
  std::string bound = {};
};

/// Puts the declarations with these keys (asserted) into a group.
void putInGroup(ParameterGroup group, std::initializer_list<std::string_view> keys,
                std::vector<ParameterDeclaration>& declarations);

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
  /// Takes back what was given of the keys whose values come from the cameras: they have their
  /// defaults until suggest().
  void leaveToCameras();
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

/// Whether the value of a declared key is larger than the one that bounds it, which is used then.
bool exceedsBound(const ParameterValues& values, const ParameterDeclaration& declaration);

} // namespace dewpoint::tracking

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"
#include "core/tracking/parameters.h"
#include "core/tracking/target.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tracking {

class Tracker;

/// How a project defines its targets.
enum class TargetsFrom {
  Color, ///< each target has a color and a size
  Box,   ///< each target has a box in one frame of one camera
  Images ///< not at all: the method finds the targets automatically
};

/// Kind of tables written for a run.
enum class RunTables {
  Trajectory, ///< positions in the room
  Boxes,      ///< boxes in images
  People      ///< positions in the room, and bodies of people
};

/// Properties of a family of methods, known before any of them runs: one row of the catalog's table
/// of families. The properties are independent. A new family has its own values, and code that
/// reads a property need not know the family. Read properties instead of comparing families:
/// tests/architecture counts where a family is named.
struct MethodFamily {
  TargetsFrom targets = TargetsFrom::Color;
  /// Purpose of these methods, used as the heading of their group in a list.
  std::string_view heading;
  /// True if the method estimates positions in the room with calibrated cameras; otherwise it works
  /// in the images of one camera and needs no calibration.
  bool needsCalibration = true;
  /// Smallest number of cameras with which a target can be found.
  int fewestCameras = 1;
  RunTables tables = RunTables::Trajectory;
  /// Trajectories have columns for the particle of highest weight.
  bool hasBestParticle = true;
  /// Masks and maps show motion in every frame with images, tracked or not.
  bool masksMotion = false;
  /// Targets can be edited in frames that were already tracked. The frames from there on are
  /// tracked again at once, and past frames show the present targets.
  bool tracksAgainOnEdit = false;
  /// Describes a target in words, as the method uses it.
  std::string (*describe)(const Target& target) = nullptr;
  /// Returns whether a target of the project has everything required for tracking.
  bool (*isDefined)(const Target& target) = [](const Target&) { return true; };
  /// Returns the reason in words why nothing can be tracked while lacksTargets().
  std::string (*lack)(std::string_view method) = nullptr;
  /// Returns the frame, at most `frame`, at which a run must begin so that its result at `frame` is
  /// correct.
  std::int64_t (*beginFor)(const std::vector<Target>& targets, std::int64_t frame) =
      [](const std::vector<Target>&, std::int64_t frame) { return frame; };

  /// Returns whether the method finds its targets automatically: the project defines none, and a
  /// truth does not use their names.
  bool findsTargets() const { return targets == TargetsFrom::Images; }
  /// Returns whether masks show the pixels that have the color of a target.
  bool masksColors() const { return targets == TargetsFrom::Color; }
  /// Returns whether there is nothing to track with these targets of a project.
  bool lacksTargets(const std::vector<Target>& projectTargets) const;
  /// Returns whether other methods track the same targets, so that one of them can continue a run
  /// of the other.
  bool tracksSameTargetsAs(const MethodFamily& other) const { return targets == other.targets; }
  /// Returns whether positions are written, row by row during the run.
  bool writesPositions() const { return tables != RunTables::Boxes; }
  /// Returns whether the bodies of the targets are also stored and written.
  bool writesBodies() const { return tables == RunTables::People; }
};

/// Description of a method for a user who chooses one.
struct MethodText {
  std::string_view title;      ///< by its use: what it follows
  std::string_view sentence;   ///< what it is for, or what sets it apart, in one line
  std::string_view page;       ///< of the manual, a file of docs/
  std::string_view paper = {}; ///< the method is exactly the one of this paper; empty: our own
};

/// A tracking method: one row of the catalog.
struct Method {
  std::string_view name; ///< name in project files and on the command line
  MethodFamily family;
  MethodText text;
  /// Returns the declarations, which exist for the whole lifetime of the program.
  std::span<const ParameterDeclaration> (*parameters)();
  /// Creates a tracker. The parameters must be those of the method (asserted).
  std::unique_ptr<Tracker> (*make)(const ParameterValues& parameters, const CameraRig& rig,
                                   const std::vector<Target>& targets);
  /// Trajectories have additional columns for measurements from the images of a frame alone.
  bool writesMeasurements = false;
  /// Trajectories have a column that marks where another object may be the target about as well.
  bool statesAmbiguity = false;
  /// Trajectories have columns for the extent of targets that are not balls.
  bool learnsShapes = false;
};

/// Returns all methods that a project may choose, the default first, and in each family its default
/// first.
std::span<const Method> methods();
/// The name of the first.
std::string_view defaultMethod();
/// Null for an unknown name.
const Method* findMethod(std::string_view name);

/// Returns methods() in the order of a list of choices. Methods of papers, which are intended for
/// teaching and comparison, are last. Methods with the same headingOf() are adjacent.
std::vector<const Method*> methodsByUse();
/// Returns the heading of the method's group: the purpose of the methods in it.
std::string_view headingOf(const Method& method);

/// Returns the names of methods(), in their order.
std::vector<std::string> methodNames();
/// Returns the names of the methods whose targets are defined in this way.
std::vector<std::string> methodNames(TargetsFrom targets);
/// Returns the names of the methods that write these tables.
std::vector<std::string> methodNames(RunTables tables);
/// Returns the family of a method; for an unknown method, that of the default method.
MethodFamily methodFamily(std::string_view method);
/// Returns empty texts for an unknown method.
MethodText methodText(std::string_view method);
/// Returns an empty text for an unknown method.
std::string_view methodSentence(std::string_view method);
/// The page of the manual about a method; of an unknown one that of the default one.
std::string_view methodPage(std::string_view method);
/// Each of these pages once, in the order of methods().
std::vector<std::string_view> methodPages();
/// Empty for an unknown method.
std::span<const ParameterDeclaration> methodParameters(std::string_view method);
/// Returns the defaults of a method, with the values of equal keys that were changed from their
/// defaults in `previous`, limited to their allowed ranges. A default that was given in `previous`
/// becomes the given default of this method, so it is not derived from the cameras.
ParameterValues carriedOver(const ParameterValues& previous, std::string_view method);
/// Returns MissingKey if the method has a parameter that `parameters` do not declare.
Status checkParameters(std::string_view method, const ParameterValues& parameters);

/// Creates a tracker of the named method. `targets` are ignored by methods that find targets
/// automatically. Returns NotFound for an unknown method, and MissingKey if `parameters` are not
/// those of the method.
Result<std::unique_ptr<Tracker>> makeTracker(std::string_view method,
                                             const ParameterValues& parameters,
                                             const CameraRig& rig,
                                             const std::vector<Target>& targets);

} // namespace dewpoint::tracking

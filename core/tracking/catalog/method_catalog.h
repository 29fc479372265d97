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
enum class TargetSource {
  Color, ///< each target has a color and a size
  Box,   ///< each target has a box in one frame of one camera
  Images ///< the project defines no targets: the method finds them automatically
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
  TargetSource targets = TargetSource::Color;
  /// Purpose of these methods, used as the heading of their group in a list.
  std::string_view heading;
  /// True if the method estimates positions in the room with calibrated cameras; otherwise it works
  /// in the images of one camera and needs no calibration.
  bool needsCalibration = true;
  /// Smallest number of cameras with which a target can be found.
  int fewestCameras = 1;
  RunTables tables = RunTables::Trajectory;
  /// True if trajectories have columns for the particle of highest weight.
  bool hasBestParticle = true;
  /// True if masks and maps show motion, in every frame with images, whether it is tracked or not.
  bool masksMotion = false;
  /// True if targets can be edited in frames that were already tracked. The following frames are
  /// then tracked again immediately, and past frames show the edited targets.
  bool tracksAgainOnEdit = false;
  /// Describes a target in words, as the method uses it.
  std::string (*describe)(const Target& target) = nullptr;
  /// Returns whether a target of the project has everything required for tracking.
  bool (*isDefined)(const Target& target) = [](const Target&) { return true; };
  /// Returns a text that explains why nothing can be tracked while lacksTargets() is true.
  std::string (*noTargetsText)(std::string_view method) = nullptr;
  /// Returns the frame, at most `frame`, at which a run must begin so that its result at `frame` is
  /// correct.
  std::int64_t (*firstFrameFor)(const std::vector<Target>& targets, std::int64_t frame) =
      [](const std::vector<Target>&, std::int64_t frame) { return frame; };

  /// Returns whether the method finds its targets automatically: the project defines none, and
  /// ground truth does not use their names.
  bool findsTargets() const { return targets == TargetSource::Images; }
  /// Returns whether masks show the pixels that have the color of a target.
  bool masksColors() const { return targets == TargetSource::Color; }
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

/// Description of a method, to help users choose one.
struct MethodText {
  std::string_view title;    ///< title that names its use: what it tracks
  std::string_view sentence; ///< its purpose or its distinguishing feature, in one line
  std::string_view page;     ///< page of the manual, a file in docs/
  /// Paper that describes exactly this method; empty: developed for this project.
  std::string_view paper = {};
};

/// A tracking method: one row of the catalog.
struct Method {
  std::string_view name; ///< method name in project files and on the command line
  MethodFamily family;
  MethodText text;
  /// Returns the declarations, which exist for the whole lifetime of the program.
  std::span<const ParameterDeclaration> (*parameters)();
  /// Creates a tracker. The parameters must be those of the method (asserted).
  std::unique_ptr<Tracker> (*make)(const ParameterValues& parameters, const CameraRig& rig,
                                   const std::vector<Target>& targets);
  /// True if trajectories have additional columns for measurements from the images of a frame
  /// alone.
  bool writesMeasurements = false;
  /// True if trajectories have a column that marks frames in which another object is about as
  /// likely to be the target.
  bool writesAmbiguity = false;
  /// True if trajectories have columns for the extent of targets that are not balls.
  bool learnsShapes = false;
};

/// Returns all methods that a project can use. The default comes first, and in each family, the
/// family's default comes first.
std::span<const Method> methods();
/// Returns the name of the first method.
std::string_view defaultMethod();
/// Returns the method with this name; null for an unknown name.
const Method* findMethod(std::string_view name);

/// Returns methods() in the order in which they are offered to the user. Methods of papers, which
/// are intended for teaching and comparison, are last. Methods with the same headingOf() are
/// adjacent.
std::vector<const Method*> methodsByUse();
/// Returns the heading of the method's group: the purpose of the methods in it.
std::string_view headingOf(const Method& method);

/// Returns the names of methods(), in the same order.
std::vector<std::string> methodNames();
/// Returns the names of the methods whose targets are defined in this way.
std::vector<std::string> methodNames(TargetSource targets);
/// Returns the names of the methods that write these tables.
std::vector<std::string> methodNames(RunTables tables);
/// Returns the family of a method; for an unknown method, that of the default method.
MethodFamily methodFamily(std::string_view method);
/// Returns the description of a method; empty strings for an unknown method.
MethodText methodText(std::string_view method);
/// Returns MethodText::sentence of a method; empty for an unknown method.
std::string_view methodSummary(std::string_view method);
/// Returns the manual page about a method; for an unknown method, that of the default method.
std::string_view methodPage(std::string_view method);
/// Returns the manual pages of all methods without duplicates, in the order of methods().
std::vector<std::string_view> methodPages();
/// Returns the parameters of a method; empty for an unknown method.
std::span<const ParameterDeclaration> methodParameters(std::string_view method);
/// Returns the defaults of a method, with the changes made in `previous`. A value that was changed
/// from its default is kept if this method has the key and allows the value. If the default value
/// was given explicitly in `previous`, the default of this method counts as given too; it is then
/// not derived from the cameras.
ParameterValues carryOverParameters(const ParameterValues& previous, std::string_view method);
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

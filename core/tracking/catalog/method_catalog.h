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

/// What says in a project which targets there are.
enum class TargetsFrom {
  Color, ///< each target has a color and a size
  Box,   ///< each target has a box in one frame of one camera
  Images ///< nothing: the method finds by itself who is there
};

/// The tables that are written of a run.
enum class RunTables {
  Trajectory, ///< positions in the room
  Boxes,      ///< boxes in images
  People      ///< positions in the room, and the bodies of people
};

/// The properties of a kind of methods, known before any of them runs: a row of the catalog's table
/// of families. They are independent: a new kind has values of its own, and code that reads one of
/// them need not know the kind. Read properties, do not compare kinds: tests/architecture counts
/// where a kind is named.
struct MethodFamily {
  TargetsFrom targets = TargetsFrom::Color;
  /// What these methods are for, as the heading of their choices.
  std::string_view heading;
  /// Estimates positions in the room, by calibrated cameras; else in the images of one camera,
  /// about which nothing need be known.
  bool needsCalibration = true;
  /// With fewer cameras nothing is ever found.
  int fewestCameras = 1;
  RunTables tables = RunTables::Trajectory;
  /// Trajectories have columns for the particle of highest weight.
  bool hasBestParticle = true;
  /// Masks and maps show what moves, in every frame with images, tracked or not.
  bool masksMotion = false;
  /// A target may be edited in a frame that was tracked already: the frames from there on are
  /// tracked again at once, and past frames show the targets that there are now.
  bool tracksAgainOnEdit = false;
  /// What a target is to the method, in words.
  std::string (*describe)(const Target& target) = nullptr;
  /// Whether a target of the project has all that tracking it needs.
  bool (*isDefined)(const Target& target) = [](const Target&) { return true; };
  /// Why nothing can be tracked while lacksTargets(), in words.
  std::string (*lack)(std::string_view method) = nullptr;
  /// The frame at which a run has to begin so that it is right at `frame`: at most that one.
  std::int64_t (*beginFor)(const std::vector<Target>& targets, std::int64_t frame) =
      [](const std::vector<Target>&, std::int64_t frame) { return frame; };

  /// Finds by itself which targets there are: the project names none of them, and a truth has none
  /// of their names.
  bool findsTargets() const { return targets == TargetsFrom::Images; }
  /// The pixels that have the color of a target are masked.
  bool masksColors() const { return targets == TargetsFrom::Color; }
  /// Whether there is nothing to track with these targets of a project.
  bool lacksTargets(const std::vector<Target>& projectTargets) const;
  /// Whether the other methods track the same targets, so that a run by one of them can go on from
  /// where the other was.
  bool tracksSameTargetsAs(const MethodFamily& other) const { return targets == other.targets; }
  /// Positions are written, row by row while the run goes on.
  bool writesPositions() const { return tables != RunTables::Boxes; }
  /// The bodies of the targets are kept and written, too.
  bool writesBodies() const { return tables == RunTables::People; }
};

/// What a user reads of a method before choosing it.
struct MethodText {
  std::string_view title;      ///< by its use: what it follows
  std::string_view sentence;   ///< what it is for, or what sets it apart, in one line
  std::string_view paper = {}; ///< the method is exactly the one of this paper; empty: our own
};

/// A tracking method: one row of the catalog.
struct Method {
  std::string_view name; ///< in project files and on the command line
  MethodFamily family;
  MethodText text;
  /// The declarations live for ever.
  std::span<const ParameterDeclaration> (*parameters)();
  /// The parameters are the method's own (asserted).
  std::unique_ptr<Tracker> (*make)(const ParameterValues& parameters, const CameraRig& rig,
                                   const std::vector<Target>& targets);
  /// Trajectories have columns of their own for what the images of a frame alone say.
  bool writesMeasurements = false;
  /// Trajectories have a column that says where something else may be the target about as well.
  bool statesAmbiguity = false;
  /// Trajectories have columns for the extent of targets that are no balls.
  bool learnsShapes = false;
};

/// All methods a project may choose, the default first; of each family its default first.
std::span<const Method> methods();
/// Null for an unknown name.
const Method* findMethod(std::string_view name);

/// methods() as they are listed for a choice: those of papers, which are for teaching and
/// comparison, behind all others. Those with the same headingOf() follow each other.
std::vector<const Method*> methodsByUse();
/// What the methods among which it stands there are for.
std::string_view headingOf(const Method& method);

/// Names of methods(), in their order.
std::vector<std::string> methodNames();
/// Names of the methods whose targets come from there.
std::vector<std::string> methodNames(TargetsFrom targets);
/// Names of the methods of which such tables are written.
std::vector<std::string> methodNames(RunTables tables);
/// Of an unknown method that of the default one.
MethodFamily methodFamily(std::string_view method);
/// Empty texts for an unknown method.
MethodText methodText(std::string_view method);
/// Empty for an unknown method.
std::string_view methodSentence(std::string_view method);
/// Empty for an unknown method.
std::span<const ParameterDeclaration> methodParameters(std::string_view method);
/// The defaults of a method, but with the values under the same keys that were changed from their
/// defaults in `previous`, as far as they are allowed. A default that was given in `previous` gives
/// the method's own: it does not come from the cameras.
ParameterValues carriedOver(const ParameterValues& previous, std::string_view method);
/// MissingKey when the method has a parameter that `parameters` do not declare.
Status checkParameters(std::string_view method, const ParameterValues& parameters);

/// A tracker of the named method; `targets` mean nothing to methods that find them. NotFound for an
/// unknown method, MissingKey when `parameters` are not the method's.
Result<std::unique_ptr<Tracker>> makeTracker(std::string_view method,
                                             const ParameterValues& parameters,
                                             const CameraRig& rig,
                                             const std::vector<Target>& targets);

} // namespace dewpoint::tracking

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
enum class RunTableKind {
  Trajectory, ///< positions in the room
  Boxes,      ///< boxes in images
  People      ///< positions in the room, and bodies of people
};

/// Properties of a family of methods, known before any of its methods runs. Code must read these
/// properties instead of comparing families, so that a new family needs no changes elsewhere. A
/// test (tests/architecture) counts the places in the code that name a family.
struct MethodFamily {
  TargetSource targetSource = TargetSource::Color;
  /// Purpose of these methods, used as the heading of their group in a list.
  std::string_view heading;
  /// True if the method estimates positions in the room with calibrated cameras. False if the
  /// method works in the images of one camera and needs no calibration.
  bool needsCalibration = true;
  /// Smallest number of cameras with which a target can be found.
  int minCameraCount = 1;
  RunTableKind tableKind = RunTableKind::Trajectory;
  /// True if trajectories have columns for the particle of highest weight.
  bool hasBestParticle = true;
  /// True if the masks and maps of these methods show motion instead of targets. They exist for
  /// every frame with images, whether or not the frame is tracked.
  bool hasMotionMasks = false;
  /// True if targets can be edited in frames that were already tracked. The following frames are
  /// then tracked again immediately, and past frames show the edited targets.
  bool retracksAfterEdit = false;
  /// Describes a target in words, as the method uses it.
  std::string (*describe)(const Target& target) = nullptr;
  /// Returns whether a target of the project has everything required for tracking.
  bool (*isDefined)(const Target& target) = [](const Target&) { return true; };
  /// Returns a text that explains why nothing can be tracked if the project defines no target that
  /// the method can track (lacksTargets()).
  std::string (*noTargetsText)(std::string_view method) = nullptr;
  /// Returns the frame, at most `frame`, at which a run must begin so that its result at `frame` is
  /// correct. For example, methods that track boxes must begin at the frame of the first box.
  std::int64_t (*firstFrameFor)(const std::vector<Target>& targets, std::int64_t frame) =
      [](const std::vector<Target>&, std::int64_t frame) { return frame; };

  /// Returns whether the method finds its targets automatically. The project then defines no
  /// targets, and the names of the targets found do not occur in the ground truth.
  bool findsTargets() const { return targetSource == TargetSource::Images; }
  /// Returns whether masks show the pixels that have the color of a target.
  bool hasColorMasks() const { return targetSource == TargetSource::Color; }
  /// Returns whether the method needs targets from the project, but none of `projectTargets` can be
  /// tracked.
  bool lacksTargets(const std::vector<Target>& projectTargets) const;
  /// Returns whether the methods of this family and of `other` track the same targets, so that a
  /// method of one family can continue a run of the other.
  bool tracksSameTargetsAs(const MethodFamily& other) const {
    return targetSource == other.targetSource;
  }
  /// Returns whether positions in the room are written, row by row during the run.
  bool writesPositions() const { return tableKind != RunTableKind::Boxes; }
  /// Returns whether the bodies of the targets are also stored and written.
  bool writesBodies() const { return tableKind == RunTableKind::People; }
};

/// Description of a method, to help users choose one.
struct MethodText {
  std::string_view title;      ///< title that names what the method tracks
  std::string_view summary;    ///< purpose or distinguishing feature of the method, in one line
  std::string_view manualPage; ///< page of the manual, a file in docs/
  /// Paper that describes exactly this method; empty if the method was developed for this project.
  std::string_view paper = {};
};

/// A tracking method: one row of the catalog.
struct Method {
  std::string_view name; ///< method name in project files and on the command line
  MethodFamily family;
  MethodText text;
  /// Returns the declarations of the parameters, which exist as long as the program runs.
  std::span<const ParameterDeclaration> (*parameters)();
  /// Creates a tracker. `parameters` must be declared by this method (asserted).
  std::unique_ptr<Tracker> (*make)(const ParameterValues& parameters, const CameraRig& rig,
                                   const std::vector<Target>& targets);
  /// True if trajectories have additional columns for measurements from the images of a frame
  /// alone.
  bool writesMeasurements = false;
  /// True if trajectories have a column that marks frames in which another object is about as
  /// likely to be the target.
  bool writesAmbiguity = false;
  /// True if trajectories have columns for the extent of targets that are not balls.
  bool tracksAnyShape = false;
};

/// Returns all methods that a project can use. The first method is the default, and the first
/// method of each family is the default of this family.
std::span<const Method> methods();
/// Returns the name of the default method, which is the first of methods().
std::string_view defaultMethod();
/// Returns the method with this name, or null for an unknown name.
const Method* findMethod(std::string_view name);

/// Returns methods() in the order in which they are offered to the user. Methods of papers, which
/// are intended for teaching and comparison, are last. Methods with the same headingOf() are
/// adjacent.
std::vector<const Method*> methodsInDisplayOrder();
/// Returns the heading of the group of methods to which a method belongs in a list. The heading
/// names the purpose of the group.
std::string_view headingOf(const Method& method);

/// Returns the names of all methods, in the order of methods().
std::vector<std::string> methodNames();
/// Returns the names of the methods whose targets are defined as `targets` says.
std::vector<std::string> methodNames(TargetSource targets);
/// Returns the names of the methods that write tables of the kind `tables`.
std::vector<std::string> methodNames(RunTableKind tables);
/// Returns the family of a method, or the family of the default method if the name is unknown.
MethodFamily methodFamily(std::string_view method);
/// Returns the description of a method, with empty strings if the name is unknown.
MethodText methodText(std::string_view method);
/// Returns MethodText::summary of a method, or an empty text if the name is unknown.
std::string_view methodSummary(std::string_view method);
/// Returns the manual page about a method, or the page about the default method if the name is
/// unknown.
std::string_view methodManualPage(std::string_view method);
/// Returns the manual pages of all methods without duplicates, in the order of methods().
std::vector<std::string_view> methodManualPages();
/// Returns the declarations of the parameters of a method, or nothing if the name is unknown.
std::span<const ParameterDeclaration> methodParameters(std::string_view method);
/// Returns parameters for `method` that keep the user's changes in `previous`, the parameters of
/// another method. A value in `previous` that differs from its default is kept if `method` has the
/// key and allows the value. All other values are the defaults of `method`. A value that the user
/// has set to the default counts as set by the user in the result too, so that it is not derived
/// from the cameras.
ParameterValues carryOverParameters(const ParameterValues& previous, std::string_view method);
/// Checks that `parameters` declare every parameter of the method. Error: MissingKey if one is
/// missing.
Status checkParameters(std::string_view method, const ParameterValues& parameters);

/// Creates a tracker of the named method. Methods that find targets automatically ignore `targets`.
/// Errors: NotFound for an unknown method; MissingKey if `parameters` lack a parameter of the
/// method.
Result<std::unique_ptr<Tracker>> makeTracker(std::string_view method,
                                             const ParameterValues& parameters,
                                             const CameraRig& rig,
                                             const std::vector<Target>& targets);

} // namespace dewpoint::tracking

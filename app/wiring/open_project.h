// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/live_camera.h"
#include "core/project/project.h"
#include "core/session/session.h"
#include "core/simulation/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::app {

/// Returns a project that tracks the balls of a simulated scene. All parameters have the method's
/// defaults. The scenes "converge" and "one-camera" have their own methods.
Project makeSceneProject(const Scene& scene, const std::string& sceneName);

/// Returns the true positions of all balls of a scene in every frame (meters), named like the
/// targets in the project.
Trajectory sceneGroundTruth(const Scene& scene);

/// Loads a project file, or a built-in scene by its name ("demo" if empty). The cameras of a
/// simulated project are taken from its scene. `moved` has the current locations of files that were
/// moved.
Result<Project> resolveProject(const std::string& nameOrFile, const MovedFiles& moved = {});

/// Completes a project from resolveProject() for tracking, and returns the errors of checking it.
/// If the calibration does not give the image size of a camera, the size is read from the video or
/// camera.
Result<Project> completedProject(Project project);

/// Opens the videos or cameras of a project from resolveProject(), and its ground truth if there is
/// one.
Result<SessionInputs> openInputs(Project project);

/// Returns the live cameras of a project, in project order.
std::vector<LiveCamera> liveCamerasOf(const Project& project);

/// Loads the requested project, unless the request contains an unsaved one, and opens its inputs.
/// "Open" in the window does the same.
Result<SessionInputs> openProject(const SessionRequest& request);

} // namespace dewpoint::app

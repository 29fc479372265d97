// SPDX-License-Identifier: GPL-3.0-or-later
// Namespaces of the floors, which are the layers of the program. Each floor can use the names of
// the floors below it without qualification (docs/architecture.md).
#pragma once

namespace dewpoint::base {} // namespace dewpoint::base
namespace dewpoint::geometry {
using namespace base;
} // namespace dewpoint::geometry
namespace dewpoint::color {
using namespace base;
} // namespace dewpoint::color
namespace dewpoint::trajectory {
using namespace base;
} // namespace dewpoint::trajectory
namespace dewpoint::filter {
using namespace base;
} // namespace dewpoint::filter
namespace dewpoint::simulation {
using namespace geometry;
} // namespace dewpoint::simulation
namespace dewpoint::capture {
using namespace geometry;
} // namespace dewpoint::capture
namespace dewpoint::calibration {
using namespace geometry;
} // namespace dewpoint::calibration
namespace dewpoint::observation {
using namespace filter;
using namespace color;
using namespace geometry;
} // namespace dewpoint::observation
namespace dewpoint::tracking {
using namespace observation;
using namespace capture;
} // namespace dewpoint::tracking
namespace dewpoint::camera_motion {
using namespace tracking;
} // namespace dewpoint::camera_motion
namespace dewpoint::project {
using namespace calibration;
using namespace tracking;
} // namespace dewpoint::project
namespace dewpoint::setup {
using namespace project;
using namespace capture;
using namespace trajectory;
} // namespace dewpoint::setup
namespace dewpoint::session {
using namespace project;
using namespace capture;
using namespace trajectory;
using namespace camera_motion;
} // namespace dewpoint::session
namespace dewpoint::broadcast {
using namespace session;
} // namespace dewpoint::broadcast
namespace dewpoint::experiment {
using namespace session;
using namespace setup;
using namespace simulation;
} // namespace dewpoint::experiment
namespace dewpoint::ui {
using namespace session;
using namespace setup;
using namespace experiment;
} // namespace dewpoint::ui
namespace dewpoint::app {
using namespace broadcast;
using namespace experiment;
using namespace ui;
} // namespace dewpoint::app
namespace dewpoint::bench {
using namespace app;
} // namespace dewpoint::bench
namespace dewpoint::tests {
using namespace app;
} // namespace dewpoint::tests

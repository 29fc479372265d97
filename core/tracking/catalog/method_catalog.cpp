// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/catalog/method_catalog.h"

#include "core/tracking/barrera/barrera_parameters.h"
#include "core/tracking/barrera/barrera_tracker.h"
#include "core/tracking/barrera/dynamics_parameters.h"
#include "core/tracking/barrera/dynamics_tracker.h"
#include "core/tracking/boxes/histogram_parameters.h"
#include "core/tracking/boxes/histogram_tracker.h"
#include "core/tracking/boxes/multi_box_tracker.h"
#include "core/tracking/boxes/sugandi_parameters.h"
#include "core/tracking/boxes/sugandi_tracker.h"
#include "core/tracking/dewpoint/dewpoint_parameters.h"
#include "core/tracking/dewpoint/dewpoint_tracker.h"
#include "core/tracking/independent_trackers.h"
#include "core/tracking/people/mohedano_tracker.h"
#include "core/tracking/people/people_parameters.h"
#include "core/tracking/people/people_particle_tracker.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace dewpoint::tracking {
namespace {

std::string colorText(const Target& target) {
  std::string text;
  for (const ColorRange& color : target.colors()) {
    text += fmt::format("{}hue {} to {}, saturation {} to {}, intensity {} to {}",
                        text.empty() ? "" : " or ", color.hueMin, color.hueMax, color.saturationMin,
                        color.saturationMax, color.intensityMin, color.intensityMax);
  }
  return fmt::format("{}, radius {} m", text, target.radius);
}

std::string boxText(const Target& target) {
  return target.box ? "another box" : "no box";
}

std::string lackOfTargets(std::string_view /*method*/) {
  return "at least one [[target]] is needed; learn-color creates one";
}

std::string lackOfBoxes(std::string_view method) {
  return fmt::format("method {} needs at least one [[target]] with a box", method);
}

/// Targets begin at their boxes.
std::int64_t firstBox(const std::vector<Target>& targets, std::int64_t frame) {
  for (const Target& target : targets) {
    frame = target.box ? std::min(frame, target.box->frame) : frame;
  }
  return frame;
}

constexpr MethodFamily kSpheres{
    .heading = "Colored objects in 3D", .describe = colorText, .noTargetsText = lackOfTargets};
/// Positions where the rays of several cameras meet.
constexpr MethodFamily kTriangulated{.heading = kSpheres.heading,
                                     .minCameraCount = 2,
                                     .describe = colorText,
                                     .noTargetsText = lackOfTargets};
constexpr MethodFamily kBoxes{
    .targetSource = TargetSource::Box,
    .heading = "Any object in the images of one camera (2D)",
    .needsCalibration = false,
    .tableKind = RunTableKind::Boxes,
    .hasBestParticle = false,
    .retracksAfterEdit = true,
    .describe = boxText,
    .isDefined = [](const Target& target) { return target.box.has_value(); },
    .noTargetsText = lackOfBoxes,
    .firstFrameFor = firstBox};
constexpr MethodFamily kPeople{
    .targetSource = TargetSource::Images,
    .heading = "People in a room",
    .minCameraCount = 2,
    .tableKind = RunTableKind::People,
    .hasBestParticle = false,
    .hasMotionMasks = true,
    .describe = colorText,
    // The background is learned at the beginning.
    .firstFrameFor = [](const std::vector<Target>&, std::int64_t) { return std::int64_t{0}; }};

using Made = std::unique_ptr<Tracker>;
using Targets = std::vector<Target>;

/// Methods that treat all targets together.
template <class T>
Made makeTogether(const ParameterValues& parameters, const CameraRig& rig, const Targets& targets) {
  return std::make_unique<T>(parameters, rig, targets);
}

template <BoxFilter F>
Made makeBoxes(const ParameterValues& parameters, const CameraRig& /*rig*/,
               const Targets& targets) {
  return std::make_unique<MultiBoxTracker<F>>(parameters, targets);
}

template <class T>
Made makePeople(const ParameterValues& parameters, const CameraRig& rig,
                const Targets& /*targets*/) {
  return std::make_unique<T>(parameters, rig);
}

template <bool WithColor>
Made makeMohedano(const ParameterValues& parameters, const CameraRig& rig,
                  const Targets& /*targets*/) {
  return std::make_unique<MohedanoTracker>(parameters, rig, WithColor);
}

/// The one place that knows all methods.
constexpr Method kMethods[] = {
    {"dewpoint",
     kSpheres,
     {"Balls, hands and other colored objects",
      "The most accurate method. It finds out by itself whether the target is a ball or has "
      "another shape.",
      "method-dewpoint.md"},
     dewpointParameters,
     makeTogether<DewpointTracker>,
     true,
     true,
     true},
    {"barrera",
     kSpheres,
     {"A simple particle filter with color", "For teaching: shows how a particle filter works.",
      "method-dynamics.md", "Barrera et al. 2005"},
     barreraParameters,
     makeIndependentTrackers<BarreraTracker>},
    {"dynamics",
     kTriangulated,
     {"A particle filter with position measurements",
      "For teaching: shows how particles follow measured positions.", "method-dynamics.md",
      "Barrera et al. 2005, III-C"},
     dynamicsParameters,
     makeIndependentTrackers<DynamicsTracker>},
    {"histogram",
     kBoxes,
     {"Anything you draw a box around",
      "Tracks an object by its colors, adapts to its size, and finds it again after it was hidden.",
      "method-sugandi.md"},
     histogramParameters,
     makeBoxes<HistogramTracker>},
    {"sugandi",
     kBoxes,
     {"A particle filter with color histograms",
      "For teaching: tracks an object as a box in the images of one camera.", "method-sugandi.md",
      "Sugandi et al. 2009"},
     sugandiParameters,
     makeBoxes<SugandiTracker>},
    {"people",
     kPeople,
     {"People who walk and meet", "Tracks several people on the floor, even in similar clothes.",
      "method-people.md"},
     peopleParameters,
     makePeople<PeopleParticleTracker>},
    {"mohedano-msc",
     kPeople,
     {"People by motion and color", "For comparison: distinguishes people by their clothes.",
      "method-people.md", "Mohedano et al. 2009, MS+C"},
     mohedanoMscParameters,
     makeMohedano<true>},
    {"mohedano-ms",
     kPeople,
     {"People by motion alone", "For comparison: mixes up people who come close to each other.",
      "method-people.md", "Mohedano et al. 2009, MS"},
     mohedanoMsParameters,
     makeMohedano<false>},
};

template <class Suits> std::vector<std::string> namesWhere(const Suits& suits) {
  std::vector<std::string> names;
  for (const Method& method : kMethods) {
    if (suits(method.family)) {
      names.emplace_back(method.name);
    }
  }
  return names;
}

} // namespace

bool MethodFamily::lacksTargets(const std::vector<Target>& projectTargets) const {
  return !findsTargets() && std::ranges::none_of(projectTargets, isDefined);
}

std::span<const Method> methods() {
  return kMethods;
}

std::vector<const Method*> methodsInDisplayOrder() {
  std::vector<const Method*> all;
  std::ranges::transform(kMethods, std::back_inserter(all),
                         [](const Method& method) { return &method; });
  std::stable_partition(all.begin(), all.end(),
                        [](const Method* method) { return method->text.paper.empty(); });
  return all;
}

std::string_view headingOf(const Method& method) {
  return method.text.paper.empty() ? method.family.heading
                                   : "From papers, for teaching and comparison";
}

std::string_view defaultMethod() {
  return kMethods[0].name;
}

const Method* findMethod(std::string_view name) {
  const auto found = std::ranges::find(kMethods, name, &Method::name);
  return found == std::end(kMethods) ? nullptr : found;
}

std::vector<std::string> methodNames() {
  return namesWhere([](const MethodFamily&) { return true; });
}

std::vector<std::string> methodNames(TargetSource targets) {
  return namesWhere(
      [targets](const MethodFamily& family) { return family.targetSource == targets; });
}

std::vector<std::string> methodNames(RunTableKind tables) {
  return namesWhere([tables](const MethodFamily& family) { return family.tableKind == tables; });
}

MethodFamily methodFamily(std::string_view method) {
  const Method* row = findMethod(method);
  return row != nullptr ? row->family : kMethods[0].family;
}

MethodText methodText(std::string_view method) {
  const Method* row = findMethod(method);
  return row != nullptr ? row->text : MethodText();
}

std::string_view methodSummary(std::string_view method) {
  return methodText(method).summary;
}

std::string_view methodManualPage(std::string_view method) {
  const Method* row = findMethod(method);
  return (row != nullptr ? *row : kMethods[0]).text.manualPage;
}

std::vector<std::string_view> methodManualPages() {
  std::vector<std::string_view> pages;
  for (const Method& method : kMethods) {
    if (std::ranges::find(pages, method.text.manualPage) == pages.end()) {
      pages.push_back(method.text.manualPage);
    }
  }
  return pages;
}

std::span<const ParameterDeclaration> methodParameters(std::string_view method) {
  const Method* row = findMethod(method);
  return row != nullptr ? row->parameters() : std::span<const ParameterDeclaration>();
}

ParameterValues carryOverParameters(const ParameterValues& previous, std::string_view method) {
  ParameterValues values(methodParameters(method));
  for (const auto& declaration : previous.declarations()) {
    if (!previous.isGiven(declaration.key)) {
      continue;
    }
    const double value = previous.at(declaration.key);
    if (value != declaration.defaultValue) {
      (void)values.set(declaration.key, value); // or its own default stays
    } else {
      values.markAsGiven(declaration.key);
    }
  }
  return values;
}

Status checkParameters(std::string_view method, const ParameterValues& parameters) {
  const auto declared = parameters.declarations();
  for (const ParameterDeclaration& needed : methodParameters(method)) {
    if (std::ranges::find(declared, needed.key, &ParameterDeclaration::key) == declared.end()) {
      return failure(ErrorCode::MissingKey, "", needed.key,
                     fmt::format("method {} needs it", method));
    }
  }
  return {};
}

Result<std::unique_ptr<Tracker>> makeTracker(std::string_view method,
                                             const ParameterValues& parameters,
                                             const CameraRig& rig,
                                             const std::vector<Target>& targets) {
  const Method* row = findMethod(method);
  if (row == nullptr) {
    return failure(ErrorCode::NotFound, "", "method",
                   fmt::format("\"{}\"; known: {}", method, fmt::join(methodNames(), ", ")));
  }
  if (const auto checked = checkParameters(method, parameters); !checked) {
    return tl::make_unexpected(checked.error());
  }
  return row->make(parameters, rig, targets);
}

} // namespace dewpoint::tracking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/frame_range.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/parameter_settings.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/dewpoint-cli/common/repeated_job.h"
#include "app/dewpoint-cli/track/run_notes.h"
#include "app/wiring/open_project.h"
#include "core/base/units.h"
#include "core/session/people/people_overlay.h"
#include "core/session/people/people_writer.h"
#include "core/session/run/frame_loop.h"
#include "core/session/run/tracking_clock.h"
#include "core/session/run/tracking_run.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/people/people_parameters.h"
#include "core/tracking/tracker_capabilities.h"
#include "core/trajectory/jobs/job_folder.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <memory>

namespace dewpoint::app {
namespace {

struct PeopleOptions {
  std::string project;
  std::string folder;
  std::string method; ///< empty: the project's, if it is for people, else the default
  std::string frames;
  std::optional<std::uint64_t> seed;
  int threads = 1;
  std::vector<std::string> settings;
  std::vector<std::string> persons;
  int overlay = 0;
  bool list = false;
  JobOptions job;
};

/// The files whose content a repetition does not change.
const std::vector<std::string> kPeopleFiles{"trajectory.csv", "volumes.csv", "hulls.csv",
                                            "ground.csv"};

/// Those of which the command writes the tables, the default first.
std::vector<std::string> peopleMethods() {
  return methodNames(RunTableKind::People);
}

void listMethods() {
  for (const std::string& method : peopleMethods()) {
    fmt::print("{}: {}\n", method, methodSummary(method));
    for (const ParameterDeclaration& one : methodParameters(method)) {
      fmt::print("  {:<20} {:>9} {:<5} {} to {}. {}\n", one.key, one.defaultValue, one.unit,
                 one.minimum, one.maximum, one.description);
    }
  }
}

/// Chooses the method and its parameters: the project's, where they are for people.
Status applyOptions(const PeopleOptions& options, Project& project) {
  const std::vector<std::string> known = peopleMethods();
  const bool isKnown = std::ranges::find(known, project.method) != known.end();
  const std::string usual = isKnown ? project.method : known.front();
  const std::string method = options.method.empty() ? usual : options.method;
  if (method != project.method) {
    project.method = method;
    project.parameters = ParameterValues(methodParameters(method));
  }
  project.seed = options.seed.value_or(project.seed);
  return applySettings(options.settings, project.parameters);
}

/// Whether somebody's middle can be there: above the floor that is watched.
Status inArea(const std::string& text, const Eigen::Vector3d& position, const PeopleArea& area) {
  constexpr double kReach = 3.0; // meters above the floor
  if (area.contains(position.head<2>()) && position.z() >= area.floorHeight &&
      position.z() <= area.floorHeight + kReach) {
    return {};
  }
  const Eigen::Vector2d low = area.center - area.halfSize;
  const Eigen::Vector2d high = area.center + area.halfSize;
  return failure(
      ErrorCode::BadValue, "", "--person",
      fmt::format("{} lies outside the tracked area: x {:g} to {:g}, y {:g} to {:g}, z {:g} to "
                  "{:g} m; area_x, area_y, area_half_x, area_half_y and floor_z define it",
                  text, low.x(), high.x(), low.y(), high.y(), area.floorHeight,
                  area.floorHeight + kReach));
}

Status addPersons(const std::vector<std::string>& texts, const PeopleArea& area, TrackingRun& run) {
  for (const std::string& text : texts) {
    Eigen::Vector3d position;
    int used = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &position[0], &position[1], &position[2],
                    &used) != 3 ||
        static_cast<std::size_t>(used) != text.size() || !position.allFinite()) {
      return failure(ErrorCode::BadValue, "", "--person", text + " is not x,y,z in meters");
    }
    if (const auto inside = inArea(text, position, area); !inside) {
      return inside;
    }
    run.apply(PeopleChange{position, std::nullopt});
  }
  return {};
}

/// Writes what becomes of the frames, and draws some of them.
class PeopleObserver final : public FrameObserver {
public:
  /// `overlayEvery`: frames between two rows of the contact sheet; 0: none.
  PeopleObserver(PeopleWriter& writer, Progress& progress, int overlayEvery)
      : writer_(writer), progress_(progress), overlayEvery_(overlayEvery) {}

  Status onFrameTracked(const TrackingRun& run) override {
    const auto* const finding = run.capability<PeopleFinding>();
    assert(finding != nullptr); // as the methods that may be chosen are
    const FrameSet& set = *run.frames();
    for (const PersonEstimate& person : finding->people()) {
      const TrajectorySample sample = sampleOf(person, set.index, 0.0);
      found_[sample.target] += sample.isValid ? 1 : 0;
    }
    most_ = std::max(most_, static_cast<int>(finding->people().size()));
    if (const auto written = writer_.write(*finding, set.index, dewpoint::base::seconds(set.time));
        !written) {
      return written;
    }
    if (overlayEvery_ > 0 && frames_ % overlayEvery_ == 0) {
      rows_.push_back(peopleOverlay(*finding, set, run.rig(), 400));
    }
    progress_.show(++frames_);
    return {};
  }

  std::int64_t frames() const { return frames_; }
  int most() const { return most_; } ///< people at once
  const std::vector<cv::Mat>& rows() const { return rows_; }
  /// In how many frames each person was found.
  std::vector<JobTarget> targets() const {
    std::vector<JobTarget> targets;
    for (const auto& [name, frames] : found_) {
      targets.push_back({name, frames});
    }
    return targets;
  }

private:
  PeopleWriter& writer_;
  Progress& progress_;
  int overlayEvery_;
  std::vector<cv::Mat> rows_;
  std::map<std::string, std::int64_t> found_;
  std::int64_t frames_ = 0;
  int most_ = 0;
};

int overlayEvery(const PeopleOptions& options, const FrameRange& range, std::int64_t total) {
  if (options.overlay == 0) {
    return 0;
  }
  const auto span = range.end.value_or(total) - range.first;
  return static_cast<int>(
      std::max<std::int64_t>(1, (span + options.overlay - 1) / options.overlay));
}

int runPeople(const PeopleOptions& options) {
  if (options.list) {
    listMethods();
    return kExitDone;
  }
  auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  const auto frames = parseFrames(options.frames);
  const auto applied = applyOptions(options, *project);
  if (!frames || !applied) {
    reportError(frames ? applied.error() : frames.error());
    return kExitUsage;
  }
  auto job = makeJobRecord(
      "people", *project, options.job.label.empty() ? options.project : options.job.label,
      options.frames, fmt::format("{} {}", options.overlay, fmt::join(options.persons, " ")));
  if (isAlreadyDone(options.folder, job, options.job)) {
    return kExitDone;
  }
  auto inputs = openInputs(std::move(*project));
  if (!inputs) {
    return reportError(inputs.error());
  }
  auto run = TrackingRun::create(inputs->project, options.threads, inputs->backgroundImages);
  if (!run) {
    return reportError(run.error());
  }
  const PeopleArea area = peopleSettings(inputs->project.parameters).area;
  if (const auto added = addPersons(options.persons, area, *run); !added) {
    reportError(added.error());
    return kExitUsage;
  }
  const auto begun = JobFolder::beginJob(options.folder, kPeopleFiles);
  if (!begun) {
    return reportError(begun.error());
  }
  auto writer = PeopleWriter::create(options.folder, trajectoryHeader(inputs->project));
  if (!writer) {
    return reportError(writer.error());
  }
  catchInterruption();
  FrameSetSource& source = *inputs->source;
  Progress progress("people", frames->countIn(source).value_or(0));
  PeopleObserver observer(*writer, progress,
                          overlayEvery(options, *frames, source.frameCount().value_or(0)));
  TrackingClock clock;
  RunNotes notes(source, run->rig());
  const std::array<FrameObserver*, 3> observers{&notes, &clock, &observer};
  auto tracked = trackFrames(source, *frames, *run, observers, [&] {
    notes.printNotices();
    return !wasInterruptionRequested();
  });
  notes.printNotices();
  progress.finish();
  tracked = tracked ? writer->finish() : tracked;
  if (!observer.rows().empty()) {
    const auto sheet = std::filesystem::path(options.folder) / "overlay.png";
    const auto written = writeContactSheet(observer.rows(), sheet);
    if (tracked && !written) { // else what failed before is what is to be said
      return reportError(written.error());
    }
  }
  fmt::print("frames                  {:>10}\n", observer.frames());
  fmt::print("most people at once     {:>10}\n", observer.most());
  fmt::print("ms per frame            {:>10.2f}\n",
             inMilliseconds(clock.seconds()) /
                 static_cast<double>(std::max<std::int64_t>(1, observer.frames())));
  if (!tracked) {
    const int code = reportError(tracked.error());
    return code == kExitBadInput && observer.frames() > 0 ? kExitEndedEarly : code;
  }
  if (wasInterruptionRequested()) {
    return kExitInterrupted;
  }
  job.frameCount = observer.frames();
  job.trackingSeconds = clock.seconds();
  job.threadCount = options.threads;
  job.targets = observer.targets();
  const auto finished = begun->finish(std::move(job), kPeopleFiles);
  return finished ? kExitDone : reportError(finished.error());
}

} // namespace

void addPeopleCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "people",
      "Track people with the cameras of a project: positions, volumes, densities on the floor.");
  auto options = std::make_shared<PeopleOptions>();
  command->add_flag("--list", options->list, "Only list the methods and parameters");
  command->add_option("PROJECT", options->project, "Project file (TOML)");
  command->add_option("--out", options->folder, "Folder to write");
  command
      ->add_option("--method", options->method,
                   "Method (default: the project's method if it is for people, otherwise people)")
      ->check(CLI::IsMember(peopleMethods()));
  command->add_option("--seed", options->seed, "Seed of the run (default: the project's)");
  command
      ->add_option("--threads", options->threads, "Number of threads; does not change the result")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--frames", options->frames,
                      "Only frames A to B-1, as A:B (either may be empty)");
  command->add_option("--set", options->settings, "Set a parameter of the method: key=value");
  command->add_option("--person", options->persons,
                      "Position of a person in the first frame: x,y,z of the center of the body");
  command
      ->add_option("--overlay", options->overlay,
                   "Also write overlay.png: about this many frames of all cameras, with the hulls "
                   "of the people drawn over them")
      ->check(CLI::Range(0, 1000));
  addJobOptions(*command, options->job);
  command->callback([options, command, &exitCode] {
    if (!options->list && (options->project.empty() || options->folder.empty())) {
      throw CLI::RequiredError(options->project.empty() ? "PROJECT" : "--out");
    }
    exitCode = runPeople(*options);
  });
}

} // namespace dewpoint::app

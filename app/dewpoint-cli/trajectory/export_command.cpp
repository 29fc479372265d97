// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/progress.h"
#include "core/base/text_file.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/trajectory/export/export_catalog.h"
#include "core/trajectory/export/trajectory_export.h"
#include "core/trajectory/figure/figure_drawing.h"

#include <CLI/CLI.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

namespace dewpoint::app {
namespace {

struct ExportCommand {
  std::string source;
  std::string file;   ///< empty: no export is written
  std::string figure; ///< empty: no figure is written
  std::string from;
  std::string to;
  std::string gaps = "leave";
  std::string axes;
  std::string unit;
  std::string format;
  bool noHeader = false;
  bool preview = false;
  ExportOptions options;
};

/// "2.5" or "2.5s" are seconds, "75f" is a frame.
Result<std::optional<RangeBound>> parseSpanEnd(const std::string& text, const char* option) {
  if (text.empty()) {
    return std::optional<RangeBound>();
  }
  RangeBound end;
  std::string_view digits = text;
  end.isFrameNumber = digits.ends_with('f');
  if (end.isFrameNumber || digits.ends_with('s')) {
    digits.remove_suffix(1);
  }
  const auto number = toNumber<double>(digits);
  if (!number) {
    return failure(
        ErrorCode::BadValue, "", option,
        fmt::format("expected seconds, such as 2.5, or a frame, such as 75f; found {}", text));
  }
  end.secondsOrFrame = *number;
  return std::optional(end);
}

/// The format that is asked for, or the one that the file's ending means. BadValue when the ending
/// is that of another one, or of none.
Result<std::string> formatFor(const std::string& wanted, const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  const auto ofEnding = std::ranges::find(exportFormats(), ending, &ExportFormat::suffix);
  const bool isKnown = ofEnding != exportFormats().end();
  if (wanted.empty()) {
    if (!isKnown && !ending.empty()) {
      return failure(ErrorCode::BadValue, "", "--out",
                     fmt::format("no format uses the extension {}; use --format", ending));
    }
    return std::string(isKnown ? ofEnding->id : exportFormats().front().id);
  }
  const auto format = findExportFormat(wanted);
  if (format && isKnown && (*format)->suffix != ending) {
    return failure(ErrorCode::BadValue, "", "--out",
                   fmt::format("the extension {} is that of format {}, but --format is {}", ending,
                               ofEnding->id, wanted));
  }
  return wanted;
}

Status completeOptions(ExportCommand& command) {
  if (!command.figure.empty() && std::filesystem::path(command.figure).extension() != ".svg") {
    return failure(ErrorCode::BadValue, "", "--figure",
                   "figures are SVG files; the name must end in .svg");
  }
  auto format = formatFor(command.format, command.file);
  if (!format) {
    return tl::make_unexpected(format.error());
  }
  command.options.format = std::move(*format);
  const auto from = parseSpanEnd(command.from, "--from");
  if (!from) {
    return tl::make_unexpected(from.error());
  }
  const auto to = parseSpanEnd(command.to, "--to");
  if (!to) {
    return tl::make_unexpected(to.error());
  }
  ExportOptions& options = command.options;
  options.rangeBegin = *from;
  options.rangeEnd = *to;
  options.gapRule = command.gaps == "fill" ? GapRule::Fill : GapRule::LeaveEmpty;
  if (!command.axes.empty()) {
    options.axes = command.axes == "y-up" ? WorldAxes::YUp : WorldAxes::ZUp;
  }
  if (!command.unit.empty()) {
    options.unit = command.unit == "mm" ? LengthUnit::Millimeter : LengthUnit::Meter;
  }
  options.writesHeader = !command.noHeader;
  const auto now = std::chrono::system_clock::now();
  options.exportDate = fmt::format("{:%FT%TZ}", std::chrono::floor<std::chrono::seconds>(now));
  return {};
}

/// The sentence of an error names the file that was read where nothing else was.
int reportAbout(Error error, const std::string& file) {
  if (error.file.empty()) {
    error.file = file;
  }
  return reportError(error);
}

int showPreview(const ExportCommand& command, const Trajectory& trajectory) {
  const auto preview =
      previewExport(trajectory, command.options, command.file.empty() ? "preview" : command.file);
  if (!preview) {
    return reportAbout(preview.error(), command.source);
  }
  fmt::print("{}\n{}\n{}\n", preview->unitsSentence, preview->sizeSentence, preview->text);
  return kExitDone;
}

/// What is chosen, in the units and axes that the figures of the window have.
Status writeFigure(const ExportCommand& command, const Trajectory& trajectory) {
  const auto table = makeExportTable(trajectory, command.options, {});
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  const std::string title = figureTitle(trajectory.header.entries);
  const FigureDrawing drawing = layOutFigure(*table, {title, "time (s)", "from above"});
  return writeTextFile(command.figure, figureSvg(drawing, title));
}

int writeExport(const ExportCommand& command, const Trajectory& trajectory) {
  Progress bar("export", 100);
  const auto summary =
      exportTrajectory(trajectory, command.options, command.file, [&](double done) {
        bar.show(static_cast<std::int64_t>(inPercent(done)));
        return true;
      });
  bar.finish();
  if (!summary) {
    return reportAbout(summary.error(), command.source);
  }
  fmt::print("{} rows of {} target{}{} in {}.\n", summary->rowCount, summary->targetCount,
             summary->targetCount == 1 ? "" : "s",
             summary->gapCount > 0 ? fmt::format(", {} positions unknown,", summary->gapCount) : "",
             summary->files.size() == 1
                 ? summary->files.back().string()
                 : fmt::format("{} files, the last is {}", summary->files.size(),
                               summary->files.back().string()));
  return kExitDone;
}

int exportCommand(ExportCommand& command) {
  if (const auto complete = completeOptions(command); !complete) {
    reportError(complete.error());
    return kExitUsage;
  }
  std::error_code ignored;
  const std::filesystem::path source = command.source;
  for (const auto& read : {source, source / "trajectory.csv"}) {
    if (!command.file.empty() && std::filesystem::equivalent(read, command.file, ignored)) {
      reportError({ErrorCode::BadValue, command.file, "--out", "this is the input trajectory"});
      return kExitUsage;
    }
  }
  const auto trajectory = readExportSource(command.source);
  if (!trajectory) {
    return reportError(trajectory.error());
  }
  if (command.preview) {
    return showPreview(command, *trajectory);
  }
  if (!command.figure.empty()) {
    if (const auto drawn = writeFigure(command, *trajectory); !drawn) {
      return reportAbout(drawn.error(), command.source);
    }
    fmt::print("Figure in {}.\n", command.figure);
  }
  return command.file.empty() ? static_cast<int>(kExitDone) : writeExport(command, *trajectory);
}

std::string formatHelp() {
  std::string text = "Format; taken from the extension of --out if omitted:";
  for (const ExportFormat& format : exportFormats()) {
    text += fmt::format(" {}", format.id);
  }
  return text;
}

std::vector<std::string> formatIds() {
  std::vector<std::string> ids;
  for (const ExportFormat& format : exportFormats()) {
    ids.emplace_back(format.id);
  }
  return ids;
}

} // namespace

void addExportCommand(CLI::App& app, int& exitCode) {
  auto* command =
      app.add_subcommand("export", "Write a trajectory in the format of another program.");
  auto arguments = std::make_shared<ExportCommand>();
  ExportOptions& options = arguments->options;
  command->add_option("TRAJECTORY", arguments->source, "Trajectory (CSV), or the folder of a run")
      ->required();
  command->add_option("--format", arguments->format, formatHelp())
      ->check(CLI::IsMember(formatIds()));
  command->add_option("--out", arguments->file, "File to write");
  command->add_option("--figure", arguments->figure,
                      "Figure to write (SVG): positions over time, and from above");
  command->add_option("--targets", options.targets, "Targets; all if omitted")->delimiter(',');
  command->add_option("--from", arguments->from,
                      "First time in seconds, or first frame, such as 75f");
  command->add_option("--to", arguments->to, "Last time in seconds, or last frame, such as 150f");
  command->add_option("--rate", options.rowsPerSecond, "Rows per second; as recorded if omitted")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--gaps", arguments->gaps,
                   "What to write in gaps: leave (nothing) or fill (interpolated positions)")
      ->check(CLI::IsMember({"leave", "fill"}))
      ->capture_default_str();
  command
      ->add_option("--longest-gap", options.maxFilledGapSeconds,
                   "Longest gap that is filled, seconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--axes", arguments->axes,
                   "World axes: z-up or y-up (default: that of the format)")
      ->check(CLI::IsMember({"z-up", "y-up"}));
  command->add_option("--unit", arguments->unit, "Lengths: m or mm (default: that of the format)")
      ->check(CLI::IsMember({"m", "mm"}));
  command->add_flag("--smooth", options.usesSmoothedEstimates,
                    "Export smoothed estimates, which use all frames, instead of live ones");
  command->add_flag(
      "--no-header", arguments->noHeader,
      "Leave out the notes about the run; CSV files then begin with the column names");
  command->add_flag("--preview", arguments->preview, "Only show the first lines, units and axes");
  command->callback([arguments, command, &exitCode] {
    if (arguments->file.empty() && arguments->figure.empty() && !arguments->preview) {
      throw CLI::RequiredError(command->get_option("--out")->get_name());
    }
    exitCode = exportCommand(*arguments);
  });
}

} // namespace dewpoint::app

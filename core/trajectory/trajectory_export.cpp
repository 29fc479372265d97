// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/trajectory_export.h"

#include "core/base/text_file.h"
#include "core/trajectory/export_encoders.h"
#include "core/trajectory/trajectory_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint {
namespace {

constexpr double kShareOfTable = 0.5; ///< of the progress; smoothing is most of it
constexpr double kShareOfEncoding = 0.2;

std::string plainName(const std::filesystem::path& file) {
  return file.stem().string();
}

std::filesystem::path pathOf(const std::filesystem::path& file, const ExportFile& part) {
  return part.nameEnd.empty() ? file : file.parent_path() / (plainName(file) + part.nameEnd);
}

/// Some formats make a folder for their many files.
Status makeFolderOf(const std::filesystem::path& file, const std::filesystem::path& base) {
  const auto folder = file.parent_path();
  std::error_code problem;
  if (folder != base) {
    std::filesystem::create_directory(folder, problem);
  }
  return problem
             ? Status(failure(ErrorCode::FileUnwritable, folder.string(), "", problem.message()))
             : Status();
}

struct Encoded {
  ExportTable table;
  std::vector<ExportFile> files;
};

Result<Encoded> encode(const Trajectory& trajectory, const ExportOptions& options,
                       const ExportFormat& format, const std::filesystem::path& file,
                       const ExportProgress& progress) {
  bool wanted = true;
  auto table = makeExportTable(trajectory, options, format.wishes, [&](double done) {
    wanted = wanted && (!progress || progress(done));
    return wanted;
  });
  if (!wanted) {
    return failure(ErrorCode::Cancelled, file.string(), "preview", "stopped");
  }
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  auto files = format.encode(*table, plainName(file));
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  return Encoded{std::move(*table), std::move(*files)};
}

std::string firstLines(const std::string& text, std::size_t count) {
  std::size_t end = 0;
  for (std::size_t line = 0; line < count && end < text.size(); ++line) {
    const std::size_t next = text.find('\n', end);
    end = next == std::string::npos ? text.size() : next + 1;
  }
  return text.substr(0, end);
}

std::string sizeSentence(const ExportTable& table) {
  const std::size_t gaps = table.gapCount();
  return fmt::format("{} target{}, {} rows at {:.4g} per second, {}.", table.targets.size(),
                     table.targets.size() == 1 ? "" : "s", table.rowCount(), table.rate,
                     gaps == 0 ? std::string("no gaps") : fmt::format("{} places unknown", gaps));
}

/// The first places of a file that is no text.
std::string described(const ExportFormat& format, const ExportTable& table, std::size_t bytes,
                      std::size_t lineCount) {
  std::string text = fmt::format("{}, {} bytes: {}\n", format.title, bytes, format.fields);
  ExportTable plain = table;
  plain.header = false;
  const auto rows = encoders::wideCsv(plain, "");
  return text + firstLines(rows->front().bytes, lineCount > 1 ? lineCount - 1 : 1);
}

} // namespace

Result<ExportSummary> exportTrajectory(const Trajectory& trajectory, const ExportOptions& options,
                                       const std::filesystem::path& file,
                                       const ExportProgress& progress) {
  const auto format = exportFormat(options.format);
  if (!format) {
    return tl::make_unexpected(format.error());
  }
  const auto goesOn = [&](double done) { return !progress || progress(done); };
  ExportSummary summary;
  summary.cancelled = !goesOn(0.0);
  if (summary.cancelled) {
    return summary;
  }
  auto table = makeExportTable(trajectory, options, (*format)->wishes,
                               [&](double done) { return goesOn(kShareOfTable * done); });
  summary.cancelled = !goesOn(kShareOfTable);
  if (summary.cancelled) {
    return summary;
  }
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  summary.rows = table->rowCount();
  summary.targets = table->targets.size();
  summary.gaps = table->gapCount();
  const auto parts = (*format)->encode(*table, plainName(file));
  if (!parts) {
    return tl::make_unexpected(parts.error());
  }
  const double begin = kShareOfTable + kShareOfEncoding;
  for (std::size_t k = 0; k < parts->size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(parts->size());
    summary.cancelled = !goesOn(begin + (1.0 - begin) * share);
    if (summary.cancelled) {
      return summary;
    }
    const auto path = pathOf(file, (*parts)[k]);
    auto written = makeFolderOf(path, file.parent_path());
    if (written) {
      written = writeTextFile(path, (*parts)[k].bytes);
    }
    if (!written) {
      return tl::make_unexpected(written.error());
    }
    summary.files.push_back(path);
  }
  return summary;
}

Result<ExportPreview> previewExport(const Trajectory& trajectory, const ExportOptions& options,
                                    const std::filesystem::path& file, std::size_t lineCount,
                                    const ExportProgress& progress) {
  const auto format = exportFormat(options.format);
  if (!format) {
    return tl::make_unexpected(format.error());
  }
  const auto encoded = encode(trajectory, options, **format, file, progress);
  if (!encoded) {
    return tl::make_unexpected(encoded.error());
  }
  ExportPreview preview;
  preview.units = unitsSentence(encoded->table);
  preview.size = sizeSentence(encoded->table);
  preview.axes = encoded->table.axes;
  preview.unit = encoded->table.unit;
  preview.targets = encoded->table.targets.size();
  preview.rows = encoded->table.rowCount();
  preview.gaps = encoded->table.gapCount();
  preview.rate = encoded->table.rate;
  for (const ExportFile& part : encoded->files) {
    preview.nameEnds.push_back(part.nameEnd);
  }
  const std::string& bytes = encoded->files.back().bytes;
  preview.text = (*format)->binary ? described(**format, encoded->table, bytes.size(), lineCount)
                                   : firstLines(encoded->files.size() > 1 && (*format)->id == "tum"
                                                    ? encoded->files.front().bytes
                                                    : bytes,
                                                lineCount);
  return preview;
}

Result<Trajectory> readExportSource(const std::filesystem::path& fileOrFolder) {
  std::error_code ignored;
  return readTrajectory(std::filesystem::is_directory(fileOrFolder, ignored)
                            ? fileOrFolder / "trajectory.csv"
                            : fileOrFolder);
}

} // namespace dewpoint

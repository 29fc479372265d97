// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/trajectory_export.h"

#include "core/base/text_file.h"
#include "core/trajectory/export/export_catalog.h"
#include "core/trajectory/export/export_encoders.h"
#include "core/trajectory/trajectory_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <deque>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace dewpoint::trajectory {
namespace {

constexpr double kShareOfTable = 0.5; ///< of the progress; smoothing is most of it
constexpr double kShareOfEncoding = 0.2;

std::string plainName(const std::filesystem::path& file) {
  return file.stem().string();
}

std::filesystem::path pathOf(const std::filesystem::path& file, const ExportFile& part) {
  return part.nameSuffix.empty() ? file : file.parent_path() / (plainName(file) + part.nameSuffix);
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

/// Writes the files of an export beside their places; they take them together, so that an export
/// that fails or is canceled leaves an older one whole.
class ExportWriter {
public:
  explicit ExportWriter(std::filesystem::path file) : file_(std::move(file)) {}
  ExportWriter(const ExportWriter&) = delete;
  ExportWriter& operator=(const ExportWriter&) = delete;

  ~ExportWriter() {
    std::error_code ignored;
    for (const Staged& staged : staged_) {
      std::filesystem::remove(staged.beside, ignored);
    }
    if (folder_) {
      std::filesystem::remove(*folder_, ignored); // only when it is empty
    }
  }

  /// Where this file of the export will lie.
  Result<std::filesystem::path> write(const ExportFile& part) {
    const auto path = pathOf(file_, part);
    if (path.parent_path() != file_.parent_path() && !exists(path.parent_path())) {
      folder_ = path.parent_path();
    }
    if (auto there = makeFolderOf(path, file_.parent_path()); !there) {
      return tl::make_unexpected(there.error());
    }
    auto beside = path;
    beside += ".part";
    staged_.push_back({beside, path});
    // Of thousands of parts none is waited for until it is on the disk: without the file that
    // names them they are nothing.
    auto written =
        part.nameSuffix.empty() ? writeAndFlush(beside, part.bytes) : writePart(beside, part.bytes);
    if (!written) {
      written.error().file = path.string();
      return tl::make_unexpected(written.error());
    }
    return path;
  }

  /// All that was written takes its place, the file that names the others last.
  Status commit() {
    while (!staged_.empty()) {
      const Staged& staged = staged_.front();
      std::error_code problem;
      std::filesystem::rename(staged.beside, staged.path, problem);
      if (problem) {
        return failure(ErrorCode::FileUnwritable, staged.path.string(), "", problem.message());
      }
      staged_.pop_front();
    }
    folder_.reset();
    return {};
  }

private:
  struct Staged {
    std::filesystem::path beside;
    std::filesystem::path path;
  };

  static bool exists(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
  }

  static Status writePart(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream out(path, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    return out ? Status()
               : Status(failure(ErrorCode::FileUnwritable, path.string(), "",
                                std::generic_category().message(errno)));
  }

  std::filesystem::path file_;
  std::deque<Staged> staged_;
  std::optional<std::filesystem::path> folder_;
};

/// The first of the files that is there already; empty: none.
std::filesystem::path occupiedOf(const std::filesystem::path& file,
                                 const std::vector<ExportFile>& parts) {
  std::error_code ignored;
  for (const ExportFile& part : parts) {
    if (auto path = pathOf(file, part); std::filesystem::exists(path, ignored)) {
      return path;
    }
  }
  return {};
}

struct Encoded {
  ExportTable table;
  std::vector<ExportFile> files;
};

Result<Encoded> encode(const Trajectory& trajectory, const ExportOptions& options,
                       const ExportFormat& format, const std::filesystem::path& file,
                       const ExportProgress& progress) {
  bool wanted = true;
  auto table = makeExportTable(trajectory, options, format.tableDefaults, [&](double done) {
    wanted = wanted && (!progress || progress(done));
    return wanted;
  });
  if (!wanted) {
    return failure(ErrorCode::Canceled, file.string(), "preview", "stopped");
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

std::size_t noteLineCount(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < text.size() && text[begin] == '#'; ++count) {
    const std::size_t next = text.find('\n', begin);
    begin = next == std::string::npos ? text.size() : next + 1;
  }
  return count;
}

std::string sizeSentence(const ExportTable& table) {
  const std::size_t gaps = table.gapCount();
  return fmt::format("{} target{}, {} rows at {:.4g} per second, {}.", table.targets.size(),
                     table.targets.size() == 1 ? "" : "s", table.rowCount(), table.rowsPerSecond,
                     gaps == 0 ? std::string("no gaps")
                               : fmt::format("{} positions unknown", gaps));
}

/// The first places of a file that is no text.
std::string described(const ExportFormat& format, const ExportTable& table, std::size_t bytes,
                      std::size_t lineCount) {
  std::string text =
      fmt::format("{}, {} bytes: {}\n", format.title, bytes, format.contentsSentence);
  ExportTable plain = table;
  plain.writesHeader = false;
  const auto rows = encoders::encodeWideCsv(plain, "");
  return text + firstLines(rows->front().bytes, lineCount > 1 ? lineCount - 1 : 1);
}

} // namespace

Result<ExportSummary> exportTrajectory(const Trajectory& trajectory, const ExportOptions& options,
                                       const std::filesystem::path& file,
                                       const ExportProgress& progress) {
  const auto format = findExportFormat(options.format);
  if (!format) {
    return tl::make_unexpected(format.error());
  }
  const auto shouldContinue = [&](double done) { return !progress || progress(done); };
  ExportSummary summary;
  summary.isCanceled = !shouldContinue(0.0);
  if (summary.isCanceled) {
    return summary;
  }
  auto table = makeExportTable(trajectory, options, (*format)->tableDefaults,
                               [&](double done) { return shouldContinue(kShareOfTable * done); });
  summary.isCanceled = !shouldContinue(kShareOfTable);
  if (summary.isCanceled) {
    return summary;
  }
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  summary.rowCount = table->rowCount();
  summary.targetCount = table->targets.size();
  summary.gapCount = table->gapCount();
  const auto parts = (*format)->encode(*table, plainName(file));
  if (!parts) {
    return tl::make_unexpected(parts.error());
  }
  summary.existingFile =
      options.replacesExisting ? std::filesystem::path() : occupiedOf(file, *parts);
  if (!summary.existingFile.empty()) {
    return summary;
  }
  const double begin = kShareOfTable + kShareOfEncoding;
  ExportWriter writer(file);
  for (std::size_t k = 0; k < parts->size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(parts->size());
    summary.isCanceled = !shouldContinue(begin + (1.0 - begin) * share);
    if (summary.isCanceled) {
      summary.files.clear();
      return summary;
    }
    const auto path = writer.write((*parts)[k]);
    if (!path) {
      return tl::make_unexpected(path.error());
    }
    summary.files.push_back(*path);
  }
  if (const auto there = writer.commit(); !there) {
    return tl::make_unexpected(there.error());
  }
  return summary;
}

Result<ExportPreview> previewExport(const Trajectory& trajectory, const ExportOptions& options,
                                    const std::filesystem::path& file, std::size_t lineCount,
                                    const ExportProgress& progress) {
  const auto format = findExportFormat(options.format);
  if (!format) {
    return tl::make_unexpected(format.error());
  }
  const auto encoded = encode(trajectory, options, **format, file, progress);
  if (!encoded) {
    return tl::make_unexpected(encoded.error());
  }
  ExportPreview preview;
  preview.unitsSentence = unitsSentence(encoded->table);
  preview.sizeSentence = sizeSentence(encoded->table);
  preview.axes = encoded->table.axes;
  preview.unit = encoded->table.unit;
  preview.targetCount = encoded->table.targets.size();
  preview.rowCount = encoded->table.rowCount();
  preview.gapCount = encoded->table.gapCount();
  preview.rowsPerSecond = encoded->table.rowsPerSecond;
  const std::string& bytes = encoded->files.back().bytes;
  preview.text = (*format)->isBinary
                     ? described(**format, encoded->table, bytes.size(), lineCount)
                     : firstLines(encoded->files.size() > 1 && (*format)->id == "tum"
                                      ? encoded->files.front().bytes
                                      : bytes,
                                  lineCount);
  preview.noteLineCount = (*format)->isBinary ? 0 : noteLineCount(preview.text);
  return preview;
}

Result<Trajectory> readExportSource(const std::filesystem::path& fileOrFolder) {
  std::error_code ignored;
  return readTrajectory(std::filesystem::is_directory(fileOrFolder, ignored)
                            ? fileOrFolder / "trajectory.csv"
                            : fileOrFolder);
}

} // namespace dewpoint::trajectory

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_store.h"

#include "core/base/limits.h"
#include "core/base/table_text.h"
#include "core/base/text_file.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr const char* kRuns = "runs.csv";
constexpr const char* kTraces = "traces.csv";
constexpr const char* kSkipped = "skipped.csv";

/// The ended lines below the header; Mismatch for another header, none for a missing file.
Result<std::vector<std::string>> readLines(const std::filesystem::path& file,
                                           const std::string& header) {
  std::vector<std::string> lines;
  if (!std::filesystem::exists(file)) {
    return lines;
  }
  const auto text = readTableText(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  std::size_t begin = 0;
  for (std::size_t end = text->find('\n'); end != std::string::npos;
       end = text->find('\n', begin)) {
    if (lines.size() == limits::kMaxRows) {
      return failure(ErrorCode::NotParsed, file.string(), fmt::format("line {}", lines.size() + 1),
                     fmt::format("more than {} rows", limits::kMaxRows));
    }
    lines.push_back(text->substr(begin, end - begin));
    begin = end + 1;
  }
  if (lines.empty()) {
    return lines; // killed before the header was out
  }
  if (lines.front() != header) {
    return failure(ErrorCode::Mismatch, file.string(), "line 1",
                   "its columns are from another version of Dewpoint; choose another folder");
  }
  lines.erase(lines.begin());
  return lines;
}

template <class Item>
Result<std::vector<Item>> readItems(const std::filesystem::path& file, const std::string& header,
                                    std::optional<Item> (*parse)(const std::string&)) {
  const auto lines = readLines(file, header);
  if (!lines) {
    return tl::make_unexpected(lines.error());
  }
  std::vector<Item> items;
  for (std::size_t k = 0; k < lines->size(); ++k) {
    auto item = parse((*lines)[k]);
    if (item) {
      items.push_back(std::move(*item));
    } else if (k + 1 < lines->size()) {
      return failure(ErrorCode::NotParsed, file.string(), fmt::format("line {}", k + 2),
                     "not a row of the suite");
    }
  }
  return items;
}

Status appendLine(std::ofstream& stream, const std::filesystem::path& file,
                  const std::string& line) {
  stream << line << '\n' << std::flush;
  if (!stream) {
    return failure(ErrorCode::FileUnwritable, file.string(), "", "writing failed");
  }
  return {};
}

} // namespace

Result<SuiteStore> SuiteStore::open(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), "--out", problem.message());
  }
  SuiteStore store(folder);
  if (const auto loaded = store.load(); !loaded) {
    return tl::make_unexpected(loaded.error());
  }
  std::vector<RunKey> keys;
  for (const auto& [key, result] : store.results_) {
    keys.push_back(key);
  }
  // Without what was cut, so that the next line starts on a line of its own.
  if (const auto written = store.rewrite(keys); !written) {
    return tl::make_unexpected(written.error());
  }
  return store;
}

Result<SuiteResults> SuiteStore::read(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / kRuns)) {
    return failure(ErrorCode::FileMissing, (folder / kRuns).string(), "", "");
  }
  SuiteStore store(folder);
  return store.load().map([&] { return store.results_; });
}

Result<SkippedRuns> SuiteStore::readSkipped(const std::filesystem::path& folder) {
  return readItems<SkippedRun>(folder / kSkipped, skippedCsvHeader(), parseSkippedRun)
      .map([](const std::vector<SkippedRun>& runs) {
        return SkippedRuns(runs.begin(), runs.end());
      });
}

void SuiteStore::merge(const SkippedRuns& skipped) {
  skipped_.insert(skipped.begin(), skipped.end());
}

void SuiteStore::merge(const SuiteResults& results) {
  for (const auto& [key, result] : results) {
    results_.insert_or_assign(key, result);
  }
}

Status SuiteStore::load() {
  const auto rows = readItems<SuiteRow>(folder_ / kRuns, rowHeader(), parseRow);
  if (!rows) {
    return tl::make_unexpected(rows.error());
  }
  auto traces = readItems<SuiteTrace>(folder_ / kTraces, traceHeader(), parseTrace);
  if (!traces) {
    return tl::make_unexpected(traces.error());
  }
  std::map<RunKey, SuiteTrace> traceOf;
  for (SuiteTrace& trace : *traces) {
    const RunKey key = trace.key;
    traceOf.insert_or_assign(key, std::move(trace));
  }
  for (const SuiteRow& row : *rows) {
    // A run counts only with both; one without its trace is done again.
    if (const auto trace = traceOf.find(row.key); trace != traceOf.end()) {
      results_.insert_or_assign(row.key, SuiteResult{row, trace->second});
    }
  }
  return readSkipped(folder_).map([this](const SkippedRuns& skipped) { skipped_ = skipped; });
}

Status SuiteStore::append(const SuiteResult& result) {
  // The trace first: a run is known by its row.
  if (auto written = appendLine(traces_, folder_ / kTraces, traceText(result.trace)); !written) {
    return written;
  }
  if (auto written = appendLine(runs_, folder_ / kRuns, rowText(result.row)); !written) {
    return written;
  }
  results_.insert_or_assign(result.row.key, result);
  return {};
}

Status SuiteStore::append(const SkippedRun& run) {
  skipped_.insert(run);
  return writeSkipped(); // they are few
}

Status SuiteStore::writeSkipped() const {
  std::string text = skippedCsvHeader() + "\n";
  for (const SkippedRun& run : skipped_) {
    text += skippedCsvLine(run) + "\n";
  }
  return writeTextFile(folder_ / kSkipped, text);
}

Status SuiteStore::rewrite(const std::vector<RunKey>& order) {
  std::string rows = rowHeader() + "\n";
  std::string traces = traceHeader() + "\n";
  for (const RunKey& key : order) {
    const SuiteResult& result = results_.at(key);
    rows += rowText(result.row) + "\n";
    traces += traceText(result.trace) + "\n";
  }
  runs_ = std::ofstream();
  traces_ = std::ofstream();
  if (auto written = writeTextFile(folder_ / kTraces, traces); !written) {
    return written;
  }
  if (auto written = writeTextFile(folder_ / kRuns, rows); !written) {
    return written;
  }
  if (auto written = writeSkipped(); !written) {
    return written;
  }
  return openForAppending();
}

Status SuiteStore::openForAppending() {
  runs_.open(folder_ / kRuns, std::ios::app);
  traces_.open(folder_ / kTraces, std::ios::app);
  if (!runs_ || !traces_) {
    return failure(ErrorCode::FileUnwritable, folder_.string(), "--out", "cannot open its files");
  }
  return {};
}

} // namespace dewpoint::experiment

#include "io/run_file.hpp"

#include <algorithm>
#include <functional>
#include <system_error>

#include "io/atomic_file.hpp"
#include "io/hdf5.hpp"
#include "io/snapshot.hpp"
#include "io/xdmf.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"

namespace pmr::io {
namespace {

constexpr const char* run_format = "pmr-run";
constexpr int run_version = 2;  // of the layout in docs/file-formats.md

std::filesystem::path run_path(const std::filesystem::path& dir) { return dir / "run.h5"; }

H5File open_run(const std::filesystem::path& dir) {
  H5File file = H5File::open(run_path(dir));
  require_format(file, run_format, run_version);
  return file;
}

std::string column_path(const std::string& name) { return "/series/" + name; }

// Names of the columns in their order, the first "time".
std::vector<std::string> column_names(const H5File& file) {
  return file.has("/column_names") ? file.read_texts("/column_names") : std::vector<std::string>{};
}

// The first append fixes the columns.
void make_columns(H5File& file, const Series& rows) {
  ensure(rows.columns.front().name == "time", "the first column of a series is time");
  std::vector<std::string> names;
  for (const Column& column : rows.columns) {
    names.push_back(column.name);
    file.write(column_path(column.name), std::span<const double>{},
               {column.unit, Number::float64, Packing::extendible});
  }
  file.write_texts("/column_names", names);
}

void append_rows(H5File& file, const Series& rows) {
  if (rows.columns.empty()) return;
  if (column_names(file).empty()) make_columns(file, rows);
  const std::vector<std::string> names = column_names(file);
  ensure(names.size() == rows.columns.size(), "rows have the columns of the first append");
  for (std::size_t c = 0; c < names.size(); ++c) {
    const Column& column = rows.columns[c];
    ensure(column.name == names[c] && column.values.size() == rows.rows(),
           "rows have the columns of the first append, all of one length");
    file.extend(column_path(column.name), column.values);
  }
}

void write_xdmf(const std::filesystem::path& dir) {
  replace_text(dir / "run.xdmf", xdmf_text(open_run(dir)));
}

// Changes a copy of run.h5 and puts it in the place of the original. Who changes a run has written
// it: a file that is no longer what it was is the disk's fault, not that of any input.
void change_run(const std::filesystem::path& dir, const std::function<void(H5File&)>& change) try {
  static_cast<void>(open_run(dir));
  Replacement replacement(run_path(dir));
  std::error_code error;
  std::filesystem::copy_file(run_path(dir), replacement.temporary(),
                             std::filesystem::copy_options::overwrite_existing, error);
  if (error) throw StorageError(run_path(dir).string() + ": cannot be copied: " + error.message());
  H5File file = H5File::modify(replacement.temporary());
  change(file);
  write_vertices(file);
  file.close();
  replacement.commit();
  write_xdmf(dir);
} catch (const CaseError& error) {
  throw StorageError(error.what());
}

void make_folder(const std::filesystem::path& dir) {
  std::error_code error;
  std::filesystem::create_directories(dir, error);
  if (error) throw StorageError(dir.string() + ": folder cannot be made: " + error.message());
}

}  // namespace

void create_run(const std::filesystem::path& dir, const RunHeader& header) {
  make_folder(dir);
  Replacement replacement(run_path(dir));
  H5File file = H5File::create(replacement.temporary());
  set_format(file, run_format, run_version);
  file.write_texts("/case", {header.case_text});
  file.write_texts("/species", header.species);
  file.write_texts("/patches", header.patches);
  if (!header.adhered_radius.empty())
    file.write("/adhered_radius", std::span<const double>(header.adhered_radius),
               {"m", Number::float64, Packing::deflated});
  for (const char* group : {"/provenance", "/series", "/snapshots"}) file.make_group(group);
  for (const auto& [key, value] : header.provenance) file.set_attribute("/provenance", key, value);
  file.close();
  // A checkpoint of an earlier run in this folder would resume the wrong run.
  std::error_code error;
  std::filesystem::remove(dir / "checkpoint.h5", error);
  if (error)
    throw StorageError((dir / "checkpoint.h5").string() +
                       ": cannot be removed: " + error.message());
  replacement.commit();
  write_xdmf(dir);
}

void append_run(const std::filesystem::path& dir, const Series& rows,
                std::span<const Snapshot> snapshots) {
  change_run(dir, [&](H5File& file) {
    append_rows(file, rows);
    std::vector<std::string> groups = snapshot_groups(file);
    for (const Snapshot& snapshot : snapshots) {
      groups.push_back(next_snapshot_group(groups));
      write_snapshot(file, groups.back(), snapshot);
    }
  });
}

void drop_after(const std::filesystem::path& dir, double time) {
  change_run(dir, [&](H5File& file) {
    for (const std::string& group : snapshot_groups(file))
      if (file.number_attribute(group, "time") > time) file.remove(group);
    const std::vector<std::string> names = column_names(file);
    if (names.empty()) return;
    const std::vector<double> times = file.read<double>(column_path("time"));
    const auto first_late =
        std::find_if(times.begin(), times.end(), [&](double t) { return t > time; });
    for (const std::string& name : names)
      file.shorten(column_path(name), static_cast<std::size_t>(first_late - times.begin()));
  });
}

RunHeader read_header(const std::filesystem::path& dir) {
  const H5File file = open_run(dir);
  RunHeader header;
  const std::vector<std::string> text = file.read_texts("/case");
  header.case_text = text.empty() ? "" : text.front();
  header.species = file.read_texts("/species");
  header.patches = file.read_texts("/patches");
  if (file.has("/adhered_radius")) header.adhered_radius = file.read<double>("/adhered_radius");
  for (const std::string& key : file.attributes("/provenance"))
    header.provenance[key] = file.text_attribute("/provenance", key);
  return header;
}

Series read_series(const std::filesystem::path& dir) {
  const H5File file = open_run(dir);
  Series series;
  for (const std::string& name : column_names(file)) {
    const std::string path = column_path(name);
    series.columns.push_back({name, file.text_attribute(path, "unit"), file.read<double>(path)});
  }
  return series;
}

std::vector<double> snapshot_times(const std::filesystem::path& dir) {
  const H5File file = open_run(dir);
  std::vector<double> times;
  for (const std::string& group : snapshot_groups(file))
    times.push_back(file.number_attribute(group, "time"));
  return times;
}

Snapshot read_snapshot(const std::filesystem::path& dir, std::size_t index) {
  const H5File file = open_run(dir);
  const std::vector<std::string> groups = snapshot_groups(file);
  if (index >= groups.size())
    throw CaseError({Fault{run_path(dir).string(), "",
                           "snapshot " + std::to_string(index) + " wanted, the file holds " +
                               std::to_string(groups.size())}});
  return load_snapshot(file, groups[index]);
}

}  // namespace pmr::io
